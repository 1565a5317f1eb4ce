// SPDX-License-Identifier: Apache-2.0
// Rules of the leading edge offset. VC = ±R·V/|V| with V = (VM × VT) × VT; with VT in the X-Z plane and VM along X the
// vectors are those of LE1 and LE2 (corpus/examples/fanuc/leading_edge_offset.cpp), others are derived in the comments.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "spec/language/input_error.h"
#include "tests/support/setup_with_feed.h"
#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;
using test::Lines;
using test::run;
using test::Show;

// D1 = 10, D2 = 5, D3 = -10, D4 = 0, D5 beyond the range. Only X Y Z: the direction is I J K.
std::string setup(const std::string& fluctuation = "1.0") {
  return "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[parameters]\n19631 = \"" + fluctuation +
         "\"\n[offsets.H]\n1 = 50\n[offsets.D]\n1 = 10\n2 = 5\n3 = -10\n4 = 0\n5 = 1000\n";
}
// C (about Z) carries B (about Y).
constexpr const char* kHead =
    "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[parameters]\n19680 = 2\n19681 = 5\n19682 = 3\n"
    "19686 = 4\n19687 = 2\n[offsets.H]\n1 = 50\n[offsets.D]\n1 = 10\n";

// The tool stands as in LE1 (leaning forward for +X) or LE2 (back).
constexpr const char* kForward = "G43.5 I3 J0 K4\n";
constexpr const char* kBack = "G43.5 I-3 J0 K4\n";

Lines points(const std::string& program, const std::string& fluctuation = "1.0") {
  return test::lines(run(setup(fluctuation), program), Show::point);
}

TEST(ModelLeadingEdge, StartAndCancel) {
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D1\nG01 X100 F100\nG40\n"),
            (Lines{"1 rapid X0 Y0 Z0", "2 rapid X-8 Y0 Z6 (start-up)", "3 linear X92 Y0 Z6",
                   "4 linear X100 Y0 Z0 (cancel)"}));
  // The type of the inserted moves is that of the code in force.
  EXPECT_EQ(points(std::string(kForward) + "G01 G41.3 D1\nX100\nG00 G40\n"),
            (Lines{"1 rapid X0 Y0 Z0", "2 linear X-8 Y0 Z6 (start-up)", "3 linear X92 Y0 Z6",
                   "4 rapid X100 Y0 Z0 (cancel)"}));
}

// The vector at the end of a block looks at the next one: a corner from +X to -X changes the side.
TEST(ModelLeadingEdge, LooksAtTheNextBlock) {
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D1\nG01 X100\nX0\nG40\n"),
            (Lines{"1 rapid X0 Y0 Z0", "2 rapid X-8 Y0 Z6 (start-up)", "3 linear X92 Y0 Z6", "4 linear X-8 Y0 Z6",
                   "5 linear X0 Y0 Z0 (cancel)"}));
  // From X to Y: VM = (0,1,0), VT = (3,0,4)/5 is a right angle; the side stays backward: (0,-10,0).
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D1\nG01 X100\nY50\nG40\n")[2], "3 linear X100 Y-10 Z0");
}

TEST(ModelLeadingEdge, NegativeAndZeroOffset) {
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D3\nG01 X100\nG40\n")[1], "2 rapid X8 Y0 Z-6 (start-up)");
  // The value 0 starts the mode: the moves are there, the vectors are zero.
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D4\nG01 X100\nG40\n"),
            (Lines{"1 rapid X0 Y0 Z0", "2 rapid X0 Y0 Z0 (start-up)", "3 linear X100 Y0 Z0",
                   "4 linear X100 Y0 Z0 (cancel)"}));
  // A reversed vector does not reverse the side that a right angle inherits: (0,+10,0).
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D3\nG01 X100\nY50\nG40\n")[2], "3 linear X100 Y10 Z0");
}

