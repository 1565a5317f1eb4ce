// SPDX-License-Identifier: Apache-2.0
// Whole numbers of 128 bits (GCC and clang).
#pragma once

namespace toolcomp::fast {

__extension__ typedef __int128 Int128;            // NOLINT(modernize-use-using): the attribute needs a typedef
__extension__ typedef unsigned __int128 UInt128;  // NOLINT(modernize-use-using)

}  // namespace toolcomp::fast
