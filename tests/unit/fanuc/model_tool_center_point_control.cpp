// SPDX-License-Identifier: Apache-2.0
// Tool center point control: its rules, alarms and events. Expected values are derived in the comments; the worked
// examples stand in golden/fanuc.
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;
using test::Lines;
using test::run;
using test::Show;

// Axes X1 Y2 Z3 A4 B5 C6; H1 = 50, H2 = 10.
std::string setup(const std::string& parameters, const std::string& more = "") {
  return "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"A\", \"B\", \"C\"]\n[parameters]\n" + parameters +
         "[offsets.H]\n1 = 50\n2 = 10\n[offsets.D]\n1 = 10\n2 = 5\n" + more;
}
const std::string kNone;
// C carries B.
const std::string kHead = "19680 = 2\n19681 = 6\n19682 = 3\n19686 = 5\n19687 = 2\n";
// A carries C.
const std::string kTable = "19680 = 12\n19681 = 4\n19682 = 1\n19684 = 1\n19686 = 6\n19687 = 3\n19689 = 1\n";
// B turns the tool, C the table.
const std::string kMixed = "19680 = 21\n19681 = 5\n19682 = 2\n19686 = 6\n19687 = 3\n19689 = 1\n";
const std::string kWorkpiece = "\"19696#5\" = 1\n";

std::string last(const std::string& parameters, const std::string& program, Show show = Show::axes, int digits = 9) {
  return test::lines(run(setup(parameters), program), show, digits).back();
}
Lines lines(const std::string& parameters, const std::string& program, std::uint32_t samples = 0,
            Show show = Show::axes, int digits = 9) {
  return test::lines(run(setup(parameters), program, nullptr, samples), show, digits);
}
std::string tool(const model::Event& event, int digits = 9) {
  if (!event.tool_axis) return "none";
  std::string text;
  for (const exact::Real& component : *event.tool_axis) text += (text.empty() ? "" : " ") + component.decimal(digits);
  return text;
}
std::string last_tool(const std::string& parameters, const std::string& program) {
  return tool(run(setup(parameters), program).events().back());
}

// B30: the tool leans by (1/2, 0, sqrt(3)/2), with L = 50 (25, 0, 43.301270189).
TEST(ModelToolCenterPoint, TypeOneOnAHead) {
  EXPECT_EQ(lines(kHead, "G43.4 H1\nG01 X10 B30 F1\nY5\nC90\n"),
            (Lines{"1 rapid X0 Y0 Z50 A0 B0 C0", "2 linear X35 Y0 Z43.301270189 A0 B30 C0",
                   "3 linear X35 Y5 Z43.301270189 A0 B30 C0", "4 linear X10 Y30 Z43.301270189 A0 B30 C90"}));
  // Rotary words in the block of the code, incremental words.
  EXPECT_EQ(last(kHead, "G43.4 H1 B20\nG91 G01 B10 X10 F1\n"), "2 linear X35 Y0 Z43.301270189 A0 B30 C0");
  // G00 runs to the same positions.
  EXPECT_EQ(last(kHead, "G43.4 H1\nX10 B30\n"), "2 rapid X35 Y0 Z43.301270189 A0 B30 C0");
}

TEST(ModelToolCenterPoint, TypeTwoOnAHead) {
  // (1, 0, 1): from C0 the pairs are (0, 45) and (180, -45).
  EXPECT_EQ(lines(kHead, "G43.5 H1\nI1 K1\nX10\nK1\n", 0, Show::axes, 6),
            (Lines{"1 rapid X0 Y0 Z50 A0 B0 C0", "2 rapid X35.355339 Y0 Z35.355339 A0 B45 C0",
                   "3 rapid X45.355339 Y0 Z35.355339 A0 B45 C0", "4 rapid X10 Y0 Z50 A0 B0 C0"}));
  // I J K in the block of the code.
  EXPECT_EQ(last(kHead, "G43.5 H1 I1\n"), "1 rapid X50 Y0 Z0 A0 B90 C0");
  EXPECT_EQ(last(kHead, "G43.5 H1 I1 P1\n"), "1 rapid X50 Y0 Z0 A0 B90 C0");
}

// The table turns by C90 under a standing tool: the point (10, 0) of the table goes to (0, -10) with a left-handed
// table, whose axis is at A.
TEST(ModelToolCenterPoint, TableAndItsPosition) {
  const std::string moved = kTable + "19700 = 100\n";
  EXPECT_EQ(last(kTable, "G43.4 H1\nX10\nC90\n"), "3 rapid X0 Y-10 Z50 A0 B0 C90");
  EXPECT_EQ(last(moved, "G43.4 H1\nX10\nC90\n"), "3 rapid X100 Y90 Z50 A0 B0 C90");
  // The programmed point stays; so does the tool in the table system.
  EXPECT_EQ(last(kTable, "G43.4 H1\nX10\nC90\n", Show::point), "3 rapid X10 Y0 Z0");
  EXPECT_EQ(last_tool(kTable, "G43.4 H1\nX10\nC90\n"), "0 0 1");
  // The frame stands as the workpiece system at the end of the block of the code.
  EXPECT_EQ(last(kTable, "C30\nG43.4 H1\nX10\nC120\n"), "4 rapid X0 Y-10 Z50 A0 B0 C120");
  EXPECT_EQ(last(kTable, "C30\nG43.4 H1 C90\nX10\nC180\n"), "4 rapid X0 Y-10 Z50 A0 B0 C180");
}

// A90 of a table: the tool lies along +-Y of the table.
TEST(ModelToolCenterPoint, ToolSeenFromTheTable) {
  EXPECT_EQ(last_tool(kTable, "G43.4\nA90\n"), "0 -1 0");
  EXPECT_EQ(last_tool(kTable, "A90\nG43.4\n"), "0 0 1");
  EXPECT_EQ(last_tool(kTable + kWorkpiece, "G43.4\nA90\n"), "0 0 1");
  EXPECT_EQ(last_tool(kMixed, "G43.4\nB90 C90\n"), "0 1 0");
  EXPECT_EQ(last_tool(kMixed + kWorkpiece, "G43.4\nB90 C90\n"), "1 0 0");
}

