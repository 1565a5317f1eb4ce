// SPDX-License-Identifier: Apache-2.0
// The memory of numbers of GMP and MPFR.
#pragma once

namespace toolcomp::exact {

// From this call on, both libraries keep released memory, by size, for the next number of the same thread. A number of
// a few limbs lives for some nanoseconds, and malloc takes as long (under AddressSanitizer several times as long).
// Blocks come from malloc and go back to it at the end of the thread. A block may be released by another thread. Call
// this once, before the first number is made.
void use_limb_pool();

}  // namespace toolcomp::exact
