#include "model/fanuc/tool_posture_control/direction_motion.h"

namespace toolcomp::model {

DirectionMotion::DirectionMotion(const Direction& from, const Direction& to) : first_(from.unit) {
  if (!is_zero(cross(from.vector, to.vector))) arc_.emplace(from, to);
}

Posture DirectionMotion::at(const Rational& t) const { return {Pose(), arc_ ? arc_->at(t) : first_}; }

}  // namespace toolcomp::model