TEST(ModelToolCenterPoint, HolderOffsetAndH) {
  EXPECT_EQ(lines(kHead + "19666 = 3\n", "G43.4 H1\nH2\nH2\nH0\n"),
            (Lines{"1 rapid X0 Y0 Z53 A0 B0 C0", "2 rapid X0 Y0 Z13 A0 B0 C0", "4 rapid X0 Y0 Z3 A0 B0 C0"}));
  // EVO: an edited value in the next block.
  EXPECT_EQ(last(kHead + "\"5001#6\" = 1\n", "G43.4 H1\nG10 L11 P1 R60\nY1\n"), "3 rapid X0 Y1 Z60 A0 B0 C0");
}

// The length goes evenly from 50 to 10.
TEST(ModelToolCenterPoint, LengthInsideABlock) {
  EXPECT_EQ(lines(kHead, "G43.4 H1\nG01 X8 H2 F1\n", 4),
            (Lines{"1 rapid X0 Y0 Z50 A0 B0 C0", "2 1/4 X2 Y0 Z40 A0 B0 C0", "2 1/2 X4 Y0 Z30 A0 B0 C0",
                   "2 3/4 X6 Y0 Z20 A0 B0 C0", "2 linear X8 Y0 Z10 A0 B0 C0"}));
}

TEST(ModelToolCenterPoint, Samples) {
  // Not in the block of the code; in every own move behind it, a lone H included; other axes evenly.
  EXPECT_EQ(lines(kHead, "G43.4\nX2 A90\nH1\nG04 P1\nG49\nX4\n", 2),
            (Lines{"1 rapid X0 Y0 Z0 A0 B0 C0", "2 1/2 X1 Y0 Z0 A45 B0 C0", "2 rapid X2 Y0 Z0 A90 B0 C0",
                   "3 1/2 X2 Y0 Z25 A90 B0 C0", "3 rapid X2 Y0 Z50 A90 B0 C0", "6 rapid X4 Y0 Z50 A90 B0 C0"}));
  // No machine coordinates.
  const auto done = run(setup(kHead), "G43.4\nX2\n", nullptr, 2);
  EXPECT_TRUE(done.events()[1].machine.empty());
  EXPECT_FALSE(done.events()[2].machine.empty());
  EXPECT_EQ(tool(done.events()[1]), "0 0 1");
  // One sample a block is none.
  EXPECT_EQ(lines(kHead, "G43.4\nX2\n", 1).size(), 2U);
}

// Relative to the table the tip runs straight: from (10, 0) to (0, 0) while C turns by 90; at t = 1/2 it is at (5, 0),
// turned by -45.
TEST(ModelToolCenterPoint, TipPathOnATable) {
  EXPECT_EQ(lines(kTable, "G43.4\nX10\nX0 C90\n", 2)[3], "3 1/2 X3.535533906 Y-3.535533906 Z0 A0 B0 C45");
  EXPECT_EQ(lines(kTable, "G43.4\nX10\nX0 C90\n", 2, Show::point)[3], "3 1/2 X5 Y0 Z0");
}

TEST(ModelToolCenterPoint, Arcs) {
  // A quarter of a circle about the origin, with B going to 90: at t = 1/2 the tip is at 45 degrees.
  EXPECT_EQ(lines(kHead, "G43.4\nX10\nG17 G03 X0 Y10 R10 B90 F1\n", 2)[3],
            "3 1/2 X7.071067812 Y7.071067812 Z0 A0 B45 C0");
  EXPECT_EQ(lines(kHead, "G43.4\nX10\nG17 G02 X0 Y10 Z8 I-10 J0 F1\n", 2)[3],
            "3 1/2 X-7.071067812 Y-7.071067812 Z4 A0 B0 C0");
  // A spiral: the radius goes evenly from 10 to 20.
  EXPECT_EQ(lines(kHead, "G43.4\nX10\nG17 G03 X0 Y20 I-10 J0 F1\n", 2)[3],
            "3 1/2 X10.606601718 Y10.606601718 Z0 A0 B0 C0");
  EXPECT_EQ(last(kHead, "G43.5\nX10\nG17 G03 X0 Y10 R10 K1 F1\n"), "3 arc X0 Y10 Z0 A0 B0 C0");
  EXPECT_EQ(last(kHead, "G43.5\nX10\nG17 G03 X0 Y10 I-10 K1 F1\n"), "3 PS5421");
  EXPECT_EQ(last(kHead, "G43.5\nG03 K1\n"), "2 PS5421");
  EXPECT_EQ(last(kHead, "G43.4\nG03 B5.\n"), "2 PS5421");
  EXPECT_EQ(last(kHead, "G43.5\nX10\nG03 X10 R10\n"), "3 linear X10 Y0 Z0 A0 B0 C0");  // an arc of 0 degrees
  // A full circle of type 1.
  EXPECT_EQ(last(kHead, "G43.4\nX10\nG17 G03 I-10 B90 H1 F1\n"), "3 arc X60 Y0 Z0 A0 B90 C0");
}

