// SPDX-License-Identifier: Apache-2.0
// Angles of unit vectors, against the arc tangents of the C library in long double.
#include "fast/kinematics/unit_angle.h"
#include "tests/effort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace toolcomp::fast {
namespace {

TEST(UnitAngle, WithinItsError) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
  double worst = 0;
  for (std::uint64_t i = 0; i < test::random_cases(200'000); ++i) {
    // Everywhere, and ever nearer to 0 and to 90.
    const double shrunk = std::ldexp(angle(random), -static_cast<int>(i % 40));
    for (const double t : {angle(random), shrunk, std::numbers::pi / 2 + shrunk}) {
      const double s = std::sin(t);
      const double c = std::cos(t);
      const DoublePair degrees = unit_angle(DoublePair{s, c}, DoublePair{c, s});
      const auto error = [](double value, long double y, long double x) {
        const long double exact = std::atan2(y, x) * 180 / std::numbers::pi_v<long double>;
        return static_cast<double>(std::abs((value - exact) / exact));
      };
      worst = std::max({worst, error(degrees[0], s, c), error(degrees[1], c, s)});
    }
  }
  EXPECT_LE(worst, kUnitAngleError);
}

TEST(UnitAngle, MultiplesOfNinetyAreExact) {
  const DoublePair first = unit_angle(DoublePair{0, 1}, DoublePair{1, 0});
  const DoublePair second = unit_angle(DoublePair{0, -1}, DoublePair{-1, 0});
  EXPECT_EQ(first[0], 0);
  EXPECT_EQ(first[1], 90);
  EXPECT_EQ(second[0], 180);
  EXPECT_EQ(second[1], -90);
}

}  // namespace
}  // namespace toolcomp::fast
