// SPDX-License-Identifier: Apache-2.0
// The search for hard cases: the numbers of a case, and the ways to zero and upwards on quantities whose answer is
// known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "corpus/hard.h"
#include "corpus/mine/approach.h"
#include "fuzz/gen/numbers.h"

namespace toolcomp::corpus {
namespace {

spec::Decimal decimal(const std::string& text) { return *spec::parse_decimal(text); }

double value(const spec::Decimal& d) {
  const double magnitude = static_cast<double>(d.digits) / std::pow(10.0, d.decimals);
  return d.negative ? -magnitude : magnitude;
}

spec::Case fanuc_case(const std::string& program) {
  spec::Case c;
  c.section = "fanuc/cutter-compensation-c";
  c.setup.axes = spec::Axes("XYZ");
  c.setup.d[1] = {decimal("5.5"), {}};
  c.program = program;
  return c;
}

// Words that are no measure, and comments, stay; a number that has not changed stays as it was written.
TEST(Numbers, OfAFanucProgram) {
  const fuzz::Numbers numbers(fanuc_case("N10 G41 D1 X10. Y-3.50 (X9)\nG01 X.5 F100\n"));
  std::vector<std::string> names;
  for (std::size_t i = 0; i < numbers.size(); ++i) names.push_back(numbers.name(i));
  EXPECT_EQ(names, (std::vector<std::string>{"X", "Y", "X", "D1", "wear of D1"}));
  EXPECT_EQ(numbers.line(1), 1U);
  EXPECT_EQ(numbers.line(2), 2U);
  EXPECT_EQ(numbers.line(3), 0U);
  fuzz::Point point = numbers.values();
  point[1] = *fuzz::moved(point[1], 1, 4);
  point[3] = *fuzz::moved(point[3], -6, 0);
  const spec::Case c = numbers.with(point);
  EXPECT_EQ(c.program, "N10 G41 D1 X10. Y-3.4999 (X9)\nG01 X.5 F100\n");
  EXPECT_EQ(spec::to_string(c.setup.d.at(1).geometry), "4.9");
  EXPECT_EQ(numbers.changed(point), "Y, D1");
  EXPECT_EQ(numbers.with(numbers.values()).program, "N10 G41 D1 X10. Y-3.50 (X9)\nG01 X.5 F100\n");
}

// Without a point a number counts increments where parameter 3401#0 is 0: a point would make it a thousand times
// larger.
TEST(Numbers, WholeOnesStayWhole) {
  spec::Case c = fanuc_case("X10 Y10.\n");
  c.setup.parameters[{3401, 0}] = decimal("0");
  const fuzz::Numbers numbers(c);
  EXPECT_TRUE(numbers.is_whole(0));
  EXPECT_FALSE(numbers.is_whole(1));
}

TEST(Numbers, OfAKlartextProgram) {
  spec::Case c;
  c.section = "heidenhain/face-milling";
  c.setup.control = spec::Control::heidenhain;
  c.program = "4 TOOL CALL 5 Z S1000 DR2+0.3 DR-0,1\n5 LN X+1 IY-2.5 NX+0.6 TZ1 R0 F200 ; X9\n";
  const fuzz::Numbers numbers(c);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < numbers.size(); ++i) names.push_back(numbers.name(i));
  EXPECT_EQ(names, (std::vector<std::string>{"DR2", "DR", "X", "IY", "NX", "TZ"}));
  fuzz::Point point = numbers.values();
  point[1] = *fuzz::moved(point[1], 1, 1);
  EXPECT_EQ(numbers.with(point).program,
            "4 TOOL CALL 5 Z S1000 DR2+0.3 DR0.\n5 LN X+1 IY-2.5 NX+0.6 TZ1 R0 F200 ; X9\n");
}

TEST(Numbers, KeepToWhatIsSearched) {
  EXPECT_EQ(spec::to_string(*fuzz::moved(decimal("10000"), -1, 3)), "9999.999");
  EXPECT_FALSE(fuzz::moved(decimal("10000"), 1, 3));
  EXPECT_EQ(spec::to_string(*fuzz::moved(decimal("1"), 1, 14)), "1.00000000000001");
  EXPECT_FALSE(fuzz::moved(decimal("10"), 1, 14)) << "16 digits";
  EXPECT_EQ(spec::to_string(*fuzz::moved(decimal("-.001"), 2, 3)), ".001");
  EXPECT_EQ(fuzz::most_decimals(decimal("123.4")), 12);
  EXPECT_EQ(fuzz::most_decimals(decimal(".4")), 14);
  EXPECT_TRUE(fuzz::is_searched(fanuc_case("X1.\n")));
  EXPECT_FALSE(fuzz::is_searched(fanuc_case("X10001.\n")));
}

// 50 x + y² = 5000: with three decimals the least difference that is none is one unit of the square, 1e-6: one number
// alone leaves some 1e-3 · 25. How x follows y is of the second degree, what the three values tell without an error.
TEST(Approach, FindsTheNearestDecimalsOfTwoNumbers) {
  const fuzz::Numbers numbers(fanuc_case("X50.123 Y49.2\n"));
  double least = 1;
  std::size_t tries = 0;
  const Quantity quantity = [&](const fuzz::Point& p) -> std::optional<double> {
    ++tries;
    const double x = value(p[0]);
    const double y = value(p[1]);
    const double q = (50 * x + y * y - 5000) / 5000;
    if (fuzz::finest(p) <= 3 && q != 0) least = std::min(least, std::fabs(q));
    return q;
  };
  fuzz::SeededSource source(1);
  fuzz::Choices choose(source);
  approach(numbers, quantity, choose, {3, [] { return false; }});
  EXPECT_LE(least * 5000, 2e-6);
  EXPECT_LE(tries, 800U);
}

// With all digits a root that no decimal is.
TEST(Approach, GoesOnToAllDigits) {
  const fuzz::Numbers numbers(fanuc_case("X1. Y3.\n"));
  double least = 1;
  const Quantity quantity = [&](const fuzz::Point& p) -> std::optional<double> {
    const double q = value(p[0]) * value(p[0]) - 2;
    if (q != 0) least = std::min(least, std::fabs(q));
    return q;
  };
  fuzz::SeededSource source(1);
  fuzz::Choices choose(source);
  approach(numbers, quantity, choose, {4, [] { return false; }});
  EXPECT_LE(least, 1e-13);
}

TEST(Approach, EndsWhereNothingIsDefined) {
  const fuzz::Numbers numbers(fanuc_case("X1.\n"));
  std::size_t tries = 0;
  const Quantity nothing = [&](const fuzz::Point&) -> std::optional<double> {
    ++tries;
    return std::nullopt;
  };
  fuzz::SeededSource source(1);
  fuzz::Choices choose(source);
  approach(numbers, nothing, choose, {4, [] { return false; }});
  EXPECT_EQ(tries, 1U);
}

TEST(Climb, ReachesATop) {
  const fuzz::Numbers numbers(fanuc_case("X1. Y1.\n"));
  const Quantity hill = [](const fuzz::Point& p) -> std::optional<double> {
    return -std::fabs(value(p[0]) - 12.34) - std::fabs(value(p[1]) + 56);
  };
  fuzz::SeededSource source(1);
  fuzz::Choices choose(source);
  const fuzz::Point top = climb(numbers, hill, choose, {0, [] { return false; }}, 2000);
  EXPECT_GT(*hill(top), -0.01);
}

TEST(RoundedUp, NeverBelow) {
  using exact::Rational;
  EXPECT_EQ(rounded_up(0, 3), "0");
  EXPECT_EQ(rounded_up(1, 3), "1");
  EXPECT_EQ(rounded_up(Rational(1, 3), 3), "3.34e-1");
  EXPECT_EQ(rounded_up(Rational(12301, 10), 3), "1.24e3");
  EXPECT_EQ(rounded_up(Rational(1230), 3), "1.23e3");
  EXPECT_EQ(rounded_up(Rational(9999, 10'000), 3), "1");
  EXPECT_EQ(rounded_up(Rational(1, 1'000'000), 3), "1e-6");
}

}  // namespace
}  // namespace toolcomp::corpus
