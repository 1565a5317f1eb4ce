// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_side_compensation/side_corner.h"

#include <utility>

namespace toolcomp::model {
namespace {

// The stop point is the head of the intersection or of the first vector of an acute corner: the first head, or the one
// behind the vector that stands square to the former block.
void mark_stop(SpaceGroup& group) {
  const std::size_t stop = group.front().former == Seat::square ? 1 : 0;
  for (std::size_t i = stop + 1; i < group.size(); ++i) group[i].after_stop = true;
}

}  // namespace

Real SideGroup::squared_distance(std::size_t a, std::size_t b) const {
  if (in_frame.empty()) return squared_norm(vectors[a].vector - vectors[b].vector);
  return squared_norm(in_frame[a].vector - in_frame[b].vector);
}

FramedCorner::FramedCorner(const SideCorner& corner) : corner_(corner) {
  const Vector v1 = direction_of(corner.former);
  const Vector v2 = direction_of(corner.latter);
  if (known_zero(cross(v1, v2)) && !corner.plane.has_rational_tool()) {
    set_parallel(v1, v2);
    return;
  }
  frame_ = corner.plane.frame();
  former_ = seen(corner.plane, frame_, corner.former);
  latter_ = seen(corner.plane, frame_, corner.latter);
}

// A line along a radius, or both arcs with theirs in one line, make corners of exactly 0, 90 or 180 degrees under any
// tool: in a frame along them this is no matter of proof.
void FramedCorner::set_parallel(const Vector& v1, const Vector& v2) {
  const CompensationPlane& plane = corner_.plane;
  frame_ = plane.frame_along(v2);
  const Real length = sqrt(squared_norm(plane.left(v2)) / plane.tool().norm2);
  const Real ratio = dot(v1, v2) / squared_norm(v2);
  former_ = seen(plane, PlanePoint{ratio * length, 0}, corner_.former);
  latter_ = seen(plane, PlanePoint{length, 0}, corner_.latter);
}

// Vectors square to a block have a simpler form than that in the frame.
SideGroup FramedCorner::lifted(VectorGroup group) const {
  SpaceGroup result;
  result.reserve(group.size());
  for (const CornerVector& v : group) {
    const Vector vector = v.former == Seat::square   ? perpendicular(corner_.plane, corner_.former)
                          : v.latter == Seat::square ? perpendicular(corner_.plane, corner_.latter)
                                                     : lift(frame_, v.vector);
    result.push_back({vector, v.former, v.latter, false});
  }
  mark_stop(result);
  return {std::move(result), std::move(group)};
}

SpaceGroup way_round(CornerClass kind, const LineCorner& lines, bool with_former, bool with_latter) {
  auto group = model::way_round<SpaceGroup>(kind, lines, with_former, with_latter);
  mark_stop(group);
  return group;
}

}  // namespace toolcomp::model
