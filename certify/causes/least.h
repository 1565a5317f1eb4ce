// SPDX-License-Identifier: Apache-2.0
// Finds the minimum of a function of one number.
#pragma once

#include <functional>
#include <optional>

namespace toolcomp::certify {

// The number in [-reach, reach] at which `f` is smallest, if its value there is less than half of its value at 0. `f`
// must grow about evenly to both sides of this number; far away it may be infinite. About forty values are computed,
// most of them near 0, where mistakes are likely.
std::optional<double> least_of(const std::function<double(double)>& f, double reach);

}  // namespace toolcomp::certify
