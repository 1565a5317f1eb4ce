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

const GreatCircle::Turning& GreatCircle::turning() const {
  if (!turning_) {
    const Real length = sqrt(normal2_);
    // N is at right angles to `from`.
    turning_ = Turning{Angle::of_direction(dot(from_.vector, to_.vector), length).degrees(),
                       cross(normal_, from_.unit) / length};
  }
  return *turning_;
}

Real GreatCircle::swept(const Rational& t) const { return t * turning().degrees; }

// fanuc.tool-posture.great-circle: With posture control the direction of the tool stays in the plane of Vs and Ve, seen
// from the table, and turns in it evenly with t.
Vector GreatCircle::at(const Rational& t) const {
  if (t == Rational(1, 2)) {
    // Algebraic: what is zero in the middle of a symmetric arc is proven to be.
    const Vector middle = from_.unit + to_.unit;
    return middle / sqrt(squared_norm(middle));
  }
  const Real angle = swept(t);
  return exact::cos_real_degrees(angle) * from_.unit + exact::sin_real_degrees(angle) * turning().ahead;
}

bool known_same(const Vector& a, const Vector& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (!exact::alike(component(a, i), component(b, i))) return false;
  return true;
}

AxisPassed pass(const GreatCircle& arc, const Vector& axis) {
  const Real product = dot(arc.from().vector, arc.to().vector);
  AxisPassed result;
  result.side = dot(arc.normal(), axis);
  result.along_from = dot(arc.from().vector, axis);
  result.along_to = dot(arc.to().vector, axis);
  result.cosine_from = dot(arc.from().unit, axis);
  result.cosine_to = dot(arc.to().unit, axis);
  result.behind_start = arc.from().norm2 * result.along_to - product * result.along_from;
  result.before_end = arc.to().norm2 * result.along_from - product * result.along_to;
  return result;
}

AxisPassed operator-(const AxisPassed& passed) {
  return {-passed.side,     -passed.behind_start, -passed.before_end, -passed.along_from,
          -passed.along_to, -passed.cosine_from,  -passed.cosine_to};
}

}  // namespace toolcomp::model
