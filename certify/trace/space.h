// SPDX-License-Identifier: Apache-2.0
// The space in which a recording is compared with the path: the recorded axes, separated into linear and rotary ones.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "spec/language/axes.h"

namespace toolcomp::certify {

// A position of every axis of the setup, by index. Axes that are not recorded are at 0.
using AxisPoint = std::array<double, spec::kMaxAxes>;

// A distance of two positions, or a tolerance: of the linear axes together, as a Euclidean length in setup units, and
// of each rotary axis, in degrees. The two are never added.
struct Distance {
  double linear = 0;
  double rotary = 0;
};

// The larger of the two, each divided by its tolerance.
inline double in_tolerances(const Distance& d, const Distance& tolerance) {
  return std::max(d.linear / tolerance.linear, d.rotary / tolerance.rotary);
}

// The axes that are recorded, by index.
struct TraceSpace {
  std::vector<std::size_t> linear;
  std::vector<std::size_t> rotary;
};

}  // namespace toolcomp::certify
