// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_posture_control/tool_posture_control.h"

#include <utility>

#include "model/fanuc/tool_posture_control/lift.h"
#include "model/kinematics/inverse.h"

namespace toolcomp::model {
namespace {

// The pairs of a direction. It is asked for in the table frame less the turn of the work-side axis by a position, which
// is added to the pairs.
Solutions pairs(Recorder& recorder, const SharedFrame& frame, Direction direction) {
  direction.vector = frame->frame.to_table_beside(direction.vector);
  direction.unit = frame->frame.to_table_beside(direction.unit);
  const bool head = frame->machine.type() == MachineType::head;
  return inverse(frame->machine, recorder, direction, head ? Angle() : frame->frame.frozen().work);
}

// What is known to be zero of an arc that leans the tool from where it stands toward a travel: it runs in their plane.
void pass_leaned(const Vector& travel, AxisPassed& passed) {
  const Vector& from = passed.arc.from().vector;
  if (known_zero(dot(cross(from, travel), passed.axis))) passed.side = Real();
  if (known_zero(dot(passed.axis, travel)) && known_zero(dot(from, travel))) passed.behind_start = Real();
}

// Positive: one direction, negative: opposite ones; zero where neither is known.
Sign known_parallel(const Direction& a, const Direction& b) {
  if (known_same(a.vector, b.vector)) return Sign::positive;
  try {
    return is_zero(cross(a.vector, b.vector)) ? dot(a.vector, b.vector).sign() : Sign::zero;
  } catch (const exact::Undecided&) {
    return Sign::zero;
  }
}

}  // namespace

PosturePlan even_plan(const SharedFrame& frame, const Pose& start, const Pose& end, const Direction& tool) {
  PosturePlan plan{{}, start, end, tool};
  plan.motion = even_motion(frame, start, end);
  return plan;
}

// The pair that is to be reached where no branch is followed.
Solution ToolPostureControl::pair(const SharedFrame& frame, const PostureBlock& block) const {
  if (const auto& commanded = block.commanded)
    return {*commanded, frame->machine.is_invertible() ? branch_of(frame->machine, commanded->tool) : 0};
  return choice_.choose(pairs(recorder_, frame, block.to), block.start, known_parallel(block.from, block.to));
}

PosturePlan ToolPostureControl::conventional(const SharedFrame& frame, const PostureBlock& block) const {
  const Pose end = pair(frame, block).pose;
  recorder_.reach(Clause::fanuc_tool_center_point_conventional);
  return even_plan(frame, block.start, end, block.to);
}

// A block whose directions span a plane.
struct ToolPostureControl::InPlane {
  const ToolPostureControl& control;
  const SharedFrame& frame;
  const PostureBlock& block;
  ArcView view;          // of the arc
  AxisPassed work_axis;  // by the arc
  Solutions solutions;   // type 2: the pairs of the end

  // The pole along which a direction of the arc points; `commanded`: its pose in type 1.
  [[nodiscard]] const SingularPosture* pole_along(Clause clause, const Direction& direction,
                                                  const Pose& commanded) const {
    if (!block.commanded) return control.rules_.pole_along(clause, view.work_axis(), direction);
    // Turning about the work-side axis changes nothing about that: what its position is need not be asked.
    const Direction tilted = Direction::of_unit(frame->machine.tilted(commanded.tool));
    return control.rules_.pole_along(clause, frame->machine.work_side().line, tilted);
  }

  [[nodiscard]] BranchPart start() const {
    const Sign branch = control.rules_.branch(block.start.tool);
    if (branch != Sign::zero) return {block.start, static_cast<int>(branch)};
    const Solution to = control.pair(frame, block);
    const bool has_branch = to.branch != 0;
    return {block.start, has_branch ? to.branch : branch_toward(frame->machine, block.start.tool, to.pose.tool), 0,
            true};
  }

  // On orthogonal axes a great circle through a pole is run by the tool-side axis alone, evenly.
  [[nodiscard]] SharedMotion motion(const BranchPart& part, int side, const std::optional<BranchPart>& behind,
                                    const Pose& end) const {
    if (frame->machine.is_orthogonal() && (side == 0 || part.pole != 0)) return even_motion(frame, part.start, end);
    const bool in_plane = work_axis.side.sign() == Sign::zero;
    return great_circle_motion(view, work_axis.arc, side, in_plane, part, behind);
  }

