// SPDX-License-Identifier: Apache-2.0
// The numbers of a case, each changed by itself.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "fuzz/gen/numbers.h"
#include "spec/language/decimal.h"

namespace toolcomp::fuzz {
namespace {

spec::Decimal decimal(const std::string& text) { return *spec::parse_decimal(text); }

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
  const Numbers numbers(fanuc_case("N10 G41 D1 X10. Y-3.50 (X9)\nG01 X.5 F100\n"));
  std::vector<std::string> names;
  for (std::size_t i = 0; i < numbers.size(); ++i) names.push_back(numbers.name(i));
  EXPECT_EQ(names, (std::vector<std::string>{"X", "Y", "X", "D1", "wear of D1"}));
  EXPECT_EQ(numbers.line(1), 1U);
  EXPECT_EQ(numbers.line(2), 2U);
  EXPECT_EQ(numbers.line(3), 0U);
  Point point = numbers.values();
  point[1] = *moved(point[1], 1, 4);
  point[3] = *moved(point[3], -6, 0);
  const spec::Case c = numbers.with(point);
  EXPECT_EQ(c.program, "N10 G41 D1 X10. Y-3.4999 (X9)\nG01 X.5 F100\n");
  EXPECT_EQ(spec::to_string(c.setup.d.at(1).geometry), "4.9");
  EXPECT_EQ(numbers.with(numbers.values()).program, "N10 G41 D1 X10. Y-3.50 (X9)\nG01 X.5 F100\n");
}

// Without a point a number counts increments where parameter 3401#0 is 0: a point would make it a thousand times
// larger.
TEST(Numbers, WholeOnesStayWhole) {
  spec::Case c = fanuc_case("X10 Y10.\n");
  c.setup.parameters[{3401, 0}] = decimal("0");
  const Numbers numbers(c);
  EXPECT_TRUE(numbers.is_whole(0));
  EXPECT_FALSE(numbers.is_whole(1));
}

TEST(Numbers, OfAKlartextProgram) {
  spec::Case c;
  c.section = "heidenhain/face-milling";
  c.setup.control = spec::Control::heidenhain;
  c.program = "4 TOOL CALL 5 Z S1000 DR2+0.3 DR-0,1\n5 LN X+1 IY-2.5 NX+0.6 TZ1 R0 F200 ; X9\n";
  const Numbers numbers(c);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < numbers.size(); ++i) names.push_back(numbers.name(i));
  EXPECT_EQ(names, (std::vector<std::string>{"DR2", "DR", "X", "IY", "NX", "TZ"}));
  Point point = numbers.values();
  point[1] = *moved(point[1], 1, 1);
  EXPECT_EQ(numbers.with(point).program,
            "4 TOOL CALL 5 Z S1000 DR2+0.3 DR0.\n5 LN X+1 IY-2.5 NX+0.6 TZ1 R0 F200 ; X9\n");
}

TEST(Numbers, KeepToWhatIsSearched) {
  EXPECT_EQ(spec::to_string(*moved(decimal("10000"), -1, 3)), "9999.999");
  EXPECT_FALSE(moved(decimal("10000"), 1, 3));
  EXPECT_EQ(spec::to_string(*moved(decimal("1"), 1, 14)), "1.00000000000001");
  EXPECT_FALSE(moved(decimal("10"), 1, 14)) << "16 digits";
  EXPECT_EQ(spec::to_string(*moved(decimal("-.001"), 2, 3)), ".001");
  EXPECT_TRUE(is_searched(fanuc_case("X1.\n")));
  EXPECT_FALSE(is_searched(fanuc_case("X10001.\n")));
}

}  // namespace
}  // namespace toolcomp::fuzz
