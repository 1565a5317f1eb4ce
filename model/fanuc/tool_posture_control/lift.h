// SPDX-License-Identifier: Apache-2.0
// The rotary positions along a great circle: the continuous branch from the pair at its start.
#pragma once

#include "model/fanuc/tool_posture_control/motions.h"
#include "model/kinematics/machine.h"

namespace toolcomp::model {

// How an arc that meets no singular posture goes round the work-side axis.
struct Way {
  Vector from;  // directions at its ends, in the table frame or turned from there about that axis
  Vector to;
  int side = 0;  // on which the axis lies: left 1, right -1; 0 in the plane of the arc
};

// Clauses: fanuc.tool-posture.lift, crossing.
class Lift {
 public:
  explicit Lift(const Machine& machine) : machine_(machine) {}

  // Both axes can move, and turning them changes the direction.
  [[nodiscard]] bool is_possible() const { return machine_.has_both_axes() && machine_.tilts(); }

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

  // A pair of the end, with the whole turns of a continuous motion.
  [[nodiscard]] Pose end(const BranchPart& part, const Way& way, const Pose& pair) const;

 private:
  const Machine& machine_;
};

}  // namespace toolcomp::model
