// SPDX-License-Identifier: Apache-2.0
// Cutter compensation C in the fast engine, by hand. The worked examples of 14.5 and 14.6 stand in
// golden/fanuc/corpus_examples_cutter_c.cpp. Unless stated d = 10, G41, type A, A = (0,0) to (40,0).
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/unit/fanuc/fast_run.h"

namespace toolcomp::fast {
namespace {

using Heads = std::vector<std::pair<double, double>>;

// The values typed in have 15 digits or more, none is above 1500.
constexpr double kTolerance = 6e-13;

std::string setup(const std::string& parameters, double x, double y) {
  return "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\"]\n[position]\nX=" + std::to_string(x) +
         "\nY=" + std::to_string(y) + "\n[parameters]\n" + parameters +
         "\n[offsets.H]\n1=20\n[offsets.D]\n1=10\n2=5\n3=20\n4=-10\n5=17.5\n6=0\n7=8\n";
}

const std::string kAlone = "\"5003#1\"=1\n";

// The points of all moves whose programmed point is (x, y): the heads at that corner, in order.
Heads heads_at(const ProgramRun& run, double x, double y) {
  Heads heads;
  for (std::size_t i = 0; i < run.events.size(); ++i)
    if (run.events[i].kind == spec::EventKind::move && run.programmed(i, 'X') == x && run.programmed(i, 'Y') == y)
      heads.emplace_back(run.point(i, 'X'), run.point(i, 'Y'));
  return heads;
}

Heads path(const ProgramRun& run) {
  Heads heads;
  for (std::size_t i = 0; i < run.events.size(); ++i)
    if (run.events[i].kind == spec::EventKind::move) heads.emplace_back(run.point(i, 'X'), run.point(i, 'Y'));
  return heads;
}

void expect_heads(const Heads& actual, const Heads& expected, const std::string& what) {
  ASSERT_EQ(actual.size(), expected.size()) << what;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    EXPECT_NEAR(actual[i].first, expected[i].first, kTolerance) << what << ", head " << i;
    EXPECT_NEAR(actual[i].second, expected[i].second, kTolerance) << what << ", head " << i;
  }
}

struct Row {
  const char* what;
  std::string parameters;
  std::pair<double, double> from;  // position before the program
  std::string program;
  std::pair<double, double> corner;
  Heads heads;
  const char* alarm = "";
};

void check(const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    const ProgramRun run(setup(row.parameters, row.from.first, row.from.second), row.program);
    EXPECT_EQ(run.alarm(), row.alarm) << row.what;
    expect_heads(heads_at(run, row.corner.first, row.corner.second), row.heads, row.what);
  }
}

// Lines run in from (-50,0); block 2 is A.
const std::string kA = "G41 D1 G01 F100 X0\nX40\n";

TEST(FastCutterCompensationC, Heads) {
  const std::pair<double, double> left{-50, 0};
  check({
      {"an arc by radius", "", left, kA + "G03 X0 Y80 R50", {40, 0}, {{34.64101615137755, 10}}},
      {"the code repeated in a block between", "", left, kA + "G41\nX40 Y30", {40, 0}, {{40, 10}}},
      {"short arc, limit 5",
       "5010=5\n",
       {0, 0},
       "G41 D1 G01 X15 Y20\nG91 X15 Y20\nG02 X60 Y-60 J-60",
       {30, 40},
       {{25, 50}}},
      {"short arc, limit just under 5",
       "5010=\"4.999999999999999\"\n",
       {0, 0},
       "G41 D1 G01 X15 Y20\nG91 X15 Y20\nG02 X60 Y-60 J-60",
       {30, 40},
       {{25, 50}, {30, 50}}},
      {"lone G41, SUV = 1", kAlone, {0, 0}, "G41 D1 G01\nX40 Y30\nX80", {0, 0}, {{-6, 8}}},
      {"two blocks behind the lone G41", kAlone, {0, 0}, "G41 D1 G01\nM08\nM09\nX40\nX40 Y30", {40, 0}, {{30, 0}}},
  });
}

// A full circle between tangents stays a full circle.
TEST(FastCutterCompensationC, FullCircle) {
  const ProgramRun full(setup("", 0, 0), "G41 D1 G01 X100\nG02 J-60\nG01 X150");
  ASSERT_TRUE(full.events.at(1).arc);
  EXPECT_EQ(full.events[1].arc->sweep, 360);
  expect_heads(path(full), {{100, 10}, {100, 10}, {150, 10}}, "full circle");
}