// Q leans toward the travel, +X: from +Z to (1/2, 0, sqrt(3)/2).
TEST(ModelToolCenterPoint, Lean) {
  EXPECT_EQ(last_tool(kNone, "G43.5 Q30\nX10\n"), "0.5 0 0.866025404");
  EXPECT_EQ(last_tool(kNone, "G43.5 Q-30\nX10\n"), "-0.5 0 0.866025404");
  EXPECT_EQ(last_tool(kNone, "G43.5 Q30\nX10\nY10\n"), "0 0.5 0.866025404");
  EXPECT_EQ(last_tool(kNone, "G43.5 Q30\nZ10\n"), "0 0 1");
  EXPECT_EQ(last_tool(kNone, "G43.5 Q30\nX10\nI1\n"), "1 0 0");
  EXPECT_EQ(last_tool(kNone, "G43.5 Q30 I1\n"), "1 0 0");
  // In an arc along the tangent at its end: counter-clockwise to (0, 10) that is -X.
  EXPECT_EQ(last_tool(kNone, "G43.5 Q30\nG01 X10 F1\nG17 G03 X0 Y10 R10\n"), "-0.5 0 0.866025404");
  // A helix in space, from an independent computation: a quarter of a circle of 10 that climbs by 20, d = (-5 pi, 0,
  // 20); three quarters of it the other way, d = (15 pi, 0, 20). The tool on the axis does not see the pitch.
  EXPECT_EQ(last_tool(kNone, "G43.5 Q30 J1\nG01 X10 F1\nG17 G03 X0 Y10 Z20 R10 J1\n"),
            "-0.308833912 0.866025404 0.39321955");
  EXPECT_EQ(last_tool(kNone, "G43.5 Q30 J1\nG01 X10 F1\nG17 G02 X0 Y10 Z20 R-10 J1\n"),
            "0.460262629 0.866025404 0.195341527");
  EXPECT_EQ(last_tool(kNone, "G43.5 Q30\nG01 X10 F1\nG17 G03 X0 Y10 Z20 R10\n"), "-0.5 0 0.866025404");
  // On a head; Q0 and no Q do not lean; Q elsewhere nobody reads.
  EXPECT_EQ(last(kHead, "G43.5 Q30\nX10\n"), "2 rapid X10 Y0 Z0 A0 B30 C0");
  EXPECT_EQ(last(kHead, "G43.5\nX10 Q30\n"), "2 rapid X10 Y0 Z0 A0 B0 C0");
  EXPECT_EQ(last(kHead, "G43.5 Q30\nG49\nG43.5\nX10\n"), "4 rapid X10 Y0 Z0 A0 B0 C0");
  // Words beside G04 or G10 are theirs.
  EXPECT_EQ(last(kHead, "G43.5 G04 P500 Q30\nX10\n"), "2 rapid X10 Y0 Z0 A0 B0 C0");
}

TEST(ModelToolCenterPoint, End) {
  // The programmed position becomes that of the axes; the next words go from there.
  EXPECT_EQ(last(kHead, "G43.4 H1 B90\nX10\nG49\nG91 Y1\n"), "4 rapid X60 Y1 Z0 A0 B90 C0");
  EXPECT_EQ(last(kHead + "19709 = 7\n", "G43.4 H1 B90\nX10\nG49\nG91 Y1\n"), "4 rapid X60 Y1 Z-7 A0 B90 C0");
  EXPECT_EQ(last(kTable, "G43.4 H1\nX10\nC90\nG49\nG91 Z1\n"), "5 rapid X0 Y-10 Z51 A0 B0 C90");
  EXPECT_EQ(lines(kHead, "G43.4\nG49\n").size(), 1U);
  // The rotary positions of type 2 stay, exactly: 90 degrees of C more is 135.
  EXPECT_EQ(last(kHead, "G43.5\nI1 J1\nG49\nG91 C90\n"), "4 rapid X0 Y0 Z0 A0 B90 C135");
  EXPECT_EQ(last(kHead, "G43.5\nI1 J2\nG49\nG91 C90\nG90 C0\n"), "5 rapid X0 Y0 Z0 A0 B90 C0");
}

// The tip stays: C90 has taken the table point (10, 0) to (0, -10), which is where the new system has it.
TEST(ModelToolCenterPoint, Again) {
  EXPECT_EQ(lines(kTable, "G43.4 H1\nX10\nC90\nG43.4\nG91 Y1\n", 0, Show::point)[3], "4 rapid X0 Y-10 Z0");
  EXPECT_EQ(lines(kTable, "G43.4 H1\nX10\nC90\nG43.4\nG91 Y1\n"),
            (Lines{"1 rapid X0 Y0 Z50 A0 B0 C0", "2 rapid X10 Y0 Z50 A0 B0 C0", "3 rapid X0 Y-10 Z50 A0 B0 C90",
                   "4 rapid X0 Y-10 Z50 A0 B0 C90", "5 rapid X0 Y-9 Z50 A0 B0 C90"}));
  EXPECT_EQ(last(kHead, "G43.4 H1\nG43.5 H2\nX1 I1\n"), "3 rapid X11 Y0 Z0 A0 B90 C0");
}

TEST(ModelToolCenterPoint, WorkpieceSystem) {
  const std::string table = kTable + kWorkpiece;
  // The end is that after the turn; on the way the tip runs straight on the table, from (10, 0) there to (0, 10).
  EXPECT_EQ(lines(table, "G43.4 H1\nX10\nX10 Y0 C90\n", 2),
            (Lines{"1 rapid X0 Y0 Z50 A0 B0 C0", "2 1/2 X5 Y0 Z50 A0 B0 C0", "2 rapid X10 Y0 Z50 A0 B0 C0",
                   "3 1/2 X7.071067812 Y0 Z50 A0 B0 C45", "3 rapid X10 Y0 Z50 A0 B0 C90"}));
  // A rotary word alone takes the tip along; back again it is where it was.
  EXPECT_EQ(lines(table, "G43.4 H1\nX10\nC90\nC0\nC45\nC0\n", 0, Show::point),
            (Lines{"1 rapid X0 Y0 Z0", "2 rapid X10 Y0 Z0", "3 rapid X0 Y-10 Z0", "4 rapid X10 Y0 Z0",
                   "5 rapid X7.071067812 Y-7.071067812 Z0", "6 rapid X10 Y0 Z0"}));
  // On a head it makes no difference.
  EXPECT_EQ(last(kHead + kWorkpiece, "G43.4 H1\nX10\nB90\n"), "3 rapid X60 Y0 Z0 A0 B90 C0");
  EXPECT_EQ(last(kHead + kWorkpiece, "G43.5 H1\n"), "1 PS5459");
  EXPECT_EQ(last(table, "G43.4\nG41.2 D1 X10\nX20\n"), "2 COMPENSATION_IN_WORKPIECE_SYSTEM");
  EXPECT_EQ(last(table, "G43.4\nG41.3 D1\n"), "2 COMPENSATION_IN_WORKPIECE_SYSTEM");
  // Arcs: free while no table axis has moved.
  EXPECT_EQ(last(table, "G43.4\nX10\nG17 G03 X0 Y10 R10 F1\n"), "3 arc X0 Y10 Z0 A0 B0 C0");
  EXPECT_EQ(last(table, "G43.4\nX10\nG17 G03 X0 Y10 R10 C90 F1\n"), "3 ARC_WITH_TABLE_TURNED");
  EXPECT_EQ(last(table, "G43.4\nX10 C90\nG17 G03 X0 Y10 R10 F1\n"), "3 ARC_WITH_TABLE_TURNED");
  EXPECT_EQ(last(table, "G43.4\nX10\nG17 G03 X0 Y10 R10 A90 F1\n"), "3 PS5421");
  EXPECT_EQ(last(table, "G43.4\nX10 A5.\nG17 G03 X0 Y10 R10 F1\n"), "3 PS5421");
  EXPECT_EQ(last(kMixed + kWorkpiece, "G43.4\nX10\nG17 G03 X0 Y10 R10 B90 F1\n"), "3 arc X0 Y10 Z0 A0 B90 C0");
}

