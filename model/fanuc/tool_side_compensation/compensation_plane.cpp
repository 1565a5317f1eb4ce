// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_side_compensation/compensation_plane.h"

#include <cstddef>

namespace toolcomp::model {
namespace {

// Any axis that is not the tool's will do: nothing that follows depends on the choice.
std::size_t axis_across(const Vector& tool) {
  for (std::size_t i = 0; i < 3; ++i)
    if (known_zero(component(tool, i))) return i;
  return square(tool.x) < square(tool.y) + square(tool.z) ? 0 : 1;
}

}  // namespace

bool CompensationPlane::is_same_as(const CompensationPlane& other) const {
  return known_zero(tool_.vector - other.tool_.vector);
}

PlaneFrame CompensationPlane::frame() const {
  Vector axis;
  component(axis, axis_across(tool_.vector)) = 1;
  return frame_along(axis);
}

PlaneFrame CompensationPlane::frame_along(const Vector& v) const {
  const Vector in_plane = along(v);
  const Vector first = in_plane / sqrt(squared_norm(in_plane));
  return {first, cross(tool_.unit, first)};
}

bool CompensationPlane::has_rational_tool() const {
  return tool_.vector.x.is_rational() && tool_.vector.y.is_rational() && tool_.vector.z.is_rational();
}

}  // namespace toolcomp::model
