// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_side_compensation/rules.h"

#include <utility>

namespace toolcomp::model {

// fanuc.cutter-c.value-zero: If r = 0, the group is the zero vector alone, whatever the corner and No. 5010. There are
// then no corner moves, not even before an arc of 180 degrees or more.
SpaceGroup SideRules::square_to(const SideEnd& former) const {
  if (former.offset != 0) return {{perpendicular(former), Seat::square, Seat::off, false}};
  recorder_.reach(Clause::fanuc_cutter_c_value_zero);
  return {{{}, Seat::square, Seat::square, false}};
}

// fanuc.tool-side.plane: The vectors at the end of a block lie in the plane perpendicular to the tool direction there,
// even if the rotary axes turn in that block or in the next one. Both blocks of a corner are seen in the plane at the
// end of the first block.
// fanuc.tool-side.stop-point: Corner moves before the single-block stop point S run at the feed of the block before,
// corner moves after S at the feed of the next block. S is the head of Vi, or of K1 (ours).
SpaceGroup SideRules::in_plane(SpaceGroup group) const {
  recorder_.reach(Clause::fanuc_tool_side_plane);
  for (std::size_t i = 1; i < group.size(); ++i)
    recorder_.decide(Clause::fanuc_tool_side_stop_point, !group[i].after_stop);
  return group;
}

std::optional<SideGroup> SideRules::in_mode(const SideCorner& corner) const {
  if (!corner.of_lines()) {
    const FramedCorner framed(corner);
    const auto group = offset_mode(recorder_, framed.former, framed.latter);
    return group ? std::optional(framed.lifted(*group)) : std::nullopt;
  }
  const CornerClass kind = classify(recorder_, corner);
  // fanuc.tool-side.inner: At an inner corner of two lines, straight on included, nothing is inserted: the group is the
  // intersection of the offset lines, however long the vector is.
  //
  // Straight on Vi is r n1, a simpler form.
  if (kind == CornerClass::inner || kind == CornerClass::straight) {
    recorder_.reach(Clause::fanuc_tool_side_inner);
    return one(kind == CornerClass::inner ? tangents_meet(corner.former, corner.latter) : perpendicular(corner.former));
  }
  // fanuc.tool-side.outer-obtuse: At an obtuse outer corner of two lines the group is the intersection of the offset
  // lines.
  // fanuc.tool-side.outer-acute: At an acute outer corner of two lines, straight back included, both offset lines are
  // prolonged by r and joined by a straight inserted move, never an arc.
  recorder_.reach(kind == CornerClass::obtuse ? Clause::fanuc_tool_side_outer_obtuse
                                              : Clause::fanuc_tool_side_outer_acute);
  return way_round(kind, corner, false, false);
}

// fanuc.tool-side.type-b: No. 5003 bit 0, SUP, chooses the type: 0 is type A, 1 is type B.
SideGroup SideRules::start_or_cancel(const SideCorner& corner, bool cancels) const {
  const auto alone = [&] { return cancels ? square_to(corner.former) : square_to_latter(corner.latter); };
  if (!recorder_.decide(Clause::fanuc_tool_side_type_b, setup_.bit(5003, 0))) return alone();
  const auto framed = corner.of_lines() ? std::nullopt : std::optional<FramedCorner>(corner);
  const CornerClass kind = framed ? classify(recorder_, framed->former, framed->latter) : classify(recorder_, corner);
  if (!framed && kind == CornerClass::acute && is_under_one_degree(recorder_, corner)) return alone();
  // fanuc.tool-side.start-up-inner: At a start-up of type B with an inner corner, straight on included, the group is
  // the vector perpendicular to the next block.
  // fanuc.tool-side.cancel-inner: At a cancel of type B with an inner corner, straight on included, the group is the
  // vector perpendicular to the last compensated block.
  if (kind == CornerClass::inner || kind == CornerClass::straight) {
    recorder_.reach(cancels ? Clause::fanuc_tool_side_cancel_inner : Clause::fanuc_tool_side_start_up_inner);
    return alone();
  }
  // fanuc.tool-side.start-up-obtuse: At a start-up of type B with an obtuse outer corner, the group is the vector
  // perpendicular to the start-up block (fanuc.tool-side.type-b-perpendicular), then the intersection. If B is an arc,
  // its perpendicular vector follows.
  // fanuc.tool-side.start-up-acute: At a start-up of type B with an acute outer corner, the group is the vector
  // perpendicular to the start-up block (fanuc.tool-side.type-b-perpendicular), then the two vectors of an acute
  // corner. If B is an arc, its perpendicular vector follows.
  // fanuc.tool-side.cancel-obtuse: At a cancel of type B with an obtuse outer corner, the group is the intersection,
  // then the vector perpendicular to the cancel block (fanuc.tool-side.type-b-perpendicular). If A is an arc, its
  // perpendicular vector comes first.
  // fanuc.tool-side.cancel-acute: At a cancel of type B with an acute outer corner, the group is the two vectors of an
  // acute corner, then the vector perpendicular to the cancel block (fanuc.tool-side.type-b-perpendicular). If A is an
  // arc, its perpendicular vector comes first.
  if (kind == CornerClass::obtuse)
    recorder_.reach(cancels ? Clause::fanuc_tool_side_cancel_obtuse : Clause::fanuc_tool_side_start_up_obtuse);
  else
    recorder_.reach(cancels ? Clause::fanuc_tool_side_cancel_acute : Clause::fanuc_tool_side_start_up_acute);
  // fanuc.tool-side.type-b-perpendicular: At a start-up or cancel of type B with an outer corner, the vector
  // perpendicular to the start-up or cancel block is made, as in chapter 14.
  const bool own = recorder_.decide(Clause::fanuc_tool_side_type_b_perpendicular, !setup_.type_b_without_perpendicular);
  const bool with_former = cancels ? corner.former.is_arc() : own;
  const bool with_latter = cancels ? own : corner.latter.is_arc();
  if (!framed) return way_round(kind, corner, with_former, with_latter);
  return framed->lifted(
      model::way_round(kind, tangent(framed->former), tangent(framed->latter), with_former, with_latter));
}

// fanuc.tool-side.which-rule: The group between A and B is made by the first of these rules that applies: r = 0
// (fanuc.cutter-c.value-zero); an alarm of fanuc.cutter-c.direction-change-at-start-up; Q1 of A; change of side;
// repeated code; start-up block followed by the cancel block; cancel; start-up; corner of the mode, then Q2 of A.
std::optional<SideGroup> SideRules::by_first_rule(const SideCorner& corner, const SideCase& given) const {
  if (corner.former.offset == 0) return square_to(corner.former);
  // fanuc.tool-side.q1: With Q1 in block A, the vector at its end is the one perpendicular to A, whether an
  // interference is found or not, even at a change of side.
  if (given.treatment == 1) {
    recorder_.reach(Clause::fanuc_tool_side_q1);
    return square_to(corner.former);
  }
  // fanuc.cutter-c.direction-change: If the side changes from A to B (G41 to G42 or back, or the sign of the value),
  // inner and outer corners are not told apart. If the offset paths of A and B have an intersection, the group is the
  // vector to it; if not, it is the vector perpendicular to B.
  if (!given.cancels && recorder_.decide(Clause::fanuc_cutter_c_direction_change, given.side_changes))
    return side_change(corner);
  // fanuc.tool-side.repeated: If block B, or a block between A and B (also one with a corner of its own), has a word
  // equal to the code in force before it, the group is the vector perpendicular to A, at inner and outer corners alike.
  // B starts from that vector.
  // fanuc.tool-side.start-then-cancel: If B of a start-up block of type A or B is the cancel block, the group at the
  // end of the start-up block is the vector perpendicular to the start-up block, whatever the type.
  if (given.repeated || (given.starts && given.cancels)) {
    recorder_.reach(given.repeated ? Clause::fanuc_tool_side_repeated : Clause::fanuc_tool_side_start_then_cancel);
    return square_to(corner.former);
  }
  if (given.cancels || given.starts) return start_or_cancel(corner, given.cancels);
  std::optional<SideGroup> group = in_mode(corner);
  // fanuc.tool-side.q2: With Q2 in block A, the second of the two vectors between two lines is deleted.
  if (group && given.treatment == 2 &&
      recorder_.decide(Clause::fanuc_tool_side_q2, corner.of_lines() && group->vectors.size() == 2))
    group->vectors.pop_back();
  return group;
}

// fanuc.tool-side.which-rule: The group between A and B is made by the first of these rules that applies: r = 0
// (fanuc.cutter-c.value-zero); an alarm of fanuc.cutter-c.direction-change-at-start-up; Q1 of A; change of side;
// repeated code; start-up block followed by the cancel block; cancel; start-up; corner of the mode, then Q2 of A. Then
// vectors are dropped (fanuc.tool-side.small-difference). Then A is checked, first for a plane change (not if r = 0),
// then for interference.
std::optional<SideGroup> SideRules::group(const SideCorner& corner, const SideCase& given) const {
  std::optional<SideGroup> group = by_first_rule(corner, given);
  if (!group || corner.former.offset == 0) return group;
  // fanuc.tool-side.q3: With Q3 in block A, all vectors are kept, and the alarm of fanuc.tool-side.plane-change-alarm
  // is not raised. It is not raised with Q1 or Q2 either.
  if (given.treatment == 3) recorder_.reach(Clause::fanuc_tool_side_q3);
  drop_small_differences(*group, corner.former.offset, given.next_arc);
  return group;
}

// fanuc.tool-side.side-change: The side may change without G40, by the code or by the sign of the value. This is as in
// cutter compensation C, in the compensation plane: fanuc.cutter-c.direction-change and its clauses on lines, parallel
// tangents, arcs and paths that do not meet. For lines that are not parallel in the plane, the group is the
// intersection of A's offset line and B's; for parallel lines it is the vector perpendicular to B.
SideGroup SideRules::side_change(const SideCorner& corner) const {
  if (!corner.of_lines()) {
    const FramedCorner framed(corner);
    return framed.lifted(direction_change(recorder_, framed.former, framed.latter));
  }
  if (is_parallel(recorder_, corner)) {
    // fanuc.cutter-c.direction-change-without-intersection: At a change of direction without intersection (parallel
    // tangents, R' < 0, or paths that do not meet), the group is the vector perpendicular to B at its start.
    recorder_.reach(Clause::fanuc_cutter_c_direction_change_without_intersection);
    return square_to_latter(corner.latter);
  }
  // fanuc.cutter-c.direction-change-lines: Two lines at an angle always have an intersection, however far away.
  recorder_.reach(Clause::fanuc_cutter_c_direction_change_lines);
  return one(tangents_meet(corner.former, corner.latter));
}

// fanuc.tool-side.small-difference: A vector of a group is dropped if its distance from the last vector kept is no more
// than the limit, No. 5010. The limit is in setup units. It is 0 if it is not given, and nothing is dropped if it is
// negative. The vectors are taken in the order of the group, start-up and cancel included, and the first vector always
// stays.
void SideRules::drop_small_differences(SideGroup& group, const Rational& offset,
                                       const std::optional<SideArc>& next_arc) const {
  if (group.vectors.size() < 2) return;
  if (next_arc) {
    const ArcEnds& ends = next_arc->ends;
    if (!is_under_half_circle(recorder_, ends.turn, ends.start, ends.end,
                              sqrt(squared_norm(ends.start) * squared_norm(ends.end))))
      return;
  }
  if (limit_ < 0) return;
  const Rational limit2 = limit_ * limit_;
  const Rational scale = limit2 + 8 * offset * offset;
  SpaceGroup kept{group.vectors.front()};
  for (std::size_t i = 1, last = 0; i < group.vectors.size(); ++i) {
    const Real apart2 = group.in_frame.empty() ? squared_norm(group.vectors[i].vector - group.vectors[last].vector)
                                               : squared_norm(group.in_frame[i].vector - group.in_frame[last].vector);
    if (recorder_.decide(Clause::fanuc_tool_side_small_difference, limit2 - apart2, scale) != Sign::negative) continue;
    kept.push_back(group.vectors[i]);
    last = i;
  }
  group.vectors = std::move(kept);
}

}  // namespace toolcomp::model
