// SPDX-License-Identifier: Apache-2.0
// Exact decimals: what is read, what is refused, and that the written form is kept.
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <optional>
#include <string>

#include "spec/language/decimal.h"
#include "spec/language/number_text.h"

namespace {

using namespace toolcomp::spec;

TEST(Decimal, KeepsSignPointAndTrailingZeros) {
  EXPECT_EQ(parse_decimal("12"), (Decimal{12, 0, false, false}));
  EXPECT_EQ(parse_decimal("12."), (Decimal{12, 0, false, true}));
  EXPECT_EQ(parse_decimal("-0"), (Decimal{0, 0, true, false}));
  EXPECT_EQ(parse_decimal("1.50"), (Decimal{150, 2, false, true}));
  EXPECT_EQ(parse_decimal("+.5"), (Decimal{5, 1, false, true}));
  EXPECT_EQ(parse_decimal("-0.050"), (Decimal{50, 3, true, true}));
  EXPECT_EQ(decimal(-7), (Decimal{7, 0, true, false}));
  EXPECT_EQ(decimal(0), Decimal{});
}

TEST(Decimal, RefusesEverythingElse) {
  for (const char* text :
       {"", "+", "-", ".", "-.", "1.2.3", "--1", "1-", "1e5", "0x1", " 1", "1 ", "1,5", "inf", "nan"})
    EXPECT_EQ(parse_decimal(text), std::nullopt) << text;
}

TEST(Decimal, HasAtMostEighteenDigits) {
  EXPECT_EQ(parse_decimal("999999999999999999"), (Decimal{999'999'999'999'999'999, 0, false, false}));
  EXPECT_EQ(parse_decimal("1000000000000000000"), std::nullopt);
  // Leading zeros of the integer part do not count, those behind the point do.
  EXPECT_EQ(parse_decimal("0000000000000000000000007"), (Decimal{7, 0, false, false}));
  EXPECT_EQ(parse_decimal("0.000000000000000001"), (Decimal{1, 18, false, true}));
  EXPECT_EQ(parse_decimal("0.0000000000000000001"), std::nullopt);
}

TEST(Decimal, ShortestTextReadsBack) {
  for (const char* text : {"0", "-0", "0.", "12", "12.", ".5", "-.005", "1.50", ".000000000000000001", "-.00"}) {
    const std::optional<Decimal> value = parse_decimal(text);
    ASSERT_TRUE(value) << text;
    EXPECT_EQ(to_string(*value), text);
  }
  EXPECT_EQ(to_string(*parse_decimal("+0.50")), ".50");
  EXPECT_EQ(to_string(*parse_decimal("007")), "7");
}

TEST(NumberText, AcceptsDecimalsWithExponent) {
  for (const char* text : {"0", "-1.5", "+2", ".5", "5.", "1e9", "-1.5E-07"}) EXPECT_TRUE(is_number_text(text)) << text;
  for (const char* text : {"", ".", "-", "e5", "1e", "1e+", "nan", "inf", "0x1p3", "1 ", "1.2.3"})
    EXPECT_FALSE(is_number_text(text)) << text;
  EXPECT_FALSE(is_number_text("1e9", false));
}

std::string shortest(double value) {
  std::string text;
  append_shortest(text, value);
  return text;
}
std::string fixed(double value) {
  std::string text;
  append_shortest_fixed(text, value);
  return text;
}

TEST(Shortest, ReadsBackToTheSameDoubleAndIsNeverMinusZero) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(-0.0), "0");
  EXPECT_EQ(shortest(1.0 / 3), "0.3333333333333333");
  EXPECT_EQ(shortest(1e-7), "1e-07");
  EXPECT_EQ(fixed(1e-7), "0.0000001");
  EXPECT_EQ(fixed(-0.0), "0");
  EXPECT_EQ(fixed(1e22), "10000000000000000000000");
  EXPECT_EQ(std::strtod(fixed(5e-324).c_str(), nullptr), 5e-324);
}

TEST(Shortest, WhatIsNotFiniteIsNoNumber) {
  EXPECT_EQ(shortest(std::numeric_limits<double>::infinity()), "\"inf\"");
  EXPECT_EQ(shortest(-std::numeric_limits<double>::infinity()), "\"-inf\"");
  EXPECT_EQ(shortest(std::numeric_limits<double>::quiet_NaN()), "\"nan\"");
}

}  // namespace