// A tilted groove of exactly 2 r is no interference: the frame (3,4)/5, in tenths.
TEST(FastCutterCompensationC, TiltedGroove) {
  const ProgramRun tilted(setup("", -30, -40), "G41 D1 G01 X0 Y0\nX24 Y32\nX8 Y44\nX-16 Y12");
  EXPECT_EQ(tilted.alarm(), "");
  expect_heads(path(tilted), {{-8, 6}, {10, 30}, {10, 30}, {-8, 6}}, "tilted groove");
}

TEST(FastCutterCompensationC, Alarms) {
  const auto alarm = [](const std::string& program, const std::string& parameters = "") {
    return ProgramRun(setup(parameters, -50, 0), program).alarm();
  };
  EXPECT_EQ(alarm("G41 D1 G01 X0\nG42 X40\nY30"), "DIR_CHANGE_AT_STARTUP@2");
  EXPECT_EQ(alarm("G41 D1 G01 X0\nM08\nM09\nG42 X40\nY30"), "DIR_CHANGE_AT_STARTUP@4");
  EXPECT_EQ(alarm("G41 D1 G01 X0\nD4 X40\nY30"), "DIR_CHANGE_AT_STARTUP@2");
  EXPECT_EQ(alarm(kA + "G40 G02 X60 Y-20 J-20"), "PS0034@3");
  EXPECT_EQ(alarm(kA + "G40\nG02 X60 Y-20 J-20"), "PS0034@4");
  EXPECT_EQ(alarm("G39 I1"), "PS0035@1");
  EXPECT_EQ(alarm("G41 D1 G01 X0\nG39 I0 J0"), "PS0035@2");
  EXPECT_EQ(alarm(kA + "G18 X60"), "PS0037@3");
  // A centre in the end, and in the start, with any letter; PS0023 is for an R that cannot be, or without any.
  for (const char* block : {"G02 X60 Y-20 I20 J-20", "G02 X60 I0", "G03 X50 Y5 J0", "G02 X40 J0", "G02 I0",
                            "G02 X50 K3", "G02 G43 H0 X50 I0", "G02 X50 I0 M08"})
    EXPECT_EQ(alarm(kA + block), "PS0038@3") << block;
  EXPECT_EQ(alarm(kA + "G02 X60 R1"), "PS0023@3");
  EXPECT_EQ(alarm(kA + "G02 X60"), "PS0023@3");
  EXPECT_EQ(alarm("G41 D1 G02 X0 I0"), "PS0034@1");
  EXPECT_EQ(alarm(kA + "G40 X60\nG02 X70 I0"), "PS0023@4");
  EXPECT_EQ(alarm("G41 D0\nG02 X70 I0"), "PS0023@2");
  EXPECT_EQ(alarm("G41 D1\nG02 X70 I0", kAlone), "PS0038@2");
}

// fanuc.cutter-c.start-without-motion: a second lone G41 that ends the look-ahead of the first makes the vector by its
// own next block. By hand: 10 square to (30, 40) is (-8, 6).
TEST(FastCutterCompensationC, ASecondLoneStart) {
  const auto start = [](const std::string& between) {
    const ProgramRun run(setup(kAlone, 0, 0), "G41 D1 F100\n" + between + "G01 X30 Y40\nX60 Y80\n");
    EXPECT_EQ(run.alarm(), "");
    const Event& first = run.events.front();
    EXPECT_EQ(first.cause, spec::Cause::start_up);
    return std::pair(first.line, first.point.value[1]);
  };
  EXPECT_EQ(start("M05\nG41 D1\n"), std::pair(std::uint64_t{3}, 6.0));
  EXPECT_EQ(start("M05\nG42 D1\n"), std::pair(std::uint64_t{3}, -6.0));
  EXPECT_EQ(start("G41 X0\n"), std::pair(std::uint64_t{2}, 6.0));
  EXPECT_EQ(start("G41 D1\n"), std::pair(std::uint64_t{1}, 6.0));
  EXPECT_EQ(start("M05\nG41 D1\nM05\nG41 D1\n"), std::pair(std::uint64_t{5}, 6.0));
  // Without a word in the block that ends it the next moving block is the start-up block.
  EXPECT_EQ(start("M05\nM08\n"), std::pair(std::uint64_t{4}, 46.0));
}

// As the model has it: whatever the outcome of what is left open.
TEST(FastCutterCompensationC, UndecidedPermitsEveryOutcome) {
  for (const char* program : {"G41 D1 G01 X0\nG40\nG41 D1\nX40", "G41 D1 G01 X0\nG92 X7\nX40"}) {
    const ProgramRun run(setup("", -50, 0), program);
    ASSERT_EQ(run.events.back().kind, spec::EventKind::undecided) << program;
    EXPECT_EQ(run.events.back().permitted, (spec::PermittedOutcomes{true, true, true}));
  }
  EXPECT_EQ(ProgramRun(setup("", -50, 0), kA + "G18").events.back().permitted, spec::PermittedOutcomes{});
}

