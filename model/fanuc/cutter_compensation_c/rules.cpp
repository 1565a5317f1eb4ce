// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/cutter_compensation_c/rules.h"

#include <algorithm>

#include "model/basis/number.h"

namespace toolcomp::model {

// fanuc.cutter-c.which-rule: The group between A and B is made by the first of these rules that applies: r = 0; change
// of direction (rhoA = -rhoB and B is not a cancel block; after a start-up block this is an alarm); G41 or G42
// repeated; cancel with I J; cancel; start-up; corner of the offset mode.
std::optional<VectorGroup> CutterRules::by_first_rule(const CutterPlan& a, const CutterPlan& b, bool repeated) const {
  const PathEnd& former = a.path.end;
  const PathEnd& latter = b.path.start;
  const bool cancels = b.part == CutterPart::cancel;
  if (former.offset == 0) return square_to(recorder_, former);
  // fanuc.cutter-c.direction-change: If the side changes from A to B (G41 to G42 or back, or the sign of the value),
  // inner and outer corners are not told apart. If the offset paths of A and B have an intersection, the group is the
  // vector to it; if not, it is the vector perpendicular to B. A change of code in a block that does not move in the
  // plane counts in the next moving block.
  if (!cancels && recorder_.decide(Clause::fanuc_cutter_c_direction_change, a.offset.side != b.offset.side))
    return direction_change(recorder_, former, latter);
  // fanuc.cutter-c.repeated: If block B, or a block between A and B, has a word G41 or G42 equal to the code in force
  // before it, the group is P1 of A, at inner and outer corners alike. B starts from that vector. A may be the start-up
  // block, and B may be the cancel block. The rule does not apply while the mode is off, nor to the B of
  // fanuc.cutter-c.start-without-motion.
  if (repeated) {
    recorder_.reach(Clause::fanuc_cutter_c_repeated);
    return square_to(recorder_, former);
  }
  if (cancels) {
    // fanuc.cutter-c.cancel-direction: In a cancel block with the word G40, the letters of the plane among I J K give a
    // direction (I J in G17, K I in G18, J K in G19; a missing letter is 0). A line from A's end in that direction is
    // offset to A's side. The group is the intersection of A's offset path with that offset line, at inner and outer
    // corners alike. The letter outside the plane, and letters without the word G40, mean nothing.
    const bool directed = recorder_.decide(Clause::fanuc_cutter_c_cancel_direction, b.direction.has_value());
    if (directed) return cancel_along(former, *b.direction);
  }
  if (cancels || a.part == CutterPart::start_up) return start_or_cancel(former, latter, cancels);
  return offset_mode(recorder_, former, latter);
}

// fanuc.cutter-c.start-up-type: No. 5003 bit 0, SUP, chooses the type of start-up and cancel in blocks that move in the
// plane, whatever SUV is: 0 is type A, 1 is type B. With type A the group is P2 at start-up and P1 at cancel, whatever
// the corner; the corner is not classified.
CutterRules::CutterRules(const spec::Setup& setup, Recorder& recorder)
    : recorder_(recorder),
      type_b_(setup.bit(5003, 0)),
      smallest_move_(setup.parameter(5010) ? plain(*setup.parameter(5010)) : Rational(0)) {}

// fanuc.cutter-c.start-up-type: No. 5003 bit 0, SUP, chooses the type of start-up and cancel in blocks that move in the
// plane, whatever SUV is: 0 is type A, 1 is type B.
// fanuc.cutter-c.start-up-inner: At a start-up of type B with an inner corner, B straight on included, the group is P2.
// fanuc.cutter-c.start-up-obtuse: At a start-up of type B with an obtuse outer corner, the group is the vector
// perpendicular to the start-up block, then the intersection. If B is an arc, its perpendicular vector follows.
// fanuc.cutter-c.start-up-acute: At a start-up of type B with an acute outer corner (of two lines: from 1 degree on),
// the group is the vector perpendicular to the start-up block, then the two vectors of an acute corner. If B is an arc,
// its perpendicular vector follows.
// fanuc.cutter-c.cancel-inner: At a cancel of type B with an inner corner, B straight on included, the group is P1.
// fanuc.cutter-c.cancel-obtuse: At a cancel of type B with an obtuse outer corner, the group is the intersection, then
// the vector perpendicular to the cancel block. If A is an arc, its perpendicular vector comes first.
// fanuc.cutter-c.cancel-acute: At a cancel of type B with an acute outer corner (of two lines: from 1 degree on), the
// group is the two vectors of an acute corner, then the vector perpendicular to the cancel block. If A is an arc, its
// perpendicular vector comes first.
VectorGroup CutterRules::start_or_cancel(const PathEnd& former, const PathEnd& latter, bool cancels) const {
  const auto alone = [&]() -> VectorGroup { return {cancels ? square_to_former(former) : square_to_latter(latter)}; };
  if (!recorder_.decide(Clause::fanuc_cutter_c_start_up_type, type_b_)) return alone();
  const CornerClass kind = classify(recorder_, former, latter);
  const bool of_line = !(cancels ? former : latter).is_arc();
  if (kind == CornerClass::acute && of_line && is_under_one_degree(recorder_, former, latter)) return alone();
  if (kind == CornerClass::inner || kind == CornerClass::straight) {
    recorder_.reach(cancels ? Clause::fanuc_cutter_c_cancel_inner : Clause::fanuc_cutter_c_start_up_inner);
    return alone();
  }
  if (kind == CornerClass::obtuse)
    recorder_.reach(cancels ? Clause::fanuc_cutter_c_cancel_obtuse : Clause::fanuc_cutter_c_start_up_obtuse);
  else
    recorder_.reach(cancels ? Clause::fanuc_cutter_c_cancel_acute : Clause::fanuc_cutter_c_start_up_acute);
  return way_round(kind, tangent(former), tangent(latter), !cancels || former.is_arc(), cancels || latter.is_arc());
}

// fanuc.cutter-c.cancel-direction-parallel: If the direction given with G40 makes no intersection (it is parallel to
// A's end tangent in either sense, R' < 0, or A is an arc that the line does not meet), the group is P1. PS0033 is not
// raised.
VectorGroup CutterRules::cancel_along(const PathEnd& former, const PlanePoint& direction) const {
  const PathEnd line{heading(direction), 0, former.offset};
  const Sign turn =
      recorder_.decide(Clause::fanuc_cutter_c_cancel_direction_parallel,
                       cross(former.heading.along, line.heading.along), former.heading.length * line.heading.length);
  if (turn != Sign::zero && have_offset_paths(recorder_, former, line))
    if (const auto meeting = paths_meet(recorder_, former, line)) return {{*meeting, Seat::on, Seat::on}};
  return {square_to_former(former)};
}

// fanuc.cutter-c.small-corner-movement: A vector of a group is dropped if it differs from the last vector kept by at
// most the limit, No. 5010, both in the first and in the second axis of the plane. The limit is in setup units. It is 0
// if it is not given, and nothing is dropped if it is negative. The vectors are taken in the order of the group,
// start-up and cancel included, and the first vector always stays. The first axis is asked, then the second. An arc B
// that starts at a head not on its offset circle runs as a spiral.
void CutterRules::drop_small_movements(VectorGroup& group, const OffsetPath& latter) const {
  if (group.size() < 2) return;
  if (latter.is_arc()) {
    const Heading& from = latter.start.heading;
    const Heading& to = latter.end.heading;
    if (!is_under_half_circle(recorder_, latter.start.turn, from.along, to.along, from.length * to.length)) return;
  }
  if (smallest_move_ < 0) return;
  // From both sides. The scale is the length of the heads, not that of their difference: heads that nearly coincide are
  // told apart no better than each of them is known. A head of a group is at most the diagonal of the square of the
  // offset long.
  const Rational scale = smallest_move_ + 4 * abs(latter.start.offset);
  const auto within = [&](const Real& margin) {
    return recorder_.decide(Clause::fanuc_cutter_c_small_corner_movement, margin, scale) != Sign::negative;
  };
  const auto is_small = [&](const Real& component) {
    return within(smallest_move_ - component) && within(smallest_move_ + component);
  };
  VectorGroup kept{group.front()};
  for (std::size_t i = 1; i < group.size(); ++i)
    if (!std::ranges::all_of(group[i].vector - kept.back().vector, is_small)) kept.push_back(group[i]);
  group = kept;
}

}  // namespace toolcomp::model
