// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_posture_control/linear_motion.h"

namespace toolcomp::model {

Angle between(const Angle& start, const Angle& end, const Rational& t) {
  // A rational way keeps the position exact, whatever it starts from.
  if (const Angle way = end - start; way.is_rational()) return start + Angle(Rational(t * way.rational()));
  const Real degrees = Real(Rational(1 - t)) * start.degrees() + t * end.degrees();
  return Angle::known(exact::cos_real_degrees(degrees), exact::sin_real_degrees(degrees), degrees);
}

// fanuc.tool-center-point.conventional: Under conventional control each rotary axis goes by itself, evenly, from the
// start pair to the end pair, while the tip runs along its path. The manual says that the rotary axes are not coupled.
// That they go evenly with the path is our reading.
// fanuc.tool-posture.passing: A block with a changed end passes the singular posture while the rotary axes run evenly
// with t and the work side stands. With orthogonal axes this is the great circle to the changed end.
Posture LinearMotion::at(const Rational& t) const {
  const Pose pose{between(start_.tool, end_.tool, t), between(start_.work, end_.work, t)};
  return {pose, frame_->frame.direction(pose)};
}

}  // namespace toolcomp::model
