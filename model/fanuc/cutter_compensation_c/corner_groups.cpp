// SPDX-License-Identifier: Apache-2.0
// The vectors at the end of a block held.
#include "model/fanuc/cutter_compensation_c/cutter_compensation_c.h"

namespace toolcomp::model {

SpaceGroup CutterCompensationC::without_corner(const Held& held) {
  return in_space(said(held.step).plane, rules_.square_to(path_of(held).end));
}

SpaceGroup CutterCompensationC::vector_of_start(Held& held, const PathEnd& next) {
  // fanuc.cutter-c.start-without-motion: If SUV = 1, the mode is off, and a block that does not move in the plane has
  // the word G41 or G42 and a number other than 0 in force at its end, the tool moves by P2 of the next moving block B.
  // P2 has the value in force at the end of the G41 or G42 block; the cause is start-up.
  recorder().reach(Clause::fanuc_cutter_c_start_without_motion);
  see_move_alone(held.step, held.offset.distance != 0);
  return in_space(said(held.step).plane, {square_to_latter(next)});
}

SpaceGroup CutterCompensationC::group_before(const Held& held, const CutterBlock& next, const OffsetPath& path,
                                             const CutterOffset& offset) {
  const bool directed = next.code == CutterSide::none && next.direction && !is_zero(*next.direction);
  const CutterCorner corner{.former = path_of(held).end,
                            .latter = path,
                            .starts = held.kind == Held::Kind::start_up,
                            .side_changes = held.offset.side != offset.side,
                            .repeated = held.repeated,
                            .cancels = !wanted(next),
                            .direction = directed ? next.direction : std::nullopt};
  // fanuc.cutter-c.value-at-a-corner: A new number or value counts for the vectors at the end of the moving block that
  // has it, or, if that block does not move, at the end of the next moving block.
  if (!corner.cancels) recorder().decide(Clause::fanuc_cutter_c_value_at_a_corner, offset.value != held.offset.value);
  const auto group = rules_.group(corner);
  // fanuc.cutter-c.no-intersection: An inner corner with an arc and R' >= 0 whose offset paths do not meet raises
  // PS0033. The alarm names A. Neither A nor a corner move of A is given, and the blocks before A are given as computed
  // with A present.
  if (!group) ahead_.raise_held(Clause::fanuc_cutter_c_no_intersection, AlarmCause::no_intersection);
  return in_space(said(held.step).plane, *group);
}

}  // namespace toolcomp::model
