// SPDX-License-Identifier: Apache-2.0
// Tool side compensation: the manual's route by C1, C2 and M against the model's route without a basis, and rules
// derived in the comments. VT345 is (3/5, 0, 4/5), I3 J0 K4. The worked examples TS1 to TS11 stand in
// golden/fanuc/corpus_examples_tool_side.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "model/exact/vector.h"
#include "spec/language/input_error.h"
#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;
using exact::Real;
using exact::Vector3;
using test::Lines;
using test::run;
using test::Show;

// D1 = 10, D2 = 5, D3 = -10, D4 = 0, D5 beyond the range. Only X Y Z: the direction is I J K.
std::string setup(const std::string& parameters = "", const std::string& position = "") {
  return "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[parameters]\n" + parameters +
         "[offsets.H]\n1 = 50\n[offsets.D]\n1 = 10\n2 = 5\n3 = -10\n4 = 0\n5 = 1000\n[position]\n" + position;
}
// C carries B (or A).
std::string head(const std::string& parameters = "", const std::string& position = "", const std::string& tilt = "B") {
  return "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"" + tilt +
         "\", \"C\"]\n[parameters]\n19680 = 2\n19681 = 5\n19682 = 3\n19686 = 4\n19687 = " + (tilt == "B" ? "2" : "1") +
         "\n" + parameters + "[offsets.D]\n1 = 10\n2 = 5\n3 = -10\n4 = 0\n[position]\n" + position;
}
const std::string kTypeB = "\"5003#0\" = 1\n";
const std::string kTypeC = "\"5003#1\" = 1\n";
const std::string kTilted = "G43.5 I3 J0 K4\n";

Lines points(const std::string& with, const std::string& program) {
  return test::lines(run(with, program), Show::point);
}
// Without the first `skip` lines.
Lines behind(std::size_t skip, const std::string& with, const std::string& program) {
  Lines lines = points(with, program);
  lines.erase(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(std::min(skip, lines.size())));
  return lines;
}

TEST(ModelToolSide, NegativeValueExchangesTheCodes) {
  EXPECT_EQ(points(head("", "X = -40\n"), "G01 G42.2 D3 X0 F1\nX100\nY100\n")[1], "2 linear X90 Y10 Z0");
}

TEST(ModelToolSide, RotationAlone) {
  // The rotation runs at the last head of the corner and owns the move there: reversal with (10,10,0), (10,-10,0).
  EXPECT_EQ(behind(1, setup("", "X = -40\n"), "G43.5 K1\nG01 G41.6 D1 X0 F1\nX100\nG00 I3 K4\nG01 X0\n"),
            (Lines{"2 linear X0 Y10 Z0 (start-up)", "3 linear X110 Y10 Z0", "4 rapid X110 Y-10 Z0 (corner)",
                   "4 rapid X110 Y-10 Z0", "5 linear X0 Y-10 Z0"}));
  // A block without a move owns nothing.
  EXPECT_EQ(behind(1, setup("", "X = -40\n"), "G43.5 K1\nG01 G41.6 D1 X0 F1\nX100\nM08\nX0\n")[2],
            "5 linear X110 Y-10 Z0 (corner)");
}

TEST(ModelToolSide, StartUpOfTypeB) {
  // Without the perpendicular vector, the second reading.
  const std::string without = "type_b_without_perpendicular = true\n" + setup(kTypeB);
  EXPECT_EQ(
      behind(1, without, kTilted + "G01 G41.6 D1 Y100 F1\nX94 Y40 Z-8\n"),
      (Lines{"2 linear X-8 Y110 Z6 (start-up)", "3 linear X-1.6 Y114 Z1.2 (corner)", "3 linear X98.8 Y48 Z-11.6"}));
  // Under 1°, here 0°, one vector as of type A: back along Y the tool is on the other side.
  EXPECT_EQ(behind(1, setup(kTypeB), kTilted + "G01 G41.6 D1 Y100 F1\nY0\n")[0], "2 linear X8 Y100 Z-6 (start-up)");
}

TEST(ModelToolSide, TypeC) {
  EXPECT_EQ(behind(2, setup(kTypeC), kTilted + "G01 Y100 F1\nG00 G41.6 D1\nG01 X94 Y40 Z-8\n")[0],
            "3 rapid X4.8 Y108 Z-3.6 (start-up)");
  // A value of 0 has no vector to make: only a change of the length makes the move.
  EXPECT_EQ(points(head(kTypeC), "G41.2 D4\nG01 X10 F1\nG40\n"), (Lines{"2 linear X10 Y0 Z0"}));
}

