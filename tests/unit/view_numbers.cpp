// SPDX-License-Identifier: Apache-2.0
// Numbers of a program's page (certify/view/number_words.h): decimals and fractions by hand, doubles by std::nextafter.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "certify/view/number_words.h"

namespace {

using toolcomp::certify::number_words;
using toolcomp::certify::ulps_off;
using toolcomp::exact::Rational;
using toolcomp::exact::Real;

constexpr int kDigits = 15;

TEST(ViewNumbers, SayWhatTheyAre) {
  EXPECT_EQ(number_words(Real(Rational(5, 4)), kDigits), "1.25");
  EXPECT_EQ(number_words(Real(-20), kDigits), "-20");
  EXPECT_EQ(number_words(Real(0), kDigits), "0");
  EXPECT_EQ(number_words(Real(Rational(1, 3)), kDigits), "0.333333333333333=1/3");
  EXPECT_EQ(number_words(Real(Rational(-2, 3)), 3), "-0.667=-2/3");
  // 1.25 has no one decimal of its own: it is a fraction there.
  EXPECT_EQ(number_words(Real(Rational(5, 4)), 1), "1.2=5/4");
  // √2 = 1.41421356237309504880…
  EXPECT_EQ(number_words(sqrt(Real(2)), kDigits), "1.414213562373095~");
}

TEST(ViewNumbers, AFractionTooLongIsCounted) {
  // 3^100 has 48 digits, so 1/3^100 has 50 characters.
  Real value = 1;
  for (int i = 0; i < 100; ++i) value /= Real(3);
  EXPECT_EQ(number_words(value, kDigits), "0#50");
}

TEST(ViewNumbers, UlpsFromTheTwoDoublesNextToIt) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(ulps_off(1.0, Real(1)), 0);
  EXPECT_EQ(ulps_off(std::nextafter(1.0, 2.0), Real(1)), 1);
  EXPECT_EQ(ulps_off(std::nextafter(1.0, 0.0), Real(1)), -1);
  EXPECT_EQ(ulps_off(0.0, Real(0)), 0);
  EXPECT_EQ(ulps_off(-0.0, Real(0)), 0);
  EXPECT_EQ(ulps_off(std::numeric_limits<double>::denorm_min(), Real(0)), 1);
  EXPECT_EQ(ulps_off(-std::numeric_limits<double>::denorm_min(), Real(0)), -1);
  // 1/3 lies between two doubles: both are next to it.
  const Real third(Rational(1, 3));
  const double below = 1.0 / 3.0;
  EXPECT_EQ(ulps_off(below, third), 0);
  EXPECT_EQ(ulps_off(std::nextafter(below, 1.0), third), 0);
  EXPECT_EQ(ulps_off(std::nextafter(below, 0.0), third), -1);
  EXPECT_EQ(ulps_off(std::nextafter(std::nextafter(below, 1.0), 1.0), third), 1);
  EXPECT_EQ(ulps_off(infinity, third), std::nullopt);
  EXPECT_EQ(ulps_off(std::nan(""), third), std::nullopt);
}

}  // namespace
