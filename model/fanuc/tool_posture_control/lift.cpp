// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_posture_control/lift.h"

#include "model/kinematics/inverse.h"

namespace toolcomp::model {
namespace {

bool on_upper_edge(const Machine& machine, const Angle& tool) {
  const Real height = dot(machine.work_side().line, machine.tilted(tool));
  return (height - machine.heights().mean).sign() == Sign::positive;
}

// Where the tilted direction comes to a pole, or leaves it: the azimuth of this vector.
Vector limit(const Machine& machine, int branch) {
  return Real(branch) * cross(machine.tool_side().line, machine.work_side().line);
}

// The position of the tool-side axis at `end`, beside that of the start.
Angle tool_at(const Machine& machine, const BranchPart& part, const Angle& end) {
  // Only from edge to edge the branch matters, and there the lower edge is left the other way. From a pole the edge of
  // reach is half a turn.
  const bool lower = part.pole < 0 || (part.on_edge && !on_upper_edge(machine, part.start.tool));
  return lifted_tool(part.start.tool, end, lower ? -part.branch : part.branch, machine);
}

// By how much the tool, tilted alone from the start to `end`, swings about u_w. From edge to edge it is 180 degrees,
// past the side of the branch.
Angle tilt_swing(const Machine& machine, const BranchPart& part, const Angle& end) {
  const Vector to = machine.tilted(end);
  const Vector side = limit(machine, part.branch);
  if (part.pole != 0) return azimuth(machine, side, to);
  const Vector from = machine.tilted(part.start.tool);
  if (!part.on_edge) return azimuth(machine, from, to);
  return azimuth(machine, from, side) + azimuth(machine, side, to);
}

}  // namespace

// From the greatest height branch 1 turns up, from the least down.
int branch_between(const Machine& machine, const Angle& from, const Angle& to) {
  const int up = machine.tool_side().sense * static_cast<int>(sign(to - from));
  if (up == 0) return 1;
  return on_upper_edge(machine, from) ? up : -up;
}

int branch_toward(const Machine& machine, const Angle& from, const Angle& to) {
  return on_upper_edge(machine, from) == on_upper_edge(machine, to) ? 1 : branch_between(machine, from, to);
}

Angle work_at_pole(const Machine& machine, const Pose& pair, int branch) {
  if (machine.is_orthogonal()) return pair.work;
  const Angle swing = azimuth(machine, machine.tilted(pair.tool), limit(machine, branch));
  return machine.work_side().sense > 0 ? pair.work - swing : pair.work + swing;
}

Pose lifted_to_pole(const Machine& machine, const BranchPart& part, const SingularPosture& pole) {
  return {tool_at(machine, part, pole.tool), work_at_pole(machine, part.start, part.branch)};
}

// fanuc.tool-posture.lift: The rotary axes follow the great circle without a jump from their actual positions at the
// start. The tool-side axis stays on its branch, and the work-side axis turns by the azimuth of the tool less that of
// the tool side. This gives the end pair, whole turns included, also in type 2. The choice by moving angles is not
// made. The manual's example of a changed end fits no other reading.
Pose lifted(const Machine& machine, const BranchPart& part, const std::optional<Angle>& swing, const Pose& pair) {
  Pose result{tool_at(machine, part, pair.tool), part.start.work};
  if (!swing && machine.is_orthogonal()) return result;
  const Angle tilted = machine.is_orthogonal() ? Angle() : tilt_swing(machine, part, result.tool);
  result.work = lifted_work(part.start.work, pair.work, swing.value_or(Angle()), tilted, machine);
  return result;
}

}  // namespace toolcomp::model