// Acute, the corner of TS3: K1, K2 and the vector of TS7 (b).
TEST(ModelToolSide, CancelOfTypeB) {
  EXPECT_EQ(behind(2, setup(kTypeB, "Y = -40\n"), kTilted + "G01 G41.6 D1 Y0 F1\nY100\nG40 X94 Y40 Z-8\n"),
            (Lines{"3 linear X-8 Y110 Z6", "4 linear X-1.6 Y114 Z1.2 (corner)", "4 linear X4.8 Y108 Z-3.6 (corner)",
                   "4 linear X94 Y40 Z-8 (cancel)"}));
}

// By hand, clause fanuc.tool-side.stop-point: up Y, then right: the paths meet at (-10, 110), square to the cancel
// block stands (0, 110), which that block calls X-30.
TEST(ModelToolSide, CancelInAnotherWorkpieceSystem) {
  const std::string with = setup(kTypeB, "Y = -40\n") + "[workpiece.G59]\nX = 30\n";
  EXPECT_EQ(behind(1, with, "G01 G41.2 D1 Y0 F1\nY100\nG40 G59 X20\n"),
            (Lines{"2 linear X-10 Y110 Z0", "3 linear X-30 Y110 Z0 (corner)", "3 linear X20 Y100 Z0 (cancel)"}));
}

TEST(ModelToolSide, PlaneChangeFormat) {
  const auto change = [](const std::string& q, const std::string& parameters) {
    return behind(2, head(parameters, "Y = 40\nZ = 40\n", "A"),
                  "G00 A46.\nG01 G41.2 D1 X0 Y0 Z0 F1\nY-200 Z-200" + q + "\nA-45.\nY-400 Z0\n");
  };
  EXPECT_EQ(change(" Q4", ""), (Lines{"3 Q_FORMAT"}));
  EXPECT_THROW((void)change("", "6261 = 181\n"), spec::InputError);
}

TEST(ModelToolSide, SideChange) {
  const auto change = [](const std::string& next) {
    return behind(1, head("", "X = -40\n"), "G01 G41.2 D1 X0 F1\nX100\n" + next + "\n");
  };
  EXPECT_EQ(change("D3 Y100")[0], "2 linear X110 Y10 Z0");
  // In the block right behind a start-up.
  EXPECT_EQ(points(head(), "G01 G41.2 D1 X100 F1\nG42.2 X200\n"),
            (Lines{"1 linear X100 Y10 Z0 (start-up)", "2 DIR_CHANGE_AT_STARTUP"}));
  // Q1 counts before the change of side.
  EXPECT_EQ(behind(1, head("", "X = -40\n"), "G01 G41.2 D1 X0 F1\nX100 Q1\nG42.2 Y100\n")[0], "2 linear X100 Y10 Z0");
}

// Out of an arc the move from its perpendicular vector to the stop point belongs to the arc, as a line: the arc ends
// along +X at (100,0), the next line goes to -Y: r n1 = (0,10), Vi = (10,10).
TEST(ModelToolSide, OutOfAnArc) {
  EXPECT_EQ(points(head("", "X = 30\nY = -50\n"), "G01 G41.2 D1 X50 F1\nG02 X100 Y0 I50\nG01 Y-100\n"),
            (Lines{"1 linear X40 Y-50 Z0 (start-up)", "2 arc X100 Y10 Z0", "2 linear X110 Y10 Z0 (corner)",
                   "3 linear X110 Y-100 Z0"}));
}

// Under the tool tilted about Y an arc of G17 has radii foreshortened along X: a warning, once, before the first move
// that belongs to it.
TEST(ModelToolSide, ArcPlane) {
  const auto tilted = [](const std::string& tool) {
    return points(setup("", "X = -40\n"), "G43.5 " + tool + "\nG01 G41.6 D1 X0 F1\nX100\nG03 X90 Y70 R50\nG01 X0\n");
  };
  const Lines lines = tilted("I3 K4");
  ASSERT_GE(lines.size(), 5U);
  EXPECT_EQ(lines[3], "4 ARC_PLANE_MISMATCH");
  EXPECT_EQ(std::ranges::count(lines, "4 ARC_PLANE_MISMATCH"), 1);
  // Seen on edge it has no sense of rotation: undecided, and the block before ends with its perpendicular (0,0,-10),
  // left of +X as seen from +Y.
  EXPECT_EQ(tilted("J1"), (Lines{"1 rapid X-40 Y0 Z0", "2 linear X0 Y0 Z-10 (start-up)", "3 linear X100 Y0 Z-10",
                                 "4 fanuc.tool-side.arc-plane"}));
  // From below left of +X is -Y, and the arc, of tangent (3/5, 4/5), turns to the right: an outer corner, n1 = (0,-1),
  // n2 = (4/5,-3/5), Vi = 10 (n1 + n2)/(8/5).
  EXPECT_EQ(tilted("K-1")[2], "3 linear X105 Y-10 Z0");
}