// Inserted moves are made at a standing tool, with the pose of the corner and machine coordinates.
TEST(ModelToolCenterPoint, CornerMoves) {
  // Right of +X, then back at an acute angle: the corner moves of tool side compensation at B0.
  const std::string program = "G43.4 H1\nG01 G42.2 D2 X0 F1\nX20\nX10 Y9 B90\nG40 X0 Y0\n";
  const auto done = run(setup(kHead + "\"19605#5\" = 1\n", "[position]\nX = -10\n"), program, nullptr, 2);
  std::size_t corners = 0;
  for (const model::Event& event : done.events()) {
    if (event.kind != spec::EventKind::move || event.cause != spec::Cause::corner) continue;
    ++corners;
    EXPECT_EQ(event.axes[4].decimal(9), "0");
    EXPECT_EQ(event.axes[2].decimal(9), "50");
    EXPECT_FALSE(event.machine.empty());
  }
  EXPECT_EQ(corners, 1U);
}

// Behind the corner moves that belong to its block, right before the block's own move.
TEST(ModelToolCenterPoint, WhereTheWarningStands) {
  const std::string program = "G43.4 H1 P1 B20\nG01 G42.2 D2 X0 F1\nX20\nX10 Y9 C200\nG40 X0 Y0\n";
  const auto done = run(setup(kHead + "\"19605#5\" = 1\n", "[position]\nX = -10\n"), program);
  std::string order;
  for (const model::Event& event : done.events()) {
    if (event.line != 4) continue;
    const bool corner = event.cause == spec::Cause::corner;
    order += event.kind == spec::EventKind::warning ? "warning " : corner ? "corner " : "own ";
  }
  EXPECT_EQ(order, "corner warning own ");
}

TEST(ModelToolCenterPoint, TurnsAtThePole) {
  EXPECT_EQ(lines(kHead, "G43.4 H1 P1\nG01 X10 B30 C90 F1\nX0 B0 C0\n", 2, Show::axes, 6),
            (Lines{"1 rapid X0 Y0 Z50 A0 B0 C0", "2 linear X0 Y0 Z50 A0 B0 C90 (pre-turn)",
                   "2 1/2 X5 Y12.940952 Z48.296291 A0 B15 C90", "2 linear X10 Y25 Z43.30127 A0 B30 C90",
                   "3 1/2 X5 Y12.940952 Z48.296291 A0 B15 C90", "3 linear X0 Y0 Z50 A0 B0 C90",
                   "3 linear X0 Y0 Z50 A0 B0 C0 (post-turn)"}));
  // With P0 the axes run evenly; 19604#0 decides where there is no P.
  EXPECT_EQ(lines(kHead, "G43.4 H1 P0\nG01 X10 B30 C90 F1\n").size(), 2U);
  EXPECT_EQ(lines(kHead, "G43.4 H1\nG01 X10 B30 C90 F1\n").size(), 2U);
  EXPECT_EQ(lines(kHead + "\"19604#0\" = 1\n", "G43.4 H1\nG01 X10 B30 C90 F1\n").size(), 3U);
  EXPECT_EQ(lines(kHead + "\"19604#0\" = 1\n", "G43.4 H1 P0\nG01 X10 B30 C90 F1\n").size(), 2U);
  // The warning stands before the move.
  EXPECT_EQ(lines(kHead, "G43.4 P1 B20\nB20 C200\n"),
            (Lines{"1 rapid X0 Y0 Z0 A0 B20 C0", "2 posture-branch", "2 rapid X0 Y0 Z0 A0 B20 C200"}));
}

// In the workpiece system the tip stands on the table while that turns before or behind a block, and the end of the
// block is the one behind its turn. Table point (10, 0), C90 takes it to (0, -10).
TEST(ModelToolCenterPoint, TurnsOfTheTableInTheWorkpieceSystem) {
  const std::string table = kMixed + kWorkpiece;
  EXPECT_EQ(lines(table, "G43.4 P1\nX10\nB30 C90\n"),
            (Lines{"1 rapid X0 Y0 Z0 A0 B0 C0", "2 rapid X10 Y0 Z0 A0 B0 C0", "3 rapid X0 Y-10 Z0 A0 B0 C90 (pre-turn)",
                   "3 rapid X0 Y-10 Z0 A0 B30 C90"}));
  EXPECT_EQ(
      lines(table, "G43.4 P1 B30 C90\nX0 Y-10 Z0\nX10 Y0 B0 C0\nX20\n", 2),
      (Lines{"1 rapid X0 Y0 Z0 A0 B30 C90", "2 1/2 X0 Y-5 Z0 A0 B30 C90", "2 rapid X0 Y-10 Z0 A0 B30 C90",
             "3 1/2 X0 Y-10 Z0 A0 B15 C90", "3 rapid X0 Y-10 Z0 A0 B0 C90", "3 rapid X10 Y0 Z0 A0 B0 C0 (post-turn)",
             "4 1/2 X15 Y0 Z0 A0 B0 C0", "4 rapid X20 Y0 Z0 A0 B0 C0"}));
}

