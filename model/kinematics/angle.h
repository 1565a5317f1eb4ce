// SPDX-License-Identifier: Apache-2.0
// The position of a rotary axis, exact: rational degrees, whole turns included, or with a rest known by its cosine and
// sine. Comparisons read signs of algebraic numbers; the angle in degrees is for output only.
#pragma once

#include <optional>

#include "model/exact/real.h"

namespace toolcomp::model {

using exact::Integer;
using exact::Rational;
using exact::Real;
using exact::Sign;

class Angle {
 public:
  Angle() = default;                                      // 0
  Angle(const Rational& degrees) : rational_(degrees) {}  // NOLINT(google-explicit-constructor): every rational is one
  Angle(int degrees) : rational_(degrees) {}              // NOLINT(google-explicit-constructor)

  // The principal angle, in (-180, 180], of this cosine and sine; their squares add up to 1.
  static Angle of_unit(const Real& cosine, const Real& sine);
  // An angle inside a block, of which no sign may be asked because a zero could not be proven: cosine, sine and degrees
  // of a principal angle, as they are.
  static Angle known(const Real& cosine, const Real& sine, const Real& degrees);
  // The principal angle of a direction; x and y are not both zero.
  static Angle of_direction(const Real& x, const Real& y);

  [[nodiscard]] bool is_rational() const { return !rest_; }
  // Degrees; requires is_rational().
  [[nodiscard]] Rational rational() const { return rational_.rational(); }

  [[nodiscard]] Real cosine() const;
  [[nodiscard]] Real sine() const;
  // For output: the arc tangent of a rest is never proven equal to a number.
  [[nodiscard]] Real degrees() const;
  // The same without the trouble of recognising a rational.
  [[nodiscard]] Real plain_degrees() const;
  // The same angle, without a rest where that is a whole number of thousandths of a degree.
  [[nodiscard]] Angle recognised() const;

  // The difference a - b where it is known to be rational without asking a sign: of rational angles, and of angles with
  // the same rest.
  friend std::optional<Rational> known_difference(const Angle& a, const Angle& b);

  // The whole number n for which angle - 360 n lies in (-180, 180].
  [[nodiscard]] Integer nearest_turns() const;
  // The largest n with 360 n <= angle.
  [[nodiscard]] Integer whole_turns() const;
  [[nodiscard]] Angle plus_turns(const Integer& turns) const;
  // In (-180, 180].
  [[nodiscard]] Angle principal() const { return plus_turns(-nearest_turns()); }

  friend Angle operator-(const Angle& a);
  friend Angle operator+(const Angle& a, const Angle& b);
  friend Angle operator-(const Angle& a, const Angle& b);

 private:
  // cos and sin of an angle in (-180, 180] that is not known to be rational; 180 itself where it was not recognised.
  struct Rest {
    Real cosine;
    Real sine;
    std::optional<Real> degrees;  // where it was given
  };
  friend Real order(const Angle& a, const Angle& b);

  [[nodiscard]] bool no_rational() const { return rational_.sign() == Sign::zero; }
  // The full turns that the sum of two rests, of this cosine and sine, is away from its principal angle.
  static int turns_of_sum(const Rest& x, const Rest& y, const Real& cosine, const Real& sine);
  static Real degrees_of(const Rest& rest);

  Real rational_;  // counted, not copied
  std::optional<Rest> rest_;
};

Angle operator-(const Angle& a);
Angle operator+(const Angle& a, const Angle& b);
Angle operator-(const Angle& a, const Angle& b);

std::optional<Rational> known_difference(const Angle& a, const Angle& b);

// A number with the sign of a - b and of magnitude at most 1: the sine of the difference where that is less than 90
// degrees. For a recorder's decide().
Real order(const Angle& a, const Angle& b);
// |a|.
Angle absolute(const Angle& a);

// Certified; they throw exact::Undecided.
inline Sign sign(const Angle& a) { return order(a, Angle()).sign(); }
inline bool operator==(const Angle& a, const Angle& b) { return order(a, b).sign() == Sign::zero; }
inline bool operator<(const Angle& a, const Angle& b) { return order(a, b).sign() == Sign::negative; }
inline bool operator>(const Angle& a, const Angle& b) { return b < a; }
inline bool operator<=(const Angle& a, const Angle& b) { return !(b < a); }
inline bool operator>=(const Angle& a, const Angle& b) { return !(a < b); }

}  // namespace toolcomp::model