// Under a tilted tool the heads at both ends of a whole circle are one, and those of a half circle lie opposite: the
// tool's own arc turns as far as the programmed one, on one radius, and both are proven. B30 C10, radius 20.
TEST(ModelToolSide, CirclesUnderATiltedTool) {
  for (const auto& [arc, sweep] : {std::pair("I12 J16", "360"), std::pair("X24 Y32 I12 J16", "180")}) {
    const auto done = run(head("\"5008#0\" = 1\n", "X = -40\nB = 30\nC = 10\n"),
                          "G01 G41.2 D1 X0 F1\nG03 " + std::string(arc) + "\n");
    ASSERT_EQ(done.events().size(), 3U) << arc;
    const model::Event& event = done.events()[2];
    ASSERT_EQ(event.type, spec::MoveType::arc) << arc;
    EXPECT_FALSE(event.arc->radius) << arc;
    EXPECT_EQ(event.arc->sweep->decimal(20), sweep) << arc;
  }
}

TEST(ModelToolSide, BlocksWithoutMovement) {
  const auto at_corner = [](const std::string& between, const std::string& parameters = "") {
    return behind(1, head(parameters, "X = -40\n"), "G01 G41.2 D1 X0 F1\nX100\n" + between + "G90 Y100\n");
  };
  // Inner corner (-10,10): one block is looked past.
  for (const char* block : {"M08\n", "F5\n", "C30.\n", "Z5\n", "G91 X0\n", "G91 Z-5\n"})
    EXPECT_EQ(at_corner(block)[0], "2 linear X90 Y10 Z0") << block;
  // Two of them, a stop, and the end: the perpendicular vector.
  for (const char* blocks : {"M08\nM09\n", "C30.\nC0\n", "X100\nX100\n", "M01\n", "M00\n", "M30\n"})
    EXPECT_EQ(at_corner(blocks)[0], "2 linear X100 Y10 Z0") << blocks;
  // No. 19630: strictly less counts as none.
  EXPECT_EQ(at_corner("X105\n", "19630 = 6\n")[0], "2 linear X90 Y10 Z0");
  EXPECT_EQ(at_corner("X105\n", "19630 = 5\n")[0], "2 linear X100 Y10 Z0");
  // Along a tilted tool: (30,0,40) moves nothing in the plane.
  EXPECT_EQ(behind(2, setup("", "Y = -40\n"), kTilted + "G01 G41.6 D1 Y0 F1\nY100\nX30 Z40\nX130\n"),
            (Lines{"3 linear X-8 Y110 Z6", "4 linear X22 Y110 Z46", "5 linear X130 Y110 Z40"}));
}

// B moves in the plane at its start, but its tool turns to lie along it: it ends with the vector at its start, and the
// next block starts from there, without a corner.
TEST(ModelToolSide, AlongTheToolAtItsEnd) {
  EXPECT_EQ(
      behind(1, setup("\"19605#5\" = 1\n", "X = -40\n"), "G43.5 K1\nG01 G41.6 D1 X0 F1\nX100\nY100 J1 K0\nX200\n"),
      (Lines{"2 linear X0 Y10 Z0 (start-up)", "3 linear X90 Y10 Z0", "4 linear X90 Y110 Z0",
             "5 linear X200 Y100 Z-10"}));
}

