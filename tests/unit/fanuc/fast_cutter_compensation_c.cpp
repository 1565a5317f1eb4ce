// Cutter compensation C in the fast engine. Expected values: the worked examples of 14.5 and 14.6 of the fact sheet,
// typed in, and hand derivations where a comment says so. Unless stated d = 10, G41, type A, A = (0,0) to (40,0).
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/unit/fanuc/fast_run.h"

namespace toolcomp::fast {
namespace {

using Heads = std::vector<std::pair<double, double>>;

// The values of the sheet have 15 digits or more, none is above 1500.
constexpr double kTolerance = 6e-13;

std::string setup(const std::string& parameters, double x, double y) {
  return "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\"]\n[position]\nX=" + std::to_string(x) +
         "\nY=" + std::to_string(y) + "\n[parameters]\n" + parameters +
         "\n[offsets.H]\n1=20\n[offsets.D]\n1=10\n2=5\n3=20\n4=-10\n5=17.5\n6=0\n7=8\n";
}

const std::string kTypeB = "\"5003#0\"=1\n";
const std::string kAlone = "\"5003#1\"=1\n";
const std::string kCcn = "\"5003#2\"=1\n";
const std::string kUnchecked = "\"5008#0\"=1\n";

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

TEST(FastCutterCompensationC, StartUpExamples) {
  const auto rows = [](const char* what, const std::string& side, const std::string& next, const Heads& a,
                       const Heads& b) {
    const std::string program = side + " D1 G01 F100 X40\n" + next + "\n";
    check({{what, "", {0, 0}, program, {40, 0}, a}, {what, kTypeB, {0, 0}, program, {40, 0}, b}});
  };
  rows("1 inner 270", "G41", "X40 Y30", {{30, 0}}, {{30, 0}});
  rows("2 straight on", "G41", "X80", {{40, 10}}, {{40, 10}});
  rows("3 90", "G41", "Y-30", {{50, 0}}, {{40, 10}, {50, 10}});
  rows("4 obtuse", "G41", "X80 Y-30", {{46, 8}}, {{40, 10}, {43.33333333333333, 10}});
  rows("7 acute", "G42", "X10 Y40", {{48, 6}}, {{40, -10}, {50, -10}, {54, -2}});
  rows("8 obtuse line-arc", "G41", "G02 X60 Y-40 I-30 J-40", {{46, 8}}, {{40, 10}, {43.33333333333333, 10}, {46, 8}});
  rows("10 acute line-arc", "G41", "G02 X0 Y-20 I-40 J30", {{48, -6}}, {{40, 10}, {50, 10}, {54, 2}, {48, -6}});
  check({{"11 under 1 degree",
          kTypeB,
          {0, 0},
          "G41 D1 G01 F100 X100\nX0 Y-1\n",
          {100, 0},
          {{100.099995000375, -9.999500037496875}}}});
}

// Lines run in from (-50,0); block 2 is A.
const std::string kA = "G41 D1 G01 F100 X0\nX40\n";

TEST(FastCutterCompensationC, OffsetModeExamples) {
  const std::pair<double, double> left{-50, 0};
  check({
      {"1", "", left, kA + "X64 Y32", {40, 0}, {{35, 10}}},
      {"2", "", left, kA + "X40 Y30", {40, 0}, {{30, 10}}},
      {"3", "", left, kA + "X70 Y30", {40, 0}, {{35.85786437626905, 10}}},
      {"5 exactly 90", "", left, kA + "Y-30", {40, 0}, {{50, 10}}},
      {"6 acute", "", left, kA + "X10 Y-40", {40, 0}, {{50, 10}, {54, 2}}},
      {"8 reversal", "", left, kA + "X0", {40, 0}, {{50, 10}, {50, -10}}},
      {"9 inner line-arc", "", left, kA + "G03 X0 Y80 I-40 J30", {40, 0}, {{34.64101615137755, 10}}},
      {"9 d=17.5", "", left, "G41 D5 G01 X0\nX40\nG03 X0 Y80 I-40 J30", {40, 0}, {{30, 17.5}}},
      {"9 by radius", "", left, kA + "G03 X0 Y80 R50", {40, 0}, {{34.64101615137755, 10}}},
      {"11 obtuse line-arc", "", left, kA + "G02 X60 Y-40 I-30 J-40", {40, 0}, {{43.33333333333333, 10}, {46, 8}}},
      {"12 acute line-arc", "", left, kA + "G02 X0 Y-20 I-40 J30", {40, 0}, {{50, 10}, {54, 2}, {48, -6}}},
      {"13 obtuse arc-line",
       "",
       {60, -90},
       "G42 D1 G01 X60 Y-40\nG03 X40 Y0 I-50\nG01 X0",
       {40, 0},
       {{46, 8}, {43.33333333333333, 10}}},
      {"15 obtuse arc-arc",
       "",
       {48, -38},
       "G41 D1 G01 X0 Y-24\nG02 X0 Y24 I7 J24\nG02 X0 Y-24 I-7 J-24",
       {0, 24},
       {{-2.8, 33.6}, {0, 34.41666666666667}, {2.8, 33.6}}},
      {"18 change of direction", "", left, kA + "G42 X40 Y30", {40, 0}, {{50, 10}}},
      {"19 ... U-turn", "", left, kA + "G42 X0", {40, 0}, {{40, 10}}},
      {"20 ... straight on", "", left, kA + "G42 X80", {40, 0}, {{40, -10}}},
      {"22 ... line-arc", "", left, kA + "G42 G03 X0 Y80 I-40 J30", {40, 0}, {{56.5685424949238, 10}}},
      {"23 ... tangent arc", "", left, kA + "G42 G03 X70 Y30 J30", {40, 0}, {{40, -10}}},
      {"by the sign of D", "", left, kA + "D4 X40 Y30", {40, 0}, {{50, 10}}},
      {"25 one M code", "", left, kA + "M05\nX40 Y30\nX80", {40, 0}, {{30, 10}}},
      {"25 one M code", "", left, kA + "M05\nX40 Y30\nX80", {40, 30}, {{30, 40}}},
      {"25 two M codes", "", left, kA + "M05\nM08\nX40 Y30\nX80", {40, 0}, {{40, 10}}},
      {"25 two M codes", "", left, kA + "M05\nM08\nX40 Y30\nX80", {40, 30}, {{30, 40}}},
      {"zero travel counts two", "", left, kA + "X40\nX40 Y30\nX80", {40, 0}, {{40, 10}, {40, 10}}},
      {"26 repeated", "", left, kA + "G41 X40 Y30", {40, 0}, {{40, 10}}},
      {"26 repeated in a block between", "", left, kA + "G41\nX40 Y30", {40, 0}, {{40, 10}}},
      {"27 D change", "", left, kA + "D2 Y-40\nX0", {40, 0}, {{50, 10}}},
      {"27 D change", "", left, kA + "D2 Y-40\nX0", {40, -40}, {{45, -45}}},
      {"28 limit 2.2", "5010=\"2.2\"\n", left, kA + "X20 Y-99", {40, 0}, {{50, 10}}},
      {"28 limit 2", "5010=2\n", left, kA + "X20 Y-99", {40, 0}, {{50, 10}, {51.78217821782178, 7.821782178217822}}},
      {"29 full circle",
       "",
       {0, 0},
       "G41 D1 G01 X15 Y20\nG91 X15 Y20\nG02 J-60",
       {30, 40},
       {{25, 50}, {30, 50}, {30, 50}}},
      {"29 full circle, limit 5",
       "5010=5\n",
       {0, 0},
       "G41 D1 G01 X15 Y20\nG91 X15 Y20\nG02 J-60",
       {30, 40},
       {{25, 50}, {30, 50}, {30, 50}}},
      {"29 short arc, limit 5",
       "5010=5\n",
       {0, 0},
       "G41 D1 G01 X15 Y20\nG91 X15 Y20\nG02 X60 Y-60 J-60",
       {30, 40},
       {{25, 50}}},
      {"29 short arc, limit just under 5",
       "5010=\"4.999999999999999\"\n",
       {0, 0},
       "G41 D1 G01 X15 Y20\nG91 X15 Y20\nG02 X60 Y-60 J-60",
       {30, 40},
       {{25, 50}, {30, 50}}},
      {"31 unchecked",
       kUnchecked,
       {0, 0},
       "G41 D1 G01 X100\nG02 J-60\nG40 G01 X150 I-10 J-10",
       {100, 0},
       {{100, 10}, {120.937502231726, 6.795366607995099}}},
      {"31", "", {0, 0}, "G41 D1 G01 X100\nG02 J-60\nG40 G01 X150 I-10 J-10", {100, 0}, {{100, 10}}, "PS0041@2"},
      {"32 end not on the arc", "", left, kA + "G02 X95 Y-50 J-50", {95, -50}, {{105, -50}}},
  });
}

TEST(FastCutterCompensationC, ToolArcs) {
  const ProgramRun circle(setup(kUnchecked, 0, 0), "G41 D1 G01 X100\nG02 J-60\nG40 G01 X150 I-10 J-10");
  ASSERT_TRUE(circle.events.at(1).arc);
  EXPECT_NEAR(*circle.events[1].arc->sweep, 17.4039858696496, 1e-12);
  EXPECT_FALSE(circle.events[1].arc->radius);
  EXPECT_EQ(circle.events[1].arc->center[1], -60);

  const ProgramRun spiral(setup("", -50, 0), kA + "G02 X95 Y-50 J-50");
  ASSERT_TRUE(spiral.events.at(2).arc && spiral.events[2].arc->radius);
  EXPECT_NEAR(spiral.events[2].arc->radius->first, 60, kTolerance);
  EXPECT_NEAR(spiral.events[2].arc->radius->second, 65, kTolerance);
  EXPECT_NEAR(*spiral.events[2].arc->sweep, 90, kTolerance);

  // A full circle between tangents stays a full circle.
  const ProgramRun full(setup("", 0, 0), "G41 D1 G01 X100\nG02 J-60\nG01 X150");
  ASSERT_TRUE(full.events.at(1).arc);
  EXPECT_EQ(full.events[1].arc->sweep, 360);
  expect_heads(path(full), {{100, 10}, {100, 10}, {150, 10}}, "full circle");
}

TEST(FastCutterCompensationC, ManualProgram) {
  const auto program = [](const std::string& d, const std::string& code = "G41") {
    return "G92 X0 Y0\nG90 G17 G00 " + code + " " + d +
           " X250 Y550\nG01 F100 Y900\nX450\nG03 X500 Y1150 R650\nG02 X900 R-250\nG03 X950 Y900 R650\nG01 X1150\nY550\n"
           "X700 Y650\nX250 Y550\nG00 G40 X0 Y0\n";
  };
  const ProgramRun ten(setup("", 0, 0), program("D1"));
  EXPECT_EQ(ten.alarm(), "");
  expect_heads(path(ten),
               {{240, 550},
                {240, 910},
                {443.295878967653, 910},
                {489.9915665097066, 1146.714456444996},
                {910.0084334902934, 1146.714456444996},
                {956.704121032347, 910},
                {1160, 910},
                {1160, 540},
                {1157.592566023653, 538.0688248199739},
                {700, 639.756061714119},
                {252.1693045781866, 540.2381293981605},
                {0, 0}},
               "d = 10");
  EXPECT_NEAR(ten.events[2].point[0] + 150, std::sqrt(352000), kTolerance);
  expect_heads(path(ProgramRun(setup("", 0, 0), program("D3"))),
               {{230, 550},
                {230, 920},
                {436.5151319446072, 920},
                {479.9666946292995, 1143.522063767303},
                {920.0333053707005, 1143.522063767303},
                {963.4848680553928, 920},
                {1170, 920},
                {1170, 530},
                {1165.185132047306, 526.1376496399478},
                {700, 629.512123428238},
                {254.3386091563731, 530.4762587963209},
                {0, 0}},
               "d = 20");
  const Heads negative = {{260, 550},
                          {260, 890},
                          {456.6666666666667, 890},
                          {459.2307692307692, 896.1538461538462},
                          {510, 1150},
                          {510, 1153.333333333333},
                          {508, 1156},
                          {892, 1156},
                          {890, 1153.333333333333},
                          {890, 1150},
                          {940.7692307692308, 896.1538461538462},
                          {943.3333333333333, 890},
                          {1140, 890},
                          {1140, 562.4661605081032},
                          {700, 660.243938285881},
                          {247.8306954218134, 559.7618706018395},
                          {0, 0}};
  expect_heads(path(ProgramRun(setup("", 0, 0), program("D4"))), negative, "d = -10");
  expect_heads(path(ProgramRun(setup("", 0, 0), program("D1", "G42"))), negative, "G42, d = 10");
  // D00 in the last block cancels as G40 does; an arc cannot start.
  std::string zero = program("D1");
  zero.replace(zero.find("G40"), 3, "D00");
  expect_heads(path(ProgramRun(setup("", 0, 0), zero)), path(ten), "D00");
  std::string arc = program("D1");
  arc.replace(arc.find("G00"), 3, "G02");
  EXPECT_EQ(ProgramRun(setup("", 0, 0), arc).alarm(), "PS0034@2");
}

TEST(FastCutterCompensationC, CancelExamples) {
  const auto rows = [](const char* what, const std::string& next, const Heads& a, const Heads& b) {
    const std::string program = kA + "G40 " + next + "\n";
    check({{what, "", {-50, 0}, program, {40, 0}, a}, {what, kTypeB, {-50, 0}, program, {40, 0}, b}});
  };
  rows("1 inner", "X40 Y30", {{40, 10}}, {{40, 10}});
  rows("2 90", "Y-30", {{40, 10}}, {{50, 10}, {50, 0}});
  rows("3 obtuse", "X80 Y-30", {{40, 10}}, {{43.33333333333333, 10}, {46, 8}});
  rows("4 acute", "X10 Y-40", {{40, 10}}, {{50, 10}, {54, 2}, {48, -6}});
  rows("5 45 degrees", "X70 Y-30", {{40, 10}}, {{44.14213562373095, 10}, {47.07106781186548, 7.071067811865475}});
  check({
      {"6 under 1 degree", kTypeB, {-50, 0}, "G41 D1 G01 X0\nX100\nG40 X0 Y-1", {100, 0}, {{100, 10}}},
      {"7 arc-line, A", "", {60, -90}, "G42 D1 G01 Y-40\nG03 X40 Y0 I-50\nG40 G01 X0", {40, 0}, {{46, 8}}},
      {"7 arc-line, B",
       kTypeB,
       {60, -90},
       "G42 D1 G01 Y-40\nG03 X40 Y0 I-50\nG40 G01 X0",
       {40, 0},
       {{46, 8}, {43.33333333333333, 10}, {40, 10}}},
      {"9 arc-line inner", "", {-50, 80}, "G42 D1 G01 X0\nG02 X40 Y0 J-50\nG40 G01 X0", {40, 0}, {{32, 6}}},
      {"10 lone G40", "", {-50, 0}, kA + "G40\nX40 Y-30", {40, 0}, {{40, 10}}},
      {"10 lone G40", "", {-50, 0}, kA + "G40\nX40 Y-30", {40, -30}, {{40, -30}}},
      {"lone G40, SUV = 1", kAlone, {-50, 0}, kA + "G40\nX40 Y-30", {40, 0}, {{40, 10}, {40, 0}}},
      {"lone G41, SUV = 1", kAlone, {0, 0}, "G41 D1 G01\nX40 Y30\nX80", {0, 0}, {{-6, 8}}},
      {"two blocks behind the lone G41", kAlone, {0, 0}, "G41 D1 G01\nM08\nM09\nX40\nX40 Y30", {40, 0}, {{30, 0}}},
  });
}

TEST(FastCutterCompensationC, InterferenceExamples) {
  const auto line = [](double x, double y) { return "X" + std::to_string(x) + "Y" + std::to_string(y) + "\n"; };
  const auto groove = [&](double width) { return kA + line(40, width) + line(0, width); };
  check({
      {"1 groove of 15", "", {-50, 0}, groove(15), {40, 0}, {{30, 10}}, "PS0041@3"},
      {"2 groove of 20", "", {-50, 0}, groove(20), {40, 0}, {{30, 10}}},
      {"2 groove of 20", "", {-50, 0}, groove(20), {40, 20}, {{30, 10}}},
      {"3 groove of 25", "", {-50, 0}, groove(25), {40, 25}, {{30, 15}}},
      {"4 step", "", {-50, 0}, kA + line(40, 5) + line(80, 5), {40, 5}, {{30, 15}}},
      {"5", "", {-50, 0}, kA + line(37, -4) + line(80, -4), {40, 0}, {{50, 10}}, "PS0041@3"},
      {"6", "", {-50, 0}, kA + line(25, -20) + line(80, -20), {40, 0}, {{50, 10}, {54, 2}}},
      {"6", "", {-50, 0}, kA + line(25, -20) + line(80, -20), {25, -20}, {{45, -10}}},
      {"7 corner radius of 8", "", {-50, 0}, kA + "G03 X48 Y8 J8\nG01 Y40", {40, 0}, {{40, 10}}, "PS0041@3"},
      {"7 corner radius of 10", "", {-50, 0}, kA + "G03 X50 Y10 J10\nG01 Y40", {50, 10}, {{40, 10}}},
      // By hand (decision of the sheet): the arc loses its nearest vectors and is run straight.
      {"removal", "", {-50, 0}, kA + "G03 X50 Y0 I5\nG01 Y-20", {40, 0}, {{50, 10}}},
      {"removal", "", {-50, 0}, kA + "G03 X50 Y0 I5\nG01 Y-20", {50, 0}, {{60, 10}}},
  });
  // The tilted groove of exactly 2 r is no interference either: the frame (3,4)/5, in tenths.
  const ProgramRun tilted(setup("", -30, -40), "G41 D1 G01 X0 Y0\nX24 Y32\nX8 Y44\nX-16 Y12");
  EXPECT_EQ(tilted.alarm(), "");
  expect_heads(path(tilted), {{-8, 6}, {10, 30}, {10, 30}, {-8, 6}}, "tilted groove");

  const ProgramRun removal(setup("", -50, 0), kA + "G03 X50 Y0 I5\nG01 Y-20");
  EXPECT_EQ(removal.alarm(), "");
  EXPECT_EQ(removal.events.at(2).type, spec::MoveType::linear);
  EXPECT_EQ(removal.events[2].cause, spec::Cause::programmed);
}

TEST(FastCutterCompensationC, OvercuttingExamples) {
  const std::string start = "G91 G00 G41 X500 Y400 D1\n";
  check({
      {"1 one Z block", "", {0, 0}, start + "G01 Z-300 F100\nY100", {500, 400}, {{490, 400}, {490, 400}}},
      {"2 two Z blocks",
       "",
       {0, 0},
       start + "G01 Z-250 F100\nZ-50\nY100",
       {500, 400},
       {{493.7530495244558, 407.8086880944303},
        {493.7530495244558, 407.8086880944303},
        {493.7530495244558, 407.8086880944303}}},
      {"3", "", {0, 0}, start + "Y100\nG01 Z-250 F100\nZ-50\nY100", {500, 400}, {{490, 400}}},
      {"3", "", {0, 0}, start + "Y100\nG01 Z-250 F100\nZ-50\nY100", {500, 500}, {{490, 500}, {490, 500}, {490, 500}}},
  });
}

TEST(FastCutterCompensationC, MachineMoves) {
  const auto g53 = [](const std::string& next) { return kA + "G00 G53 X200 Y100\nG01 X80 Y60\n" + next; };
  const std::pair<double, double> left{-50, 0};
  check({
      {"1", "", left, g53("X0"), {40, 0}, {{40, 10}}},
      {"1", "", left, g53("X0"), {200, 100}, {{200, 100}}},
      {"2 type A", "", left, g53("X0"), {80, 60}, {{80, 50}}},
      {"2 type B",
       kTypeB,
       left,
       g53("X0"),
       {80, 60},
       {{83.16227766016838, 50.51316701949486}, {81.62277660168379, 50}}},
      {"2 CCN", kCcn, left, g53("X0"), {80, 60}, {{81.62277660168379, 50}}},
      {"3", "", left, g53("Y0"), {80, 60}, {{90, 60}}},
      {"3 CCN", kCcn, left, g53("Y0"), {80, 60}, {{90, 52.79240779943874}}},
      {"4", "", left, g53("Y160"), {80, 60}, {{70, 60}}},
      {"4 type B",
       kTypeB,
       left,
       g53("Y160"),
       {80, 60},
       {{83.16227766016838, 50.51316701949486}, {73.67544467966324, 47.35088935932648}, {70, 50}}},
      {"4 CCN", kCcn, left, g53("Y160"), {80, 60}, {{73.67544467966324, 47.35088935932648}, {70, 50}}},
      {"5 CCN", kCcn, left, kA + "G28 X40 Y60", {40, 0}, {{30, 10}}},
      {"5 CCN", kCcn, left, kA + "G28 X40 Y60", {40, 60}, {{30, 60}}},
      {"5", "", left, kA + "G28 X40 Y60", {40, 0}, {{40, 10}}},
      {"5", "", left, kA + "G28 X40 Y60", {40, 60}, {{40, 60}}},
      {"6 CCN", kCcn, left, kA + "G28 X100 Y-45", {40, 0}, {{43.33333333333333, 10}}},
      {"6 CCN", kCcn, left, kA + "G28 X100 Y-45", {100, -45}, {{106, -37}}},
  });
}

TEST(FastCutterCompensationC, CornerArcs) {
  check({
      {"1", "", {0, -20}, "G42 D2 G01 X0 Y0\nG91 Y10\nG39\nX-10", {0, 10}, {{5, 10}, {0, 15}}},
      {"2",
       "",
       {0, -20},
       "G42 D2 G01 X0 Y0\nG91 Y10\nG39 I-1 J2\nX-10 Y20",
       {0, 10},
       {{5, 10}, {4.472135954999579, 12.23606797749979}}},
      {"3", "", {-50, 0}, kA + "G39\nX80 Y-30", {40, 0}, {{40, 10}, {46, 8}}},
      {"4", "", {-50, 0}, kA + "G39 I3 J-4\nX70 Y-40", {40, 0}, {{40, 10}, {48, 6}}},
      {"5 inner", "", {-50, 0}, "G41 D2 G01 X0\nX40\nG39\nY30", {40, 0}, {{40, 5}, {35, 0}}},
      {"6 straight on", "", {-50, 0}, kA + "G39\nX80", {40, 0}, {{40, 10}}},
  });
  const ProgramRun inner(setup("", -50, 0), "G41 D2 G01 X0\nX40\nG39\nY30");
  ASSERT_TRUE(inner.events.at(2).arc);
  EXPECT_EQ(inner.events[2].arc->direction, spec::ArcDirection::cw);
  EXPECT_NEAR(*inner.events[2].arc->sweep, 270, kTolerance);
  EXPECT_EQ(inner.events[2].arc->center[0], 40);
  EXPECT_EQ(inner.events[2].cause, spec::Cause::corner);
  EXPECT_EQ(inner.events[2].line, 3U);
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

// Sheet, decisions: a second lone G41 that ends the look-ahead of the first makes the vector by its own next block. By
// hand: 10 square to (30, 40) is (-8, 6).
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
