// SPDX-License-Identifier: Apache-2.0
#include "model/kinematics/turn.h"

namespace toolcomp::model {
namespace {

Vector turned(const Turn& turn, const Vector& v, const Real& cosine, const Real& sine) {
  if (turn.about == 3) return cosine * v + sine * cross(turn.line, v) + (dot(turn.line, v) * (1 - cosine)) * turn.line;
  const std::size_t j = (turn.about + 1) % 3;
  const std::size_t k = (turn.about + 2) % 3;
  Vector result = v;
  component(result, j) = cosine * component(v, j) - sine * component(v, k);
  component(result, k) = sine * component(v, j) + cosine * component(v, k);
  return result;
}

Vector turned(const Turn& turn, const Vector& v, const Angle& by) { return turned(turn, v, by.cosine(), by.sine()); }

}  // namespace

Vector Turn::apply(const Vector& v, const Angle& position) const { return turned(*this, v, angle(position)); }
Vector Turn::apply_back(const Vector& v, const Angle& position) const { return turned(*this, v, -angle(position)); }

// Other irrational angles are not subtracted as such: inside a block no sign of them may be asked.
Vector Turn::carry(const Vector& v, const Angle& from, const Angle& to) const {
  if (const auto by = known_difference(from, to)) return turned(*this, v, Angle(sense < 0 ? Rational(-*by) : *by));
  const Real from_cosine = from.cosine();
  const Real from_sine = from.sine();
  const Real to_cosine = to.cosine();
  const Real to_sine = to.sine();
  const Real sine = from_sine * to_cosine - from_cosine * to_sine;
  return turned(*this, v, from_cosine * to_cosine + from_sine * to_sine, sense < 0 ? -sine : sine);
}

Angle Turn::angle(const Angle& position) const {
  const Angle sum = position + offset;
  return sense < 0 ? -sum : sum;
}
Angle Turn::position_at(const Angle& angle) const { return (sense < 0 ? -angle : angle) - offset; }

}  // namespace toolcomp::model