// Whether a block moves is asked at each corner by itself. Along the tool before, Z, which turns to (3/5, 0, 4/5): the
// corner before passes over it, (-10, 10, 0); at its own end n1 = -Y and Y's left (-4/5, 0, 3/5) make (-8, -10, 6).
TEST(ModelToolSide, MovesAtItsOwnEnd) {
  const auto mode = [](const std::string& rest, const std::string& parameters = "") {
    return behind(2, setup(parameters, "X = -40\n"), "G43.5 K1\nG01 G41.6 D1 X0 F1\n" + rest);
  };
  EXPECT_EQ(mode("X100\nZ50 I3 K4\nY100\nG40 Y150\n"),
            (Lines{"3 linear X90 Y10 Z0", "4 linear X92 Y-10 Z56", "5 linear X92 Y100 Z56",
                   "6 linear X100 Y150 Z50 (cancel)"}));
  // The tool alone before it: two blocks without movement at the end of X.
  EXPECT_EQ(mode("X100\nI3 K4\nZ50\nY100\n"),
            (Lines{"3 linear X100 Y10 Z0", "4 linear X100 Y10 Z0", "5 linear X92 Y-10 Z56", "6 linear X92 Y100 Z56"}));
  // Two of them, the second along the tool of the first: X sees that one go straight on, (0, 10, 0); the first passes
  // over it and meets Y as above; itself it keeps the vector.
  EXPECT_EQ(mode("X100\nZ50 I3 K4\nX130 Z90\nY100\n"), (Lines{"3 linear X100 Y10 Z0", "4 linear X92 Y-10 Z56",
                                                              "5 linear X122 Y-10 Z96", "6 linear X122 Y100 Z96"}));
  // It owns the corner move behind the stop point: reversal with (10, 10, 0), (10, -10, 0). Its own corner with X back,
  // VT (0, 3/5, 4/5): n1 = X, left of X back is (0, -4/5, 3/5), straight on across the tool, (10, -8, 6).
  EXPECT_EQ(mode("X100\nZ50 J3 K4\nX0\n", "\"19605#5\" = 1\n"),
            (Lines{"3 linear X110 Y10 Z0", "4 linear X110 Y-10 Z0 (corner)", "4 linear X110 Y-8 Z56",
                   "5 linear X0 Y-8 Z56"}));
  // Interference is asked of it, from (10, 10, 0) to (8, -10, -6), along (-12/25, 0, 9/25) of each unit of Z.
  EXPECT_EQ(mode("X100\nZ3 I3 K4\nY-100\n"), (Lines{"3 linear X110 Y10 Z0", "4 PS0041"}));
  // Q and the value count at its own end; a code repeated in it counts at the corner before it.
  EXPECT_EQ(mode("X100\nZ50 I3 K4 Q1\nY100\n")[1], "4 linear X100 Y-10 Z50");
  EXPECT_EQ(mode("X100\nZ50 I3 K4 D2\nY100\n")[1], "4 linear X96 Y-5 Z53");
  EXPECT_EQ(mode("X100\nG41.6 Z50 I3 K4\nY100\n"),
            (Lines{"3 linear X100 Y10 Z0", "4 linear X92 Y-10 Z56", "5 linear X92 Y100 Z56"}));
  EXPECT_EQ(mode("X100\nZ50 I3 K4\nG41.6 Y100\n"),
            (Lines{"3 linear X100 Y10 Z0", "4 linear X100 Y-10 Z50", "5 linear X92 Y100 Z56"}));
  // An arc always moves, so that both corners ask how they see it: the first on edge.
  EXPECT_EQ(behind(2, setup("", "X = -40\n"), "G19 G43.5 K1\nG01 G41.6 D1 X0 F1\nX100\nZ50 I1 K0\nG02 Y10 Z60 R10\n"),
            (Lines{"3 linear X100 Y10 Z0", "4 linear X100 Y-10 Z50", "5 fanuc.tool-side.arc-plane"}));
  // M00 ends both, and so does the end of the program.
  for (const char* end : {"M00\n", ""})
    EXPECT_EQ(mode(std::string("X100\nZ50 I3 K4\n") + end), (Lines{"3 linear X100 Y10 Z0", "4 linear X100 Y-10 Z50"}));
}

// No. 19630 in the plane of its own tool: Z is 3/5 as long across (3/5, 0, 4/5).
TEST(ModelToolSide, LimitAtItsOwnEnd) {
  const auto mode = [](const std::string& z) {
    return behind(2, setup("19630 = 6\n", "X = -40\n"), "G43.5 K1\nG01 G41.6 D1 X0 F1\nX100\n" + z + " I3 K4\nY100\n");
  };
  EXPECT_EQ(mode("Z10"), (Lines{"3 linear X90 Y10 Z0", "4 linear X92 Y-10 Z16", "5 linear X92 Y100 Z16"}));
  EXPECT_EQ(mode("Z9.999"), (Lines{"3 linear X90 Y10 Z0", "4 linear X90 Y10 Z9.999", "5 linear X92 Y100 Z15.999"}));
  // Long enough at the corner before it, not at its own end: it is the outgoing leg there, and keeps the vector.
  EXPECT_EQ(mode("X106 Z8.5"), (Lines{"3 linear X100 Y10 Z0", "4 linear X106 Y10 Z8.5", "5 linear X98 Y100 Z14.5"}));
}

