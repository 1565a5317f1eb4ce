// SPDX-License-Identifier: Apache-2.0
// The tool without rotary axes: G43.5 on a machine that has none.
#pragma once

#include <optional>

#include "model/fanuc/tool_posture_control/great_circle.h"
#include "model/kinematics/posture_motion.h"

namespace toolcomp::model {

// Along the great circle; between opposite directions the first one stays until the end. Clause:
// fanuc.tool-center-point.without-kinematics.
class DirectionMotion : public PostureMotion {
 public:
  DirectionMotion(const Direction& from, const Direction& to);

  [[nodiscard]] Posture at(const Rational& t) const override;
  [[nodiscard]] MotionForm form() const override;

 private:
  Vector first_;
  std::optional<GreatCircle> arc_;
};

}  // namespace toolcomp::model
