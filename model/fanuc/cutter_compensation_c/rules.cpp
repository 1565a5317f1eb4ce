// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/cutter_compensation_c/rules.h"

#include <algorithm>

#include "model/basis/number.h"

namespace toolcomp::model {

// fanuc.cutter-c.which-rule: The group between A and B is made by the first rule that applies: r = 0; change of
// direction (rhoA = -rhoB, B is no cancel block; after a start-up block an alarm); G41 or G42 repeated; cancel with I
// J; cancel; start-up; corner of the offset mode.
std::optional<VectorGroup> CutterRules::by_first_rule(const CutterCorner& corner) const {
  const PathEnd& former = corner.former;
  const PathEnd& latter = corner.latter.start;
  if (former.offset == 0) return square_to(former);
  // fanuc.cutter-c.direction-change: Where the side changes from A to B (G41 to G42 or back, or the sign of the value)
  // inner and outer are not told apart: with an intersection of A's offset path and B's the group is its vector,
  // without one it is the vector perpendicular to B. A change of code in a block that does not move in the plane counts
  // in the next moving block.
  if (!corner.cancels && recorder().decide(Clause::fanuc_cutter_c_direction_change, corner.side_changes))
    return direction_change(former, latter);
  // fanuc.cutter-c.repeated: A word G41 or G42 equal to the code in force before it, in block B or in a block between A
  // and B, gives P1 of A, inner and outer alike; B starts from it. A may be the start-up block, B the cancel block. It
  // does not concern a mode that is off, nor the B of fanuc.cutter-c.start-without-motion.
  if (corner.repeated) {
    recorder().reach(Clause::fanuc_cutter_c_repeated);
    return square_to(former);
  }
  if (!corner.cancels) return corner.starts ? start_up(former, latter) : offset_mode(former, latter);
  // fanuc.cutter-c.cancel-direction: A cancel block with the word G40 and the letters of the plane among I J K (I J in
  // G17, K I in G18, J K in G19; a missing one is 0): a line from A's end in that direction is offset to A's side, and
  // the group is the intersection of A's offset path with it, inner and outer alike. The other letter, and letters
  // without the word G40, mean nothing.
  const bool directed = recorder().decide(Clause::fanuc_cutter_c_cancel_direction, corner.direction.has_value());
  return directed ? cancel_along(former, *corner.direction) : cancel(former, latter);
}

// fanuc.cutter-c.corner-movement: A ends at the first head of the group. The straight moves between its heads belong to
// B: cause corner, rapid where G00 is in force in B, else linear, with B's feed, tool direction, length offset and
// other axes as before B; they carry no machine coordinates, also before G28.
std::optional<VectorGroup> CutterRules::group(const CutterCorner& corner) const {
  std::optional<VectorGroup> group = by_first_rule(corner);
  if (!group) return std::nullopt;
  drop_small_movements(*group, corner.latter);
  recorder().decide(Clause::fanuc_cutter_c_corner_movement, group->size() > 1);
  return group;
}

// fanuc.cutter-c.start-up-type: No. 5003 bit 0, SUP, chooses start-up and cancel in blocks that move in the plane,
// whatever SUV: 0 type A, 1 type B. Type A: the group is P2 at start-up and P1 at cancel, whatever the corner, which is
// not classified.
CutterRules::CutterRules(const spec::Setup& setup, Recorder& recorder)
    : CornerRules(recorder),
      type_b_(setup.bit(5003, 0)),
      limit_(setup.parameter(5010) ? plain(*setup.parameter(5010)) : Rational(0)) {}

// fanuc.cutter-c.start-up-type: No. 5003 bit 0, SUP, chooses start-up and cancel in blocks that move in the plane,
// whatever SUV: 0 type A, 1 type B.
std::optional<CornerClass> CutterRules::detour(const PathEnd& former, const PathEnd& latter, bool to_line) const {
  if (!recorder().decide(Clause::fanuc_cutter_c_start_up_type, type_b_)) return std::nullopt;
  const CornerClass kind = classify(recorder(), former, latter);
  if (kind == CornerClass::acute && to_line && is_under_one_degree(recorder(), former, latter)) return std::nullopt;
  return kind;
}

// fanuc.cutter-c.start-up-inner: Type B at an inner corner, B straight on included: P2.
// fanuc.cutter-c.start-up-obtuse: Type B at an obtuse outer corner: the vector perpendicular to the start-up block, the
// intersection, and before an arc its perpendicular vector.
// fanuc.cutter-c.start-up-acute: Type B at an acute outer corner (two lines: from 1 degree on): the vector
// perpendicular to the start-up block, the two prolonged ones, and before an arc its perpendicular vector.
VectorGroup CutterRules::start_up(const PathEnd& former, const PathEnd& latter) const {
  const auto kind = detour(former, latter, !latter.is_arc());
  if (!kind) return {square_to_latter(latter)};
  if (*kind == CornerClass::inner || *kind == CornerClass::straight) {
    recorder().reach(Clause::fanuc_cutter_c_start_up_inner);
    return {square_to_latter(latter)};
  }
  recorder().reach(*kind == CornerClass::obtuse ? Clause::fanuc_cutter_c_start_up_obtuse
                                                : Clause::fanuc_cutter_c_start_up_acute);
  return way_round(*kind, former, latter, true, latter.is_arc());
}

// fanuc.cutter-c.cancel-inner: Type B at an inner corner, B straight on included: P1.
// fanuc.cutter-c.cancel-obtuse: Type B at an obtuse outer corner: the intersection and the vector perpendicular to the
// cancel block, behind an arc its perpendicular vector first.
// fanuc.cutter-c.cancel-acute: Type B at an acute outer corner (two lines: from 1 degree on): the two prolonged vectors
// and the one perpendicular to the cancel block, behind an arc its perpendicular vector first.
VectorGroup CutterRules::cancel(const PathEnd& former, const PathEnd& latter) const {
  const auto kind = detour(former, latter, !former.is_arc());
  if (!kind) return {square_to_former(former)};
  if (*kind == CornerClass::inner || *kind == CornerClass::straight) {
    recorder().reach(Clause::fanuc_cutter_c_cancel_inner);
    return {square_to_former(former)};
  }
  recorder().reach(*kind == CornerClass::obtuse ? Clause::fanuc_cutter_c_cancel_obtuse
                                                : Clause::fanuc_cutter_c_cancel_acute);
  return way_round(*kind, former, latter, former.is_arc(), true);
}

// fanuc.cutter-c.cancel-direction-parallel: Where there is no such intersection (direction parallel to A's end tangent
// in either sense, R' < 0, an arc the line does not meet) the group is P1; no PS0033.
VectorGroup CutterRules::cancel_along(const PathEnd& former, const PlanePoint& direction) const {
  PathEnd line;
  line.heading = heading(direction);
  line.offset = former.offset;
  const Sign turn =
      recorder().decide(Clause::fanuc_cutter_c_cancel_direction_parallel,
                        cross(former.heading.along, line.heading.along), former.heading.length * line.heading.length);
  if (turn != Sign::zero && have_offset_paths(recorder(), former, line))
    if (const auto meeting = paths_meet(recorder(), former, line)) return {{*meeting, Seat::on, Seat::on}};
  return {square_to_former(former)};
}

// fanuc.cutter-c.small-corner-movement: No. 5010 (setup units, 0 where not given, nothing is dropped where it is
// negative): going along a group, start-up and cancel included, a vector that differs from the last one kept by at most
// the limit in the first and in the second axis of the plane is dropped; the first vector always stays. Asked of the
// first axis, then of the second. An arc B that starts at a head not on its offset circle runs as a spiral.
void CutterRules::drop_small_movements(VectorGroup& group, const OffsetPath& latter) const {
  if (group.size() < 2) return;
  if (latter.is_arc()) {
    const Heading& from = latter.start.heading;
    const Heading& to = latter.end.heading;
    if (!is_under_half_circle({from.along, to.along, latter.start.turn, {}, true}, from.length * to.length)) return;
  }
  if (limit_ < 0) return;
  VectorGroup kept{group.front()};
  for (std::size_t i = 1; i < group.size(); ++i)
    if (!is_small(group[i].vector - kept.back().vector, latter.start.offset)) kept.push_back(group[i]);
  group = kept;
}

// fanuc.cutter-c.small-corner-movement: No. 5010 (setup units, 0 where not given, nothing is dropped where it is
// negative): going along a group, start-up and cancel included, a vector that differs from the last one kept by at most
// the limit in the first and in the second axis of the plane is dropped; the first vector always stays.
//
// From both sides. The scale is the length of the heads, not that of their difference: heads that nearly coincide are
// told apart no better than each of them is known. A head of a group is at most the diagonal of the square of the
// offset long.
bool CutterRules::is_small(const PlanePoint& movement, const Rational& offset) const {
  const Rational scale = limit_ + 4 * abs(offset);
  const auto within = [&](const Real& margin) {
    return recorder().decide(Clause::fanuc_cutter_c_small_corner_movement, margin, scale) != Sign::negative;
  };
  return std::ranges::all_of(
      movement, [&](const Real& component) { return within(limit_ - component) && within(limit_ + component); });
}

}  // namespace toolcomp::model