// Start-up, cancel and change of side beside a block that moves at its own end only, or not there.
TEST(ModelToolSide, StartAndCancelByTheirOwnEnds) {
  const auto mode = [](const std::string& rest, const std::string& parameters = "") {
    return behind(2, setup(parameters, "X = -40\n"), "G43.5 K1\nG01 G41.6 D1 X0 F1\n" + rest);
  };
  // G40 along the tool before takes the vector away; along its own it keeps the last vector of the cancel's group.
  EXPECT_EQ(mode("X100\nG40 Z50 I3 K4\n"), (Lines{"3 linear X100 Y10 Z0", "4 linear X100 Y0 Z50 (cancel)"}));
  EXPECT_EQ(mode("X100\nG40 Y-30 Z40 J-3 K4\nX200\n", kTypeB),
            (Lines{"3 linear X110 Y10 Z0", "4 linear X110 Y0 Z0 (corner)", "4 linear X110 Y-30 Z40",
                   "5 linear X200 Y-30 Z40 (cancel)"}));
  // Behind a block that X passes over: r n1 of both, then the cancel.
  EXPECT_EQ(mode("X100\nZ50 I3 K4\nG40 Y100\n"),
            (Lines{"3 linear X100 Y10 Z0", "4 linear X100 Y-10 Z50", "5 linear X100 Y100 Z50 (cancel)"}));
  EXPECT_EQ(mode("G42.6 Z50 I3 K4\nY100\n"), (Lines{"3 DIR_CHANGE_AT_STARTUP"}));
  EXPECT_EQ(mode("Z50 I3 K4\nG42.6 Y100\n"), (Lines{"3 linear X0 Y-10 Z50", "4 DIR_CHANGE_AT_STARTUP"}));
  // The start-up block's corner passes over it.
  EXPECT_EQ(behind(1, setup("", "X = -40\n"), "G43.5 K1\nG01 G41.6 D1 X0 F1\nZ50 I3 K4\nY100\n"),
            (Lines{"2 linear X-10 Y0 Z0 (start-up)", "3 linear X-8 Y-10 Z56", "4 linear X-8 Y100 Z56"}));
  // Type C: the block right behind must move in the plane there, whatever it does at its own end.
  EXPECT_EQ(behind(1, setup(kTypeC), "G43.5 K1\nG01 G41.6 D1 F1\nZ50 I3 K4\n"), (Lines{"2 TYPE_C_FORMAT"}));
}

// A line along the last radius of an arc is square to its tangent under any tool, here B17 C30: no matter of proof. The
// heads n1 and n1 + n2, times 10, by a computation of 50 digits.
TEST(ModelToolSide, LineAlongARadius) {
  EXPECT_EQ(behind(4, head("\"5008#0\" = 1\n", "Y = -40\nB = 17\nC = 30\n"),
                   "G01 G41.2 D1 Y0 F1\nY50\nG02 X10 Y60 I10 J0\nG01 Y20\n"),
            (Lines{"3 arc X9.625835895684062 Y69.892571438050777 Z-1.413163672793577",
                   "3 linear X19.292733546629557 Y69.892571438050777 Z-3.972673353600525 (corner)",
                   "4 linear X19.666897650945494 Y20 Z-2.559509680806948"}));
}

// P1 of A wherever the vector at its end is given: repeated code, two non-moving blocks.
TEST(ModelToolSide, Repeated) {
  EXPECT_EQ(behind(1, head("", "X = -40\n"), "G01 G41.2 D1 X0 F1\nX100\nG41.2 Y100\n")[0], "2 linear X100 Y10 Z0");
  EXPECT_EQ(behind(1, head("", "X = -40\n"), "G01 G41.2 D1 X0 F1\nX100\nG41.2\nY100\n")[0], "2 linear X100 Y10 Z0");
}

TEST(ModelToolSide, ValueChanged) {
  // The value at the end of a block is that in force in it: r = 10 at the corner, then 5.
  EXPECT_EQ(behind(1, head("", "X = -40\n"), "G01 G41.2 D1 X0 F1\nX100\nD2 Y100\nX200\n"),
            (Lines{"2 linear X90 Y10 Z0", "3 linear X95 Y105 Z0", "4 linear X200 Y105 Z0"}));
  EXPECT_EQ(behind(1, head("", "X = -40\n"), "G01 G41.2 D1 X0 F1\nX100\nD4 Y100\nX200\n")[1], "3 linear X100 Y100 Z0");
  EXPECT_EQ(points(head(), "G01 G41.2 D1 X100 F1\nX200\nD0 X300\n"),
            (Lines{"1 linear X100 Y10 Z0 (start-up)", "2 linear X200 Y10 Z0", "3 linear X300 Y0 Z0 (cancel)"}));
}

TEST(ModelToolSide, StartAndCancelWithoutMovement) {
  // The start waits for the next block that moves, the vector for its removal.
  EXPECT_EQ(points(head(), "G01 G41.2 D1 F1\nZ5\nX100\nX200\nG40\nZ0\nX300\nX400\n"),
            (Lines{"2 linear X0 Y0 Z5", "3 linear X100 Y10 Z5 (start-up)", "4 linear X200 Y10 Z5",
                   "6 linear X200 Y10 Z0", "7 linear X300 Y0 Z0 (cancel)", "8 linear X400 Y0 Z0"}));
  EXPECT_EQ(points(head(), "G01 G41.2 D1 X100 F1\nG40 Y100\n"),
            (Lines{"1 linear X100 Y10 Z0 (start-up)", "2 linear X100 Y100 Z0 (cancel)"}));
  EXPECT_EQ(points(head(), "G01 G41.2 D1 X100 F1\nX200\nG40\nG41.2 X300\n").back(),
            "4 fanuc.cutter-c.restart-before-removal");
}

