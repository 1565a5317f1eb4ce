// SPDX-License-Identifier: Apache-2.0
// Surface normals and tool vectors for LN blocks: exact decimals in every relation that decides something.
#pragma once

#include <array>
#include <cstdint>

#include "fuzz/gen/choices.h"

namespace toolcomp::fuzz {

// Three components of `decimals` digits behind the point.
struct VectorWords {
  std::array<std::int64_t, 3> count{};
  int decimals = 0;
};

// Pythagorean, of unit length rounded to 4, 7 or 8 decimals, along an axis, whole numbers, any length, at the bound of
// what counts as normalised.
VectorWords any_vector(Choices& choose);
// At right angles to it, exactly.
VectorWords perpendicular_to(Choices& choose, const VectorWords& v);
// A normal for a tool along `tool`: free, along it, opposite, at right angles, near one of these, at the bound below
// it.
VectorWords normal_for(Choices& choose, const VectorWords& tool);
// A normal whose angle with the tool is a whole number of degrees that tables have (45, 60, 90, 120, 135).
struct NormalAndTool {
  VectorWords normal;
  VectorWords tool;
};
NormalAndTool whole_angle(Choices& choose);

}  // namespace toolcomp::fuzz
