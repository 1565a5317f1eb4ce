// SPDX-License-Identifier: Apache-2.0
// Whether two numbers were made in the same way.
#pragma once

#include "model/exact/real.h"

namespace toolcomp::exact {

// Whether they are the same operations on the same rationals. Then they are equal, whatever functions they contain.
// Within a budget of work: false if the budget is not enough.
[[nodiscard]] bool alike(const Real& a, const Real& b);

}  // namespace toolcomp::exact