TEST(ModelToolSide, Interference) {
  // A step of 5 into the corner: the tool of radius 10 would run back; r n... PS0041 at the short block.
  EXPECT_EQ(behind(1, head("", "X = -40\n"), "G01 G41.2 D1 X0 F1\nX100\nY5\nX200\nX300\n").back(),
            "5 linear X300 Y15 Z0");
  EXPECT_EQ(points(head("", "X = -40\n"), "G01 G41.2 D1 X0 F1\nX100\nY15\nX0\n").back(), "3 PS0041");
  EXPECT_EQ(points(head("\"5008#0\" = 1\n", "X = -40\n"), "G01 G41.2 D1 X0 F1\nX100\nY15\nX0\n").back(),
            "4 linear X0 Y5 Z0");
  // Heads that the check of the next block drops are dropped before they are given: outer acute at (100,0) with
  // (10,10), (14,2) for the line to (103,-4) of which the inner corner lies behind. The block keeps the first head of
  // its start and the only one of its end.
  const Lines dropped = behind(1, head("", "X = -40\n"), "G01 G41.2 D1 X0 F1\nX100\nX97 Y-4\nX197\n");
  EXPECT_EQ(dropped[0], "2 linear X110 Y10 Z0");
}

TEST(ModelToolSide, SmallDifference) {
  // From (-8,10,6) to (-1.6,14,1.2) of TS3 it is √(6.4² + 4² + 4.8²) = √80.
  const auto heads = [](const std::string& limit) {
    return behind(2, setup("5010 = \"" + limit + "\"\n", "Y = -40\n"),
                  kTilted + "G01 G41.6 D1 Y0 F1\nY100\nX94 Y40 Z-8\n");
  };
  EXPECT_EQ(heads("8.944")[1], "4 linear X-1.6 Y114 Z1.2 (corner)");
  EXPECT_EQ(heads("8.945")[1], "4 linear X98.8 Y48 Z-11.6");
}

TEST(ModelToolSide, Modes) {
  EXPECT_EQ(points(setup(), "G43.5 K1\nG01 G41.2 D1 X100 F1\n").back(), "2 TOOL_SIDE_MODE");
  EXPECT_EQ(points(setup(), "G01 G42.6 D1 X100 F1\n"), (Lines{"1 TOOL_SIDE_MODE"}));
  EXPECT_EQ(points(head(), "G43.5\nG01 G41.6 D1 X100 F1\nX200 B5.\n").back(), "3 PS5460");
  EXPECT_EQ(points(head(), "G43.5\nG01 X100 F1\nX200 B5.\n").back(), "3 PS5421");
  EXPECT_EQ(points(setup(), kTilted + "G01 G41.6 D1 X100 F1\nG49 X200\n").back(), "3 TOOL_DIRECTION_FORMAT");
  EXPECT_EQ(points(head(), "G01 G41.2 D1 X100 F1\nG43.5 X200\n").back(), "2 TOOL_DIRECTION_FORMAT");
  EXPECT_EQ(points(setup(), kTilted + "Q1 X1\n").back(), "2 rapid X1 Y0 Z0");
  EXPECT_EQ(points(setup(), kTilted + "G01 G41.6 D1 X100 F1\nG40 X200 Q1\n").back(), "3 linear X200 Y0 Z0 (cancel)");
}

TEST(ModelToolSide, Forbidden) {
  for (const char* block : {"G04 P1",   "G10 L11 P1 R1", "G28 X0",  "G29 X0", "G30 X0", "G37 Z0", "G39",
                            "G45 X1",   "G53 X0",        "G92 X0",  "G54",    "G59",    "G20",    "G21",
                            "X200 M08", "X200 S1",       "X200 T1", "G41",    "G42",    "G41.3",  "G02 X200 I50 M08"})
    EXPECT_EQ(points(head(), "G01 G41.2 D1 X100 F1\nX150\n" + std::string(block) + "\nX300\n").back(),
              "3 FORBIDDEN_IN_3D_COMPENSATION")
        << block;
  for (const char* block : {"G53 X0", "G04 P1", "G28 X0"})
    EXPECT_EQ(points(head(), "G01 G41.2 D1 X100 F1\nG40 " + std::string(block) + "\n").back(),
              "2 FORBIDDEN_IN_3D_COMPENSATION")
        << block;
  EXPECT_EQ(points(head(), "G01 G41.2 D1 X100 F1\nG40 G54 X200 M08\n").back(), "2 linear X200 Y0 Z0 (cancel)");
  EXPECT_EQ(points(head(), "G01 G41 D1 X100 F1\nG41.2 X200\n").back(), "2 FORBIDDEN_IN_CUTTER_COMPENSATION");
  EXPECT_EQ(points(setup(), kTilted + "G41.3 D1\nG01 X100 F1\nG41.6 X200\n").back(), "4 FORBIDDEN_IN_3D_COMPENSATION");
  EXPECT_EQ(points(head(), "G01 G41.2 D1 X100 F1\nG18 X200\n").back(), "2 PS0037");
  EXPECT_EQ(points(head(), "G02 G41.2 D1 X100 I50 F1\n").back(), "1 PS0034");
  EXPECT_EQ(points(head(), "G01 G41.2 D1 X100 F1\nX200\nG02 G40 X300 I50\n").back(), "3 PS0034");
  // The letters of G22 are limits (fanuc.program.letters-as-data): no arc.
  EXPECT_EQ(points(head(), "G01 G41.2 D1 X100 F1\nX200\nG02 G40 G22 X300 I50\n").back(), "2 linear X200 Y10 Z0");
  EXPECT_EQ(points(setup(), "G01 G41.2 D5 X100 F1\n").back(), "1 PS0029");
}