TEST(ModelLeadingEdge, NumberZero) {
  // Nothing starts, and the next block is free to be an arc.
  EXPECT_EQ(points("G41.3\nG02 X10 I5 F1\nG40\n"), (Lines{"2 arc X10 Y0 Z0"}));
  // D0 in the mode is G40.
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D1\nG01 X100\nD0\nX200\n"),
            (Lines{"1 rapid X0 Y0 Z0", "2 rapid X-8 Y0 Z6 (start-up)", "3 linear X92 Y0 Z6",
                   "4 linear X100 Y0 Z0 (cancel)", "5 linear X200 Y0 Z0"}));
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D1\nG01 X100\nX200 D0\n").back(), "4 PS5406");
}

TEST(ModelLeadingEdge, NumberChangedInTheMode) {
  // D2 = 5 from the end of its block on: (-4, 0, 3).
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D1\nG01 X100\nX200 D2\nX300\nG40\n"),
            (Lines{"1 rapid X0 Y0 Z0", "2 rapid X-8 Y0 Z6 (start-up)", "3 linear X92 Y0 Z6", "4 linear X196 Y0 Z3",
                   "5 linear X296 Y0 Z3", "6 linear X300 Y0 Z0 (cancel)"}));
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D5\nX1\n").back(), "2 PS0029");
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D1\nX100\nX200 D5\n").back(), "4 PS0029");
}

// One block without movement between: the vector is made of the tool before it and the movement after it, and kept
// through it. End of X100: VT = (3,0,4)/5, VM = +Y, side backward: (0,-10,0). Then the tool turns to VT = (0,3,4)/5 for
// the block Y50, whose end looks at its own +Y before G40: (0,-8,6).
TEST(ModelLeadingEdge, OneBlockWithoutMovement) {
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D1\nG01 X100\nI0 J3 K4\nY50\nG40\n"),
            (Lines{"1 rapid X0 Y0 Z0", "2 rapid X-8 Y0 Z6 (start-up)", "3 linear X100 Y-10 Z0", "4 linear X100 Y-10 Z0",
                   "5 linear X100 Y42 Z6", "6 linear X100 Y50 Z0 (cancel)"}));
  // M, S, F and H alone, a travel of zero, and N with a word are such blocks; one of them changes nothing here.
  for (const char* block : {"M08", "S100", "F5", "H0", "G91 X0", "X100", "N7 M08"})
    EXPECT_EQ(points(std::string(kForward) + "G41.3 D1\nG01 X100\n" + block + "\nG90 Y50\nG40\n")[2],
              "3 linear X100 Y-10 Z0")
        << block;
  // N and O alone are no blocks: two of them and one real one still count as one.
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D1\nG01 X100\nN5\nO7\nM08\nY50\nG40\n")[2], "3 linear X100 Y-10 Z0");
}

// Two and more in a row: the vector from before, here that of the start.
TEST(ModelLeadingEdge, TwoBlocksWithoutMovement) {
  const Lines kept{"1 rapid X0 Y0 Z0", "2 rapid X-8 Y0 Z6 (start-up)", "3 linear X92 Y0 Z6", "6 linear X100 Y40 Z0",
                   "7 linear X100 Y50 Z0 (cancel)"};
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D1\nG01 X100\nM08\nM09\nY50\nG40\n"), kept);
  // Own moves of such blocks carry it too.
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D1\nG01 X100\nI0 J3 K4\nI3 J0 K4\nM08\nY50\nG40\n"),
            (Lines{"1 rapid X0 Y0 Z0", "2 rapid X-8 Y0 Z6 (start-up)", "3 linear X92 Y0 Z6", "4 linear X92 Y0 Z6",
                   "5 linear X92 Y0 Z6", "7 linear X100 Y40 Z0", "8 linear X100 Y50 Z0 (cancel)"}));
}

// VT = (0,3,4)/5 at the end of Y50. Its own vector is (0,-8,6); the one from before, made with VT = (3,0,4)/5,
// (0,-10,0).
TEST(ModelLeadingEdge, BeforeCancel) {
  const std::string program = std::string(kForward) + "G41.3 D1\nG01 X100\nY50 I0 J3 K4\n";
  EXPECT_EQ(points(program + "G40\n")[3], "4 linear X100 Y42 Z6");
  EXPECT_EQ(points(program + "M08\nG40\n")[3], "4 linear X100 Y42 Z6");
  EXPECT_EQ(points(program + "M08\nM09\nG40\n")[3], "4 linear X100 Y40 Z0");
  // A movement along the tool keeps the vector here too: (30,0,40) with VT = (3,0,4)/5.
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D1\nG01 X100\nX130 Z40\nG40\n")[3], "4 linear X122 Y0 Z46");
}

