// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_posture_control/great_circle.h"

#include <utility>

#include "model/basis/event.h"
#include "model/exact/alike.h"
#include "model/kinematics/angle.h"

namespace toolcomp::model {

GreatCircle::GreatCircle(Direction from, Direction to)
    : from_(std::move(from)),
      to_(std::move(to)),
      normal_(cross(from_.vector, to_.vector)),
      normal2_(squared_norm(normal_)) {
  if (normal2_.sign() == Sign::zero) throw NotFinite();
}

const DirectionSwing& GreatCircle::swing() const {
  if (!swing_) {
    const Real length = sqrt(normal2_);
    // N is at right angles to `from`.
    swing_ = {from_.unit, cross(normal_, from_.unit) / length,
              Angle::of_direction(dot(from_.vector, to_.vector), length).degrees()};
  }
  return *swing_;
}

// fanuc.tool-posture.great-circle: With posture control the direction of the tool stays in the plane of Vs and Ve, seen
// from the table, and turns in it evenly with t.
Vector GreatCircle::at(const Rational& t) const {
  if (t == Rational(1, 2)) {
    // Algebraic: what is zero in the middle of a symmetric arc is proven to be.
    const Vector middle = from_.unit + to_.unit;
    return middle / sqrt(squared_norm(middle));
  }
  const Real angle = swept(t);
  return exact::cos_real_degrees(angle) * from_.unit + exact::sin_real_degrees(angle) * swing().ahead;
}

bool known_same(const Vector& a, const Vector& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (!exact::alike(component(a, i), component(b, i))) return false;
  return true;
}

AxisPassed pass(const GreatCircle& arc, const Vector& axis) {
  const Direction& from = arc.from();
  const Direction& to = arc.to();
  const Real product = dot(from.vector, to.vector);
  AxisPassed result{arc, axis, dot(arc.normal(), axis), dot(from.vector, axis), dot(to.vector, axis), {}, {}};
  result.behind_start = from.norm2 * result.along_to - product * result.along_from;
  result.before_end = to.norm2 * result.along_from - product * result.along_to;
  return result;
}

}  // namespace toolcomp::model
