// SPDX-License-Identifier: Apache-2.0
#include "model/kinematics/angle.h"

#include <utility>

namespace toolcomp::model {
namespace {

Rational with_sign(Sign sign, int value) { return sign == Sign::negative ? -value : value; }

// The angles of which sine and cosine, or their magnitudes, agree with small whole numbers; (x, y) is not (0, 0). One
// that is not proven to be such an angle is as good as another.
std::optional<Rational> multiple_of_45(const Real& x, const Real& y) try {
  const Sign of_x = x.sign();
  const Sign of_y = y.sign();
  if (of_y == Sign::zero) return Rational(of_x == Sign::negative ? 180 : 0);
  if (of_x == Sign::zero) return with_sign(of_y, 90);
  if ((of_x == of_y ? x - y : x + y).sign() == Sign::zero) return with_sign(of_y, of_x == Sign::positive ? 45 : 135);
  return std::nullopt;
} catch (const exact::Undecided&) {
  return std::nullopt;
}

// The principal angle of a cosine and a sine none of which is zero, from an arc tangent of magnitude 1 at most.
Real arctangent(const Real& cosine, const Real& sine) {
  if ((square(cosine) - square(sine)).sign() == Sign::negative)
    return Real(with_sign(sine.sign(), 90)) - arctangent_degrees(cosine / sine);
  const Real angle = arctangent_degrees(sine / cosine);
  return cosine.sign() == Sign::positive ? angle : Real(with_sign(sine.sign(), 180)) + angle;
}

// A whole number of thousandths that may be x, if there is one. Mostly there is none, which rough bounds tell.
std::optional<Rational> thousandths(const Real& x) {
  constexpr int rough = 40;
  constexpr int fine = 90;
  const Rational near = Rational(1, Integer(1) << 60);
  std::optional<Rational> value;
  for (const int bits : {rough, fine}) {
    const exact::Enclosure bounds = x.enclosure(bits);
    value = Rational(floor(bounds.lower * 1000 + Rational(1, 2))) / 1000;
    const Rational width = bounds.upper - bounds.lower;
    if (*value - bounds.lower > near + width || bounds.upper - *value > near + width) return std::nullopt;
  }
  return value;
}

}  // namespace

Angle Angle::of_unit(const Real& cosine, const Real& sine) {
  if (const auto known = multiple_of_45(cosine, sine)) return *known;
  Angle result;
  result.rest_ = Rest{cosine, sine, std::nullopt};
  return result;
}

Angle Angle::known(const Real& cosine, const Real& sine, const Real& degrees) {
  Angle result;
  result.rest_ = Rest{cosine, sine, degrees};
  return result;
}

Angle Angle::of_direction(const Real& x, const Real& y) {
  if (const auto known = multiple_of_45(x, y)) return *known;
  const Real norm = sqrt(square(x) + square(y));
  Angle result;
  result.rest_ = Rest{x / norm, y / norm, std::nullopt};
  return result;
}

Real Angle::cosine() const {
  if (rest_ && no_rational()) return rest_->cosine;
  const Rational degrees = rational();
  const Real of_rational = exact::cos_degrees(degrees);
  return rest_ ? of_rational * rest_->cosine - exact::sin_degrees(degrees) * rest_->sine : of_rational;
}

Real Angle::sine() const {
  if (rest_ && no_rational()) return rest_->sine;
  const Rational degrees = rational();
  const Real of_rational = exact::sin_degrees(degrees);
  return rest_ ? of_rational * rest_->cosine + exact::cos_degrees(degrees) * rest_->sine : of_rational;
}

Real Angle::degrees() const { return recognised().plain_degrees(); }

Real Angle::plain_degrees() const { return rest_ ? rational_ + degrees_of(*rest_) : rational_; }

Angle Angle::recognised() const {
  if (!rest_ || rest_->degrees) return *this;
  const std::optional<Rational> value = thousandths(arctangent(rest_->cosine, rest_->sine));
  if (!value) return *this;
  const Real difference = rest_->sine * exact::cos_degrees(*value) - rest_->cosine * exact::sin_degrees(*value);
  try {
    return difference.sign() == Sign::zero ? Angle(rational() + *value) : *this;
  } catch (const exact::Undecided&) {
    return *this;
  }
}

Integer Angle::nearest_turns() const {
  if (!rest_) return no_rational() ? Integer(0) : -floor((180 - rational()) / 360);
  if (no_rational()) {
    // A rest is principal. A zero among its cosine and sine is proven here, and known from now on.
    if (rest_->cosine.sign() != Sign::positive) static_cast<void>(rest_->sine.sign());
    return 0;
  }
  // In [-180, 180), but 180 itself is principal.
  Integer turns = floor((rational() + 180) / 360);
  const Angle rest = plus_turns(-turns);
  if (rest.no_rational()) return turns + rest.nearest_turns();
  if (order(rest, 180).sign() == Sign::positive) return turns + 1;
  if (order(rest, -180).sign() != Sign::positive) return turns - 1;
  return turns;
}

Integer Angle::whole_turns() const {
  Integer turns = floor(rational() / 360);
  if (!rest_) return turns;
  const Angle rest = plus_turns(-turns);
  if (order(rest, 0).sign() == Sign::negative) return turns - 1;
  if (order(rest, 360).sign() != Sign::negative) return turns + 1;
  return turns;
}

Angle Angle::plus_turns(const Integer& turns) const {
  Angle result(*this);
  if (!turns.is_zero()) result.rational_ += Rational(360 * turns);
  return result;
}

Angle operator-(const Angle& a) {
  Angle result(a);
  result.rational_ = -a.rational_;
  if (result.rest_) {
    result.rest_->sine = -a.rest_->sine;
    if (result.rest_->degrees) result.rest_->degrees = -*a.rest_->degrees;
  }
  return result;
}

Angle operator+(const Angle& a, const Angle& b) {
  Angle result = a.rest_ ? a : b;
  result.rational_ += a.rest_ ? b.rational_ : a.rational_;
  if (!a.rest_ || !b.rest_) return result;
  result.rest_.reset();
  const Angle::Rest& x = *a.rest_;
  const Angle::Rest& y = *b.rest_;
  // An angle and its opposite: nothing is left to decide, unless both are 180 degrees that were not recognised.
  if (known_zero(x.cosine - y.cosine) && known_zero(x.sine + y.sine) && x.cosine.enclosure().lower > -1) return result;
  const Real cosine = x.cosine * y.cosine - x.sine * y.sine;
  const Real sine = x.sine * y.cosine + x.cosine * y.sine;
  const int turns = Angle::turns_of_sum(x, y, cosine, sine);
  result.rational_ += 360 * turns;
  if (x.degrees || y.degrees) {
    const Real sum = Angle::degrees_of(x) + Angle::degrees_of(y) - 360 * turns;
    result.rest_ = Angle::Rest{cosine, sine, sum};
    return result;
  }
  const Angle sum = Angle::of_unit(cosine, sine);
  result.rational_ += sum.rational_;
  result.rest_ = sum.rest_;
  return result;
}

// Of two rests within 90 degrees of 0 none is needed. The sine of a rest beyond is far from zero: its sign is certain.
int Angle::turns_of_sum(const Rest& x, const Rest& y, const Real& cosine, const Real& sine) {
  const bool x_is_near = x.cosine.sign() == Sign::positive;
  const bool y_is_near = y.cosine.sign() == Sign::positive;
  if (x_is_near && y_is_near) return 0;
  const Sign side = (x_is_near ? y : x).sine.sign();
  if (!x_is_near && !y_is_near) return y.sine.sign() == side ? static_cast<int>(side) : 0;
  if (cosine.sign() == Sign::positive) return 0;
  const Sign of_sum = sine.sign();
  const bool beyond = of_sum == -side || (of_sum == Sign::zero && side == Sign::negative);
  return beyond ? static_cast<int>(side) : 0;
}

Real Angle::degrees_of(const Rest& rest) { return rest.degrees ? *rest.degrees : arctangent(rest.cosine, rest.sine); }

Angle operator-(const Angle& a, const Angle& b) { return a + -b; }

std::optional<Rational> known_difference(const Angle& a, const Angle& b) {
  if (a.rest_.has_value() != b.rest_.has_value()) return std::nullopt;
  if (a.rest_ && !(known_zero(a.rest_->cosine - b.rest_->cosine) && known_zero(a.rest_->sine - b.rest_->sine)))
    return std::nullopt;
  return (a.rational_ - b.rational_).rational();
}

Real order(const Angle& a, const Angle& b) {
  const Angle difference = a - b;
  const Rational whole = difference.rational();
  if (!difference.rest_) {
    const Rational radians = whole * Rational(71, 4068);  // about
    return radians > 1 ? Real(1) : radians < -1 ? Real(-1) : Real(radians);
  }
  if (whole < 0) return -order(-difference, 0);
  // A rest is more than -180: the difference is more than 90.
  if (whole >= 270) return 1;
  const bool rest_is_near = difference.rest_->cosine.sign() == Sign::positive;
  if (rest_is_near && whole >= 180) return 1;
  if (!rest_is_near && difference.rest_->sine.sign() == Sign::positive) return 1;
  // The difference lies between -180 and 270.
  if (difference.cosine().sign() == Sign::positive) return difference.sine();
  return !rest_is_near && whole < 90 ? -1 : 1;
}

Angle absolute(const Angle& a) { return sign(a) == Sign::negative ? -a : a; }

}  // namespace toolcomp::model
