// SPDX-License-Identifier: Apache-2.0
// The vectors at the end of a block held.
#include "model/fanuc/tool_side_compensation/tool_side_compensation.h"

namespace toolcomp::model {

SpaceGroup ToolSideCompensation::without_corner(const Held& held) {
  const HeldSidePath& former = side_path_of(held);
  return rules_.in_plane(rules_.square_to(former.plane, former.end));
}

SpaceGroup ToolSideCompensation::vector_of_start(const Held& held, const SideEnd& start) {
  // fanuc.tool-side.start-type-c: With type C, the block with which a code and a number other than 0 come into force
  // inserts a move from the uncompensated point by the vector perpendicular to the next block at its start, in the
  // plane of VT at that moment. The cause of the move is start-up, and it is of the kind of group 01.
  recorder().reach(Clause::fanuc_tool_side_start_type_c);
  corner_plane_ = side_path_of(held).plane;
  return square_to_latter(corner_plane_, start);
}

SpaceGroup ToolSideCompensation::group_before(const Held& held, const NextBlock& next) {
  const HeldSidePath& former = side_path_of(held);
  SideCase given{.starts = held.kind == Held::Kind::start_up,
                 .cancels = next.cancels,
                 .side_changes = held.offset.side != next.offset.side,
                 .repeated = held.repeated,
                 .distance = held.offset.distance,
                 .next = next.path};
  if (!given.starts && !given.cancels) given.treatment = said(held.step).treatment.value_or(0);
  // fanuc.cutter-c.value-at-a-corner: A new number or value counts for the vectors at the end of the moving block that
  // has it, or, if that block does not move, at the end of the next moving block.
  if (!given.cancels)
    recorder().decide(Clause::fanuc_cutter_c_value_at_a_corner, next.offset.value != held.offset.value);

  auto group = rules_.group({former.plane, former.end, next.start}, given);
  // fanuc.cutter-c.no-intersection: An inner corner with an arc and R' >= 0 whose offset paths do not meet raises
  // PS0033. The alarm names A. Neither A nor a corner move of A is given, and the blocks before A are given as computed
  // with A present.
  if (!group) ahead_.raise_held(Clause::fanuc_cutter_c_no_intersection, AlarmCause::no_intersection);
  const bool in_mode = !given.starts && !given.cancels && !given.side_changes && !given.repeated;
  // fanuc.tool-side.plane-change-alarm: If all three conditions of the plane change check hold, PS0041 is raised;
  // OVERCUT_PLANE_CHANGE is our name for this cause of it. The alarm list of this control has P/S0041; the text of the
  // manual has PS0272, a number of a sister control.
  if (in_mode && former.end.offset != 0 && given.treatment == 0 &&
      plane_change_.interferes({former.path.travel, former.plane.tool()}, {next.path.travel, next.tool}))
    ahead_.raise_held(Clause::fanuc_tool_side_plane_change_alarm, AlarmCause::interference);
  return rules_.in_plane(std::move(*group));
}

}  // namespace toolcomp::model
