// SPDX-License-Identifier: Apache-2.0
// Whether two numbers were made alike.
#pragma once

#include "model/exact/real.h"

namespace toolcomp::exact {

// The same operations on the same rationals: equal, whatever functions they are made of. Within a budget of work: false
// where it does not reach.
[[nodiscard]] bool alike(const Real& a, const Real& b);

}  // namespace toolcomp::exact
