// SPDX-License-Identifier: Apache-2.0
// Rotary axes that run evenly from pose to pose: conventional control, and the block that passes a singular posture.
#pragma once

#include <utility>

#include "model/kinematics/control_frame.h"
#include "model/kinematics/posture_motion.h"

namespace toolcomp::model {

// Clauses: fanuc.tool-center-point.conventional, fanuc.tool-posture.passing.
class LinearMotion : public PostureMotion {
 public:
  LinearMotion(SharedFrame frame, Pose start, Pose end)
      : frame_(std::move(frame)), start_(std::move(start)), end_(std::move(end)) {}

  [[nodiscard]] Posture at(const Rational& t) const override;
  [[nodiscard]] MotionForm form() const override { return EvenTurns{start_, end_}; }

 private:
  SharedFrame frame_;
  Pose start_;
  Pose end_;
};

// The position at the fraction t of an even way.
Angle between(const Angle& start, const Angle& end, const Rational& t);

}  // namespace toolcomp::model
