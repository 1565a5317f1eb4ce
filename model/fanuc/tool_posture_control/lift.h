// SPDX-License-Identifier: Apache-2.0
// The rotary positions along a great circle: the continuous branch from the pair at its start.
#pragma once

#include "model/fanuc/tool_posture_control/great_circle_motion.h"
#include "model/fanuc/tool_posture_control/rules.h"
#include "model/kinematics/inverse.h"

namespace toolcomp::model {

// A pair that is not singular, from which an arc is followed.
struct LiftStart {
  Pose pose;
  int branch = 1;        // as of Solution
  bool on_edge = false;  // of reach: the branch is that of the pair to be reached
};

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
  [[nodiscard]] Pose at_pole(const LiftStart& start, const Pole& pole) const;
  // The work-side position at a pole from which an arc goes to this pair on this branch.
  [[nodiscard]] Angle back_at_pole(const Pose& pair, int branch) const;

  // A pair of the end, with the whole turns of a continuous motion.
  [[nodiscard]] Pose end(const LiftStart& start, const Way& way, const Pose& pair) const;
  // The same of a part that begins at a pole.
  [[nodiscard]] Pose end_behind(const BranchPart& part, const Pose& pair) const;

 private:
  // Where the tilted direction comes to a pole, or leaves it: the azimuth of this vector.
  [[nodiscard]] Vector limit(int branch) const;
  // The position of the tool-side axis at `end`, beside that of the start.
  [[nodiscard]] Angle tool_at(const LiftStart& start, const Angle& end) const;
  [[nodiscard]] bool on_upper_edge(const Angle& tool) const;
  [[nodiscard]] Angle turned_back(const Angle& work, const Angle& tilt_swing) const;
  // By how much the tool, tilted alone from the start to `end`, swings about u_w.
  [[nodiscard]] Angle tilt_swing_of(const LiftStart& start, const Angle& end) const;

  const Machine& machine_;
};

}  // namespace toolcomp::model
