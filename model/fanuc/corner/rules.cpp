// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/corner/corner.h"

namespace toolcomp::model {

// fanuc.cutter-c.value-zero: If r = 0, the group is the zero vector alone, whatever the corner and No. 5010. There are
// then no corner moves, not even before an arc of 180 degrees or more. A start-up and a cancel with r = 0 keep their
// causes.
//
// It stands square to everything.
VectorGroup square_to(Recorder& recorder, const PathEnd& former) {
  if (former.offset != 0) return {square_to_former(former)};
  recorder.reach(Clause::fanuc_cutter_c_value_zero);
  return {{{}, Seat::square, Seat::square}};
}

std::optional<VectorGroup> offset_mode(Recorder& recorder, const PathEnd& former, const PathEnd& latter) {
  const CornerClass kind = classify(recorder, former, latter);
  // fanuc.cutter-c.tangent-join: If B goes straight on, the group is P1, for lines and arcs alike.
  if (kind == CornerClass::straight) {
    recorder.reach(Clause::fanuc_cutter_c_tangent_join);
    return VectorGroup{{perpendicular(former), Seat::square, Seat::square}};
  }
  // fanuc.cutter-c.outer-obtuse: At an obtuse outer corner the group has the intersection of the offset tangents. The
  // perpendicular vector of an arc A comes before it, that of an arc B after it.
  // fanuc.cutter-c.outer-acute: At an acute outer corner both offset tangents are prolonged by r, and a straight move
  // joins their ends. The perpendicular vector of an arc A comes before these two vectors, that of an arc B after
  // them.
  if (kind != CornerClass::inner) {
    recorder.reach(kind == CornerClass::obtuse ? Clause::fanuc_cutter_c_outer_obtuse
                                               : Clause::fanuc_cutter_c_outer_acute);
    return way_round(kind, tangent(former), tangent(latter), former.is_arc(), latter.is_arc());
  }
  // fanuc.cutter-c.inner-lines: At an inner corner of two lines the group is the intersection of the offset lines,
  // however long the vector is.
  if (!former.is_arc() && !latter.is_arc()) recorder.reach(Clause::fanuc_cutter_c_inner_lines);
  // fanuc.cutter-c.offset-radius-at-a-corner: An intersection with an arc needs an offset circle. For an arc A this is
  // the circle about its centre with R' at the end of A, for an arc B with R' at the start of B, each with its own rho.
  // If R' < 0, there is no circle to meet. At an inner corner the group is then P1 of A, without an alarm. At a change
  // of direction the rule without intersection applies, and with G40 I J the group is P1.
  if (!have_offset_paths(recorder, former, latter)) return VectorGroup{square_to_former(former)};
  const auto meeting = paths_meet(recorder, former, latter);
  if (!meeting) return std::nullopt;
  return VectorGroup{{*meeting, Seat::on, Seat::on}};
}

// fanuc.cutter-c.direction-change: If the side changes from A to B (G41 to G42 or back, or the sign of the value),
// inner and outer corners are not told apart. If the offset paths of A and B have an intersection, the group is the
// vector to it; if not, it is the vector perpendicular to B.
VectorGroup direction_change(Recorder& recorder, const PathEnd& former, const PathEnd& latter) {
  // fanuc.cutter-c.direction-change-parallel: At a change of direction, paths with parallel tangents count as paths
  // without intersection. This holds straight on and straight back, for lines and arcs, even if the offset circles
  // would meet. If B goes straight back, the two perpendicular vectors are the same.
  const Sign turn =
      recorder.decide(Clause::fanuc_cutter_c_direction_change_parallel,
                      cross(former.heading.along, latter.heading.along), former.heading.length * latter.heading.length);
  if (turn != Sign::zero && have_offset_paths(recorder, former, latter)) {
    if (const auto meeting = paths_meet(recorder, former, latter)) {
      // fanuc.cutter-c.direction-change-lines: Two lines at an angle always have an intersection, however far away.
      // fanuc.cutter-c.direction-change-arcs: At a change of direction with an arc, the intersection is that of
      // fanuc.cutter-c.line-arc-point or fanuc.cutter-c.arc-arc-point, each block with its own rho.
      const bool lines = !former.is_arc() && !latter.is_arc();
      recorder.reach(lines ? Clause::fanuc_cutter_c_direction_change_lines
                           : Clause::fanuc_cutter_c_direction_change_arcs);
      return {{*meeting, Seat::on, Seat::on}};
    }
  }
  // fanuc.cutter-c.direction-change-without-intersection: At a change of direction without intersection (parallel
  // tangents, R' < 0, or paths that do not meet), the group is the vector perpendicular to B at its start. PS0033 is
  // not raised. An arc A then runs to that head.
  recorder.reach(Clause::fanuc_cutter_c_direction_change_without_intersection);
  return {square_to_latter(latter)};
}

// fanuc.cutter-c.small-corner-before-half-circle: No. 5010 drops nothing from a group of several vectors before an arc
// B whose programmed sweep is 180 degrees or more (a whole turn included).
//
// The sweep is 180° or more where its sine is not positive; a whole turn too.
bool is_under_half_circle(Recorder& recorder, int turn, const PlanePoint& start, const PlanePoint& end,
                          const Real& radii) {
  return recorder.decide(Clause::fanuc_cutter_c_small_corner_before_half_circle, Real(turn) * cross(start, end),
                         radii) == Sign::positive;
}

}  // namespace toolcomp::model
