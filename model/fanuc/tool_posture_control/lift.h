// SPDX-License-Identifier: Apache-2.0
// The rotary positions along a great circle: the continuous branch from the pair at its start.
#pragma once

#include <optional>

#include "model/fanuc/tool_posture_control/motions.h"
#include "model/kinematics/machine.h"

namespace toolcomp::model {

// Clauses: fanuc.tool-posture.lift, crossing.
class Lift {
 public:
  explicit Lift(const Machine& machine) : machine_(machine) {}

  // The side on which a tool-side position stands; 0 at the edge of reach.
  [[nodiscard]] int branch_of(const Angle& tool) const;
  // The branch on which the tool-side axis goes from one edge of reach to another.
  [[nodiscard]] int branch_between(const Angle& from, const Angle& to) const;
  // The same, 1 between two of greatest, or of least, height.
  [[nodiscard]] int branch_toward(const Angle& from, const Angle& to) const;

  // The pose in which an arc reaches the pole.
  [[nodiscard]] Pose at_pole(const BranchPart& part, const SingularPosture& pole) const;
  // The work-side position at a pole to which, or from which, an arc goes on this branch; it has this pair at the other
  // end.
  [[nodiscard]] Angle work_at_pole(const Pose& pair, int branch) const;

  // A pair of the end, with the whole turns of a continuous motion. `swing`: of the directions about the work-side
  // axis; none where that lies in the plane of the arc.
  [[nodiscard]] Pose end(const BranchPart& part, const std::optional<Angle>& swing, const Pose& pair) const;

 private:
  const Machine& machine_;
};

}  // namespace toolcomp::model
