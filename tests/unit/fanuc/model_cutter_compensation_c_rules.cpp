// SPDX-License-Identifier: Apache-2.0
// Rules of cutter compensation C that the worked examples do not show: what ends the look-ahead, codes without
// motion, alarms and the moves given before them, planes and other axes. Expected values are derived from the clauses.
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/fanuc/model_cutter_run.h"

namespace {

using namespace toolcomp;
using test::alarm;
using test::cutter_setup;
using test::Lines;
using test::run;
using test::Show;

Lines points(const std::string& program, const std::string& parameters = "", const std::string& more = "") {
  return test::lines(run(cutter_setup(parameters, more), program), Show::point);
}

// G41 from (0,0) along X, d = 10.
constexpr const char* kStart = "G01 G41 D1 X20 F100\nX40\n";
std::string started(const std::string& rest) { return kStart + rest; }

TEST(ModelCutterCRules, EndOfTheProgram) {
  EXPECT_EQ(points("G01 G41 D1 X40 F100\n"), (Lines{"1 linear X40 Y10 Z0 (start-up)"}));
  EXPECT_EQ(points(started("Y30\n")),
            (Lines{"1 linear X20 Y10 Z0 (start-up)", "2 linear X30 Y10 Z0", "3 linear X30 Y30 Z0"}));
  EXPECT_EQ(points(started("Y30\nM30\nX100\n")).back(), "3 linear X30 Y30 Z0");
}

TEST(ModelCutterCRules, StartWithoutMotion) {
  // SUV = 0: the next moving block is the start-up block, whatever stands between.
  EXPECT_EQ(points("G01 G41 D1 F100\nZ-5\nM03\nX40\n"),
            (Lines{"2 linear X0 Y0 Z-5", "4 linear X40 Y10 Z-5 (start-up)"}));
  // SUV = 1: P2 of the next moving block; one block between runs behind the start-up move.
  constexpr const char* kAtOnce = "\"5003#1\" = 1";
  EXPECT_EQ(points("G01 G41 D1 F100\nX40\nX80\n", kAtOnce),
            (Lines{"1 linear X0 Y10 Z0 (start-up)", "2 linear X40 Y10 Z0", "3 linear X80 Y10 Z0"}));
  EXPECT_EQ(points("G41 D1\nZ-5\nY40\n", kAtOnce),
            (Lines{"1 rapid X-10 Y0 Z0 (start-up)", "2 rapid X-10 Y0 Z-5", "3 rapid X-10 Y40 Z-5"}));
  // Its own move takes the vector along; the next block may be an arc.
  EXPECT_EQ(points("G41 D1 Z-5\nG02 X40 I20 F100\n", kAtOnce),
            (Lines{"1 rapid X-10 Y0 Z-5 (start-up)", "2 arc X50 Y0 Z-5"}));
  // No next block: no vector, and the next moving block is a start-up block.
  EXPECT_EQ(points("G41 D1\nM03\nM08\nX40\n", kAtOnce), (Lines{"4 rapid X40 Y10 Z0 (start-up)"}));
  EXPECT_EQ(points("G41 D1\nG40\nX40\n", kAtOnce), (Lines{"3 rapid X40 Y0 Z0"}));
  EXPECT_EQ(points("G41 D1\n", kAtOnce), (Lines{}));
  // A value of 0 makes no move of its own.
  EXPECT_EQ(points("G41 D4\nX40\n", kAtOnce), (Lines{"2 rapid X40 Y0 Z0"}));
}

TEST(ModelCutterCRules, NumberZero) {
  EXPECT_EQ(points("G01 G41 D0 X40 F100\nD1 X80\nX90\n"),
            (Lines{"1 linear X40 Y0 Z0", "2 linear X80 Y10 Z0 (start-up)", "3 linear X90 Y10 Z0"}));
  EXPECT_EQ(points(started("X60 D0\nX80 D1\n")),
            (Lines{"1 linear X20 Y10 Z0 (start-up)", "2 linear X40 Y10 Z0", "3 linear X60 Y0 Z0 (cancel)",
                   "4 linear X80 Y10 Z0 (start-up)"}));
  // With number 0 an arc is free.
  EXPECT_EQ(points("G02 G41 D0 X40 I20 F100\n"), (Lines{"1 arc X40 Y0 Z0"}));
}

TEST(ModelCutterCRules, ValueZero) {
  EXPECT_EQ(points("G01 G41 D4 X40 F100\nX0 Y-1\nG40 X10\n", "\"5003#0\" = 1"),
            (Lines{"1 linear X40 Y0 Z0 (start-up)", "2 linear X0 Y-1 Z0", "3 linear X10 Y-1 Z0 (cancel)"}));
  // A lone G40 leaves nothing to remove.
  EXPECT_EQ(points("G01 G41 D4 X40 F100\nG40\nX50\n").back(), "3 linear X50 Y0 Z0");
}

TEST(ModelCutterCRules, CancelWithoutMotion) {
  EXPECT_EQ(points(started("G40\nZ9\nX80\nX90\n")),
            (Lines{"1 linear X20 Y10 Z0 (start-up)", "2 linear X40 Y10 Z0", "4 linear X40 Y10 Z9",
                   "5 linear X80 Y0 Z9 (cancel)", "6 linear X90 Y0 Z9"}));
  EXPECT_EQ(points(started("G40 Z9\nX80\n"), "\"5003#1\" = 1"),
            (Lines{"1 linear X20 Y10 Z0 (start-up)", "2 linear X40 Y10 Z0", "3 linear X40 Y0 Z9 (cancel)",
                   "4 linear X80 Y0 Z9"}));
  // Left open.
  EXPECT_EQ(points(started("G40\nG41\n")).back(), "4 fanuc.cutter-c.restart-before-removal");
}

TEST(ModelCutterCRules, ChangeOfDirectionAtStartUp) {
  EXPECT_EQ(points("G01 G41 D1 X40 F100\nG42 Y30\n"),
            (Lines{"1 linear X40 Y10 Z0 (start-up)", "2 DIR_CHANGE_AT_STARTUP"}));
  EXPECT_EQ(alarm(run(cutter_setup(), "G01 G41 D1 X40 F100\nM03\nM08\nD3 Y30\n")), "4 DIR_CHANGE_AT_STARTUP");
  EXPECT_EQ(alarm(run(cutter_setup("\"5003#1\" = 1"), "G41 D1\nG42 X30\n")), "2 DIR_CHANGE_AT_STARTUP");
  // Before the start-up block nothing has started; a change in the cancel block is none.
  EXPECT_EQ(alarm(run(cutter_setup(), "G01 G41 D1 F1\nG42\nX40\nX80\n")), "");
  EXPECT_EQ(alarm(run(cutter_setup(), "G01 G41 D1 X40 F1\nG40 D3 X80\n")), "");
  // The next block but one may change it.
  EXPECT_EQ(points(started("G42 X40 Y30\n")).back(), "3 linear X50 Y30 Z0");
}

TEST(ModelCutterCRules, Repeated) {
  EXPECT_EQ(points("G01 G41 D1 X40 F100\nG41 Y-30\n"),
            (Lines{"1 linear X40 Y10 Z0 (start-up)", "2 linear X50 Y-30 Z0"}));
  // Between A and the cancel block too.
  EXPECT_EQ(points(started("G41\nG40 Y-30\n"), "\"5003#0\" = 1"),
            (Lines{"1 linear X20 Y10 Z0 (start-up)", "2 linear X40 Y10 Z0", "4 linear X40 Y-30 Z0 (cancel)"}));
  // In the cancel block itself, which number 0 makes: (40,0) + 10 to the left of +X. Another code is no repetition:
  // the outer right angle has the heads (10,10) and (10,0).
  EXPECT_EQ(points(started("G41 D0 Y-30\n"), "\"5003#0\" = 1"),
            (Lines{"1 linear X20 Y10 Z0 (start-up)", "2 linear X40 Y10 Z0", "3 linear X40 Y-30 Z0 (cancel)"}));
  EXPECT_EQ(points(started("G42 D0 Y-30\n"), "\"5003#0\" = 1"),
            (Lines{"1 linear X20 Y10 Z0 (start-up)", "2 linear X50 Y10 Z0", "3 linear X50 Y0 Z0 (corner)",
                   "3 linear X40 Y-30 Z0 (cancel)"}));
  // A change of the side by the value comes before it.
  EXPECT_EQ(points(started("G41 D3 Y30\n"))[1], "2 linear X50 Y10 Z0");
}

TEST(ModelCutterCRules, ArcAtStartOrCancel) {
  EXPECT_EQ(points("G02 G41 D1 X40 I20 F1\n"), (Lines{"1 PS0034"}));
  EXPECT_EQ(points(started("G02 G40 X60 I10\n")),
            (Lines{"1 linear X20 Y10 Z0 (start-up)", "2 linear X40 Y10 Z0", "3 PS0034"}));
  EXPECT_EQ(points(started("G40\nG02 X60 I10\n")).back(), "4 PS0034");
}

// fanuc.cutter-c.start-without-motion: a second lone G41 that ends the look-ahead of the first makes the vector by its
// own next block. By hand: 2 square to (30, 40) is (-1.6, 1.2).
TEST(ModelCutterCRules, ASecondLoneStart) {
  constexpr const char* kAtOnce = "\"5003#1\" = 1";
  const auto lone = [&](const std::string& between, const std::string& program = "G01 X30 Y40 F100\nX60 Y80\n") {
    return points("G90 G00 X0 Y0\nG10 L11 P1 R2\nG41 D1\n" + between + program, kAtOnce);
  };
  const auto without_setting = [](Lines seen) {
    std::erase_if(seen, [](const std::string& line) { return line.find('=') != std::string::npos; });
    return seen;
  };
  EXPECT_EQ(without_setting(lone("M05\nG41 D1\n")), (Lines{"1 rapid X0 Y0 Z0", "5 rapid X-1.6 Y1.2 Z0 (start-up)",
                                                           "6 linear X28.4 Y41.2 Z0", "7 linear X58.4 Y81.2 Z0"}));
  // By a G42 on the other side; by a zero travel with the word; without a block between the first one is the one.
  EXPECT_EQ(without_setting(lone("M05\nG42 D1\n"))[1], "5 rapid X1.6 Y-1.2 Z0 (start-up)");
  EXPECT_EQ(without_setting(lone("G41 X0\n"))[1], "4 rapid X-1.6 Y1.2 Z0 (start-up)");
  EXPECT_EQ(without_setting(lone("G41 D1\n"))[1], "3 rapid X-1.6 Y1.2 Z0 (start-up)");
  // The look-ahead of the second one ends likewise; a third makes the vector.
  EXPECT_EQ(without_setting(lone("M05\nG41 D1\nM05\nG41 D1\n"))[1], "7 rapid X-1.6 Y1.2 Z0 (start-up)");
  // Without a word in the block that ends it the next moving block is a start-up block.
  EXPECT_EQ(without_setting(lone("M05\nM08\n"))[1], "6 linear X28.4 Y41.2 Z0 (start-up)");
}

// fanuc.cutter-c.arc-ends-in-center: a centre in the start and one in the end are alike; PS0020 is for an R that cannot
// be.
TEST(ModelCutterCRules, ArcAboutItsStartOrItsEnd) {
  for (const char* block :
       {"G02 X50 I0\n", "G03 X50 Y5 J0\n", "G02 X40 I0\n", "G02 I0\n", "G02 X50 K3\n", "G02 X50 I10\n"})
    EXPECT_EQ(points(started(block)), (Lines{"1 linear X20 Y10 Z0 (start-up)", "2 linear X40 Y10 Z0", "3 PS0038"}))
        << block;
  EXPECT_EQ(points(started("G02 X50 R1\n")).back(), "3 PS0020");
  EXPECT_EQ(points(started("G02 X50\n")).back(), "3 PS0022");
  // Words come first, and where the mode is not asked for it is PS0022.
  EXPECT_EQ(points("G02 G41 D1 X40 I0 F1\n"), (Lines{"1 PS0034"}));
  EXPECT_EQ(points(started("G40 X60\nG02 X70 I0\n")).back(), "4 PS0022");
  EXPECT_EQ(points("G41 D0\nG02 X70 I0 F1\n").back(), "2 PS0022");
  EXPECT_EQ(points("G41 D1\nG02 X70 I0 F1\n", "\"5003#1\" = 1").back(), "2 PS0038");
}

TEST(ModelCutterCRules, AlarmsBeforeAMove) {
  EXPECT_EQ(alarm(run(cutter_setup(), started("G18 X50\n"))), "3 PS0037");
  EXPECT_EQ(alarm(run(cutter_setup(), started("G40 G18 X50\n"))), "3 PS0037");
  EXPECT_EQ(alarm(run(cutter_setup(), "G41 D1\nG18 X50\n")), "2 PS0037");
  EXPECT_EQ(points(started("G02 X45 Y5 I5 J5\n")),
            (Lines{"1 linear X20 Y10 Z0 (start-up)", "2 linear X40 Y10 Z0", "3 PS0038"}));
  EXPECT_EQ(alarm(run(cutter_setup(), started("G92 Z0\nX50\n"))), "");
}

// Found by fuzzing. The move of a block with G92 that makes or removes a vector is written after the renaming, that of
// the length offset alone before it.
TEST(ModelCutterCRules, LengthOffsetBesideCoordinateShift) {
  constexpr const char* kAtOnce = "\"5003#1\" = 1";
  const std::string starts = "G43 H1\nG41 D1 G92 H0 X1\nX41\n";
  EXPECT_EQ(points(starts), (Lines{"1 rapid X0 Y0 Z0", "2 rapid X0 Y0 Z0", "3 rapid X41 Y10 Z0 (start-up)"}));
  EXPECT_EQ(points(starts, kAtOnce), (Lines{"1 rapid X0 Y0 Z0", "2 rapid X1 Y10 Z0 (start-up)", "3 rapid X41 Y10 Z0"}));
  EXPECT_EQ(points("G43 H1\nG41 D4 G92 H0 X1\n", kAtOnce), (Lines{"1 rapid X0 Y0 Z0", "2 rapid X0 Y0 Z0"}));
  const std::string ends = "G43 H1\n" + started("G40 G92 H0 Z5\n");
  EXPECT_EQ(points(ends).back(), "4 linear X40 Y10 Z0");
  EXPECT_EQ(points(ends, kAtOnce).back(), "4 linear X40 Y0 Z5 (cancel)");
}

// A G02 of radius 20 into a line that its offset path misses: A is named, and the block before runs to its first head.
TEST(ModelCutterCRules, NoIntersection) {
  const std::string program = "G01 G42 D9 X40 F100\nX60\nG02 X80 Y-20 J-20\nG01 X0 Y-40\n";
  // G42, d = 15: the arc's offset circle has R' = 5 about (60,-20); the line from (80,-20) to (0,-40) runs on its left
  // 15 away on the right, above the centre by more than 5.
  const Lines seen = points(program);
  EXPECT_EQ(seen.back(), "3 PS0033");
  EXPECT_EQ(seen[1], "2 linear X60 Y-15 Z0");
  EXPECT_EQ(seen.size(), 3U);
}

TEST(ModelCutterCRules, CornerArcAlarms) {
  const auto last = [](const std::string& program, const std::string& parameters = "") {
    return alarm(run(cutter_setup(parameters), program));
  };
  EXPECT_EQ(last("G39\n"), "1 PS0035");
  EXPECT_EQ(last("G41 D1\nG39\n"), "2 PS0035");
  EXPECT_EQ(last("G41 D1\nG39\n", "\"5003#1\" = 1"), "2 PS0035");
  EXPECT_EQ(last(started("G39 I0 J0\n")), "3 PS0035");
  EXPECT_EQ(last(started("G39 X3\n")), "3 PS0035");
  EXPECT_EQ(last(started("G39 D2\n")), "3 PS0035");
  EXPECT_EQ(last(started("G39 D1\n")), "");
  EXPECT_EQ(last(started("G39 G42\n")), "3 PS0035");
  EXPECT_EQ(last(started("G40\nG39\n")), "4 PS0035");
  EXPECT_EQ(last(started("G53 X0\nG39\n"), "\"5003#2\" = 1"), "4 PS0035");
  // Another letter gives no direction.
  EXPECT_EQ(points(started("G39 K5\nY-30\n"))[2], "3 arc X50 Y0 Z0 (corner)");
}

TEST(ModelCutterCRules, CornerArcWithoutNextBlock) {
  EXPECT_EQ(points(started("G39\n")), (Lines{"1 linear X20 Y10 Z0 (start-up)", "2 linear X40 Y10 Z0"}));
  EXPECT_EQ(points(started("G39\nG40\nX80\n")).back(), "5 linear X80 Y0 Z0 (cancel)");
  EXPECT_EQ(points(started("G39\nM03\nM08\n")), (Lines{"1 linear X20 Y10 Z0 (start-up)", "2 linear X40 Y10 Z0",
                                                       "3 fanuc.cutter-c.corner-arc-without-next-block"}));
  EXPECT_EQ(points(started("G39\nM03\nY-30\n"))[2], "3 arc X50 Y0 Z0 (corner)");
  // Before the cancel block: to its perpendicular vector.
  EXPECT_EQ(points(started("G39\nG40 Y-30\n")), (Lines{"1 linear X20 Y10 Z0 (start-up)", "2 linear X40 Y10 Z0",
                                                       "3 arc X50 Y0 Z0 (corner)", "4 linear X40 Y-30 Z0 (cancel)"}));
}

TEST(ModelCutterCRules, CoordinateShift) {
  // The end of the program behind it.
  EXPECT_EQ(points(started("G92 X0\n")), (Lines{"1 linear X20 Y10 Z0 (start-up)", "2 linear X40 Y0 Z0"}));
  // Behind another one, or G53 with CCN = 1, there is no vector to take away.
  EXPECT_EQ(points(started("G92 X0\nG92 Y0\nX50\n")).back(), "5 linear X50 Y10 Z0");
  EXPECT_EQ(points(started("G53 X90\nG92 Y0\nX100\n"), "\"5003#2\" = 1").back(), "5 linear X100 Y10 Z0");
  // The side may change behind it, also in its block; a start-up before it does not forbid that.
  EXPECT_EQ(points(started("G42 G92 X0\nX50\n")).back(), "4 linear X50 Y-10 Z0");
  EXPECT_EQ(points("G01 G41 D1 X20 F100\nG92 X0\nG42 X50\n"),
            (Lines{"1 linear X20 Y0 Z0 (start-up)", "3 linear X50 Y-10 Z0"}));
  // G39 has no vector behind it; before it, it keeps the one it has.
  EXPECT_EQ(points(started("G92 X0\nG39\nY30\n")).back(), "4 PS0035");
  EXPECT_EQ(points(started("G39\nG92 X0\nX50\n")).back(), "4 fanuc.cutter-c.coordinate-shift-with-vector");
  // From (30,10) to (40,5), against a way of 5 along Y: it is not checked.
  EXPECT_EQ(points(started("Y5\nG92 X0\nX50\n")), (Lines{"1 linear X20 Y10 Z0 (start-up)", "2 linear X30 Y10 Z0",
                                                         "3 linear X40 Y5 Z0", "5 linear X50 Y15 Z0"}));
  // SUV = 1: the code makes no vector, and the next moving block is a start-up block; with the code it waits anew.
  constexpr const char* kAtOnce = "\"5003#1\" = 1";
  EXPECT_EQ(points("G01 G41 D1 F100\nG92 X5\nX40\n", kAtOnce), (Lines{"3 linear X40 Y10 Z0 (start-up)"}));
  EXPECT_EQ(points("G01 G41 D1 F100\nG41 G92 X5\nX40\n", kAtOnce),
            (Lines{"2 linear X5 Y10 Z0 (start-up)", "3 linear X40 Y10 Z0"}));
  EXPECT_EQ(points("G01 G41 D1 F100\nG92 X5\nG02 X10 I5\n", kAtOnce), (Lines{"3 PS0034"}));
}

TEST(ModelCutterCRules, MovesOfTheMachine) {
  constexpr const char* kGoesOn = "\"5003#2\" = 1";
  // One axis of the plane.
  EXPECT_EQ(points(started("G53 X90\nY40\n"))[2], "3 rapid X90 Y0 Z0");
  EXPECT_EQ(points(started("G53 X90\nX100\n"), kGoesOn)[2], "3 rapid X90 Y0 Z0");
  // Axes outside the plane keep the vector, and there is no corner behind them.
  EXPECT_EQ(points(started("G53 Z7\nY-30\n")), (Lines{"1 linear X20 Y10 Z0 (start-up)", "2 linear X40 Y10 Z0",
                                                      "3 rapid X40 Y10 Z7", "4 linear X50 Y-30 Z7"}));
  // With G40 the mode is off.
  EXPECT_EQ(points(started("G40 G53 X90\nY40\n")).back(), "4 linear X90 Y40 Z0");
  // G29 loses the vector at its intermediate point.
  EXPECT_EQ(points("G28 X5 Y5\n" + started("G29 X60 Y60\n")),
            (Lines{"1 rapid X5 Y5 Z0 (reference)", "1 rapid X0 Y0 Z0 (reference)", "2 linear X20 Y10 Z0 (start-up)",
                   "3 linear X40 Y10 Z0", "4 rapid X5 Y5 Z0", "4 rapid X60 Y60 Z0"}));
  // CCN = 1, G28 with an acute corner: its corner move is rapid and belongs to it.
  EXPECT_EQ(points(started("G28 X10 Y-40\n"), kGoesOn),
            (Lines{"1 linear X20 Y10 Z0 (start-up)", "2 linear X50 Y10 Z0", "3 rapid X54 Y2 Z0 (corner)",
                   "3 rapid X18 Y-46 Z0 (reference)", "3 rapid X0 Y0 Z0 (reference)"}));
}

TEST(ModelCutterCRules, CornerMovesBelongToTheLatterBlock) {
  // Z and length offset as before the block; a block between runs at the first head.
  EXPECT_EQ(test::lines(run(cutter_setup(), "G43 H1 Z0\n" + started("Z5\nG00 X10 Y-40 Z8\n")), Show::axes),
            (Lines{"1 rapid X0 Y0 Z50", "2 linear X20 Y10 Z50 (start-up)", "3 linear X50 Y10 Z50",
                   "4 linear X50 Y10 Z55", "5 rapid X54 Y2 Z55 (corner)", "5 rapid X18 Y-46 Z58"}));
}

TEST(ModelCutterCRules, Planes) {
  // Z X with Z as the first axis, Y Z with Y: the corner of 90° outside.
  EXPECT_EQ(points("G18 G01 G41 D1 Z20 F1\nZ40\nX-30\n")[1], "2 linear X10 Y0 Z50");
  EXPECT_EQ(points("G19 G01 G41 D1 Y20 F1\nY40\nZ-30\n")[1], "2 linear X0 Y50 Z10");
  // Helical: the third axis goes along.
  EXPECT_EQ(points(started("G02 X60 Y-20 J-20 Z-6\n")).back(), "3 arc X70 Y-20 Z-6");
}

TEST(ModelCutterCRules, WorkpieceSystemChangedOnTheWay) {
  // The origin goes 100 to the right: the machine stays, the corner is called (-60, 0) in the block with G55.
  EXPECT_EQ(points(started("G55 X-90 Y-40\n"), "", "[workpiece.G55]\nX = 100\n"),
            (Lines{"1 linear X20 Y10 Z0 (start-up)", "2 linear X50 Y10 Z0", "3 linear X-46 Y2 Z0 (corner)",
                   "3 linear X-82 Y-46 Z0"}));
  // A rotary axis has its new coordinate there too.
  const std::string rotary =
      "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\"]\n[offsets.D]\n1 = 10\n[workpiece.G55]\nB = 90\n";
  EXPECT_EQ(test::lines(run(rotary, started("G55 X10 Y-40\n")))[2], "3 linear X54 Y2 Z0 B-90 (corner)");
  // The tool, of a head with A on B, stays; where programmed angles turn it it goes with the name: (sin -90, 0, cos
  // -90).
  const std::string head =
      "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"A\", \"B\"]\n[parameters]\n19680 = 2\n19681 = 5\n"
      "19682 = 2\n19686 = 4\n19687 = 1\n[offsets.D]\n1 = 10\n[workpiece.G55]\nB = 90\n";
  const auto expect_tool = [](const std::string& setup, const std::string& x, const std::string& z) {
    const auto done = run(setup, started("G55 X10 Y-40\n"));
    const model::Event& corner = done.events().at(2);
    ASSERT_EQ(corner.cause, spec::Cause::corner);
    ASSERT_TRUE(corner.tool_axis);
    EXPECT_EQ((*corner.tool_axis)[0].decimal(9), x);
    EXPECT_EQ((*corner.tool_axis)[2].decimal(9), z);
  };
  expect_tool(head, "0", "1");
  expect_tool("rotary_angles = \"programmed\"\n" + head, "-1", "0");
}

// Every decision about a small movement, "quantity of scale".
Lines small_movements(const std::string& program, const std::string& parameters) {
  Lines result;
  const auto seen = run(cutter_setup(parameters), program);
  for (const model::Decision& decision : seen.recorder.decisions())
    if (decision.clause == spec::Clause::fanuc_cutter_c_small_corner_movement)
      result.push_back(decision.quantity.decimal(12) + " of " + decision.scale.decimal(12));
  return result;
}

TEST(ModelCutterCRules, MarginOfASmallMovement) {
  // From +X into a clockwise arc that starts along (4,-3)/5: M = (10/3, 10), P2 = (6, 8), difference (8/3, -2).
  const std::string corner = started("G91 G02 X10 Y-70 I-30 J-40\n");
  EXPECT_EQ(small_movements(corner, "5010 = 3"),
            (Lines{"0.333333333333 of 43", "5.666666666667 of 43", "5 of 43", "1 of 43"}));
  EXPECT_EQ(small_movements(corner, ""), (Lines{"-2.666666666667 of 40"}));
  // The arc turns off by 1e-8: 10 sin 1e-8 - 10 tan 0.5e-8 = 5e-8, next to nothing against heads of length 10.
  EXPECT_EQ(small_movements(started("G91 G02 X99999.998 Y-100000 I-0.001 J-99999.999\n"), ""),
            (Lines{"-0.00000005 of 40"}));
}

TEST(ModelCutterCRules, InterferenceNamesTheBlock) {
  // The alarm of the last block comes with the end of the program, before a later alarm of reading.
  EXPECT_EQ(points(started("Y15\nX0\nG02 X1\n")),
            (Lines{"1 linear X20 Y10 Z0 (start-up)", "2 linear X30 Y10 Z0", "3 PS0041"}));
  EXPECT_EQ(alarm(run(cutter_setup("\"5008#0\" = 1"), started("Y15\nX0\n"))), "");
}

TEST(ModelCutterCRules, OffsetLargerThanTheRadius) {
  // CNI = 1: the arc of radius 8 runs between its heads at |R'| = 2, with its programmed sweep.
  const auto seen = run(cutter_setup("\"5008#0\" = 1"), started("G03 X48 Y8 J8\nG01 Y40\n"));
  EXPECT_EQ(test::lines(seen, Show::point)[2], "3 arc X38 Y8 Z0");
  EXPECT_EQ(seen.events()[2].arc->sweep->decimal(10), "90");
  EXPECT_FALSE(seen.events()[2].arc->radius);
}

}  // namespace