  [[nodiscard]] PosturePlan give_way(const Pose& end) const {
    control.recorder_.reach(Clause::fanuc_tool_center_point_conventional);
    PosturePlan plan = even_plan(frame, block.start, end, block.to);
    plan.branch_differs = true;
    return plan;
  }

  // Followed back from the end pair; the work-side axis turns first to where that leads it.
  [[nodiscard]] PosturePlan from_pole(const SingularPosture& pole) const {
    const Pose& here = block.start;
    const Solution to = control.pair(frame, block);
    const int branch = to.branch != 0 ? to.branch : branch_between(frame->machine, here.tool, to.pose.tool);
    const bool differs = absolute(to.pose.tool - here.tool) > Angle(180);
    if (control.rules_.is_mismatch(differs)) return give_way(to.pose);
    control.recorder_.reach(Clause::fanuc_tool_posture_lift);
    PosturePlan plan{{}, {here.tool, work_at_pole(frame->machine, to.pose, branch)}, to.pose, block.to};
    if (control.rules_.turns(Clause::fanuc_tool_posture_pre_turn, plan.start.work, here.work))
      plan.pre_turn = plan.start;
    plan.motion = motion({plan.start, branch, pole.side}, 0, {}, plan.end);
    return plan;
  }

  [[nodiscard]] PosturePlan to_pole(const BranchPart& part, const SingularPosture& pole) const {
    control.recorder_.reach(Clause::fanuc_tool_posture_lift);
    PosturePlan plan{{}, block.start, lifted_to_pole(frame->machine, part, pole), block.to};
    if (const auto& commanded = block.commanded) {
      if (control.rules_.is_mismatch(!(commanded->tool == plan.end.tool))) return give_way(*commanded);
      if (control.rules_.turns(Clause::fanuc_tool_posture_post_turn, commanded->work, plan.end.work))
        plan.post_turn = commanded;
    } else {
      control.choice_.require_inside(plan.end);
    }
    plan.motion = motion(part, 0, {}, plan.end);
    return plan;
  }

  [[nodiscard]] PosturePlan along(const BranchPart& part, const Passing& passed) const {
    control.recorder_.reach(Clause::fanuc_tool_posture_lift);
    const auto& commanded = block.commanded;
    std::optional<BranchPart> behind;
    if (passed.crossed != nullptr)
      behind = BranchPart{lifted_to_pole(frame->machine, part, *passed.crossed), -part.branch, passed.crossed->side};
    const BranchPart& last = behind ? *behind : part;
    const std::optional<Angle> swing = swung(passed.side);
    const Pose pair = commanded ? *commanded : of_branch(last.branch);
    PosturePlan plan{{}, block.start, lifted(frame->machine, last, swing, pair), block.to};
    if (commanded) {
      const int of_commanded = branch_of(frame->machine, commanded->tool);
      const bool differs = (of_commanded != 0 && of_commanded != last.branch) || !(plan.end == *commanded);
      if (control.rules_.is_mismatch(differs)) return give_way(*commanded);
      plan.end = *commanded;
    }
    if (control.rules_.looks(!commanded) && !behind) {
      if (auto other = changed(part, swing, plan.end)) return *std::move(other);
    }
    if (!commanded) control.choice_.require_inside(plan.end);
    plan.motion = motion(part, passed.side, behind, plan.end);
    return plan;
  }

  // The swing of the directions about the work-side axis, which lies on this side of the arc; none in its plane.
  [[nodiscard]] std::optional<Angle> swung(int side) const {
    if (side == 0) return std::nullopt;
    const Vector from = view.about_axis(work_axis.arc.from().vector);
    const Angle swing = azimuth(frame->machine, from, view.about_axis(work_axis.arc.to().vector));
    // Only a forced side goes the other way round.
    const Sign right = sign(swing);
    const bool other_way = swing.cosine().sign() == Sign::negative && static_cast<int>(right) == -side;
    return other_way ? swing.plus_turns(side) : swing;
  }

  // On the edge of reach there is only one.
  [[nodiscard]] const Pose& of_branch(int branch) const {
    return solutions.at.at(solutions.count == 2 && branch < 0 ? 1 : 0).pose;
  }

