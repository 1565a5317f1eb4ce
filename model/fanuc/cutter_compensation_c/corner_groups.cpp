// The vectors at the end of a block held.
#include "model/fanuc/cutter_compensation_c/cutter_compensation_c.h"

namespace toolcomp::model {

SpaceGroup CutterCompensationC::without_corner(const Held& held) {
  return in_space(said(held.step).plane, rules_.square_to(path_of(held).end));
}

// The tool moves by the vector perpendicular to the next block.
SpaceGroup CutterCompensationC::vector_of_start(Held& held, const PathEnd& next) {
  recorder().reach(Clause::fanuc_cutter_c_start_without_motion);
  see_move_alone(held.step, held.offset.distance != 0);
  return in_space(said(held.step).plane, {{perpendicular(next), Seat::off, Seat::square}});
}

// The rules in their order (fanuc.cutter-c.which-rule).
SpaceGroup CutterCompensationC::group_before(const Held& held, const OffsetPath& next, const CutterOffset& offset) {
  recorder().decide(Clause::fanuc_cutter_c_value_at_a_corner, offset.value != held.offset.value);
  const PathEnd& former = path_of(held).end;
  std::optional<VectorGroup> group;
  if (former.offset == 0) {
    group = rules_.square_to(former);
  } else if (recorder().decide(Clause::fanuc_cutter_c_direction_change, held.offset.side != offset.side)) {
    group = rules_.direction_change(former, next.start);
  } else if (held.repeated) {
    recorder().reach(Clause::fanuc_cutter_c_repeated);
    group = rules_.square_to(former);
  } else if (held.kind == Held::Kind::start_up) {
    group = rules_.start_up(former, next.start);
  } else {
    group = rules_.offset_mode(former, next.start);
    if (!group)
      ahead_.raise_held(Clause::fanuc_cutter_c_no_intersection, "PS0033",
                        "the offset paths of an inner corner do not meet");
  }
  return finished(held, std::move(*group), next);
}

SpaceGroup CutterCompensationC::group_before_cancel(const Held& held, const CutterBlock& block,
                                                    const OffsetPath& next) {
  const PathEnd& former = path_of(held).end;
  VectorGroup group;
  const bool by_word = block.code == CutterSide::none;
  const bool direction = by_word && block.direction && !is_zero(*block.direction);
  if (former.offset == 0) {
    group = rules_.square_to(former);
  } else if (held.repeated) {
    recorder().reach(Clause::fanuc_cutter_c_repeated);
    group = rules_.square_to(former);
  } else if (recorder().decide(Clause::fanuc_cutter_c_cancel_direction, direction)) {
    group = rules_.cancel_along(former, *block.direction);
  } else {
    group = rules_.cancel(former, next.start);
  }
  return finished(held, std::move(group), next);
}

// What No. 5010 leaves of a group.
SpaceGroup CutterCompensationC::finished(const Held& held, VectorGroup group, const OffsetPath& next) const {
  rules_.drop_small_movements(group, next);
  recorder().decide(Clause::fanuc_cutter_c_corner_movement, group.size() > 1);
  return in_space(said(held.step).plane, group);
}

}  // namespace toolcomp::model