TEST(ModelToolSide, TypeCFormat) {
  for (const char* block : {"G41.2 D1 X100", "G41.2 D1 B5.", "G02 G41.2 D1", "G41.2 D1 M00"})
    EXPECT_EQ(points(head(kTypeC), std::string(block) + "\nG01 X1 F1\n").back(), "1 TYPE_C_FORMAT") << block;
  for (const char* next : {"M08", "Z5", "G40", "G40 X5", "", "G99", "G42.2 X5"})
    EXPECT_EQ(points(head(kTypeC), "G01 G41.2 D1 F1\n" + std::string(next) + "\n").back(), "1 TYPE_C_FORMAT") << next;
  for (const char* block : {"G40 X200", "G40 B5.", "G02 G40", "D0 X200"})
    EXPECT_EQ(points(head(kTypeC), "G01 G41.2 D1 F1\nX100\n" + std::string(block) + "\n").back(), "3 TYPE_C_FORMAT")
        << block;
  EXPECT_EQ(points(head(kTypeC), "G01 G41.2 D0 X5 F1\nG40 X6\n").back(), "2 linear X6 Y0 Z0");
}

// What stands in memory does not grow along a program, whose orientation changes in every block.
TEST(ModelToolSide, LiveNodesAreBounded) {
  struct Counter final : model::EventSink {
    void on(const model::Event&) override { ++events; }
    std::size_t events = 0;
  } counter;
  const spec::Setup with = spec::read_setup_toml(head(), "setup.toml");
  std::string program = "G01 G41.2 D2 X1 F1\n";
  for (int i = 1; i < 400; ++i) {
    program += "X" + std::to_string(10 * i) + " Y" + std::to_string(i * i % 7) + " B" + std::to_string(i % 50) +
               ".123 C" + std::to_string(i * 3 % 90) + ".5\n";
    if (i % 5 == 0) program += "C" + std::to_string(i % 60) + ".\n";
  }
  model::Recorder recorder;
  spec::ProgramReader reader(spec::text_source(program), with.axes);
  model::Engine engine(with, recorder, counter);
  spec::Block block;
  std::size_t early = 0;
  std::size_t late = 0;
  while (!engine.stopped() && reader.next(block)) {
    engine.block(block);
    std::size_t& most = block.line < 200 ? early : late;
    most = std::max(most, exact::live_nodes());
  }
  engine.end();
  EXPECT_GT(counter.events, 400U);
  EXPECT_LE(late, early + early / 4);
  EXPECT_LT(late, 400U);
}

// The manual's route: C2 by Gram and Schmidt from auxiliary vectors, the points turned by M, the two offset lines in
// the remaining plane, and back by the transpose of M. The offset lines are met as two equations, not by a formula.
struct ByMatrix {
  ByMatrix(const Vector3& tool, const Vector3& a2, const Vector3& a3) {
    e1 = tool / sqrt(squared_norm(tool));
    const Vector3 b2 = a2 - dot(a2, e1) * e1;
    e2 = b2 / sqrt(squared_norm(b2));
    const Vector3 b3 = a3 - dot(a3, e1) * e1 - dot(a3, e2) * e2;
    e3 = b3 / sqrt(squared_norm(b3));
    // Right-handed (e2, e3, e1): else left and right are exchanged.
    if (dot(cross(e2, e3), e1).sign() == exact::Sign::negative) e3 = -e3;
  }
  using Flat = std::array<Real, 2>;
  Flat turn(const Vector3& v) const { return {dot(e2, v), dot(e3, v)}; }
  Vector3 back(const Flat& v) const { return v[0] * e2 + v[1] * e3; }

