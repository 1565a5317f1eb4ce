// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_side_compensation/side_path.h"

namespace toolcomp::model {
namespace {

// Any axis that is not the tool's will do: nothing that follows depends on the choice.
std::size_t axis_across(const Vector& tool) {
  for (std::size_t i = 0; i < 3; ++i)
    if (known_zero(component(tool, i))) return i;
  return square(tool.x) < square(tool.y) + square(tool.z) ? 0 : 1;
}

}  // namespace

PlaneFrame CompensationPlane::frame() const {
  Vector axis;
  component(axis, axis_across(tool.vector)) = 1;
  return frame_along(axis);
}

PlaneFrame CompensationPlane::frame_along(const Vector& v) const {
  const Vector in_plane = along(v);
  const Vector first = in_plane / sqrt(squared_norm(in_plane));
  return {first, cross(tool.unit, first)};
}

SideEnd line_end(const CompensationPlane& plane, const Vector& travel) {
  const Vector left = plane.left(travel);
  return {{left, cross(left, plane.tool.unit), sqrt(squared_norm(left)), 0}, travel};
}

// Its left is -turn · u(ρ), along the part of the radius in the plane, u(ρ). |VT|² u(ρ) has the length |VT| |VT × ρ|.
SideEnd arc_end(const CompensationPlane& plane, const SideArc& arc, const PlanePoint& from_center, int sense) {
  SideEnd end;
  end.direction = in_space(arc.plane, from_center);
  end.turn = sense * arc.ends.turn;
  if (arc.ends.radius && plane.is_parallel_to(arc.plane)) end.radius = arc.ends.radius;
  const Real& norm2 = plane.tool.norm2;
  end.left = Real(-end.turn) * plane.along(end.direction);
  end.length = end.radius ? norm2 * Real(*end.radius) : sqrt(norm2 * squared_norm(plane.left(end.direction)));
  return end;
}

PathEnd seen(const PlanePoint& direction, const SideEnd& end) {
  if (end.is_arc()) return arc_end(direction, end.turn, end.radius, end.offset);
  return {heading(direction), 0, end.offset};
}

PathEnd seen(const PlaneFrame& frame, const SideEnd& end) {
  return seen(PlanePoint{dot(frame.first, end.direction), dot(frame.second, end.direction)}, end);
}

}  // namespace toolcomp::model