TEST(FastCutterCompensationC, NoIntersectionNamesTheFormerBlock) {
  // By hand: G41, line along +x to (40,0), G03 about (35,12), radius 13; offset radius 3. The offset line y = 10 passes
  // the centre at 2 < 3: they meet. With d = 12.6 (D8 of its own) the radius is 0.4, the distance 0.6: they do not.
  const std::string base = setup("", -50, 0);
  const std::string program = "G41 D8 G01 X0\nX40\nG03 X30 Y24 I-5 J12\n";
  EXPECT_EQ(ProgramRun(base + "8=10\n", program).alarm(), "");
  const ProgramRun run(base + "8=\"12.6\"\n", program);
  EXPECT_EQ(run.alarm(), "PS0033@2");
  expect_heads(path(run), {{0, 12.6}}, "the block before is given");
  // Touching is meeting: d = 12.5, radius 0.5, distance 0.5; the point lies at the foot of the centre.
  expect_heads(heads_at(ProgramRun(base + "8=\"12.5\"\n", program), 40, 0), {{35, 12.5}}, "touching");
}

// By hand: straight back after B is called 1 degree. The corner moves stand where the block before ended, as it is
// called now; the tool does not turn, but where programmed angles turn it.
TEST(FastCutterCompensationC, CornerMovesCarryTheToolAsItIsCalled) {
  const auto expect_tool = [](const std::string& angles, double x) {
    const ProgramRun run(
        angles +
            "control=\"fanuc\"\naxes=[\"X\",\"Y\",\"Z\",\"B\"]\n[parameters]\n19610=4\n19611=3\n19612=1\n19613=2\n"
            "[offsets.D]\n1=10\n",
        "G42 D1 G01 Y10 F100\nY50\nG92 B1\nY0\nY-50\n");
    EXPECT_EQ(run.alarm(), "");
    std::size_t corners = 0;
    for (const Event& event : run.events) {
      if (event.cause != spec::Cause::corner) continue;
      ++corners;
      ASSERT_TRUE(event.tool_axis);
      EXPECT_NEAR(event.tool_axis->at(0), x, 1e-15);
    }
    EXPECT_EQ(corners, 1U);
  };
  expect_tool("", 0);
  expect_tool("rotary_angles=\"programmed\"\n", std::sin(std::acos(-1.0) / 180));
}

// By hand, clause fanuc.cutter-c.workpiece-change: Z 0 is called 7 in a block that drops the length of 20. Where the
// block makes or removes a vector its move has Z 7, otherwise Z 0.
TEST(FastCutterCompensationC, LengthMoveInTheBlockOfACoordinateShift) {
  const auto second = [](const std::string& parameters, const std::string& blocks) {
    const ProgramRun run(setup(parameters, -50, 0), "G43 H1 G01 F100\n" + blocks);
    EXPECT_EQ(run.alarm(), "");
    return run;
  };
  const auto expect_move = [](const ProgramRun& run, std::size_t i, double x, double y, double z) {
    EXPECT_NEAR(run.point(i, 'X'), x, kTolerance);
    EXPECT_NEAR(run.point(i, 'Y'), y, kTolerance);
    EXPECT_EQ(run.point(i, 'Z'), z);
    EXPECT_EQ(run.axis(i, 'Z'), z);
  };
  // A start-up of type A is made by the next block; number 0 asks for none; a value of 0 makes a vector of length 0.
  expect_move(second("", "G41 D1 G92 H0 X1 Z7\nX51\n"), 1, -50, 0, 0);
  expect_move(second("", "G41 D0 G92 H0 X1 Z7\nX51\n"), 1, -50, 0, 0);
  expect_move(second(kAlone, "G41 D6 G92 H0 Z7\nX0\n"), 1, -50, 0, 0);
  // Of SUV = 1 it is made here, if a moving block follows.
  expect_move(second(kAlone, "G41 D1 G92 H0 Z7\nX0\n"), 1, -50, 10, 7);
  expect_move(second(kAlone, "G41 D1 G92 H0 Z7\n"), 1, -50, 0, 0);
  // A lone G40 keeps the vector in type A and removes it with SUV = 1; number 0 is the same.
  for (const std::string code : {"G40", "D0"}) {
    expect_move(second("", "G41 D1 X0\nX40\n" + code + " G92 H0 Z7\n"), 3, 40, 10, 0);
    expect_move(second(kAlone, "G41 D1 X0\nX40\n" + code + " G92 H0 Z7\n"), 3, 40, 0, 7);
    expect_move(second(kAlone, "G41 D6 X0\nX40\n" + code + " G92 H0 Z7\n"), 3, 40, 0, 0);
  }
}

}  // namespace
}  // namespace toolcomp::fast