  // An end changed so that the block passes the singular posture that it comes near to; nothing where it stays.
  [[nodiscard]] std::optional<PosturePlan> changed(const BranchPart& part, const std::optional<Angle>& swing,
                                                   const Pose& end) const {
    const SingularPosture* const pole = control.rules_.near(work_axis);
    if (pole == nullptr) return std::nullopt;
    const Pose to = PostureRules::changed(block.start, end, lifted_to_pole(frame->machine, part, *pole).tool);
    // With orthogonal axes the work-side axis turns as the directions do, whose components are simpler than positions.
    const Angle turned = frame->machine.is_orthogonal() && swing ? *swing : end.work - block.start.work;
    if (control.rules_.may_stand(turned) && control.choice_.inside(to)) {
      control.recorder_.reach(Clause::fanuc_tool_posture_changed);
      control.recorder_.reach(Clause::fanuc_tool_posture_passing);
      PosturePlan plan = even_plan(frame, block.start, to, mirrored(to));
      plan.changed = true;
      return plan;
    }
    control.rules_.keep_end();
    return std::nullopt;
  }

  // The direction of a changed end. Mirrored it reaches as far along the work-side axis as the one commanded, which may
  // be known to be 0. With orthogonal axes it leans the other way than at the start: of the same components across,
  // which may be rational.
  [[nodiscard]] Direction mirrored(const Pose& end) const {
    Vector unit = frame->frame.direction(end);
    for (std::size_t i = 0; i < 3; ++i) {
      const Real& axis = component(frame->work_axis, i);
      if (!axis.is_rational() || axis.rational() != 1) continue;
      const Real& along = component(block.to.unit, i);
      component(unit, i) = along;
      if (!frame->machine.is_orthogonal()) break;
      const Direction& from = block.from;
      const Real across = sqrt((from.norm2 - square(component(from.vector, i))) / (1 - square(along)));
      Vector vector = -from.vector;
      component(vector, i) = along * across;
      unit = vector / across;
      component(unit, i) = along;
      return {vector, square(across), unit, true};
    }
    return Direction::of_unit(unit);
  }
};

// fanuc.tool-posture.order: The questions of a block with P1 have a fixed order. They are: no-plane; at-start of +u_w,
// -u_w; at-end of +u_w, -u_w; branch; crossing of +u_w, -u_w, each with its foot; reach-inside; the end pair;
// branch-mismatch; near-limit; nearer-singular; near; veto and range of the changed pair; range of the end pair. If the
// pair of fanuc.tool-center-point.choice is needed, it is found before the branch. In type 2 the reach of Ve is asked
// before all of them.
PosturePlan ToolPostureControl::plan(const SharedFrame& frame, const PostureBlock& block) const {
  Solutions solutions;
  ArcView view{frame, {}};
  Direction from = block.from;
  Direction to = block.to;
  if (block.commanded) {
    view.work = block.start.work;
    from = Direction::of_unit(frame->machine.direction_beside(block.start, block.start.work));
    to = Direction::of_unit(frame->machine.direction_beside(*block.commanded, block.start.work));
  } else {
    solutions = pairs(recorder_, frame, block.to);
  }
  if (!rules_.spans_plane(from, to)) {
    const bool same = dot(from.vector, to.vector).sign() == Sign::positive;
    if (!block.commanded && same && choice_.inside(block.start))
      return even_plan(frame, block.start, block.start, block.to);
    return conventional(frame, block);
  }
  recorder_.reach(Clause::fanuc_tool_posture_great_circle);
  AxisPassed work_axis = pass(GreatCircle(from, to), view.work_axis());
  if (block.leaned_toward) pass_leaned(*block.leaned_toward, work_axis);
  const InPlane now{*this, frame, block, view, work_axis, solutions};
  const Pose end = block.commanded.value_or(Pose());
  if (const auto* const pole = now.pole_along(Clause::fanuc_tool_posture_at_start, from, block.start))
    return now.from_pole(*pole);
  const auto* const end_pole = now.pole_along(Clause::fanuc_tool_posture_at_end, to, end);
  const BranchPart start = now.start();
  if (end_pole != nullptr) {
    rules_.require_reach_inside(work_axis);
    return now.to_pole(start, *end_pole);
  }
  const Passing passed = rules_.passing(work_axis);
  rules_.require_reach_inside(work_axis);
  return now.along(start, passed);
}

}  // namespace toolcomp::model
