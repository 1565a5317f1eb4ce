#include "model/heidenhain/peripheral_milling/lateral_direction.h"

#include "model/basis/alarm.h"
#include "model/basis/event.h"

namespace toolcomp::model::klartext {
namespace {

// |v|², the number 0 where v is 0: its components are shorter to prove than the sum of their squares.
Real proven_squared_norm(const Vector& v) { return exact::is_zero(v) ? Real() : squared_norm(v); }

// v/|v|. Where |v|² is rational the factor is a rational times one root, and components stay as short.
Vector unit(const Vector& v, const Real& norm2) {
  return norm2.is_rational() ? (sqrt(norm2) / norm2) * v : v / sqrt(norm2);
}

}  // namespace

LateralDirection LateralDirections::make(const Direction& tool, const Vector& travel, Side side) {
  const Vector across = cross(tool.vector, travel);
  const Real norm2 = proven_squared_norm(across);
  const Real travel2 = squared_norm(travel);
  const Real scale = travel2.sign() == Sign::zero ? Real(1) : tool.norm2 * travel2;
  if (recorder_.decide(Clause::heidenhain_peripheral_direction, norm2, scale) == Sign::zero) {
    if (!recorder_.decide(Clause::heidenhain_peripheral_former_direction, former_.has_value())) {
      recorder_.list(Clause::heidenhain_peripheral_former_direction);
      throw Alarm("E_NO_DIRECTION", "no direction of compensation: the tool is along the movement, or nothing moves");
    }
    return *former_;
  }
  if (norm2.sign() == Sign::zero) throw NotFinite();  // only a forced outcome comes here
  const bool left = recorder_.decide(Clause::heidenhain_peripheral_side, side == Side::left);
  const Vector c = left ? across : -across;
  former_ = LateralDirection{c, norm2, unit(c, norm2)};
  return *former_;
}

// Where the angle is obtuse 1 + c.c' = |c x c'|²/(1 - c.c'), which is 0 without a root.
Vector LateralDirections::mitre(const LateralDirection& a, const LateralDirection& b) const {
  const Real product = dot(a.vector, b.vector);
  const Real norms2 = a.norm2 * b.norm2;
  const Real cosine = product / sqrt(norms2);
  Real sum = 1 + cosine;
  if (product.sign() == Sign::negative) sum = proven_squared_norm(cross(a.vector, b.vector)) / (norms2 * (1 - cosine));
  if (recorder_.decide(Clause::heidenhain_peripheral_reversal, sum, 2) == Sign::zero)
    throw Alarm("E_REVERSAL", "the directions of compensation before and behind the end point are opposite");
  if (sum.sign() == Sign::zero) throw NotFinite();  // only a forced outcome comes here
  recorder_.reach(Clause::heidenhain_peripheral_mitre);
  return (a.unit + b.unit) / sum;
}

}  // namespace toolcomp::model::klartext