// Found by fuzzing: exact zeros that follow from how a direction was made, and of which no proof is at hand.
TEST(ModelToolCenterPoint, ZerosThatAreKnown) {
  const auto ends_with_a_move = [](const std::string& machine, const std::string& program) {
    return run(setup(machine), program).events().back().kind == spec::EventKind::move;
  };
  // The changed end lies as far along u_w as the one commanded: at right angles to it, as the travel does.
  EXPECT_TRUE(ends_with_a_move(
      "19680 = 2\n19681 = 6\n19682 = 3\n19686 = 4\n19687 = 6\n19688 = 70.382\n19738 = 90\n19739 = 90\n",
      "G91 G01 F4300 A56.215 C-540.\nG43.5 H1 Q5. P1 I1231.567 J7468.19 K4869.228\nJ-90000. Y65.\nY-75.001\n"));
  // A changed end, then leaned toward u_w: the pole lies in the plane of the arc.
  EXPECT_TRUE(ends_with_a_move(
      "19680 = 12\n19681 = 5\n19682 = 2\n19684 = 1\n19686 = 4\n19687 = 1\n19689 = 1\n\"19608#5\" = 1\n19738 = 45\n"
      "19739 = 10\n",
      "G18 G01 F4800 X-40 Y40 Z-25 B360 A270\nG43.5 H1 P1 Q3.\nI-350.0422 J1844.4491 K8802.0156 X-70.0121 Y96.1797 "
      "Z-37.9659\nG02 Z-119.0909 R-41.093\nG01 I8994.5174 J-222.099 K-222.099 Z-119.0912\nX-50.0121 Y96.1797\n"));
  // A changed end of a helix leans across the travel of the next block, which is level: the foot of the pole is the
  // start.
  EXPECT_TRUE(ends_with_a_move(kHead + "19738 = 10\n19739 = 53.096\n19741 = 360\n19742 = -180\n",
                               "C-100 X19.9872\nG18 G01 F3300.\nG43.5 H1 P1 Q2 X-5.0128 I-1105.0902 J-1105.0902 "
                               "K8863.2698\nG02 Z33.5812 X25.3414 Y25 R43.1958 I1562.8336 K8863.2698\nG01 X25.3413 "
                               "Y25.0001\n"));
  // From a changed end to the direction commanded there: both stand as near to the pole.
  EXPECT_TRUE(ends_with_a_move(kTable + "19738 = 19.396\n19739 = 360\n",
                               "G01 F3900. G18 C-1710.\nG43.5 H1 P1 Q6.975\nX60\nX60\nY39.8453 I-244.8128 J1345.7826 "
                               "K8895.4447\nX31.7 Y75.86\nI-2. J3. K6\nI-2 J3 K6\n"));
  // A changed end, then leaned toward the end of an arc, which is along Z as u_w is: the pole lies in the plane again.
  EXPECT_TRUE(ends_with_a_move(
      "19680 = 2\n19681 = 6\n19682 = 3\n19686 = 5\n19687 = 5\n19688 = 45\n19738 = 26.965\n19739 = 120\n",
      "G18\nG43.5 P1 Q10.\nG01 X55. Y-15 F1\nG03 Z69.1775 X27.4675 R-45.8875 I-2705.5974 J-1079.9713 K8515.4803\n"
      "Z49.1775 X47.4675 R20\n"));
  // The same lean twice: the tool stands.
  EXPECT_TRUE(
      ends_with_a_move("19680 = 2\n19681 = 6\n19682 = 3\n19686 = 4\n19687 = 6\n19688 = 40.848\n\"19604#0\" = 1\n",
                       "A-160 C140\nG91\nG43.5 Q2.\nX-22.971 Y-30.412 Z-39.019\nX-22.971 Y-30.412 Z-39.019\n"));
  // The tool-side axis stands where both pairs lie alike on its two sides, and a helix makes the direction.
  EXPECT_TRUE(ends_with_a_move(
      "19680 = 12\n19681 = 5\n19682 = 2\n19686 = 6\n19687 = 3\n19689 = 1\n19698 = 20\n",
      "G18 B180 C270.\nG43.4 H2 P0 Z25.\nG01 B60 C135 X5.004 Y-12.2593 Z-12.9523 F1\nX101.1596 Y-247.8303 Z-1002.5258 "
      "B180.\nG43.5 H1 P1 Q2\nG03 Z-1012.113 Y-277.8303 R49.5659 I1. J-1. K2.\n"));
}

