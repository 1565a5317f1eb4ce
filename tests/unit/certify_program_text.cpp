// SPDX-License-Identifier: Apache-2.0
// Programs taken apart and put together again, by shape.
#include "certify/program_text.h"

#include <gtest/gtest.h>

namespace toolcomp::certify {
namespace {

using Words = std::vector<std::string>;

TEST(ProgramText, SplitsIsoWordsWithOrWithoutBlanks) {
  const TextProgram p = split_program("N10G01X-1.5Y.2(feed in)F100;\r\n\n%\n", "fanuc");
  ASSERT_EQ(p.size(), 3U);
  EXPECT_EQ(p[0].words, (Words{"N10", "G01", "X-1.5", "Y.2", "(feed in)", "F100", ";"}));
  EXPECT_TRUE(p[1].words.empty());
  EXPECT_EQ(p[2].words, Words{"%"});
}

TEST(ProgramText, KeepsFaultyWordsWhole) {
  EXPECT_EQ(split_program("X1.2.3 Y--4 Z (open", "fanuc")[0].words, (Words{"X1.2.3", "Y--4", "Z", "(open"}));
  EXPECT_EQ(split_program("1.5 X2", "fanuc")[0].words, (Words{"1.5", "X2"}));
}

TEST(ProgramText, SplitsKlartextAtBlanks) {
  EXPECT_EQ(split_program("12 LN X+1.5 Y-2 NX0.6", "klartext")[0].words, (Words{"12", "LN", "X+1.5", "Y-2", "NX0.6"}));
}

TEST(ProgramText, JoinsWithOneBlank) {
  EXPECT_EQ(join_program(split_program("G01X1 Y2\n\nG49\n", "fanuc")), "G01 X1 Y2\nG49\n");
}

TEST(ProgramText, CountsLinesWithWords) {
  EXPECT_EQ(count_blocks("G01 X1\n\n \t\nG49"), 2U);
  EXPECT_EQ(count_blocks(""), 0U);
}

TEST(ProgramText, FindsTheNumberOfAWordThatIsAQuantity) {
  const NumberInWord x = number_in("X-12.50");
  EXPECT_EQ(x.prefix, "X");
  EXPECT_EQ(x.number, "-12.50");
  EXPECT_EQ(x.suffix, "");
  EXPECT_EQ(number_in("G43").number, "");
  EXPECT_EQ(number_in("N30").number, "");
  EXPECT_EQ(number_in("(X1)").number, "");
  EXPECT_EQ(number_in("X").number, "");
}

TEST(ProgramText, OfKlartextWordsOnlyMIsAName) {
  EXPECT_EQ(number_in("NX-0.4658107", "klartext").number, "-0.4658107");
  EXPECT_EQ(number_in("NX-0.4658107", "klartext").prefix, "NX");
  EXPECT_EQ(number_in("DR2:+0.3", "klartext").number, "+0.3");
  EXPECT_EQ(number_in("M107", "klartext").number, "");
  EXPECT_EQ(number_in("CONTOUR", "klartext").number, "");
}

// Every proposal is shorter, or as long and smaller digit by digit: the search for the simplest ends.
TEST(ProgramText, SimplerNumbersAreSimpler) {
  for (const std::string number : {"987.654", "-0.001", "10", "+7", "0", "-0", "1", "100.", ".5", "12345678.12345678"})
    for (const std::string& simpler : simpler_numbers(number))
      EXPECT_TRUE(simpler.size() < number.size() || (simpler.size() == number.size() && simpler < number))
          << number << " → " << simpler;
}

TEST(ProgramText, SimplerNumbersComeSimplestFirst) {
  EXPECT_EQ(simpler_numbers("987.654").front(), "0");
  EXPECT_EQ(simpler_numbers("-12.5")[1], "-1");
  const auto of_twelve = simpler_numbers("12.50");
  EXPECT_NE(std::find(of_twelve.begin(), of_twelve.end(), "12"), of_twelve.end());
  EXPECT_NE(std::find(of_twelve.begin(), of_twelve.end(), "12.5"), of_twelve.end());
  EXPECT_TRUE(simpler_numbers("0").empty());
}

}  // namespace
}  // namespace toolcomp::certify