TEST(ModelLeadingEdge, KeptWhereNothingIsReadAhead) {
  const std::string program = std::string(kForward) + "G41.3 D1\nG01 X100\nY50 I0 J3 K4\n";
  for (const char* block : {"M00\nX0", "M01\nX0", "M02", "M30", "", "G99", "X1.2.3", "G02 X5", "G41.3", "G10 L11 P1 R1",
                            "X5 H401", "M30\nG40", "G40 M00"})
    EXPECT_EQ(points(program + block + "\n")[3], "4 linear X100 Y40 Z0") << block;
  EXPECT_EQ(points(program + "X0\n")[3], "4 linear X110 Y50 Z0");  // read ahead: -X at a right angle to (0,3,4)
}

// 0 and 180 degrees keep the vector over any number of blocks; VT = (3,0,4)/5. -X then gives the vector of +X.
TEST(ModelLeadingEdge, RunsAlongTheTool) {
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D1\nG01 X100\nX130 Z40\nX160 Z80\nX130 Z40\nX100 Z0\nX0\nG40\n"),
            (Lines{"1 rapid X0 Y0 Z0", "2 rapid X-8 Y0 Z6 (start-up)", "3 linear X92 Y0 Z6", "4 linear X122 Y0 Z46",
                   "5 linear X152 Y0 Z86", "6 linear X122 Y0 Z46", "7 linear X92 Y0 Z6", "8 linear X-8 Y0 Z6",
                   "9 linear X0 Y0 Z0 (cancel)"}));
}

// The side passes through a run of kept vectors to a run of right angles, each of which has its own vector: forward
// here, so along the next travel.
TEST(ModelLeadingEdge, RunsAcrossTheTool) {
  EXPECT_EQ(
      points(std::string(kBack) + "G41.3 D1\nG01 X100\nX70 Z40\nY50\nY100\nY50\nG40\n"),
      (Lines{"1 rapid X0 Y0 Z0", "2 rapid X8 Y0 Z6 (start-up)", "3 linear X108 Y0 Z6", "4 linear X70 Y10 Z40",
             "5 linear X70 Y60 Z40", "6 linear X70 Y90 Z40", "7 linear X70 Y40 Z40", "8 linear X70 Y50 Z40 (cancel)"}));
}

// At the start a right angle counts by its own sign: 89.43 degrees (LE7) and exactly 90 as leaning forward, 90.57 back.
TEST(ModelLeadingEdge, StartAcrossTheTool) {
  EXPECT_EQ(points("G43.5 I0 J0 K1\nG41.3 D1\nG01 X100\nG40\n")[1], "2 rapid X-10 Y0 Z0 (start-up)");
  EXPECT_EQ(points("G43.5 I400 J0 K39999\nG41.3 D1\nG01 X100\nG40\n")[1],
            "2 rapid X-9.999500012499688 Y0 Z0.099997500062498 (start-up)");
  EXPECT_EQ(points("G43.5 I-400 J0 K39999\nG41.3 D1\nG01 X100\nG40\n")[1],
            "2 rapid X9.999500012499688 Y0 Z0.099997500062498 (start-up)");
}

// The ranges include their ends. The cosine of (1,0,1) and X is 1/sqrt(2): exactly 45 degrees, 10/sqrt(2) = 7.07….
TEST(ModelLeadingEdge, EndsOfTheRangesAlong) {
  EXPECT_EQ(points("G43.5 I1 K1\nG41.3 D1\nG01 X100\nG40\n", "45").back(), "2 PS5408");
  EXPECT_EQ(points("G43.5 I1 K1\nG41.3 D1\nG01 X-100\nG40\n", "45").back(), "2 PS5408");
  EXPECT_EQ(points("G43.5 I1 K1\nG41.3 D1\nG01 X100\nG40\n", "44.999")[1],
            "2 rapid X-7.071067811865475 Y0 Z7.071067811865475 (start-up)");
}

