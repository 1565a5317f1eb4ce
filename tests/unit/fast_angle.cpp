// SPDX-License-Identifier: Apache-2.0
// Polar angles of the fast engine against the C library's, and the exact ones.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "fast/geometry/angle.h"
#include "tests/effort.h"

namespace toolcomp::fast {
namespace {

TEST(PolarAngle, MultiplesOfFortyFiveDegreesAreExact) {
  constexpr std::array<std::array<double, 3>, 8> kRows{{{3, 0, 0},
                                                        {0.1, 0.1, 45},
                                                        {0, 1e-9, 90},
                                                        {-7, 7, 135},
                                                        {-1e30, 0, 180},
                                                        {-7, -7, -135},
                                                        {0, -5, -90},
                                                        {1e-300, -1e-300, -45}}};
  for (const auto& [x, y, degrees] : kRows) EXPECT_EQ(polar_angle(x, y), degrees) << x << ' ' << y;
}

// Both are within 2^-51 of the angle.
TEST(PolarAngle, AgreesWithTheLibrary) {
  std::mt19937_64 random(5);
  for (std::uint64_t i = 0; i < test::random_cases(100'000); ++i) {
    const double x = std::ldexp(static_cast<double>(random() >> 11U) + 1, -static_cast<int>(random() % 60));
    const double y = std::ldexp(static_cast<double>(random() >> 11U) + 1, -static_cast<int>(random() % 60));
    const double signed_x = random() % 2 == 0 ? x : -x;
    const double signed_y = random() % 2 == 0 ? y : -y;
    const double expected = std::atan2(signed_y, signed_x) * 57.295779513082323;
    ASSERT_NEAR(polar_angle(signed_x, signed_y), expected, 0x1p-50 * std::abs(expected)) << signed_x << ' ' << signed_y;
  }
}

}  // namespace
}  // namespace toolcomp::fast