// Found by fuzzing. An incremental arc from where a machine of tables left its points, which is irrational: the words
// alone say how far it turns.
TEST(ModelToolCenterPoint, ArcsFromIrrationalPoints) {
  const auto sweep = [](const std::string& machine, const std::string& program) {
    const model::Event end = run(setup(machine), program).events().back();
    return end.arc && end.arc->sweep ? end.arc->sweep->decimal(9) : "none";
  };
  // The chord is twice the radius, 37.855.
  EXPECT_EQ(sweep("19680 = 12\n19681 = 4\n19682 = 1\n19686 = 6\n19687 = 3\n",
                  "G91 A75.\nG43.5\nI136.035 K23369.542\nG43.4\nZ-15.33 A20.886\nG43.5 Z-20\nJ-8693.332 K-2329.371\n"
                  "G43.5\nI-1745 J48267. K12933.000\nG43.4\nG02 Y75.71 R37.855\n"),
            "180");
  // 39.18584 and 29.38938 are 0.8 and 0.6 of twice the radius, 24.49115.
  EXPECT_EQ(sweep("19680 = 21\n19681 = 4\n19682 = 2\n19686 = 6\n19687 = 3\n",
                  "G91\nG43.5 Q3\nG02 Y28.72469 Z10. R-14.92026 J13.59115\nG01 G43.5\n"
                  "G03 X39.18584 Y-29.38938 R24.49115\n"),
            "180");
  // From (0.175, 62.731) to (62.731, -0.175) about the centre: a quarter clockwise, so three counter-clockwise.
  EXPECT_EQ(sweep("19680 = 12\n19681 = 5\n19682 = 5\n19683 = 45\n19684 = 1\n19686 = 6\n19687 = 3\n",
                  "B40.405\nG91\nG43.5\nJ-99.397 K8920.141\nG43.4\nG43.5\nY-0.002 I-1 J1\nG43.4\n"
                  "G03 X62.556 Y-62.906 I-0.175 J-62.731\n"),
            "270");
  // The chord is twice the way to the centre.
  EXPECT_EQ(sweep("19680 = 12\n19681 = 4\n19682 = 1\n19686 = 6\n19687 = 3\n",
                  "G18 G91\nA100\nG43.5\nJ-30781.81 K-84572.34\nG43.5 Q2\nZ14.46 I161.05 J5781.13 K6895.84\n"
                  "G43.5 Z-20\nG43.4\nG02 Z15.38 X-108.92 K7.69 I-54.46\n"),
            "180");
  // A quarter, from (37.989, 11.678) to (11.678, -37.989), that is refused: the table is turned out of its plane.
  EXPECT_EQ(last("19680 = 12\n19681 = 4\n19682 = 1\n19686 = 6\n19687 = 3\n" + kWorkpiece,
                 "G91\nG43.4\nX-9.988 Y-0.483 C-30.000\nC5.015\nY0.002 A-47.325\nA60. C295\nG43.4 A-65.381\n"
                 "A-7.402 C14.28 Z5\nA-17.173 C22.342\nG02 X-26.311 Y-49.667 I-37.989 J-11.678\n"),
            "10 PS5421");
}

// Found by fuzzing: the direction opposite to where the tool stands. B, whose singular positions are 60 and -120 for a
// tool that leans by -30 toward A, goes to 60 - (B + 180 - 60) as the shorter way, and A turns by 180.
TEST(ModelToolCenterPoint, TheOppositeDirection) {
  const auto done = run(setup("19680 = 12\n19681 = 5\n19682 = 2\n19686 = 4\n19687 = 1\n19699 = -30\n"),
                        "B180\nG43.5\nI-2699.589 J23.562 K-40.809\nG43.5\nJ-436.353 K270.456\nG43.5\n"
                        "I-4363.17 J297.782 K7866.007\nI4363.17 J-297.782 K-7866.007\n");
  const model::Event& end = done.events().back();
  const model::Event& before = done.events()[done.events().size() - 2];
  ASSERT_EQ(end.kind, spec::EventKind::move);
  constexpr std::size_t kA = 3;
  constexpr std::size_t kB = 4;
  EXPECT_EQ((end.axes[kA] - before.axes[kA]).decimal(9), "180");
  EXPECT_EQ((end.axes[kB] + before.axes[kB]).decimal(9), "300");
  // The words over their length.
  EXPECT_EQ(tool(end), "0.484796689 -0.03308689 -0.874000817");
}

// The same from a singular position of 1.012, an angle that is known by its cosine and sine.
TEST(ModelToolCenterPoint, MovesFromASingularPositionAreAlike) {
  const auto done =
      run(setup("19680 = 12\n19681 = 4\n19682 = 1\n19684 = 1\n19686 = 6\n19687 = 3\n19689 = 1\n19698 = -1.012\n"),
          "G43.5 H1 P1 Q-2\nG01 X-20. Y0.706 Z39.994 F1\nI0 K1\nG43.5 Q2.\nX-14.803 Y1.967 Z-15.006 K1\n");
  EXPECT_EQ(done.events().back().kind, spec::EventKind::move);
}

// Point and axes belong together: the point is where the tip is when the table has turned, the programmed end its name
// at the start of the block, or at its end.
TEST(ModelToolCenterPoint, PointsAroundTurnsOfTheTable) {
  const std::string table = kMixed + kWorkpiece;
  const std::string before = "G43.4 P1\nX10\nB30 C90\n";
  EXPECT_EQ(lines(table, before, 0, Show::point),
            (Lines{"1 rapid X0 Y0 Z0", "2 rapid X10 Y0 Z0", "3 rapid X0 Y-10 Z0 (pre-turn)", "3 rapid X0 Y-10 Z0"}));
  const auto turned = run(setup(table), before);
  EXPECT_EQ(turned.events()[2].programmed[0].decimal(9), "10");
  EXPECT_EQ(turned.events()[2].programmed[1].decimal(9), "0");
  const std::string behind = "G43.4 P1 B30 C90\nX0 Y-10 Z0\nX10 Y0 B0 C0\nX20\n";
  EXPECT_EQ(lines(table, behind, 0, Show::point), (Lines{"1 rapid X0 Y0 Z0", "2 rapid X0 Y-10 Z0", "3 rapid X0 Y-10 Z0",
                                                         "3 rapid X10 Y0 Z0 (post-turn)", "4 rapid X20 Y0 Z0"}));
  EXPECT_EQ(run(setup(table), behind).events()[2].programmed[0].decimal(9), "10");
}