// VT = (1,1,0), VM = (-1,0,-1): the cosine is -1/2, exactly 120 degrees. VM x VT = (1,-1,-1), V = (1,-1,2), |V| =
// sqrt(6). In the range of 90 it stays backward, 10 V/|V|; outside the tool leans back, -10 V/|V|.
TEST(ModelLeadingEdge, EndsOfTheRangeAcross) {
  const std::string program = "G43.5 I1 J1 K0\nG41.3 D1\nG01 X100\nG91 X-10 Z-10\nG40\n";
  EXPECT_EQ(points(program, "30")[2], "3 linear X104.08248290463863 Y-4.08248290463863 Z8.16496580927726");
  EXPECT_EQ(points(program, "29.999")[2], "3 linear X95.91751709536137 Y4.08248290463863 Z-8.16496580927726");
}

// From 45 on the ranges overlap: 0 and 180 come first. At 90 only an exact right angle is left to count as 90.
TEST(ModelLeadingEdge, OverlappingRanges) {
  EXPECT_EQ(points("G43.5 I1 J0 K100\nG41.3 D1\nG01 X100\nG40\n", "90").back(), "2 PS5408");
  EXPECT_EQ(points("G43.5 I0 J0 K1\nG41.3 D1\nG01 X100\nG40\n", "90")[1], "2 rapid X-10 Y0 Z0 (start-up)");
  EXPECT_THROW(points("", "90.001"), spec::InputError);
  EXPECT_THROW(points("", "-90.001"), spec::InputError);
}

// With 0 and below only exact angles count: 0.03 degrees from the tool has its own vector, exactly along is kept.
// VT = Z, VM = (1,0,2000): V = -(1,0,0) direction, the tool leans forward: (-10,0,0).
TEST(ModelLeadingEdge, ExactAnglesOnly) {
  for (const char* fluctuation : {"0", "-1"}) {
    const std::string start = "G43.5 I0 J0 K1\nG41.3 D1\nG01 Y100\n";
    EXPECT_EQ(points(start + "G91 X1 Z2000\nG40\n", fluctuation)[2], "3 linear X-10 Y100 Z0");
    EXPECT_EQ(points(start + "Z2000\nG40\n", fluctuation)[2], "3 linear X0 Y90 Z0");
    EXPECT_EQ(points("G43.5 I0 J0 K1\nG41.3 D1\nG01 Z100\nG40\n", fluctuation).back(), "2 PS5408");
    // A thousandth off a right angle leans back: forward, though the vector before pointed backward.
    EXPECT_EQ(points(start + "G91 X1000 Z-0.001\nG40\n", fluctuation)[2], "3 linear X10 Y100 Z0");
  }
}

TEST(ModelLeadingEdge, StartFormat) {
  const Lines moved{"1 rapid X0 Y0 Z0", "2 PS5406"};
  for (const char* block : {"G41.3 D1 X5", "G41.3 D1 I1", "G41.3 D1 M00", "G41.3 D1 M30", "G41.3 D0 X5"})
    EXPECT_EQ(points(std::string(kForward) + block + "\nX100\n"), moved) << block;
  EXPECT_EQ(points("G02\nG41.3 D1\nX100\n"), (Lines{"2 PS5408"}));
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D1\nG01 X100\nG40 X5\n").back(), "4 PS5406");
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D1\nG01 X100\nG40 K5\n").back(), "4 PS5406");
}

// The block right after G41.3 must move in X Y Z; the alarm names the G41.3 block, whatever the next one would raise.
TEST(ModelLeadingEdge, NothingMovesAfterTheStart) {
  for (const char* block : {"", "G40", "M08", "M30", "I0 J0 K1", "X0", "F100", "G99", "G02 X5 R9", "G41.3", "X1.2.3"})
    EXPECT_EQ(points(std::string(kForward) + "N20 G41.3 D1\n" + block + "\n"), (Lines{"1 rapid X0 Y0 Z0", "2 PS5407"}))
        << block;
  const auto failed = run(setup(), std::string(kForward) + "N20 G41.3 D1\nN30 M08\n");
  EXPECT_EQ(failed.events().back().n, 20U);
}

