// SPDX-License-Identifier: Apache-2.0
// The rotary positions along a great circle: the continuous branch from the pair at its start.
#pragma once

#include <optional>

#include "model/fanuc/tool_posture_control/motions.h"
#include "model/kinematics/machine.h"

namespace toolcomp::model {

// The branch on which the tool-side axis goes from one edge of reach to another.
int branch_between(const Machine& machine, const Angle& from, const Angle& to);
// The same, 1 between two of greatest, or of least, height.
int branch_toward(const Machine& machine, const Angle& from, const Angle& to);

// The pose in which an arc reaches the pole. Clause: fanuc.tool-posture.crossing.
Pose lifted_to_pole(const Machine& machine, const BranchPart& part, const SingularPosture& pole);
// The work-side position at a pole to which, or from which, an arc goes on this branch; it has this pair at the other
// end.
Angle work_at_pole(const Machine& machine, const Pose& pair, int branch);

// A pair of the end, with the whole turns of a continuous motion. `swing`: of the directions about the work-side axis;
// none where that lies in the plane of the arc. Clause: fanuc.tool-posture.lift.
Pose lifted(const Machine& machine, const BranchPart& part, const std::optional<Angle>& swing, const Pose& pair);

}  // namespace toolcomp::model
