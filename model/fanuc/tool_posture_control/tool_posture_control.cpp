// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_posture_control/tool_posture_control.h"

#include <memory>
#include <utility>

#include "model/fanuc/tool_posture_control/linear_motion.h"

namespace toolcomp::model {
namespace {

// What the inverse kinematics are asked for: a direction in the table frame, less the turn of the work-side axis by a
// position, which is added to the pairs.
struct Goal {
  Direction direction;
  Angle work;
};
Goal goal(const SharedFrame& frame, const Direction& direction) {
  Goal result{direction, frame->machine.type() == MachineType::head ? Angle() : frame->frame.frozen().work};
  result.direction.vector = frame->frame.to_table_beside(direction.vector);
  result.direction.unit = frame->frame.to_table_beside(direction.unit);
  return result;
}

// What is known to be zero of an arc that leans the tool from where it stands toward a travel: it runs in their plane.
void pass_leaned(const GreatCircle& arc, const Vector& travel, const Vector& axis, AxisPassed& passed) {
  const Vector& from = arc.from().vector;
  if (known_zero(dot(cross(from, travel), axis))) passed.side = Real();
  if (known_zero(dot(axis, travel)) && known_zero(dot(from, travel))) passed.behind_start = Real();
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

// On the edge of reach there is only one.
const Pose& of_branch(const Solutions& solutions, int branch) {
  return solutions.at.at(solutions.count == 2 && branch < 0 ? 1 : 0).pose;
}

}  // namespace

ToolPostureControl::ToolPostureControl(const spec::Setup& setup, const Machine& machine, const PairChoice& choice,
                                       Recorder& recorder)
    : machine_(machine), choice_(choice), recorder_(recorder), lift_(machine), rules_(setup, machine, recorder) {}

// The pair that is to be reached where no branch is followed.
Solution ToolPostureControl::pair(const SharedFrame& frame, const PostureBlock& block) const {
  if (!block.commanded) {
    const Goal to = goal(frame, block.to);
    return choice_.choose(inverse(machine_, recorder_, to.direction, to.work), block.start,
                          known_parallel(block.from, block.to));
  }
  return {*block.commanded, lift_.is_possible() ? lift_.branch_of(block.commanded->tool) : 0};
}

PosturePlan ToolPostureControl::conventional(const SharedFrame& frame, const PostureBlock& block) const {
  PosturePlan plan;
  plan.start = block.start;
  plan.end = pair(frame, block).pose;
  plan.tool = block.to;
  recorder_.reach(Clause::fanuc_tool_center_point_conventional);
  plan.motion = std::make_shared<LinearMotion>(frame, plan.start, plan.end);
  return plan;
}

PosturePlan ToolPostureControl::stand(const SharedFrame& frame, const PostureBlock& block) {
  PosturePlan plan;
  plan.start = plan.end = block.start;
  plan.tool = block.to;
  plan.motion = std::make_shared<LinearMotion>(frame, plan.start, plan.end);
  return plan;
}

ToolPostureControl::Ends ToolPostureControl::ends(const SharedFrame& frame, const PostureBlock& block) {
  if (!block.commanded) return {ArcView(frame), block.from, block.to};
  ArcView view(frame, block.start.work);
  Direction from = view.direction(block.start);
  Direction to = view.direction(*block.commanded);
  return {std::move(view), std::move(from), std::move(to)};
}

// fanuc.tool-posture.order: The questions of a block with P1 have a fixed order. They are: no-plane; at-start of +u_w,
// -u_w; at-end of +u_w, -u_w; branch; crossing of +u_w, -u_w, each with its foot; reach-inside; the end pair;
// branch-mismatch; near-limit; nearer-singular; near; veto and range of the changed pair; range of the end pair. If the
// pair of fanuc.tool-center-point.choice is needed, it is found before the branch. In type 2 the reach of Ve is asked
// before all of them.
PosturePlan ToolPostureControl::plan(const SharedFrame& frame, const PostureBlock& block) const {
  Solutions solutions;
  if (!block.commanded) {
    const Goal to = goal(frame, block.to);
    solutions = inverse(machine_, recorder_, to.direction, to.work);
  }
  Ends at = ends(frame, block);
  if (!rules_.spans_plane(at.from, at.to)) {
    const bool same = dot(at.from.vector, at.to.vector).sign() == Sign::positive;
    if (!block.commanded && same && choice_.inside(block.start)) return stand(frame, block);
    return conventional(frame, block);
  }
  recorder_.reach(Clause::fanuc_tool_posture_great_circle);
  GreatCircle arc(std::move(at.from), std::move(at.to));
  AxisPassed work_axis = pass(arc, at.view.work_axis());
  if (block.leaned_toward) pass_leaned(arc, *block.leaned_toward, at.view.work_axis(), work_axis);
  const Found found{frame, block, std::move(at.view), std::move(arc), std::move(work_axis), std::move(solutions)};
  const bool of_positions = block.commanded.has_value();
  if (const Pole* const pole = pole_along(Clause::fanuc_tool_posture_at_start, found, found.arc.from(),
                                          of_positions ? &block.start : nullptr))
    return from_pole(found, *pole);
  const Pole* const end_pole =
      pole_along(Clause::fanuc_tool_posture_at_end, found, found.arc.to(), of_positions ? &*block.commanded : nullptr);
  const LiftStart start = lift_start(found);
  if (end_pole != nullptr) {
    rules_.require_reach_inside(found.arc, found.work_axis);
    return to_pole(found, start, *end_pole);
  }
  const Passing passed = rules_.passing(found.arc, found.work_axis);
  rules_.require_reach_inside(found.arc, found.work_axis);
  return along(found, start, passed);
}

const Pole* ToolPostureControl::pole_along(Clause clause, const Found& found, const Direction& direction,
                                           const Pose* commanded) const {
  if (commanded != nullptr) {
    // Turning about the work-side axis changes nothing about that: what its position is need not be asked.
    const Vector tilted = machine_.tilted(commanded->tool);
    return rules_.pole_along(clause, machine_.work_side().line, {tilted, 1, tilted, true});
  }
  return rules_.pole_along(clause, found.view.work_axis(), direction);
}

LiftStart ToolPostureControl::lift_start(const Found& found) const {
  const Pose& start = found.block.start;
  const Sign branch = rules_.branch(start.tool);
  if (branch != Sign::zero) return {start, static_cast<int>(branch), false};
  const Solution to = pair(found.frame, found.block);
  return {start, to.branch != 0 ? to.branch : lift_.branch_toward(start.tool, to.pose.tool), true};
}

PosturePlan ToolPostureControl::give_way(const Found& found, const Pose& end) const {
  PosturePlan plan;
  plan.start = found.block.start;
  plan.end = end;
  plan.tool = found.block.to;
  plan.branch_differs = true;
  recorder_.reach(Clause::fanuc_tool_center_point_conventional);
  plan.motion = std::make_shared<LinearMotion>(found.frame, plan.start, plan.end);
  return plan;
}

// Followed back from the end pair; the work-side axis turns first to where that leads it.
PosturePlan ToolPostureControl::from_pole(const Found& found, const Pole& pole) const {
  const Pose& here = found.block.start;
  const Solution to = pair(found.frame, found.block);
  const int branch = to.branch != 0 ? to.branch : lift_.branch_between(here.tool, to.pose.tool);
  const bool differs = absolute(to.pose.tool - here.tool) > Angle(180);
  if (rules_.is_mismatch(differs)) return give_way(found, to.pose);
  recorder_.reach(Clause::fanuc_tool_posture_lift);
  PosturePlan plan;
  plan.start = {here.tool, lift_.back_at_pole(to.pose, branch)};
  plan.pre_turn = rules_.turns(Clause::fanuc_tool_posture_pre_turn, plan.start.work, here.work);
  plan.end = to.pose;
  plan.tool = found.block.to;
  plan.motion = motion(found, {plan.start, branch, pole.sign}, 0, std::nullopt, plan.end);
  return plan;
}

PosturePlan ToolPostureControl::to_pole(const Found& found, const LiftStart& start, const Pole& pole) const {
  recorder_.reach(Clause::fanuc_tool_posture_lift);
  PosturePlan plan;
  plan.start = start.pose;
  plan.end = lift_.at_pole(start, pole);
  plan.tool = found.block.to;
  if (const auto& commanded = found.block.commanded) {
    if (rules_.is_mismatch(!(commanded->tool == plan.end.tool))) return give_way(found, *commanded);
    if (rules_.turns(Clause::fanuc_tool_posture_post_turn, commanded->work, plan.end.work)) plan.post_turn = commanded;
  } else {
    choice_.require_inside(plan.end);
  }
  plan.motion = motion(found, {start.pose, start.branch, 0}, 0, std::nullopt, plan.end);
  return plan;
}

PosturePlan ToolPostureControl::along(const Found& found, const LiftStart& start, const Passing& passed) const {
  recorder_.reach(Clause::fanuc_tool_posture_lift);
  const auto& commanded = found.block.commanded;
  std::optional<BranchPart> behind;
  if (passed.crossed != nullptr)
    behind = BranchPart{lift_.at_pole(start, *passed.crossed), -start.branch, passed.crossed->sign};
  const int branch = behind ? behind->branch : start.branch;
  const Pose pair = commanded ? *commanded : of_branch(found.solutions, branch);
  const Way way{found.view.about_axis(found.arc.from().vector), found.view.about_axis(found.arc.to().vector),
                passed.side};
  PosturePlan plan;
  plan.start = start.pose;
  plan.end = behind ? lift_.end_behind(*behind, pair) : lift_.end(start, way, pair);
  plan.tool = found.block.to;
  if (commanded) {
    const int of_commanded = lift_.branch_of(commanded->tool);
    const bool differs = (of_commanded != 0 && of_commanded != branch) || !(plan.end == *commanded);
    if (rules_.is_mismatch(differs)) return give_way(found, *commanded);
    plan.end = *commanded;
  }
  if (rules_.looks(!commanded) && !behind) {
    if (auto other = changed(found, start, way, plan.end)) return *std::move(other);
  }
  if (!commanded) choice_.require_inside(plan.end);
  std::optional<Crossing> crossing;
  if (behind) crossing = Crossing{Real(behind->pole) * found.view.work_axis(), *behind};
  plan.motion = motion(found, {start.pose, start.branch, 0}, passed.side, crossing, plan.end);
  return plan;
}

// Mirrored it reaches as far along the work-side axis as the one commanded, which may be known to be 0. With orthogonal
// axes it leans the other way than at the start: of the same components across, which may be rational.
Direction ToolPostureControl::mirrored(const Found& found, const Pose& end) const {
  Vector unit = found.frame->frame.direction(end);
  for (std::size_t i = 0; i < 3; ++i) {
    const Real& axis = component(found.frame->work_axis, i);
    if (!axis.is_rational() || axis.rational() != 1) continue;
    const Real& along = component(found.block.to.unit, i);
    component(unit, i) = along;
    if (!machine_.is_orthogonal()) break;
    const Direction& from = found.block.from;
    const Real across = sqrt((from.norm2 - square(component(from.vector, i))) / (1 - square(along)));
    Vector vector = -from.vector;
    component(vector, i) = along * across;
    unit = vector / across;
    component(unit, i) = along;
    return {vector, square(across), unit, true};
  }
  return {unit, 1, unit, true};
}

std::optional<PosturePlan> ToolPostureControl::changed(const Found& found, const LiftStart& start, const Way& way,
                                                       const Pose& end) const {
  const Pole* const pole = rules_.near(found.arc, found.work_axis);
  if (pole == nullptr) return std::nullopt;
  const Angle singular = lift_.at_pole(start, *pole).tool;
  PosturePlan plan;
  plan.start = start.pose;
  plan.end = PostureRules::changed(start.pose, end, singular);
  // With orthogonal axes the work-side axis turns as the directions do, whose components are simpler than positions.
  const bool by_directions = machine_.is_orthogonal() && way.side != 0;
  const Angle turned = by_directions ? azimuth(machine_, way.from, way.to) : end.work - start.pose.work;
  if (rules_.may_stand(turned) && choice_.inside(plan.end)) {
    recorder_.reach(Clause::fanuc_tool_posture_changed);
    recorder_.reach(Clause::fanuc_tool_posture_passing);
    plan.changed = true;
    plan.tool = mirrored(found, plan.end);
    plan.motion = std::make_shared<LinearMotion>(found.frame, plan.start, plan.end);
    return plan;
  }
  rules_.keep_end();
  return std::nullopt;
}

// On orthogonal axes a great circle through a pole is run by the tool-side axis alone, evenly.
SharedMotion ToolPostureControl::motion(const Found& found, const BranchPart& part, int side,
                                        const std::optional<Crossing>& crossing, const Pose& end) const {
  if (machine_.is_orthogonal() && (side == 0 || part.pole != 0))
    return std::make_shared<LinearMotion>(found.frame, part.start, end);
  const bool in_plane = found.work_axis.side.sign() == Sign::zero;
  return std::make_shared<GreatCircleMotion>(found.view, found.arc, side, in_plane, part, crossing);
}

}  // namespace toolcomp::model