TEST(ModelLeadingEdge, NotAllowedInTheMode) {
  for (const char* block : {"G02 X5 R9", "G03", "G40 G03", "G41.3"})
    EXPECT_EQ(points(std::string(kForward) + "G41.3 D1\nG01 X100\n" + block + "\n").back(), "4 PS5407") << block;
  for (const char* block : {"G04 P1", "G10 L11 P1 R1", "G28 X0", "G29 X0", "G30 X0", "G30.1 X0", "G53 X0", "G92 X0",
                            "G54", "G59", "G20", "G21", "X5 M08", "X5 S100", "X5 T1", "X5 M00"})
    EXPECT_EQ(points("G41.3 D1\nX100\n" + std::string(block) + "\n").back(), "3 FORBIDDEN_IN_3D_COMPENSATION") << block;
  // A tool direction is a move; M, S and T without one are allowed.
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D1\nX100\nI0 K1 S100\n").back(), "4 FORBIDDEN_IN_3D_COMPENSATION");
  EXPECT_EQ(points(std::string(kForward) + "G41.3 D1\nX100\nM08 S100 T1\nG40\n").back(), "5 rapid X100 Y0 Z0 (cancel)");
  // The block that starts the mode is in it, the one that ends it is not.
  EXPECT_EQ(points("G41.3 D1 G54\nX100\n").back(), "1 FORBIDDEN_IN_3D_COMPENSATION");
  EXPECT_EQ(points("G41.3 D1\nX100\nG40 G55\n").back(), "3 rapid X100 Y0 Z0 (cancel)");
}

TEST(ModelLeadingEdge, CodesWithoutEffect) {
  EXPECT_EQ(points("G40\nX1\nG40 X2\n"), (Lines{"2 rapid X1 Y0 Z0", "3 rapid X2 Y0 Z0"}));
}

// The length offset acts on the axes as always; where it changes in the start or cancel block, that move takes it
// along.
TEST(ModelLeadingEdge, WithLengthOffset) {
  EXPECT_EQ(test::lines(run(kHead, "G43 H1\nG41.3 D1\nG01 X100\nH0\nX200\nG40 H1\n"), Show::axes),
            (Lines{"1 rapid X0 Y0 Z50 B0 C0", "2 rapid X-10 Y0 Z50 B0 C0 (start-up)", "3 linear X90 Y0 Z50 B0 C0",
                   "4 linear X90 Y0 Z0 B0 C0", "5 linear X190 Y0 Z0 B0 C0", "6 linear X200 Y0 Z50 B0 C0 (cancel)"}));
  EXPECT_EQ(test::lines(run(kHead, "G41.3 D1 G43 H1\nG01 X100\n"), Show::axes),
            (Lines{"1 rapid X-10 Y0 Z50 B0 C0 (start-up)", "2 linear X90 Y0 Z50 B0 C0"}));
}

// Under G43.5 every move has machine coordinates, the inserted ones too, also where G41 and G40 came before: the
// workpiece zero at (1,2,3) added to the points of StartAndCancel.
TEST(ModelLeadingEdge, MachineCoordinatesBehindCutterCompensation) {
  const std::string shifted = setup() + "[workpiece.G54]\nX = 1\nY = 2\nZ = 3\n";
  const std::string program = std::string(kForward) + "G41.3 D1\nG01 X100 F100\nG40\n";
  EXPECT_EQ(test::lines(run(shifted, program), Show::machine),
            (Lines{"1 rapid X1 Y2 Z3", "2 rapid X-7 Y2 Z9 (start-up)", "3 linear X93 Y2 Z9",
                   "4 linear X101 Y2 Z3 (cancel)"}));
  EXPECT_EQ(test::lines(run(shifted, "G41 D1\nG40\n" + program), Show::machine),
            (Lines{"3 rapid X1 Y2 Z3", "4 rapid X-7 Y2 Z9 (start-up)", "5 linear X93 Y2 Z9",
                   "6 linear X101 Y2 Z3 (cancel)"}));
}

