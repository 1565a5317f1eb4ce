// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_posture_control/lift.h"

namespace toolcomp::model {
namespace {

int as_int(Sign sign) { return static_cast<int>(sign); }

}  // namespace

int Lift::branch_of(const Angle& tool) const { return as_int(branch_quantity(machine_, tool).sign()); }

bool Lift::on_upper_edge(const Angle& tool) const {
  const Real height = dot(machine_.work_side().line, machine_.tilted(tool));
  return (height - machine_.heights().mean).sign() == Sign::positive;
}

// From the greatest height branch 1 turns up, from the least down.
int Lift::branch_between(const Angle& from, const Angle& to) const {
  const int up = machine_.tool_side().sense * as_int(sign(to - from));
  if (up == 0) return 1;
  return on_upper_edge(from) ? up : -up;
}

int Lift::branch_toward(const Angle& from, const Angle& to) const {
  return on_upper_edge(from) == on_upper_edge(to) ? 1 : branch_between(from, to);
}

Vector Lift::limit(int branch) const {
  return Real(branch) * cross(machine_.tool_side().line, machine_.work_side().line);
}

Angle Lift::turned_back(const Angle& work, const Angle& tilt_swing) const {
  return machine_.work_side().sense > 0 ? work - tilt_swing : work + tilt_swing;
}

Angle Lift::tool_at(const LiftStart& start, const Angle& end) const {
  // Only from edge to edge the branch matters, and there the lower edge is left the other way.
  const bool lower = start.on_edge && !on_upper_edge(start.pose.tool);
  return lifted_tool(start.pose.tool, end, lower ? -start.branch : start.branch, machine_);
}

Pose Lift::at_pole(const LiftStart& start, const Pole& pole) const {
  Pose result{tool_at(start, pole.tool), start.pose.work};
  if (!machine_.is_orthogonal())
    result.work =
        turned_back(start.pose.work, azimuth(machine_, machine_.tilted(start.pose.tool), limit(start.branch)));
  return result;
}

Angle Lift::back_at_pole(const Pose& pair, int branch) const {
  if (machine_.is_orthogonal()) return pair.work;
  return turned_back(pair.work, azimuth(machine_, machine_.tilted(pair.tool), limit(branch)));
}

// From edge to edge it is 180 degrees, past the side of the branch.
Angle Lift::tilt_swing_of(const LiftStart& start, const Angle& end) const {
  const Vector from = machine_.tilted(start.pose.tool);
  const Vector to = machine_.tilted(end);
  if (!start.on_edge) return azimuth(machine_, from, to);
  const Vector side = limit(start.branch);
  return azimuth(machine_, from, side) + azimuth(machine_, side, to);
}

// fanuc.tool-posture.lift: The rotary axes follow the great circle without a jump from their actual positions at the
// start. The tool-side axis stays on its branch, and the work-side axis turns by the azimuth of the tool less that of
// the tool side. This gives the end pair, whole turns included, also in type 2. The choice by moving angles is not
// made. The manual's example of a changed end fits no other reading.
Pose Lift::end(const LiftStart& start, const Way& way, const Pose& pair) const {
  Pose result{tool_at(start, pair.tool), start.pose.work};
  if (way.side == 0 && machine_.is_orthogonal()) return result;
  Angle swing;
  if (way.side != 0) {
    swing = azimuth(machine_, way.from, way.to);
    // Only a forced side goes the other way round.
    const Sign right = sign(swing);
    if (swing.cosine().sign() == Sign::negative && as_int(right) == -way.side) swing = swing.plus_turns(way.side);
  }
  const Angle tilt_swing = machine_.is_orthogonal() ? Angle() : tilt_swing_of(start, result.tool);
  result.work = lifted_work(start.pose.work, pair.work, swing, tilt_swing, machine_);
  return result;
}

Pose Lift::end_behind(const BranchPart& part, const Pose& pair) const {
  // The edge of reach is half a turn from the pole; from the one below the branch is left the other way.
  Pose result{lifted_tool(part.start.tool, pair.tool, part.pole * part.branch, machine_), part.start.work};
  if (!machine_.is_orthogonal())
    result.work = lifted_work(part.start.work, pair.work, Angle(),
                              azimuth(machine_, limit(part.branch), machine_.tilted(result.tool)), machine_);
  return result;
}

}  // namespace toolcomp::model
