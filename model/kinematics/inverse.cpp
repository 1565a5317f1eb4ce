// SPDX-License-Identifier: Apache-2.0
#include "model/kinematics/inverse.h"

#include "model/basis/alarm.h"
#include "model/basis/event.h"

namespace toolcomp::model {
namespace {

// The part of a vector across the work-side axis.
Vector horizontal(const Machine& machine, const Vector& v) {
  const Turn& axis = machine.work_side();
  if (axis.about == 3) return v - dot(axis.line, v) * axis.line;
  Vector result = v;
  component(result, axis.about) = Real();
  return result;
}

// The direction to be reached, of length n, and its height over the mean one of the tilted directions.
struct Goal {
  Real norm;
  Real height;        // n C
  Vector horizontal;  // n times that of the unit vector
  Real horizontal2;   // its square
};

Goal goal(const Machine& machine, const Vector& direction, const Real& norm, const Real& along) {
  Goal result;
  result.norm = norm;
  result.height = along - machine.heights().mean * norm;
  result.horizontal = horizontal(machine, direction);
  result.horizontal2 = squared_norm(result.horizontal);
  return result;
}

Angle sensed(const Turn& turn, const Angle& angle) { return turn.position_at(angle).principal(); }

// n times cosine and sine of the tool-side turn; `depth` is n^2 (rho^2 - C^2), not negative.
struct ScaledTurn {
  Real cosine;
  Real sine;
};
ScaledTurn tool_turn(const Machine& machine, const Goal& goal, const Real& depth, int branch) {
  const Machine::Heights& h = machine.heights();
  const Real across = depth.is_rational() && depth.sign() == Sign::zero ? Real() : branch * sqrt(depth);
  return {(h.a * goal.height - h.b * across) / h.swing2, (h.b * goal.height + h.a * across) / h.swing2};
}

Real depth_of(const Machine& machine, const Real& norm2, const Goal& goal) {
  return machine.heights().swing2 * norm2 - square(goal.height);
}

struct WorkTurn {
  Real cosine;
  Real sine;
};
WorkTurn work_turn(const Machine& machine, const Goal& goal, const ScaledTurn& tool) {
  // Only a forced outcome comes here with a direction along the work-side axis.
  if (goal.horizontal2.sign() == Sign::zero) throw NotFinite();
  const Machine::Heights& h = machine.heights();
  const Vector tilted = goal.norm * h.along + tool.cosine * h.across + tool.sine * h.ahead;
  const Vector across = cross(machine.work_side().line, tilted);
  return {dot(tilted, goal.horizontal) / goal.horizontal2, dot(across, goal.horizontal) / goal.horizontal2};
}

Solution solution(const Machine& machine, const Goal& goal, const Real& depth, int branch, const Angle& work_position) {
  const ScaledTurn tool = tool_turn(machine, goal, depth, branch);
  const WorkTurn work = work_turn(machine, goal, tool);
  Solution result;
  result.pose.tool = sensed(machine.tool_side(), Angle::of_unit(tool.cosine / goal.norm, tool.sine / goal.norm));
  const Angle work_angle = Angle::of_unit(work.cosine, work.sine);
  result.pose.work = (machine.work_side().position_at(work_angle) + work_position).principal();
  result.branch = branch;
  return result;
}

[[noreturn]] void unreachable(Recorder& recorder) {
  // fanuc.tool-center-point.unreachable: A direction that no position of the axes gives raises PS5459. The manual has
  // this number for a direction without a pair in range. The alarm names the block that commands the direction.
  raise(recorder, Clause::fanuc_tool_center_point_unreachable, AlarmCause::unreachable);
}

}  // namespace

Solutions inverse(const Machine& machine, Recorder& recorder, const Direction& direction, const Angle& work_position) {
  // fanuc.tool-center-point.inverse: A direction V has two pairs of positions, to each axis of which any whole turns
  // may be added. V is taken in the zero frame of the table, as (M deg)^-1 V_P. A value of one axis is combined only
  // with the value of the other axis of the same pair.
  recorder.reach(Clause::fanuc_tool_center_point_inverse);
  const Goal to =
      goal(machine, direction.vector, sqrt(direction.norm2), dot(machine.work_side().line, direction.vector));
  const SingularPosture* const ahead = machine.singular(1);
  const SingularPosture* const behind = machine.singular(-1);
  Solutions result;
  // fanuc.tool-center-point.parallel-to-the-work-side: If V is parallel to u_w, the work-side axis may stand anywhere.
  // It keeps its present position, or goes to the nearest limit of its range if that position is outside. The choice
  // then concerns only the tool-side axis and its whole turns.
  if (recorder.decide(Clause::fanuc_tool_center_point_parallel_to_the_work_side, to.horizontal2, direction.norm2) !=
      Sign::positive) {
    const bool along = dot(machine.work_side().line, direction.vector).sign() == Sign::positive;
    const SingularPosture* const posture = along ? ahead : behind;
    if (posture == nullptr) unreachable(recorder);
    result.at[0].pose.tool = posture->tool;
    result.count = 1;
    result.work_free = true;
    return result;
  }
  const Real rho = sqrt(machine.heights().swing2);
  const Real height = to.height / to.norm;
  bool edge = false;
  const auto bounded = [&](Clause clause, const Real& quantity) {
    constexpr int scale = 4;
    const Sign side = recorder.decide(clause, quantity, scale);
    if (side == Sign::negative) unreachable(recorder);
    if (side == Sign::zero) edge = true;
  };
  // fanuc.tool-center-point.reach-toward-the-axis: V can be no nearer to u_w than |alpha - beta|, with alpha the angle
  // between u_t and t0 and beta the angle between u_t and u_w. At the bound the two pairs are one. Asked unless alpha =
  // beta, and not of V parallel to u_w.
  if (ahead == nullptr) bounded(Clause::fanuc_tool_center_point_reach_toward_the_axis, rho - height);
  // fanuc.tool-center-point.reach-away-from-the-axis: V can be no farther from u_w than the smaller of alpha + beta and
  // 360 - alpha - beta. At the bound the two pairs are one. Asked after fanuc.tool-center-point.reach-toward-the-axis,
  // which explains alpha and beta, unless alpha + beta = 180, and not of V parallel to u_w.
  if (behind == nullptr) bounded(Clause::fanuc_tool_center_point_reach_away_from_the_axis, rho + height);
  Real depth = depth_of(machine, direction.norm2, to);
  // A forced outcome may let a direction through that is out of reach.
  if (edge || depth.sign() != Sign::positive) depth = Real();
  result.at[0] = solution(machine, to, depth, 1, work_position);
  result.count = 1;
  if (depth.is_rational() && depth.sign() == Sign::zero) {
    result.at[0].branch = 0;
    return result;
  }
  result.at[1] = solution(machine, to, depth, -1, work_position);
  result.count = 2;
  return result;
}

PoseCosines on_branch(const Machine& machine, const Vector& unit, const Real& along, int branch) {
  const Goal to = goal(machine, unit, 1, along);
  const ScaledTurn tool = tool_turn(machine, to, depth_of(machine, 1, to), branch);
  const WorkTurn work = work_turn(machine, to, tool);
  // The position of an angle from its cosine and sine, by its sense and offset.
  const auto positioned = [](const Turn& turn, const Real& cosine, const Real& sine, Real& to_cosine, Real& to_sine) {
    const Angle position = turn.position_at(Angle::known(cosine, sine, 0));
    to_cosine = position.cosine();
    to_sine = position.sine();
  };
  PoseCosines result;
  positioned(machine.tool_side(), tool.cosine, tool.sine, result.tool_cosine, result.tool_sine);
  positioned(machine.work_side(), work.cosine, work.sine, result.work_cosine, result.work_sine);
  return result;
}

Real branch_quantity(const Machine& machine, const Angle& tool) {
  const Angle turn = machine.tool_side().angle(tool);
  return machine.heights().a * turn.sine() - machine.heights().b * turn.cosine();
}

int branch_of(const Machine& machine, const Angle& tool) {
  return static_cast<int>(branch_quantity(machine, tool).sign());
}

Angle azimuth(const Machine& machine, const Vector& from, const Vector& to) {
  const Vector a = horizontal(machine, from);
  const Vector b = horizontal(machine, to);
  return Angle::of_direction(dot(a, b), dot(machine.work_side().line, cross(a, b)));
}

Angle lifted_tool(const Angle& start, const Angle& end, int branch, const Machine& machine) {
  const Integer turns = (end - start).nearest_turns();
  Angle nearest = end.plus_turns(-turns);
  // From one edge of reach to the other: on the side of the branch.
  const bool down = branch * machine.tool_side().sense < 0;
  if (down && nearest - start == Angle(180)) return nearest.plus_turns(-1);
  return nearest;
}

Angle lifted_work(const Angle& start, const Angle& end, const Angle& direction_swing, const Angle& tilt_swing,
                  const Machine& machine) {
  const Real swing = direction_swing.plain_degrees() - tilt_swing.plain_degrees();
  const Real turns =
      (start.plain_degrees() + machine.work_side().sense * swing - end.plain_degrees()) * Rational(1, 360);
  // A whole number and a half, of which any enclosure of less than half a turn tells the whole number; the whole number
  // itself might be a zero that is not proven.
  constexpr int bits = 30;
  return end.plus_turns(floor((turns + Rational(1, 2)).enclosure(bits).lower));
}

}  // namespace toolcomp::model
