// SPDX-License-Identifier: Apache-2.0
// Laws of arithmetic on random values with sines and roots, decided exactly.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "model/exact/vector.h"

namespace toolcomp::exact {
namespace {

// A number with 0 to 6 decimals.
Rational decimal(int bound) {
  long scale = 1;
  for (int i = *rc::gen::inRange(0, 7); i > 0; --i) scale *= 10;
  return {*rc::gen::inRange<long>(-bound * scale, bound * scale + 1), scale};
}

Real value() {
  const Rational number = decimal(1000);
  switch (*rc::gen::inRange(0, 5)) {
    case 0:
      return number;
    case 1:
      return sin_degrees(number);
    case 2:
      return decimal(10) * cos_degrees(number);
    case 3:
      return sqrt(Real(abs(number)));
    default:
      return sqrt(2 + sin_degrees(number)) - decimal(3);
  }
}

Vector3 vector() {
  Real x = value();
  Real y = value();
  return {std::move(x), std::move(y), Real(decimal(100))};
}

RC_GTEST_PROP(Laws, Ring, ()) {
  const Real a = value();
  const Real b = value();
  const Real c = value();
  RC_ASSERT(a + b == b + a);
  RC_ASSERT((a + b) + c == a + (b + c));
  RC_ASSERT(a * b == b * a);
  RC_ASSERT((a * b) * c == a * (b * c));
  RC_ASSERT(a * (b + c) == a * b + a * c);
  RC_ASSERT(a - b == -(b - a));
}

RC_GTEST_PROP(Laws, Quotients, ()) {
  const Real a = value();
  const Real b = value();
  const Real c = value();
  RC_PRE(b.sign() != Sign::zero && c.sign() != Sign::zero);
  RC_ASSERT(a / b * b == a);
  RC_ASSERT(a / b / c == a / (b * c));
  RC_ASSERT(a / (b / c) == a * c / b);
  RC_ASSERT((a / b).sign() == (a * b).sign());
}

RC_GTEST_PROP(Laws, AngleAdditionAtAnyDecimals, ()) {
  const Rational a = decimal(720);
  const Rational b = decimal(720);
  RC_ASSERT(sin_degrees(a + b) == sin_degrees(a) * cos_degrees(b) + cos_degrees(a) * sin_degrees(b));
  RC_ASSERT(cos_degrees(a - b) == cos_degrees(a) * cos_degrees(b) + sin_degrees(a) * sin_degrees(b));
}

RC_GTEST_PROP(Laws, Roots, ()) {
  const Real a = square(value());
  const Real b = square(value());
  RC_ASSERT(square(sqrt(a)) == a);
  RC_ASSERT(sqrt(a * b) == sqrt(a) * sqrt(b));
  RC_ASSERT(sqrt(a + b) <= sqrt(a) + sqrt(b));
  RC_ASSERT((sqrt(a) < sqrt(b)) == (a < b));
}

// Order agrees with differences, and every enclosure with the sign.
RC_GTEST_PROP(Laws, OrderAndEnclosures, ()) {
  const Real a = value();
  const Real b = value();
  const Sign sign = compare(a, b);
  RC_ASSERT(compare(b, a) == -sign);
  const Enclosure bounds = (a - b).enclosure();
  const DoubleEnclosure doubles = (a - b).double_enclosure();
  RC_ASSERT(bounds.lower <= bounds.upper);
  RC_ASSERT(Rational(doubles.lower) <= bounds.upper && Rational(doubles.upper) >= bounds.lower);
  if (sign == Sign::positive) RC_ASSERT(bounds.lower > 0 && doubles.upper > 0);
  if (sign == Sign::negative) RC_ASSERT(bounds.upper < 0 && doubles.lower < 0);
  if (sign == Sign::zero) RC_ASSERT(bounds.lower == 0 && bounds.upper == 0);
}

// The printed number is the nearest: no further than half a unit of the last place, by exact comparison.
RC_GTEST_PROP(Laws, DecimalsAreTheNearest, ()) {
  const Real a = value();
  const int digits = *rc::gen::inRange(0, 13);
  std::string text = a.decimal(digits);
  Rational unit = 1;
  for (int i = 0; i < digits; ++i) unit /= 10;
  const std::size_t point = text.find('.');
  RC_ASSERT(point == std::string::npos || text.back() != '0');
  RC_ASSERT(text != "-0");
  Rational scale = 1;
  if (point != std::string::npos) {
    for (std::size_t i = point + 1; i < text.size(); ++i) scale *= 10;
    text.erase(point, 1);
  }
  const bool negative = text.front() == '-';
  if (negative) text.erase(0, 1);
  text.erase(0, std::min(text.find_first_not_of('0'), text.size() - 1));
  const Rational printed = (negative ? -1 : 1) * Rational(Integer(text)) / scale;
  RC_ASSERT(square(2 * (a - printed)) <= square(Real(unit)));
}

RC_GTEST_PROP(Laws, Vectors, ()) {
  const Vector3 a = vector();
  const Vector3 b = vector();
  const Vector3 n = cross(a, b);
  RC_ASSERT(dot(n, a) == 0);
  RC_ASSERT(dot(n, b) == 0);
  RC_ASSERT(cross(b, a) == -n);
  // Lagrange's identity.
  RC_ASSERT(squared_norm(n) == squared_norm(a) * squared_norm(b) - square(dot(a, b)));
}

}  // namespace
}  // namespace toolcomp::exact