// The angles are those of the machine: a zero of an axis and its words moved against each other change nothing there.
TEST(ModelToolCenterPoint, ZerosOfRotaryAxes) {
  const auto told = [](const std::string& machine, const std::string& zeros, const std::string& program) {
    Lines result;
    const auto done = run(setup(machine, zeros), program, nullptr, 2);
    for (const model::Event& event : done.events()) {
      std::string line = std::to_string(event.line) + (event.kind == spec::EventKind::alarm ? " alarm " : " ");
      for (std::size_t i = 0; i < 6; ++i)
        if (event.machine.has(i)) line += event.machine[i].decimal(12) + " ";
      for (std::size_t i = 0; i < 3; ++i)
        if (event.axes.has(i)) line += event.axes[i].decimal(12) + " ";
      result.push_back(line + tool(event, 12));
    }
    return result;
  };
  const std::string near = "19738 = 5\n19739 = 20\n";
  const std::string ranges = "19741 = 200\n19742 = -170\n19743 = 100\n19744 = -100\n";
  const auto zeros = [](int a, int b, int c) {
    return "[workpiece.G54]\nA = " + std::to_string(a) + "\nB = " + std::to_string(b) + "\nC = " + std::to_string(c) +
           "\n";
  };
  for (const std::string& machine : {kHead, kTable, kMixed, kTable + kWorkpiece, kMixed + kWorkpiece})
    for (const std::string code : {"G43.4 P0 H1\n", "G43.4 P1 H1\n"}) {
      const auto program = [&](int a, int b, int c) {
        const auto rotary = [](char axis, int at) { return std::string(1, axis) + std::to_string(at) + " "; };
        return "X5 " + rotary('A', 20 - a) + rotary('B', 10 - b) + rotary('C', -30 - c) + "\n" + code + "G01 X10 F1 " +
               rotary('A', 35 - a) + rotary('B', -5 - b) + "\nY7 " + rotary('C', 60 - c) + "\n" + rotary('A', -a) +
               rotary('B', -b) + "\nZ1 " + rotary('A', 8 - a) + rotary('B', 9 - b) + rotary('C', 100 - c) + "\n";
      };
      EXPECT_EQ(told(machine, zeros(0, 0, 0), program(0, 0, 0)),
                told(machine, zeros(7, -15, 200), program(7, -15, 200)))
          << machine << code;
    }
  const std::string directed = "G43.5 H1 P1\nG01 X10 I1 J2 K9 F1\nI-1 J-2 K8\nX0 I3 J1 K1\nI-3 J1 K2\nX5\nG49\nX9\n";
  for (const std::string& machine : {kHead, kTable, kMixed, kHead + near, kTable + ranges, kMixed + near + ranges})
    EXPECT_EQ(told(machine, "[position]\nA = 20\nB = 10\nC = -30\n", directed),
              told(machine, zeros(7, -15, 200) + "[position]\nA = 13\nB = 25\nC = -230\n", directed))
        << machine;
  // Where programmed angles turn the tool a zero says nothing of it.
  const std::string programmed = "rotary_angles = \"programmed\"\n";
  EXPECT_EQ(test::lines(run(programmed + setup(kHead, zeros(0, 30, 0)), "G43.4 H1\n")).back(),
            "1 rapid X0 Y0 Z50 A0 B0 C0");
  EXPECT_EQ(test::lines(run(setup(kHead, zeros(0, 30, 0)), "G43.4 H1\n")).back(),
            "1 rapid X25 Y0 Z43.301270189221932 A0 B0 C0");
  // What inverse kinematics has turned is called otherwise, exactly, and goes on from there: B 90 at the azimuth of
  // (1, 2).
  EXPECT_EQ(lines(kHead, "G43.5\nI1 J2\nG49\nG92 B0 C0\nX1\nG43.5\nX10\nG49\nG91 C5\n").back(),
            "9 rapid X10 Y0 Z0 A0 B0 C5");
  EXPECT_EQ(last_tool(kHead, "G43.5\nI1 J2\nG49\nG92 B0 C0\nX1\nG43.5\nX10\n"), "0.447213595 0.894427191 0");
  EXPECT_EQ(lines(kHead, "G43.5 P0\nI1 J2\nG49\nG92 B0 C0\nG43.5 P0\nI-2 J1\n").back(), "6 rapid X0 Y0 Z0 A0 B0 C90");
}

TEST(ModelToolCenterPoint, KeptDirection) {
  // Without I J K the axes stand, whatever the range says.
  EXPECT_EQ(last(kHead + "19743 = 10\n19744 = -10\n", "B30.\nG43.5\nX10\n"), "3 rapid X10 Y0 Z0 A0 B30 C0");
  EXPECT_EQ(last(kHead + "19743 = 10\n19744 = -10\n", "B30.\nG43.5\nI1 K2\n"), "3 PS5459");
  // A leaned direction is leaned anew from the one commanded.
  EXPECT_EQ(last_tool(kHead, "G43.5 Q30\nX10\nX20\n"), "0.5 0 0.866025404");
  // After a changed end the actual direction is kept: (C0, B-12).
  const std::string near = kHead + "19738 = 1\n19739 = 5\n";
  const std::string program = "B10.\nG43.5 P1\nI-2074.05228388532 J145.031864016257 K9781.47600733806\nX10\n";
  EXPECT_EQ(last(near, program), "4 rapid X10 Y0 Z0 A0 B-12 C0");
  EXPECT_EQ(last_tool(near, program), "-0.207911691 0 0.978147601");
}

