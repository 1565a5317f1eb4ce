// The vectors at the end of a block held.
#include <utility>

#include "model/fanuc/tool_side_compensation/tool_side_compensation.h"

namespace toolcomp::model {

SpaceGroup ToolSideCompensation::without_corner(const Held& held) {
  const HeldSidePath& former = side_path_of(held);
  return in_plane(rules_.square_to(former.plane, former.end));
}

// The tool moves by the vector perpendicular to the next block.
SpaceGroup ToolSideCompensation::vector_of_start(const Held& held, const SideEnd& start) {
  recorder().reach(Clause::fanuc_tool_side_start_type_c);
  corner_plane_ = side_path_of(held).plane;
  return rules_.square_to_latter(corner_plane_, start);
}

SpaceGroup ToolSideCompensation::group_before(const Held& held, const Step& now, const Movement& movement,
                                              const SideEnd& start, const CutterOffset& offset) {
  const HeldSidePath& former = side_path_of(held);
  recorder().decide(Clause::fanuc_cutter_c_value_at_a_corner, offset.value != held.offset.value);
  if (former.end.offset == 0) return in_plane(rules_.square_to(former.plane, former.end));
  const bool starts = held.kind == Held::Kind::start_up;
  const int treatment = treatment_of(held);
  const bool one_side = held.offset.side == offset.side;
  SpaceGroup group = group_by_rules(held, start, one_side);
  if (treatment == 3) recorder().reach(Clause::fanuc_tool_side_q3);
  if (may_drop(group, movement.path)) rules_.drop_small_differences(group, held.offset.distance);
  if (!starts && treatment == 0 && one_side && !held.repeated &&
      plane_change_.interferes({former.path.travel, former.plane.tool()}, {movement.path.travel, now.rest.tool}))
    ahead_.raise_held(Clause::fanuc_tool_side_plane_change_alarm, "PS0041",
                      "OVERCUT_PLANE_CHANGE: the tool turns and the path goes back, it would cut too much");
  return in_plane(std::move(group));
}

// The rules in their order (fanuc.tool-side.which-rule).
SpaceGroup ToolSideCompensation::group_by_rules(const Held& held, const SideEnd& start, bool one_side) {
  const HeldSidePath& former = side_path_of(held);
  const SideCorner corner{former.plane, former.end, start};
  const int treatment = treatment_of(held);
  if (treatment == 1) {
    recorder().reach(Clause::fanuc_tool_side_q1);
    return rules_.square_to(former.plane, former.end);
  }
  if (recorder().decide(Clause::fanuc_cutter_c_direction_change, !one_side)) return rules_.side_change(corner);
  if (held.repeated) {
    recorder().reach(Clause::fanuc_tool_side_repeated);
    return rules_.square_to(former.plane, former.end);
  }
  if (held.kind == Held::Kind::start_up) return rules_.start_up(corner);
  auto group = rules_.in_mode(corner);
  if (!group)
    ahead_.raise_held(Clause::fanuc_cutter_c_no_intersection, "PS0033",
                      "the offset paths of an inner corner do not meet");
  if (treatment == 2 && recorder().decide(Clause::fanuc_tool_side_q2, corner.of_lines() && group->size() == 2))
    group->pop_back();
  return *group;
}

// Q of a block of the mode; 0 of another.
int ToolSideCompensation::treatment_of(const Held& held) const {
  return held.kind == Held::Kind::start_up ? 0 : said(held.step).treatment.value_or(0);
}

// Nothing is dropped before an arc of a half circle or more.
bool ToolSideCompensation::may_drop(const SpaceGroup& group, const SidePath& next) const {
  if (group.size() < 2 || !next.arc) return true;
  const ArcEnds& ends = next.arc->ends;
  return is_under_half_circle(recorder(), ends.start, ends.end, ends.turn,
                              sqrt(squared_norm(ends.start) * squared_norm(ends.end)));
}

SpaceGroup ToolSideCompensation::group_before_cancel(const Held& held, SideEnd start) {
  const HeldSidePath& former = side_path_of(held);
  start.offset = held.offset.left();
  if (former.end.offset == 0) return in_plane(rules_.square_to(former.plane, former.end));
  if (held.repeated) {
    recorder().reach(Clause::fanuc_tool_side_repeated);
    return in_plane(rules_.square_to(former.plane, former.end));
  }
  if (held.kind == Held::Kind::start_up) {
    recorder().reach(Clause::fanuc_tool_side_start_then_cancel);
    return in_plane(rules_.square_to(former.plane, former.end));
  }
  SpaceGroup group = rules_.cancel({former.plane, former.end, start});
  rules_.drop_small_differences(group, held.offset.distance);
  return in_plane(std::move(group));
}

SpaceGroup ToolSideCompensation::in_plane(SpaceGroup group) const {
  recorder().reach(Clause::fanuc_tool_side_plane);
  for (std::size_t i = 1; i < group.size(); ++i)
    recorder().decide(Clause::fanuc_tool_side_stop_point, !group[i].after_stop);
  return group;
}

}  // namespace toolcomp::model
