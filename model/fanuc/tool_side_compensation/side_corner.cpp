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

LineCorner::LineCorner(Recorder& recorder, const CompensationPlane& plane, const SideEnd& former, const SideEnd& latter)
    : recorder_(recorder),
      plane_(plane),
      former_(former),
      latter_(latter),
      // W1 · U2, of travels that are often rational.
      turn_(dot(plane.tool().vector, cross(former.travel, latter.travel))),
      ahead_(dot(former.left, latter.left)) {}

Real LineCorner::scale_of_turn() const {
  return sqrt(plane_.tool().norm2 * (squared_norm(former_.travel) * squared_norm(latter_.travel)));
}
Real LineCorner::scale_ahead() const {
  return plane_.tool().norm2 * sqrt(squared_norm(former_.travel) * squared_norm(latter_.travel));
}

CornerClass LineCorner::classify() const {
  // fanuc.tool-side.corner-side: A corner of two lines is inner if their angle on the side of the workpiece, in the
  // compensation plane, is over 180 degrees, and outer if it is under 180 degrees. Exactly 180 degrees is inner.
  const Sign side =
      recorder_.decide(Clause::fanuc_tool_side_corner_side, former_.offset > 0 ? turn_ : -turn_, scale_of_turn());
  if (side == Sign::positive) return CornerClass::inner;
  const bool parallel = side == Sign::zero;
  // fanuc.tool-side.straight-or-reversal: If S = 0 (fanuc.tool-side.corner-side) and B goes straight on, the corner is
  // an inner corner of 180 degrees. If B goes straight back, it is an outer acute corner of 0 degrees, and the tool
  // goes round the end.
  // fanuc.tool-side.obtuse-or-acute: An outer corner of two lines is obtuse from 90 degrees on and acute below, in the
  // compensation plane. To which class 90 degrees belongs makes no difference to the path.
  const Clause clause =
      parallel ? Clause::fanuc_tool_side_straight_or_reversal : Clause::fanuc_tool_side_obtuse_or_acute;
  const Sign ahead = recorder_.decide(clause, ahead_, scale_ahead());
  if (ahead == Sign::negative) return CornerClass::acute;
  return parallel ? CornerClass::straight : CornerClass::obtuse;
}

bool LineCorner::is_parallel() const {
  // fanuc.cutter-c.direction-change-parallel: At a change of direction, paths with parallel tangents count as paths
  // without intersection. This holds straight on and straight back, for lines and arcs, even if the offset circles
  // would meet. If B goes straight back, the two perpendicular vectors are the same.
  return recorder_.decide(Clause::fanuc_cutter_c_direction_change_parallel, turn_, scale_of_turn()) == Sign::zero;
}

bool LineCorner::is_under_one_degree() const {
  return model::is_under_one_degree(recorder_, plane_.tool().norm2 * square(turn_), square(ahead_));
}

Real SideGroup::squared_distance(std::size_t a, std::size_t b) const {
  if (in_frame.empty()) return squared_norm(vectors[a].vector - vectors[b].vector);
  return squared_norm(in_frame[a].vector - in_frame[b].vector);
}

FramedCorner::FramedCorner(const SideCorner& of) : corner(of) {
  const CompensationPlane& plane = corner.plane;
  const Vector v1 = direction_of(corner.former);
  const Vector v2 = direction_of(corner.latter);
  if (!known_zero(cross(v1, v2)) || plane.has_rational_tool()) {
    frame = plane.frame();
    former = seen(plane, project(frame, v1), corner.former);
    latter = seen(plane, project(frame, v2), corner.latter);
    return;
  }
  // A line along a radius, or both arcs with theirs in one line, make corners of exactly 0, 90 or 180 degrees under any
  // tool: in a frame along them this is no matter of proof.
  frame = plane.frame_along(v2);
  const Real length = sqrt(squared_norm(plane.left(v2)) / plane.tool().norm2);
  const Real ratio = dot(v1, v2) / squared_norm(v2);
  former = seen(plane, PlanePoint{ratio * length, 0}, corner.former);
  latter = seen(plane, PlanePoint{length, 0}, corner.latter);
}

// Vectors square to a block have a simpler form than that in the frame.
SideGroup FramedCorner::lifted(VectorGroup group) const {
  SpaceGroup result;
  result.reserve(group.size());
  for (const CornerVector& v : group) {
    const Vector vector = v.former == Seat::square   ? perpendicular(corner.plane, corner.former)
                          : v.latter == Seat::square ? perpendicular(corner.plane, corner.latter)
                                                     : lift(frame, v.vector);
    result.push_back({vector, v.former, v.latter, false});
  }
  mark_stop(result);
  return {std::move(result), std::move(group)};
}

SpaceGroup way_round(CornerClass kind, const LineCorner& lines, bool with_former, bool with_latter) {
  auto group = model::way_round(kind, lines.former(), lines.latter(), with_former, with_latter);
  mark_stop(group);
  return group;
}

}  // namespace toolcomp::model
