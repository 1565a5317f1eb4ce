// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_center_point_control/fraction_counter.h"

#include <gtest/gtest.h>

#include <numeric>

namespace toolcomp::fast {
namespace {

// Against the greatest common divisor.
void expect_lowest_terms(std::uint32_t n, std::uint32_t count) {
  FractionCounter fraction(n);
  for (int round = 0; round < 2; ++round) {
    fraction.restart();
    for (std::uint32_t k = 1; k <= count; ++k) {
      fraction.advance();
      const std::uint32_t common = std::gcd(k, n);
      ASSERT_EQ(fraction.numerator(), k / common) << k << '/' << n;
      ASSERT_EQ(fraction.denominator(), n / common) << k << '/' << n;
    }
  }
}

TEST(FractionCounter, LowestTermsOfSmallDenominators) {
  for (std::uint32_t n = 2; n <= 360; ++n) expect_lowest_terms(n, n - 1);
}

TEST(FractionCounter, LargestDenominators) {
  expect_lowest_terms(2'147'483'648, 5000);    // 2^31
  expect_lowest_terms(4'294'967'291, 5000);    // the largest prime below 2^32
  expect_lowest_terms(4'294'967'295, 5000);    // 3 5 17 257 65537
  expect_lowest_terms(4'294'836'225, 70'000);  // 65535^2
}

// No samples.
TEST(FractionCounter, NothingToDivide) {
  for (const std::uint32_t n : {0U, 1U}) {
    FractionCounter fraction(n);
    fraction.restart();
    EXPECT_EQ(fraction.denominator(), n);
  }
}

}  // namespace
}  // namespace toolcomp::fast
