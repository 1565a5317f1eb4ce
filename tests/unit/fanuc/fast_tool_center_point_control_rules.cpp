// SPDX-License-Identifier: Apache-2.0
// Rules of tool center point control in the fast engine: words, alarms, the end of the mode, WKP, arcs, samples, turns.
// Expected values: the worked examples and the clauses, and hand derivations where a comment says so.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/unit/fanuc/fast_run.h"
#include "tests/unit/fanuc/fast_tip_control.h"

namespace toolcomp::fast {
namespace {

using tip_control::expect_axes;
using tip_control::expect_direction;
using tip_control::expect_point;
using tip_control::machine_b_c_mixed;
using tip_control::machine_head;
using tip_control::machine_table;
using tip_control::move_at;
using tip_control::sample_at;

const std::string kNoKinematics =
    "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\",\"B\"]\n[offsets.H]\n1=100\n";

TEST(FastToolCenterPointControlRules, AlarmsByWords) {
  const auto alarm = [](const std::string& machine, const std::string& program) {
    return ProgramRun(machine, program).alarm();
  };
  const std::string head = machine_head("", "");
  EXPECT_EQ(alarm(head, "G43.4 H1\nG54\n"), "FORBIDDEN_UNDER_TOOL_DIRECTION@2");
  EXPECT_EQ(alarm(head, "G43.4 H1 G28 X0\n"), "FORBIDDEN_UNDER_TOOL_DIRECTION@1");
  EXPECT_EQ(alarm(head, "G43.4 H1\nG41 D1\n"), "FORBIDDEN_UNDER_TOOL_DIRECTION@2");
  EXPECT_EQ(alarm(head, "G43 H1\nG43.4 P7\n"), "LENGTH_OFFSET_EXCLUSION@2");
  EXPECT_EQ(alarm(head, "G43.4 H1\nG44\n"), "LENGTH_OFFSET_EXCLUSION@2");
  EXPECT_EQ(alarm(kNoKinematics, "G43.4 H1\n"), "PS5459@1");
  EXPECT_EQ(alarm(kNoKinematics, "G43.5 H1 P2\n"), "PS5421@1");
  EXPECT_EQ(alarm(machine_head("\"19696#5\"=1\n", ""), "G43.5 H1 P7\n"), "PS5459@1");
  EXPECT_EQ(alarm(head, "G43.4 H1 P2\n"), "PS5421@1");
  EXPECT_EQ(alarm(head, "G43.4 H1 P0.5\n"), "PS5421@1");
  EXPECT_EQ(alarm(machine_head("19741=10\n19742=20\n", ""), "G43.5 H1\n"), "PS5459@1");
  EXPECT_EQ(alarm(machine_head("19741=10\n19742=20\n", ""), "G43.4 H1\n"), "");
  EXPECT_EQ(alarm(head, "G02\nG43.4 H1\n"), "TOOL_DIRECTION_FORMAT@2");
  EXPECT_EQ(alarm(head, "G41.2 D1 X1\nX5\nG43.4\n"), "TOOL_DIRECTION_FORMAT@3");
  EXPECT_EQ(alarm(head, "G43.4 H1\nG41.2 D1 X1\nX5\nG49\n"), "TOOL_DIRECTION_FORMAT@4");
  EXPECT_EQ(alarm(head, "G43.5 H1\nC5\n"), "PS5421@2");
  EXPECT_EQ(alarm(head, "G43.5 H1\nG41.6 D1 X1\nB5\n"), "PS5460@3");
  EXPECT_EQ(alarm(head, "G43.5 H1 B5\n"), "PS5421@1");
  EXPECT_EQ(alarm(head, "G43.4 H1\nG41.6 D1 X1\n"), "TOOL_SIDE_MODE@2");
  EXPECT_EQ(alarm(head, "G43.5 H1\nG41.2 D1 X1\n"), "TOOL_SIDE_MODE@2");
  EXPECT_EQ(alarm(machine_table("", ""), "G43.5 H1 I1\n"), "PS5421@1");
  EXPECT_EQ(alarm(machine_b_c_mixed("", ""), "G43.5 H1 I1\n"), "PS5421@1");
  EXPECT_EQ(alarm(head, "G43.5 H1\nI0 J0 K0\n"), "PS5421@2");
  EXPECT_EQ(alarm(head, "G43.5 H1\nG02 X5 I2\n"), "PS5421@2");
  EXPECT_EQ(alarm(head, "G43.5 H1\nG02 I1 J1\n"), "PS5421@2");
  EXPECT_EQ(alarm(head, "G43.5 H1\nG02 X0 R10\n"), "PS0023@2");
  EXPECT_EQ(alarm(head, "G43.4 H1\nG02 B5\n"), "PS5421@2");
  EXPECT_EQ(alarm(head, "G43.4 H1\nG02 B5 I5\n"), "");
  EXPECT_EQ(alarm(head, "G43.4 H1\nX5 Q9\n"), "");
  EXPECT_EQ(alarm(head, "G43.4 H1\nX5 P9\n"), "");
  EXPECT_EQ(alarm(machine_table("\"19696#5\"=1\n", ""), "G43.4 H1\nG41.2 D1 X1\n"),
            "COMPENSATION_IN_WORKPIECE_SYSTEM@2");
  EXPECT_EQ(alarm(machine_head("\"19696#5\"=1\n", ""), "G43.4 H1\nG41.2 D1 X1\nX9\n"), "");
}

TEST(FastToolCenterPointControlRules, AlarmsOfThePosture) {
  // Example 2: the range of A leaves nothing.
  EXPECT_EQ(ProgramRun(machine_table("19741=30\n19742=-30\n", ""), "G43.5 H1\nI-1 J1 K2\n").alarm(), "PS5459@2");
  EXPECT_EQ(ProgramRun(machine_table("19741=40\n19742=-30\n", ""), "G43.5 H1\nI-1 J1 K2\n").alarm(), "");
  // Example 1: the nutating head does not reach -Z, the tilted tool not +Z.
  EXPECT_EQ(ProgramRun(tip_control::machine_nutating_head("", ""), "G43.5 H1\nK-1\n").alarm(), "PS5459@2");
  EXPECT_EQ(ProgramRun(machine_head("19698=5\n", ""), "G43.5 H1\nK1\n").alarm(), "PS5459@2");
}

// The block of the code: its axes go by themselves, the length is applied at its end; one move always.
TEST(FastToolCenterPointControlRules, BlockOfTheCode) {
  const ProgramRun lone(machine_head("", "B=90\n"), "G43.4 H1\n", 4);
  ASSERT_EQ(lone.events.size(), 1U);
  expect_axes(lone, 0, "XYZ", {100, 0, 0}, 0);
  EXPECT_NE(lone.events[0].machine.present, 0);
  const ProgramRun moving(machine_head("", ""), "G43.4 H1 X5 B90 C90\n", 4);
  ASSERT_EQ(moving.events.size(), 1U);
  expect_axes(moving, 0, "XYZBC", {5, 100, 0, 90, 90}, 0);
  // A head turns to I J K in the G43.5 block; by hand the pair (-90, -90) moves as far as (90, 90): the greater one.
  const ProgramRun turning(machine_head("", ""), "G43.5 H1 P1 J1\n", 4);
  ASSERT_EQ(turning.events.size(), 1U);
  expect_axes(turning, 0, "XYZBC", {0, 100, 0, 90, 90}, 0);
}

TEST(FastToolCenterPointControlRules, EndOfTheMode) {
  // G49: no move; the programmed position is that of the axes.
  const ProgramRun head(machine_head("", "C=90\n"), "G43.5 H1\nG01 X10 J1 F100\nG49\nG91 Z1\nB1\n");
  ASSERT_EQ(head.events.size(), 4U);
  expect_axes(head, 2, "XYZBC", {10, 100, 1, 90, 90}, 0);
  EXPECT_EQ(head.programmed(2, 'Y'), 100);
  expect_axes(head, 3, "BC", {91, 90}, 0);
  EXPECT_EQ(head.events[2].machine.present, 0);
  // By hand: the table turned by A-90, C90 carries (10, 0, 0) to (0, 0, 10): the axes stand at 110.
  const ProgramRun table(machine_table("", ""), "G43.4 H1\nG01 X10 A-90 C90 F100\nG49\nX1\n");
  ASSERT_EQ(table.events.size(), 3U);
  EXPECT_EQ(table.programmed(2, 'X'), 1);
  EXPECT_EQ(table.axis(2, 'Y'), table.axis(1, 'Y'));
  EXPECT_EQ(table.axis(2, 'Z'), table.axis(1, 'Z'));
}

// G43.4 under G43.4: the tip stays, in the coordinates of the workpiece.
TEST(FastToolCenterPointControlRules, CodeAgain) {
  const ProgramRun run(machine_table("", ""), "G43.4 H1\nG01 X10 C90 F100\nG43.4 H2\nX10\n");
  ASSERT_EQ(run.alarm(), "");
  ASSERT_EQ(run.events.size(), 4U);
  // By hand: a table with sense 1 turned by C90 carries (10, 0) to (0, -10) or (0, 10); the tool stands there.
  expect_axes(run, 2, "XY", {run.axis(1, 'X'), run.axis(1, 'Y')});
  EXPECT_EQ(run.programmed(2, 'X'), 0);
  EXPECT_EQ(std::abs(run.programmed(2, 'Y')), 10);
  expect_axes(run, 2, "Z", {150}, 0);
  expect_axes(run, 3, "XY", {10, run.axis(1, 'Y')});
}

// G43.4 and G43.5 behind a G41 without a number are moves of their own kind.
TEST(FastToolCenterPointControlRules, BehindUnusedCutterCompensation) {
  const ProgramRun run(machine_head("", ""), "G41\nX5\nG43.4 H1 G40\nG01 X8 F100\n", 2);
  ASSERT_EQ(run.alarm(), "");
  ASSERT_EQ(run.events.size(), 4U);
  EXPECT_NE(run.events[1].machine.present, 0);
  expect_axes(run, 1, "XZ", {5, 100}, 0);
  EXPECT_EQ(run.events[2].kind, spec::EventKind::sample);
}

// By hand: L goes evenly from 100 to 150 in a block that changes H.
TEST(FastToolCenterPointControlRules, LengthChangesEvenly) {
  const ProgramRun run(machine_head("", ""), "G43.4 H1\nG01 X8 H2 F100\nH1\n", 4);
  ASSERT_EQ(run.events.size(), 9U);
  expect_axes(run, sample_at(run, 2, 1, 4), "XZ", {2, 112.5}, 0);
  expect_axes(run, sample_at(run, 3, 3, 4), "XZ", {8, 112.5}, 0);
  expect_axes(run, move_at(run, 3), "Z", {100}, 0);
}

// WKP = 1: the programmed end is that after the table has turned; by hand, about Z through the origin.
TEST(FastToolCenterPointControlRules, WorkpieceSystem) {
  const std::string wkp = "\"19696#5\"=1\n";
  const ProgramRun run(machine_b_c_mixed(wkp, "X=10\n"), "G43.4 H1\nG01 X10 Y0 C90 F100\nC180\nG91 X1\n", 2);
  ASSERT_EQ(run.alarm(), "");
  expect_point(run, move_at(run, 2), {10, 0, 0});
  expect_axes(run, move_at(run, 2), "XY", {10, 0}, 1e-14);
  // On the table the tip goes straight from (10, 0) to a point at right angles; half way the table has turned by 45.
  expect_axes(run, sample_at(run, 2, 1, 2), "XYC", {10 * std::sqrt(0.5), 0, 45}, 1e-14);
  // Without X Y Z the tip stays on the table.
  EXPECT_NEAR(run.programmed(move_at(run, 3), 'X'), 0, 1e-15);
  EXPECT_NEAR(std::abs(run.programmed(move_at(run, 3), 'Y')), 10, 1e-15);
  EXPECT_NEAR(run.programmed(move_at(run, 4), 'X'), 1, 1e-15);
  expect_direction(run, move_at(run, 4), {0, 0, 1});

  EXPECT_EQ(ProgramRun(machine_table(wkp, ""), "G43.4 H1\nA5\nG02 X10 R10\n").alarm(), "PS5421@3");
  EXPECT_EQ(ProgramRun(machine_table(wkp, ""), "G43.4 H1\nG02 X10 R10 C5\n").alarm(), "ARC_WITH_TABLE_TURNED@2");
  EXPECT_EQ(ProgramRun(machine_table(wkp, ""), "G43.4 H1\nG18\nG02 X10 R10 C5\n").alarm(), "PS5421@3");
  EXPECT_EQ(ProgramRun(machine_b_c_mixed(wkp, ""), "G43.4 H1\nG02 X10 R10 B5\n").alarm(), "");
}

// Arcs: a quarter circle about the origin while C follows it; by hand.
TEST(FastToolCenterPointControlRules, Arc) {
  const ProgramRun run(machine_head("", "X=10\nB=90\n"), "G43.4 H1\nG03 X0 Y10 Z4 I-10 C90 F100\n", 2);
  ASSERT_EQ(run.alarm(), "");
  const double h = std::sqrt(0.5);
  const std::size_t half = sample_at(run, 2, 1, 2);
  expect_point(run, half, {10 * h, 10 * h, 2});
  expect_axes(run, half, "XYZC", {110 * h, 110 * h, 2, 45});
  EXPECT_FALSE(run.events[half].arc);
  ASSERT_TRUE(run.events[move_at(run, 2)].arc);
  EXPECT_EQ(run.events[move_at(run, 2)].arc->sweep, 90);
  const ProgramRun by_radius(machine_head("", "X=10\nB=90\n"), "G43.5 H1 P1\nG03 X0 Y10 R10 J1 F100\n", 2);
  ASSERT_EQ(by_radius.alarm(), "");
  expect_axes(by_radius, sample_at(by_radius, 2, 1, 2), "XYC", {110 * h, 110 * h, 45});
  // Leant toward the end tangent, -X: by hand.
  const ProgramRun leant(machine_head("", "X=10\nC=180\n"), "G43.5 H1 Q30\nG03 X0 Y10 R10 K1 F100\n");
  expect_direction(leant, 1, {-0.5, 0, std::sqrt(0.75)});
  // In a helix with its pitch, from an independent computation: d = (-5 pi, 0, 20), and (15 pi, 0, 20).
  const ProgramRun helix(kNoKinematics + "[position]\nX=10\n", "G43.5 H1 Q30\nG03 X0 Y10 Z20 R10 J1 F100\n");
  expect_direction(helix, 1, {-0.308833912419428, std::sqrt(0.75), 0.3932195500476916});
  const ProgramRun larger(kNoKinematics + "[position]\nX=10\n", "G43.5 H1 Q30\nG02 X0 Y10 Z20 R-10 J1 F100\n");
  expect_direction(larger, 1, {0.4602626292564982, std::sqrt(0.75), 0.1953415268443842});
}

// WKP = 1: point and axes belong together around the turns of the table; by hand.
TEST(FastToolCenterPointControlRules, PointsAroundTurnsOfTheTable) {
  const std::string wkp = "\"19696#5\"=1\n";
  const ProgramRun before(machine_b_c_mixed(wkp, ""), "G43.4 H1 P1\nX10\nB30 C90\n");
  ASSERT_EQ(before.alarm(), "");
  ASSERT_EQ(before.events.size(), 4U);
  EXPECT_EQ(before.events[2].cause, spec::Cause::pre_turn);
  expect_point(before, 2, {0, -10, 0});
  expect_axes(before, 2, "XYC", {0, -10, 90});
  EXPECT_EQ(before.programmed(2, 'X'), 10);
  expect_point(before, 3, {0, -10, 0});
  const ProgramRun behind(machine_b_c_mixed(wkp, ""), "G43.4 H1 P1 B30 C90\nX0 Y-10 Z0\nX10 Y0 B0 C0\nX20\n");
  ASSERT_EQ(behind.alarm(), "");
  ASSERT_EQ(behind.events.size(), 5U);
  expect_point(behind, 2, {0, -10, 0});
  expect_axes(behind, 2, "XYC", {0, -10, 90});
  EXPECT_EQ(behind.programmed(2, 'X'), 10);
  EXPECT_EQ(behind.events[3].cause, spec::Cause::post_turn);
  expect_point(behind, 3, {10, 0, 0});
  expect_axes(behind, 3, "XYC", {10, 0, 0});
  expect_point(behind, 4, {20, 0, 0});
}

// The angles are those of the machine: programmed position plus zero. By hand on the head HC.
TEST(FastToolCenterPointControlRules, ZerosOfRotaryAxes) {
  const std::string zeros = "[workpiece.G54]\nB=30\n[workpiece.G55]\nB=30\nC=100\n";
  const double root = std::sqrt(0.75);
  const ProgramRun run(machine_head("", "", zeros), "G43.4 H1\nG01 X10 B60 F100\nG49\nG55\nG92 B5\nX0\n", 2);
  ASSERT_EQ(run.alarm(), "");
  expect_axes(run, 0, "XZB", {50, 100 * root, 0});
  expect_direction(run, 0, {0.5, 0, root});
  expect_axes(run, 1, "XZB", {5 + 100 * root, 50, 30});
  expect_axes(run, 2, "XZB", {110, 0, 60});
  EXPECT_NEAR(run.machine(2, 'B'), 90, 1e-13);
  expect_axes(run, 3, "BC", {5, -100}, 0);
  expect_direction(run, 3, {1, 0, 0});
  const ProgramRun programmed("rotary_angles=\"programmed\"\n" + machine_head("", "", zeros),
                              "G43.4 H1\nG01 X10 B60 F100\nG49\nG92 B5\nX0\n");
  expect_axes(programmed, 0, "XZB", {0, 100, 0});
  expect_axes(programmed, 1, "XZB", {10 + 100 * root, 50, 60});
  expect_direction(programmed, 2, {std::sin(std::acos(-1.0) / 36), 0, std::cos(std::acos(-1.0) / 36)});
  // Type 2: nearness to 0 and ranges by the angles, positions by the zero.
  const ProgramRun near(machine_head("", "C=-55\n", "[workpiece.G54]\nC=100\n"), "G43.5 P0\nI-1 J1 K2\n");
  expect_axes(near, 1, "BC", {-35.264389682754654, -145}, 1e-12);
  const ProgramRun ranged(machine_head("19743=30\n", "", "[workpiece.G54]\nB=30\n"), "G43.5 P0\nI1 K2\n");
  ASSERT_EQ(ranged.alarm(), "");
  expect_axes(ranged, 1, "BC", {26.565051177077990 - 30, 0}, 1e-12);
  // What inverse kinematics has turned, and is called otherwise since.
  const ProgramRun named(machine_head("", ""), "G43.5 P0\nI1 J2\nG49\nG92 B0 C0\nG43.5 P0\nI-2 J1\n");
  ASSERT_EQ(named.alarm(), "");
  expect_axes(named, 3, "BC", {0, 90}, 1e-12);
}

// A block of G43.5 without I J K, and those that follow, leave axes outside their ranges where they are.
TEST(FastToolCenterPointControlRules, WithoutDirectionTheAxesStandOutsideTheirRanges) {
  const ProgramRun run(machine_head("19743=10\n19744=-10\n", "B=30\n"), "G43.5 H1 P1\nX10\nI1 K2\n");
  EXPECT_EQ(run.alarm(), "PS5459@3");
  expect_axes(run, 0, "BC", {30, 0}, 0);
  expect_axes(run, 1, "BC", {30, 0}, 0);
}

// Without kinematics: I J K, on the great circle; by hand.
TEST(FastToolCenterPointControlRules, WithoutKinematics) {
  const ProgramRun run(kNoKinematics, "G43.5 H1\nG01 X10 I1 K1 F100\nX20 I-1 K-1\n", 2);
  ASSERT_EQ(run.alarm(), "");
  ASSERT_EQ(run.events.size(), 5U);
  const double s = std::sin(std::acos(-1.0) / 8);
  expect_direction(run, 1, {s, 0, std::sqrt(1 - s * s)});
  expect_axes(run, 1, "XZ", {5 + 100 * s, 100 * std::sqrt(1 - s * s)});
  EXPECT_EQ(run.events[1].machine.present, 0);
  expect_direction(run, 3, {std::sqrt(0.5), 0, std::sqrt(0.5)});
}

// The tool holder offset counts without kinematics too.
TEST(FastToolCenterPointControlRules, HolderOffset) {
  const ProgramRun run(kNoKinematics + "[parameters]\n19666=30.5\n", "G43.5 H1\nG49 X5\n");
  expect_axes(run, 0, "Z", {130.5}, 0);
  expect_axes(run, 1, "Z", {130.5}, 0);
}

// Q leans the kept vector by the travel of each block; without travel and I J K the axes stand.
TEST(FastToolCenterPointControlRules, Lean) {
  const ProgramRun run(machine_head("", "C=30\n"),
                       "G43.5 H1 Q30\nG01 X10 K1 F100\nY10\nH2\nZ10\nK1\nG49\nG43.5 H1\nX0\n");
  ASSERT_EQ(run.alarm(), "");
  expect_direction(run, 1, {0.5, 0, std::sqrt(0.75)});
  expect_direction(run, 2, {0, 0.5, std::sqrt(0.75)});
  expect_direction(run, 3, {0, 0.5, std::sqrt(0.75)});
  expect_direction(run, 4, {0, 0, 1});
  expect_direction(run, 5, {0, 0, 1});
  expect_direction(run, 7, {0, 0, 1});

  const ProgramRun bare(kNoKinematics, "G43.5 H1 Q30 K1\nG01 X10 F100\nY10\nH1\nI0 J0 K1\nG49\nG43.5 H1\nX0 K1\n");
  ASSERT_EQ(bare.alarm(), "");
  expect_direction(bare, 0, {0, 0, 1});
  expect_direction(bare, 1, {0.5, 0, std::sqrt(0.75)});
  expect_direction(bare, 2, {0, 0.5, std::sqrt(0.75)});
  expect_direction(bare, 3, {0, 0, 1});
  expect_direction(bare, 5, {0, 0, 1});
  // With G10 and G04 P and Q are data of that code.
  EXPECT_EQ(ProgramRun(machine_head("", ""), "G43.5 H1 G04 P500\nX5\n").alarm(), "");
}

// Tool side compensation, type 1: corner moves run at the standing tool of the corner; axes follow the point.
TEST(FastToolCenterPointControlRules, CornerMovesAtAStandingTool) {
  const ProgramRun run(machine_head("", "X=-40\n"),
                       "G43.4 H1 P1\nG42.2 D1 G01 X0 F100\nX100 B30\nX20 Y50 B60 C20\nX0 B0\n", 2);
  ASSERT_EQ(run.alarm(), "");
  bool corner = false;
  for (std::size_t i = 0; i < run.events.size(); ++i) {
    if (run.events[i].cause != spec::Cause::corner) continue;
    corner = true;
    // The tool of the corner at X100: B30.
    expect_axes(run, i, "BC", {30, 0}, 0);
    expect_axes(run, i, "XYZ", {run.point(i, 'X') + 50, run.point(i, 'Y'), run.point(i, 'Z') + 100 * std::sqrt(0.75)});
    EXPECT_EQ(run.machine(i, 'X'), run.axis(i, 'X'));
  }
  EXPECT_TRUE(corner);
}

// A singular end, type 1: C is commanded elsewhere and turns behind the block. Orthogonal axes keep C in it.
TEST(FastToolCenterPointControlRules, TurnBehindASingularEnd) {
  const ProgramRun run(machine_head("", "B=30\n"), "G43.4 H1 P1\nG01 X10 B0 C50 F100\nX20 B20\n", 2);
  ASSERT_EQ(run.alarm(), "");
  ASSERT_EQ(run.events.size(), 6U);
  expect_axes(run, 1, "BC", {15, 0}, 1e-13);
  expect_axes(run, 2, "BC", {0, 0}, 1e-13);
  EXPECT_EQ(run.events[3].cause, spec::Cause::post_turn);
  expect_axes(run, 3, "XZBC", {10, 100, 0, 50}, 0);
  EXPECT_EQ(run.events[3].line, 2U);
  expect_axes(run, 5, "BC", {20, 50}, 0);
}

// R of a dwell is no radius, so the table that has turned bars nothing; X without a centre is an arc that cannot be.
TEST(FastToolCenterPointControlRules, ADwellIsNoArc) {
  const ProgramRun run(machine_b_c_mixed("\"19696#5\"=1\n", ""), "G43.4\nC1\nR0 G04 G02\nX0\n");
  EXPECT_EQ(run.alarm(), "PS0023@4");
}

}  // namespace
}  // namespace toolcomp::fast
