// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_side_compensation/side_corner.h"

namespace toolcomp::model {
namespace {

// S, of travels that are often rational, and C.
Real turn_of(const SideCorner& c) { return dot(c.plane.tool.vector, cross(c.former.direction, c.latter.direction)); }
Real ahead_of(const SideCorner& c) { return dot(c.former.left, c.latter.left); }
// |VT| |U1| |U2|, or |VT|² |U1| |U2|: what S and C are measured against.
Real travels2(const SideCorner& c) { return squared_norm(c.former.direction) * squared_norm(c.latter.direction); }
Real scale_of_turn(const SideCorner& c) { return sqrt(c.plane.tool.norm2 * travels2(c)); }
Real scale_ahead(const SideCorner& c) { return c.plane.tool.norm2 * sqrt(travels2(c)); }

// The stop point is the head of the intersection or of the first vector of an acute corner: the first head, or the one
// behind the vector that stands square to the former block.
void mark_stop(SpaceGroup& group) {
  const std::size_t stop = group.front().former == Seat::square ? 1 : 0;
  for (std::size_t i = stop + 1; i < group.size(); ++i) group[i].after_stop = true;
}

bool is_rational(const Vector& v) { return v.x.is_rational() && v.y.is_rational() && v.z.is_rational(); }

}  // namespace

CornerClass classify(Recorder& recorder, const SideCorner& lines) {
  const Real turn = turn_of(lines);
  // fanuc.tool-side.corner-side: A corner of two lines is inner if their angle on the side of the workpiece, in the
  // compensation plane, is over 180 degrees, and outer if it is under 180 degrees. Exactly 180 degrees is inner.
  const Sign side = recorder.decide(Clause::fanuc_tool_side_corner_side, lines.former.offset > 0 ? turn : -turn,
                                    scale_of_turn(lines));
  if (side == Sign::positive) return CornerClass::inner;
  const bool parallel = side == Sign::zero;
  // fanuc.tool-side.straight-or-reversal: If S = 0 (fanuc.tool-side.corner-side) and B goes straight on, the corner is
  // an inner corner of 180 degrees. If B goes straight back, it is an outer acute corner of 0 degrees, and the tool
  // goes round the end.
  // fanuc.tool-side.obtuse-or-acute: An outer corner of two lines is obtuse from 90 degrees on and acute below, in the
  // compensation plane. To which class 90 degrees belongs makes no difference to the path.
  const Clause clause =
      parallel ? Clause::fanuc_tool_side_straight_or_reversal : Clause::fanuc_tool_side_obtuse_or_acute;
  const Sign ahead = recorder.decide(clause, ahead_of(lines), scale_ahead(lines));
  if (ahead == Sign::negative) return CornerClass::acute;
  return parallel ? CornerClass::straight : CornerClass::obtuse;
}

bool is_parallel(Recorder& recorder, const SideCorner& lines) {
  // fanuc.cutter-c.direction-change-parallel: At a change of direction, paths with parallel tangents count as paths
  // without intersection. This holds straight on and straight back, for lines and arcs, even if the offset circles
  // would meet. If B goes straight back, the two perpendicular vectors are the same.
  return recorder.decide(Clause::fanuc_cutter_c_direction_change_parallel, turn_of(lines), scale_of_turn(lines)) ==
         Sign::zero;
}

bool is_under_one_degree(Recorder& recorder, const SideCorner& lines) {
  return is_under_one_degree(recorder, lines.plane.tool.norm2 * square(turn_of(lines)), square(ahead_of(lines)));
}

SpaceGroup way_round(CornerClass kind, const SideCorner& lines, bool with_former, bool with_latter) {
  auto group = model::way_round(kind, lines.former, lines.latter, with_former, with_latter);
  mark_stop(group);
  return group;
}

FramedCorner::FramedCorner(const SideCorner& of) : corner(of) {
  const CompensationPlane& plane = corner.plane;
  const Vector& v1 = corner.former.direction;
  const Vector& v2 = corner.latter.direction;
  if (!known_zero(cross(v1, v2)) || is_rational(plane.tool.vector)) {
    frame = plane.frame();
    former = seen(frame, corner.former);
    latter = seen(frame, corner.latter);
    return;
  }
  // A line along a radius, or both arcs with theirs in one line, make corners of exactly 0, 90 or 180 degrees under any
  // tool: in a frame along them this is no matter of proof.
  frame = plane.frame_along(v2);
  const Real length = sqrt(squared_norm(plane.left(v2)) / plane.tool.norm2);
  const Real ratio = dot(v1, v2) / squared_norm(v2);
  former = seen(PlanePoint{ratio * length, 0}, corner.former);
  latter = seen(PlanePoint{length, 0}, corner.latter);
}

// Vectors square to a block have a simpler form than that in the frame.
SideGroup FramedCorner::lifted(VectorGroup group) const {
  SpaceGroup result;
  for (const CornerVector& v : group) {
    const Vector vector = v.former == Seat::square   ? perpendicular(corner.former)
                          : v.latter == Seat::square ? perpendicular(corner.latter)
                                                     : v.vector[0] * frame.first + v.vector[1] * frame.second;
    result.push_back({vector, v.former, v.latter, false});
  }
  mark_stop(result);
  return {std::move(result), std::move(group)};
}

}  // namespace toolcomp::model