// Rotary axes: VT = (sin B cos C, sin B sin C, cos B) at the end of each block. B30: VC = 10 (-cos 30, 0, sin 30). In
// the block that turns alone the vector stays; the block before it used the tool before the turn.
TEST(ModelLeadingEdge, RotaryAxes) {
  EXPECT_EQ(test::lines(run(kHead, "B30.\nG41.3 D1\nG01 X100\nB-30.\nX200\nG40\n"), Show::point),
            (Lines{"1 rapid X0 Y0 Z0", "2 rapid X-8.660254037844386 Y0 Z5 (start-up)",
                   "3 linear X91.339745962155614 Y0 Z5", "4 linear X91.339745962155614 Y0 Z5",
                   "5 linear X208.660254037844386 Y0 Z5", "6 linear X200 Y0 Z0 (cancel)"}));
  // Turning and moving together: VT at the end of X100 is that of B-30, which leans back against +X.
  EXPECT_EQ(test::lines(run(kHead, "B30.\nG41.3 D1\nG01 X100 B-30.\nX200\nG40\n"), Show::point)[2],
            "3 linear X108.660254037844386 Y0 Z5");
}

// Forced outcomes: what a controller in rounded arithmetic might have decided.
TEST(ModelLeadingEdge, ForcedOutcomes) {
  // Decision 0 is the sign of VM · VT at the start: forced back, the vector points forward.
  std::pair<std::size_t, exact::Sign> back{0, exact::Sign::negative};
  const std::string program = "G43.5 I3 J0 K4\nG41.3 D1\nG01 X100\nG40\n";
  const auto forced = run(setup(), program, &back);
  EXPECT_EQ(test::lines(forced, Show::point)[1], "2 rapid X8 Y0 Z-6 (start-up)");
  EXPECT_EQ(forced.recorder.decisions().at(0).outcome, exact::Sign::negative);
  EXPECT_EQ(spec::info(forced.recorder.decisions().at(0).clause).id, "fanuc.leading-edge.sign");
  // VM · VT = 300 (lengths 100 and 5), 500 at most.
  EXPECT_EQ(forced.recorder.decisions().at(0).quantity.decimal(3), "300");
  EXPECT_EQ(forced.recorder.decisions().at(0).scale.decimal(3), "500");
  // The tool exactly along the movement, forced not to count as along: there is no vector.
  std::pair<std::size_t, exact::Sign> apart{1, exact::Sign::negative};
  EXPECT_THROW(run(setup(), "G43.5 I1 J0 K0\nG41.3 D1\nG01 X100\nG40\n", &apart), model::NotFinite);
}

// 10,000 blocks keep no more nodes alive than a few blocks do, whatever the angles.
TEST(ModelLeadingEdge, NodesDoNotChain) {
  struct Discard final : model::EventSink {
    void on(const model::Event& event) override {
      ++events;
      most = std::max(most, exact::live_nodes());
      last = event.point[0];
    }
    std::size_t events = 0;
    std::size_t most = 0;
    exact::Real last;
  };
  const auto most = [](int blocks) {
    std::string program = "G91 G43 H1\nG41.3 D1\n";
    for (int i = 0; i < blocks; ++i)
      program += "G01 X" + std::to_string(1 + i % 7) + ".5 Y-" + std::to_string(i % 3) + " B" +
                 std::to_string(i % 5 - 2) + ".25 C1.125\n";
    const spec::Setup head = test::setup_with_feed(kHead);
    model::Recorder recorder;
    Discard sink;
    model::Engine engine(head, recorder, sink);
    spec::ProgramReader reader(spec::text_source(program), head.axes);
    spec::Block block;
    while (reader.next(block)) engine.block(block);
    engine.end();
    EXPECT_EQ(sink.events, static_cast<std::size_t>(blocks) + 2);
    return sink.most;
  };
  const std::size_t few = most(100);
  EXPECT_LE(most(10000), few + 100);
}

}  // namespace
