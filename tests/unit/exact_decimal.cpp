// SPDX-License-Identifier: Apache-2.0
// Correctly rounded decimals, half to even, at constructed ties and around them.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "model/exact/real.h"

namespace toolcomp::exact {
namespace {

// Zero in disguise: exact arithmetic alone can tell.
Real disguised_zero() {
  const Rational a(12345, 1000);
  return square(sin_degrees(a)) + square(cos_degrees(a)) - 1;
}

TEST(Decimal, RationalsHalfToEven) {
  const std::vector<std::pair<Rational, std::string>> cases = {
      {0, "0"},
      {Rational(1, 2000), "0"},
      {Rational(3, 2000), "0.002"},
      {Rational(5, 2000), "0.002"},
      {Rational(7, 2000), "0.004"},
      {Rational(-1, 2000), "0"},
      {Rational(-3, 2000), "-0.002"},
      {Rational(-5, 2000), "-0.002"},
      {Rational(1, 3), "0.333"},
      {Rational(2, 3), "0.667"},
      {Rational(-2, 3), "-0.667"},
      {Rational(9999, 10000), "1"},
      {Rational(-99996, 10000), "-10"},
      {100, "100"},
      {-1200, "-1200"},
      {Rational(1205, 100), "12.05"},
      {Rational(-1, 100000), "0"},
      {Rational(1, 1000), "0.001"},
  };
  for (const auto& [value, text] : cases) {
    EXPECT_EQ(Real(value).decimal(3), text) << value;
    // The same value, not known to be rational.
    EXPECT_EQ((Real(value) + disguised_zero()).decimal(3), text) << value;
  }
}

TEST(Decimal, TiesAreDecidedByProofAndNearTiesByRefinement) {
  const Real tie = Rational(25, 10);
  EXPECT_EQ((tie + disguised_zero()).decimal(0), "2");
  Rational tiny = 1;
  for (int i = 0; i < 100; ++i) tiny /= 10;
  EXPECT_EQ((tie + disguised_zero() + tiny).decimal(0), "3");
  EXPECT_EQ((tie + disguised_zero() - tiny).decimal(0), "2");
  EXPECT_EQ((tie + 1 + disguised_zero()).decimal(0), "4");
  EXPECT_EQ((tie + 1 + disguised_zero() - tiny).decimal(0), "3");
  EXPECT_EQ((-tie - disguised_zero() - tiny).decimal(0), "-3");
  // A tie by nested roots: sqrt(3 + 2 sqrt 2) - sqrt 2 = 1.
  EXPECT_EQ(((sqrt(3 + 2 * sqrt(Real(2))) - sqrt(Real(2))) / 2).decimal(0), "0");
  EXPECT_EQ(((sqrt(3 + 2 * sqrt(Real(2))) - sqrt(Real(2))) * 3 / 2).decimal(0), "2");
}

// Known digits of sqrt(2), sin(1 degree) and cos(36 degrees) = (1 + sqrt 5) / 4.
TEST(Decimal, ManyDigits) {
  // The sixtieth decimal rounds to 0 and is removed.
  EXPECT_EQ(sqrt(Real(2)).decimal(60), "1.41421356237309504880168872420969807856967187537694807317668");
  EXPECT_EQ(sqrt(Real(2)).decimal(65), "1.41421356237309504880168872420969807856967187537694807317667973799");
  EXPECT_EQ(sin_degrees(1).decimal(30), "0.017452406437283512819418978516");
  EXPECT_EQ(cos_degrees(36).decimal(20), "0.8090169943749474241");
  EXPECT_EQ((-sqrt(Real(2))).decimal(0), "-1");
}

TEST(Decimal, NeverMinusZeroNorAnExponent) {
  EXPECT_EQ((-sin_degrees(Rational(1, 1000000))).decimal(3), "0");
  Rational huge = 1;
  for (int i = 0; i < 60; ++i) huge *= 10;
  EXPECT_EQ((Real(huge) * sqrt(Real(4)) + disguised_zero()).decimal(2), "2" + std::string(60, '0'));
  EXPECT_EQ((Real(huge) * sqrt(Real(2))).decimal(0), "1414213562373095048801688724209698078569671875376948073176680");
}

// A value far below its parts needs refinement before any digit is known.
TEST(Decimal, AfterCancellation) {
  Rational big = 1;
  for (int i = 0; i < 80; ++i) big *= 10;
  const Real x = sqrt(Real(2)) + big - Real(big) * square(sqrt(sqrt(Real(3))) / sqrt(sqrt(Real(3))));
  EXPECT_EQ(x.decimal(10), "1.4142135624");
}

}  // namespace
}  // namespace toolcomp::exact
