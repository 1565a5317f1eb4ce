// SPDX-License-Identifier: Apache-2.0
// Where GMP and MPFR get the memory of numbers from.
#pragma once

namespace toolcomp::exact {

// From now on both keep what they give back, by size, for the next number of the same thread: a number of a few limbs
// lives for some nanoseconds, and malloc takes as long (under AddressSanitizer several times as long). Blocks come from
// malloc and go back to it at the end of the thread; one that another thread gives back is as good as any. To be called
// once, before there is a number.
void use_limb_pool();

}  // namespace toolcomp::exact
