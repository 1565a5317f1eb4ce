// The vectors at the end of a block held.
#include "model/fanuc/cutter_compensation_c/cutter_compensation_c.h"

namespace toolcomp::model {

SpaceGroup CutterCompensationC::without_corner(const Held& held) {
  return in_space(said(held.step).plane, rules_.square_to(path_of(held).end));
}

SpaceGroup CutterCompensationC::vector_of_start(Held& held, const PathEnd& next) {
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
  if (!corner.cancels) recorder().decide(Clause::fanuc_cutter_c_value_at_a_corner, offset.value != held.offset.value);
  const auto group = rules_.group(corner);
  if (!group)
    ahead_.raise_held(Clause::fanuc_cutter_c_no_intersection, "PS0033",
                      "the offset paths of an inner corner do not meet");
  return in_space(said(held.step).plane, *group);
}

}  // namespace toolcomp::model
