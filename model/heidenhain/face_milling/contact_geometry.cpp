// SPDX-License-Identifier: Apache-2.0
#include "model/heidenhain/face_milling/contact_geometry.h"

#include <array>
#include <optional>
#include <utility>

#include "model/basis/event.h"
#include "model/heidenhain/program/tool_direction.h"

namespace toolcomp::model::klartext {

ContactGeometry::ContactGeometry(const Motion& motion) {
  const Direction& tool = motion.direction;
  const Direction normal = direction_of(*motion.normal);
  t = tool.unit;
  along = dot(normal.vector, tool.vector);
  lengths2 = normal.norm2 * tool.norm2;
  across2 = lengths2 - square(along);
  lengths = sqrt(lengths2);
  w = tool.norm2 * normal.vector - along * tool.vector;
  // The same numbers where both are parallel, so that what cancels does so at once.
  n = across2.sign() != Sign::zero ? normal.unit : along.sign() == Sign::positive ? t : -t;
}

// |w|² = (T.T) |N x T|².
Vector ContactGeometry::ring_direction() const {
  const Real w2 = squared_norm(w);
  if (w2.sign() == Sign::zero) throw NotFinite();  // only a forced outcome comes here
  return (sqrt(w2) / w2) * w;
}

// Of the angles whose cosine has a rational square only these are rational; any other one is not even algebraic in
// degrees, so that nothing rational is ever equal to it.
Real ContactGeometry::angle() const {
  static const std::array<std::pair<Rational, int>, 5> kKnown{
      {{Rational(0), 90}, {Rational(1, 4), 60}, {Rational(1, 2), 45}, {Rational(3, 4), 30}, {Rational(1), 0}}};
  const bool obtuse = along.sign() == Sign::negative;
  const Rational cosine2 = (square(along) / lengths2).rational();
  for (const auto& [known, degrees] : kKnown)
    if (cosine2 == known) return obtuse ? 180 - degrees : degrees;
  const Real acute_or_negative = exact::arctangent_degrees(sqrt(across2) / along);
  return obtuse ? 180 + acute_or_negative : acute_or_negative;
}

}  // namespace toolcomp::model::klartext
