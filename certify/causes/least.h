// SPDX-License-Identifier: Apache-2.0
// Where a function of one number is least.
#pragma once

#include <functional>
#include <optional>

namespace toolcomp::certify {

// The number in [-reach, reach] at which `f` is least, if it is less there than half of what it is at 0. `f` grows
// about evenly to both sides of it; far away it may be infinite. Some forty values are asked for, most of them near 0
// where mistakes are.
std::optional<double> least_of(const std::function<double(double)>& f, double reach);

}  // namespace toolcomp::certify
