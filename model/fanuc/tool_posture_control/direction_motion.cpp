// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_posture_control/direction_motion.h"

namespace toolcomp::model {

DirectionMotion::DirectionMotion(const Direction& from, const Direction& to) : first_(from.unit) {
  if (!is_zero(cross(from.vector, to.vector))) arc_.emplace(from, to);
}

// fanuc.tool-center-point.without-kinematics: With 19680 = 0 G43.4 raises PS5459. G43.5 then takes I J K, leaned by Q
// as on any machine, for the direction itself. Nothing is turned, reached or chosen, no posture is singular, WKP does
// not count, and P makes no difference. Inside a block the direction goes evenly along the great circle. Between
// opposite directions there is no great circle, and the direction stays the first one until the end.
Posture DirectionMotion::at(const Rational& t) const { return {Pose(), arc_ ? arc_->at(t) : first_}; }

MotionForm DirectionMotion::form() const {
  if (!arc_) return DirectionSwing{first_, Vector(), 0};
  return DirectionSwing{first_, arc_->ahead(), arc_->degrees()};
}

}  // namespace toolcomp::model
