// SPDX-License-Identifier: Apache-2.0
// Sines and cosines of angles that are results themselves. Expected values are computed by MPFR with
// radians at 400 bits, or follow from identities.
#include <gtest/gtest.h>
#include <mpfr.h>

#include <array>

#include "model/exact/real.h"

namespace toolcomp::exact {
namespace {

constexpr mpfr_prec_t kPrecision = 400;

struct Number {
  Number() { mpfr_init2(value, kPrecision); }
  ~Number() { mpfr_clear(value); }
  Number(const Number&) = delete;
  Number& operator=(const Number&) = delete;
  Number(Number&&) = delete;
  Number& operator=(Number&&) = delete;
  mpfr_t value;  // NOLINT(misc-non-private-member-variables-in-classes)
};

// Rounding errors of the reference, far below the enclosures'.
bool holds(const Enclosure& bounds, const Number& x) {
  const Rational slack = Rational(1, Integer(1) << 300);
  const Rational low = bounds.lower - slack;
  const Rational high = bounds.upper + slack;
  return mpfr_cmp_q(x.value, low.raw()) >= 0 && mpfr_cmp_q(x.value, high.raw()) <= 0;
}

// t atan(y / x) in radians.
void fraction_of_arctangent(Number& result, int y, int x, const Rational& t) {
  mpfr_set_si(result.value, y, MPFR_RNDN);
  mpfr_div_si(result.value, result.value, x, MPFR_RNDN);
  mpfr_atan(result.value, result.value, MPFR_RNDN);
  mpfr_mul_q(result.value, result.value, t.raw(), MPFR_RNDN);
}

TEST(AngleFunctions, SinesOfFractionsOfArctangents) {
  for (int y = -7; y <= 7; ++y)
    for (int x = 1; x <= 5; ++x)
      for (const Rational& t : {Rational(1, 4), Rational(2, 3), Rational(1), Rational(17, 10), Rational(-5)}) {
        const Real degrees = t * arctangent_degrees(Rational(y, x));
        Number angle;
        fraction_of_arctangent(angle, y, x, t);
        Number expected;
        mpfr_sin(expected.value, angle.value, MPFR_RNDN);
        EXPECT_TRUE(holds(sin_real_degrees(degrees).enclosure(150), expected)) << y << ' ' << x << ' ' << t;
        mpfr_cos(expected.value, angle.value, MPFR_RNDN);
        EXPECT_TRUE(holds(cos_real_degrees(degrees).enclosure(150), expected)) << y << ' ' << x << ' ' << t;
      }
}

// MPFR's arctangent, which the model does not use, at 400 bits.
TEST(AngleFunctions, ArctangentsAreThoseOfMpfr) {
  const Rational huge(Integer(1) << 200);
  for (const Rational& size : {Rational(1), Rational(1, 3), Rational(1000003, 1000000), 1 / huge, huge})
    for (const Rational& tangent : {size, Rational(-size)}) {
      Number expected;
      mpfr_set_q(expected.value, tangent.raw(), MPFR_RNDN);
      mpfr_atanu(expected.value, expected.value, 360, MPFR_RNDN);
      const Enclosure bounds = arctangent_degrees(Real(tangent)).enclosure(150);
      EXPECT_TRUE(holds(bounds, expected)) << tangent;
      EXPECT_LT(bounds.upper - bounds.lower, Rational(1, Integer(1) << 140)) << tangent;
    }
  EXPECT_EQ(arctangent_degrees(Real(-1)).decimal(40), "-45");
  EXPECT_EQ(arctangent_degrees(Real(0)).decimal(40), "0");
}

TEST(AngleFunctions, SineOfAnArctangentIsItsSide) {
  // 3, 4, 5.
  const Real angle = arctangent_degrees(Rational(3, 4));
  EXPECT_EQ(sin_real_degrees(angle).decimal(40), "0.6");
  EXPECT_EQ(cos_real_degrees(-angle).decimal(40), "0.8");
  EXPECT_EQ(sin_real_degrees(-angle).decimal(40), "-0.6");
  EXPECT_EQ(cos_real_degrees(angle * 2).decimal(40), "0.28");
}

TEST(AngleFunctions, OfRationalDegreesTheyAreTheCyclotomicOnes) {
  EXPECT_EQ((sin_real_degrees(Real(30)) - Rational(1, 2)).sign(), Sign::zero);
  EXPECT_EQ((square(sin_real_degrees(Real(17))) + square(cos_real_degrees(Real(17))) - 1).sign(), Sign::zero);
}

TEST(AngleFunctions, Pi) {
  EXPECT_EQ(pi().decimal(30), "3.14159265358979323846264338328");
  EXPECT_EQ((Real(Rational(22, 7)) - pi()).sign(), Sign::positive);
  // The zeros of an algebraic function at a transcendental number are those it has everywhere.
  EXPECT_EQ((pi() * pi() - square(pi())).sign(), Sign::zero);
  const Real x = sqrt(Real(3)) + pi();
  EXPECT_EQ(sqrt(square(x) + 2 * x + 1), x + 1);
  EXPECT_EQ(sqrt(square(Real(3) - pi()) - 2 * (3 - pi()) + 1), pi() - 2);
  EXPECT_EQ((square(x) - 3) / (x + sqrt(Real(3))), x - sqrt(Real(3)));
  EXPECT_EQ(sqrt(pi() + sin_degrees(20)) * sqrt(pi() - sin_degrees(20)), sqrt(square(pi()) - square(sin_degrees(20))));
  // Near misses are told from zero.
  const Rational tiny = Rational(1, Integer(1) << 400);
  EXPECT_EQ((sqrt(square(x) + 2 * x + 1 + tiny) - (x + 1)).sign(), Sign::positive);
}

// What holds for any angles in their place is proven.
TEST(AngleFunctions, IdentitiesOfArctangents) {
  const Real angle = arctangent_degrees(sqrt(Real(2)) / 7);
  const Real same = arctangent_degrees(1 / sqrt(Real(Rational(49, 2))));
  EXPECT_EQ(square(angle + 1) - square(same) - 2 * same, 1);
  EXPECT_EQ(sqrt(square(angle)), same);
  EXPECT_EQ((angle * pi() + sqrt(square(angle) * pi() * pi())) / (pi() * angle), 2);
  const Real third = angle / 3;
  EXPECT_EQ(square(sin_real_degrees(third)) - square(sin_real_degrees(same / 3)), 0);
}

// A proof would have to know what a sine is of an arc tangent.
TEST(AngleFunctions, AZeroThatIsNoIdentityIsUndecided) {
  const Real angle = arctangent_degrees(Rational(3, 4));
  EXPECT_THROW(static_cast<void>((sin_real_degrees(angle) - Rational(3, 5)).sign()), Undecided);
  // Anything else is decided.
  EXPECT_EQ(
      (sin_real_degrees(angle) - Rational("600000000000000000000000000001/1000000000000000000000000000000")).sign(),
      Sign::negative);
}

}  // namespace
}  // namespace toolcomp::exact