TEST(ModelToolCenterPoint, AlarmsOfWords) {
  for (const std::string& machine : {kHead, kTable, kMixed}) {
    for (const char* block : {"G28 X0", "G29 X0", "G30 X0", "G30.1 X0", "G37 Z0", "G39", "G41", "G42", "G45 X1",
                              "G53 X0", "G92 X0", "G54", "G59"})
      EXPECT_EQ(last(machine, std::string("G43.4\n") + block + "\n"), "2 FORBIDDEN_UNDER_TOOL_DIRECTION") << block;
    EXPECT_EQ(last(machine, "G43.4\nG43 H1\n"), "2 LENGTH_OFFSET_EXCLUSION");
    EXPECT_EQ(last(machine, "G43 H1\nG43.4\n"), "2 LENGTH_OFFSET_EXCLUSION");
    EXPECT_EQ(last(machine, "G43.4 P2\n"), "1 PS5421");
    EXPECT_EQ(last(machine, "G43.4 P0.5\n"), "1 PS5421");
    EXPECT_EQ(last(machine, "G43.4\nP2\nX1\n").substr(0, 7), "3 rapid");
    EXPECT_EQ(last(machine, "G02 G43.4\n"), "1 TOOL_DIRECTION_FORMAT");
    EXPECT_EQ(last(machine, "G43.5\nC5.\n"), "2 PS5421");
    EXPECT_EQ(last(machine, "G43.5 C5.\n"), "1 PS5421");
    EXPECT_EQ(last(machine, "G43.5\nI0 J0 K0\n"), "2 PS5421");
    EXPECT_EQ(last(machine + "19741 = -1\n19742 = 1\n", "G43.5\n"), "1 PS5459");
    EXPECT_EQ(last(machine + "19741 = -1\n19742 = 1\n", "G43.4\n").substr(0, 7), "1 rapid");
  }
  EXPECT_EQ(last(kTable, "G43.5 K1\n"), "1 PS5421");
  EXPECT_EQ(last(kMixed, "G43.5 K1\n"), "1 PS5421");
  EXPECT_EQ(last(kHead, "G43.4\nG41.6 D1 X10\n"), "2 TOOL_SIDE_MODE");
  EXPECT_EQ(last(kHead, "G41 D1\nX10\nG43.4\n"), "3 FORBIDDEN_IN_CUTTER_COMPENSATION");
  // A hypothetical axis, and axes that do not tilt the tool.
  const std::string hypothetical =
      "19680 = 12\n19681 = 0\n19682 = 1\n19684 = 1\n19686 = 6\n19687 = 3\n19689 = 1\n"
      "\"19696#0\" = 1\n19685 = 30\n";
  EXPECT_EQ(last(hypothetical, "G43.5\n"), "1 PS5459");
  EXPECT_EQ(last(hypothetical, "G43.4 P1\nC90\n"), "2 rapid X0 Y0 Z0 A0 B0 C90");
  EXPECT_EQ(last("19680 = 2\n19681 = 6\n19682 = 3\n19686 = 5\n19687 = 3\n", "G43.5\n"), "1 PS5459");
}

// Under 19680 = 0 the direction goes along the great circle; between opposite ones it waits.
TEST(ModelToolCenterPoint, WithoutRotaryAxes) {
  const auto inside = run(setup(kNone), "G43.5 H1\nI1\nI-1\n", nullptr, 2);
  EXPECT_EQ(tool(inside.events()[1]), "0.707106781 0 0.707106781");
  EXPECT_EQ(tool(inside.events()[3]), "1 0 0");
  EXPECT_EQ(tool(inside.events()[4]), "-1 0 0");
  EXPECT_EQ(test::lines(inside, Show::axes, 6)[1], "2 1/2 X35.355339 Y0 Z35.355339 A0 B0 C0");
}

// The nutating head with B at 180 reaches (1, 0, 0) on the edge only: the whole arc lies on it, C alone turns.
TEST(ModelToolCenterPoint, AlongTheEdgeOfReach) {
  const std::string nutating = "19680 = 2\n19681 = 6\n19682 = 3\n19686 = 5\n19687 = 5\n19688 = 45\n";
  EXPECT_EQ(test::lines(run(setup(nutating, "[position]\nB = 180\n"), "G43.5 P1\nX10 I1\n", nullptr, 2)),
            (Lines{"1 rapid X0 Y0 Z0 A0 B180 C0", "2 1/2 X5 Y0 Z0 A0 B180 C-45", "2 rapid X10 Y0 Z0 A0 B180 C-90"}));
}

// A carries the inclined C of a table. Where the mode starts anew the tool is upright in the workpiece system, so a
// lean along Y is a turn of A alone, by Q; that C stands, and that the other pair has it just half a turn away, is
// beyond what can be proven of positions that come from directions, and need not be.
TEST(ModelToolCenterPoint, TheOtherPairNeedsNoTurns) {
  const auto done = run(setup("19680 = 12\n19681 = 4\n19682 = 1\n19686 = 6\n19687 = 6\n19688 = 50\n"),
                        "G43.5 Q5.24\nG01 F1 I-54133.7148 J70018.8878 K-16336.9609\n"
                        "X0 Z97.9896 I-246.2076 J32.9736 K865.0402\nG43.5 H0 X0. Z40.\n"
                        "X0 Z97.9896 I-246.2076 J32.9736 K865.0402\nG43.5 Q5.29\nY60.\n");
  ASSERT_EQ(done.events().size(), 7U);
  ASSERT_EQ(done.events()[6].kind, spec::EventKind::move);
  const auto turned = [&](std::size_t axis) {
    return (done.events()[6].axes[axis] - done.events()[5].axes[axis]).decimal(9);
  };
  EXPECT_EQ(turned(3), "5.29");
  EXPECT_EQ(turned(5), "0");
}

// Exact numbers do not chain: a thousand blocks leave no more nodes than a few.
TEST(ModelToolCenterPoint, NumbersDoNotChain) {
  for (const std::string code : {"G43.5 H1 P0\n", "G43.5 H1 P1\n"}) {
    for (const std::string& machine : {kHead, kTable, kMixed}) {
      const spec::Setup with = spec::read_setup_toml(setup(machine + "19738 = 5\n19739 = 20\n"), "setup.toml");
      std::string program = code + "G01 F1\n";
      for (int i = 0; i < 100; ++i) program += "X1 I1 J2 K9\nX2 I-2 J-3 K8\nX3 I-1 J1 K7\n";
      struct Count final : model::EventSink {
        void on(const model::Event& event) override {
          (event.line < 100 ? early : late) = std::max(event.line < 100 ? early : late, exact::live_nodes());
        }
        std::size_t early = 0;
        std::size_t late = 0;
      } sink;
      model::Recorder recorder;
      spec::ProgramReader reader(spec::text_source(program), with.axes);
      model::Engine engine(with, recorder, sink);
      spec::Block block;
      while (!engine.stopped() && reader.next(block)) engine.block(block);
      engine.end();
      EXPECT_LE(sink.late, sink.early + 16);
    }
  }
}

}  // namespace
