// SPDX-License-Identifier: Apache-2.0
// The shrinker on predicates whose smallest failing program is known by construction.
#include "certify/shrink.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "certify/program_text.h"

namespace toolcomp::certify {
namespace {

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

spec::Case failing(std::string program) {
  spec::Case c;
  c.id = "test";
  c.section = "fanuc/tool-length-offset";
  c.program = std::move(program);
  return c;
}

TEST(Shrink, KeepsTheTwoBlocksThatMatter) {
  std::string program;
  for (int i = 1; i <= 40; ++i) program += "N" + std::to_string(i) + " G01 X" + std::to_string(i) + ". Y2.5 F100\n";
  program += "N41 G43 Z12.345 H7 (approach)\nN42 G49\n";
  const auto fails = [](const spec::Case& c) {
    const std::size_t on = c.program.find("G43");
    return on != std::string::npos && c.program.find("G49", c.program.find('\n', on)) != std::string::npos;
  };
  const Shrunk s = shrink(failing(program), fails);
  EXPECT_EQ(s.smallest.program, "G43\nG49\n");
  EXPECT_TRUE(s.complete);
  EXPECT_LT(s.runs, 200U);
}

TEST(Shrink, JoinsBlocksAndTakesLesserWords) {
  // Fails while it adds a length (a code of the group of G43 from there on) and has an offset number behind it.
  const auto fails = [](const spec::Case& c) {
    const std::size_t on = c.program.find("G4");
    return on != std::string::npos && c.program[on + 2] >= '3' && c.program.find('H', on) != std::string::npos;
  };
  EXPECT_EQ(shrink(failing("G44\nH1\n"), fails).smallest.program, "G43 H0\n");
  EXPECT_EQ(shrink(failing("G43.4\nX2\nH2\n"), fails).smallest.program, "G43 H0\n");
  // A word of the program that is less than another stands for it.
  const auto two = [](const spec::Case& c) { return count_blocks(c.program) == 2; };
  EXPECT_EQ(shrink(failing("(A)\nM5\n"), two).smallest.program, "(A)\n(A)\n");
}

TEST(Shrink, ShortensNumbersToWhatMatters) {
  // Fails while some X is at least 100: the smallest such number of three digits is 100.
  const auto fails = [](const spec::Case& c) {
    for (const TextLine& line : split_program(c.program, "fanuc"))
      for (const std::string& word : line.words)
        if (word[0] == 'X' && std::stod(word.substr(1)) >= 100) return true;
    return false;
  };
  EXPECT_EQ(shrink(failing("G01 X-5. Y3.\nG01 X987.654 Y12.5\n"), fails).smallest.program, "X100\n");
}

TEST(Shrink, LeavesOutSetupEntriesThatDoNotMatter) {
  spec::Case c = failing("G43 H2\n");
  c.setup.h[1] = {spec::decimal(5), {}};
  c.setup.h[2] = {*spec::parse_decimal("-17.25"), spec::decimal(3)};
  c.setup.d[4] = {spec::decimal(1), {}};
  c.setup.parameters[{5001, 2}] = spec::decimal(1);
  c.setup.parameters[{19631, -1}] = spec::decimal(1);
  c.setup.position['X'] = spec::decimal(9);
  c.setup.workpiece[1]['Z'] = spec::decimal(-300);
  c.samples = 8;
  c.setup.axes = spec::Axes("XYZBC");
  const auto fails = [](const spec::Case& candidate) {
    return candidate.setup.h.contains(2) && candidate.setup.parameters.contains({5001, 2}) &&
           contains(candidate.program, "H2");
  };
  const Shrunk s = shrink(c, fails);
  EXPECT_EQ(s.smallest.program, "H2\n");
  EXPECT_EQ(s.smallest.setup.h.size(), 1U);
  EXPECT_EQ(to_string(s.smallest.setup.h.at(2).geometry), "0");
  EXPECT_EQ(to_string(s.smallest.setup.h.at(2).wear), "0");
  EXPECT_TRUE(s.smallest.setup.d.empty());
  EXPECT_EQ(s.smallest.setup.parameters.size(), 1U);
  EXPECT_TRUE(s.smallest.setup.position.empty());
  EXPECT_TRUE(s.smallest.setup.workpiece[1].empty());
  EXPECT_EQ(s.smallest.samples, 0U);
  EXPECT_EQ(s.smallest.setup.axes.letters(), "XYZ");
}

TEST(Shrink, OneBlockAlwaysStays) {
  const Shrunk s = shrink(failing("G00 X1\nG00 X2\n"), [](const spec::Case&) { return true; });
  EXPECT_EQ(count_blocks(s.smallest.program), 1U);
}

TEST(Shrink, KeepsTheCaseAsWrittenWhereNothingSmallerFails) {
  const std::string program = "%\n O0001 (part  7)\n\nG00 X1\n";
  const Shrunk s = shrink(failing(program), [](const spec::Case&) { return false; });
  EXPECT_EQ(s.smallest.program, program);
  EXPECT_TRUE(s.complete);
}

TEST(Shrink, StopsAtItsBudgetWithTheBestSoFar) {
  std::string program;
  for (int i = 0; i < 100; ++i) program += "G01 X" + std::to_string(i) + "\n";
  std::size_t calls = 0;
  const Shrunk s = shrink(failing(program),
                          [&calls](const spec::Case& c) {
                            ++calls;
                            return contains(c.program, "X99");
                          },
                          {5});
  EXPECT_EQ(calls, 5U);
  EXPECT_EQ(s.runs, 5U);
  EXPECT_FALSE(s.complete);
  EXPECT_TRUE(contains(s.smallest.program, "X99"));
  EXPECT_LT(s.smallest.program.size(), program.size());
}

TEST(Shrink, TriesNoCandidateTwiceAndIsDeterministic) {
  const std::string program = "G90 G43 Z100. H1\nG01 X10.5 Y-3.25 F100\nG49\nX0\n";
  std::string results[2];
  for (std::string& result : results) {
    std::set<std::string> seen;
    const Shrunk s = shrink(failing(program), [&seen](const spec::Case& c) {
      EXPECT_TRUE(seen.insert(c.program).second) << c.program;
      return contains(c.program, "Y-3");
    });
    result = s.smallest.program + std::to_string(s.runs);
  }
  EXPECT_EQ(results[0], results[1]);
}

TEST(Shrink, DropsTheExpectationOfTheOriginal) {
  spec::Case c = failing("G00 X1\nG00 X2\n");
  c.has_expect = true;
  c.expect.resize(2);
  const Shrunk s = shrink(c, [](const spec::Case&) { return true; });
  EXPECT_FALSE(s.smallest.has_expect);
  EXPECT_TRUE(s.smallest.expect.empty());
}

// Words between blanks, block numbers and comments; rows of the tool table that are not called.
TEST(Shrink, TakesKlartextApart) {
  spec::Case c = failing(
      "0 BEGIN PGM A MM\n1 TOOL CALL 2 Z S5000 ; ball\n2 L Z+100 R0 FMAX\n"
      "3 LN X+1.25 Y+2 Z+3.5 ~\n  NX-0.6 NY+0 NZ+0.8 ; wall\n4 END PGM A MM\n");
  c.dialect = "klartext";
  c.setup.control = spec::Control::heidenhain;
  for (const std::uint32_t number : {10U, 20U}) {
    spec::ToolRow& tool = c.setup.tools.emplace_back();
    tool.number = number;
    tool.r = spec::decimal(5);
    tool.dr = *spec::parse_decimal("-0.125");
    tool.l = spec::decimal(80);
    tool.name = "T" + std::to_string(number);
    tool.dr2_table = "D";
  }
  c.setup.tcs[3] = {};
  c.setup.dr2_tables["D"] = {{spec::decimal(0), {}}, {spec::decimal(90), {}}};
  const auto fails = [](const spec::Case& candidate) {
    const bool called = std::ranges::any_of(candidate.setup.tools, [](const auto& tool) { return tool.number == 20; });
    return called && contains(candidate.program, "TOOL CALL 2") && contains(candidate.program, "NX-0.6");
  };
  const Shrunk s = shrink(c, fails);
  EXPECT_EQ(s.smallest.program, "TOOL CALL 2\nNX-0.6\n");
  ASSERT_EQ(s.smallest.setup.tools.size(), 1U);
  const spec::ToolRow& tool = s.smallest.setup.tools[0];
  EXPECT_EQ(tool.number, 20U);
  EXPECT_TRUE(tool.r.is_zero());
  EXPECT_TRUE(tool.dr.is_zero());
  EXPECT_TRUE(!tool.l && tool.name.empty() && tool.dr2_table.empty());
  EXPECT_TRUE(s.smallest.setup.tcs.empty());
  EXPECT_TRUE(s.smallest.setup.dr2_tables.empty());
}

}  // namespace
}  // namespace toolcomp::certify