  // The heads at Q for a tool to the left (side 1) or right (-1).
  std::vector<Vector3> heads(const Vector3& p, const Vector3& q, const Vector3& r, const Real& radius, int side) const {
    const auto unit = [](const Flat& from, const Flat& to) {
      const Flat d{to[0] - from[0], to[1] - from[1]};
      const Real length = sqrt(d[0] * d[0] + d[1] * d[1]);
      return Flat{d[0] / length, d[1] / length};
    };
    const Flat d1 = unit(turn(p), turn(q));
    const Flat d2 = unit(turn(q), turn(r));
    const Flat n1{-side * d1[1], side * d1[0]};
    const Flat n2{-side * d2[1], side * d2[0]};
    const Real turned = d1[0] * d2[1] - d1[1] * d2[0];
    const Real ahead = d1[0] * d2[0] + d1[1] * d2[1];
    const exact::Sign to_tool = (side * turned).sign();
    const bool acute = to_tool != exact::Sign::positive && ahead.sign() == exact::Sign::negative;
    if (acute)
      return {back({radius * (n1[0] + d1[0]), radius * (n1[1] + d1[1])}),
              back({radius * (n2[0] - d2[0]), radius * (n2[1] - d2[1])})};
    if (to_tool == exact::Sign::zero) return {back({radius * n1[0], radius * n1[1]})};
    // V · n1 = r and V · n2 = r.
    const Real determinant = n1[0] * n2[1] - n1[1] * n2[0];
    return {back({radius * (n2[1] - n1[1]) / determinant, radius * (n1[0] - n2[0]) / determinant})};
  }

  Vector3 e1, e2, e3;
};

struct Corner {
  const char* tool;  // I J K
  Vector3 vt;
  const char* next;  // X Y Z
  Vector3 r;
};

TEST(ModelToolSide, ManualsRouteAgrees) {
  const Vector3 p{0, 0, 0};
  const Vector3 q{10, 20, 5};
  const std::vector<Corner> corners{
      {"I3 J0 K4", {3, 0, 4}, "X60 Y30 Z-8", {60, 30, -8}},
      {"I1 J2 K2", {1, 2, 2}, "X3 Y30 Z1", {3, 30, 1}},
      {"I1 J2 K2", {1, 2, 2}, "X-40 Y-3 Z1", {-40, -3, 1}},
      {"I1 J-1 K3", {1, -1, 3}, "X25 Y11 Z7", {25, 11, 7}},
      {"I-2 J3 K-6", {-2, 3, -6}, "X5 Y-30 Z5", {5, -30, 5}},
      {"I1 J1 K1", {1, 1, 1}, "X20 Y40 Z10", {20, 40, 10}},  // straight on
      {"I1 J1 K1", {1, 1, 1}, "X0 Y0 Z0", {0, 0, 0}},        // straight back
      {"I0 J0 K1", {0, 0, 1}, "X0 Y25 Z0", {0, 25, 0}},      // right angle
  };
  const std::vector<std::pair<Vector3, Vector3>> auxiliary{
      {{1, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {1, 1, 0}}, {{1, -2, 5}, {3, 1, -1}}, {{-7, 4, 1}, {1, 1, -9}}};
  for (const Corner& corner : corners) {
    for (const int side : {1, -1}) {
      const std::string code = side == 1 ? "G41.6" : "G42.6";
      const auto done = run(
          setup("\"5008#0\" = 1\n\"19605#5\" = 1\n", "X = -10\nY = -20\nZ = -5\n"),
          "G43.5 " + std::string(corner.tool) + "\nG01 " + code + " D1 X0 Y0 Z0 F1\nX10 Y20 Z5\n" + corner.next + "\n");
      std::vector<Vector3> heads;
      for (const model::Event& event : done.events())
        if (event.kind == spec::EventKind::move && event.cause != spec::Cause::start_up &&
            (event.programmed[0] == 10 && event.programmed[1] == 20))
          heads.push_back({event.point[0] - q.x, event.point[1] - q.y, event.point[2] - q.z});
      for (const auto& [a2, a3] : auxiliary) {
        const std::vector<Vector3> expected = ByMatrix(corner.vt, a2, a3).heads(p, q, corner.r, 10, side);
        ASSERT_EQ(heads.size(), expected.size()) << corner.tool << ' ' << corner.next << ' ' << code;
        for (std::size_t i = 0; i < heads.size(); ++i) {
          EXPECT_EQ(heads[i].x.decimal(25), expected[i].x.decimal(25)) << corner.tool << ' ' << corner.next;
          EXPECT_TRUE(heads[i] == expected[i]) << corner.tool << ' ' << corner.next << ' ' << code;
        }
      }
    }
  }
}

}  // namespace
