// SPDX-License-Identifier: Apache-2.0
// Leading edge offset in the fast engine, by hand. The worked examples LE1 to LE10 stand in
// golden/fanuc/corpus_examples_leading_edge_offset.cpp. Unless stated, R = 10 and the tool direction comes from I J K.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/unit/fanuc/fast_run.h"

namespace toolcomp::fast {
namespace {

using Vector = std::array<double, 3>;

std::string setup(const std::string& parameters = "") {
  return "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\"]\n[parameters]\n" + parameters +
         "\n[offsets.H]\n1=0\n2=20\n[offsets.D]\n1=10\n2=6\n3=0\n4=-10\n";
}

// C about Z carries B about Y.
std::string head(const std::string& parameters = "") {
  return "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\",\"B\",\"C\"]\n[parameters]\n\"19680\"=2\n\"19681\"="
         "5\n"
         "\"19682\"=3\n\"19686\"=4\n\"19687\"=2\n" +
         parameters + "\n[offsets.H]\n1=20\n[offsets.D]\n1=10\n2=6\n";
}

// The vector of event i.
Vector vector(const ProgramRun& run, std::size_t i) {
  return {run.point(i, 'X') - run.programmed(i, 'X'), run.point(i, 'Y') - run.programmed(i, 'Y'),
          run.point(i, 'Z') - run.programmed(i, 'Z')};
}

void expect_vector(const ProgramRun& run, std::size_t i, const Vector& expected, double tolerance = 2e-15) {
  const Vector actual = vector(run, i);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(actual[k], expected[k], tolerance * 10) << "event " << i << ", component " << k;
}

// G43.5 with a direction, start-up at the origin with D1, then `body`.
std::string started(const std::string& ijk, const std::string& body, const std::string& d = "D1") {
  return "G43.5 H1 " + ijk + "\nG41.3 " + d + "\nG01 F100 " + body;
}

TEST(LeadingEdge, RightAngleWithoutHistoryIsBackward) {
  expect_vector(ProgramRun(setup(), started("I0 J0 K1", "X100\nG40\n")), 1, {-10, 0, 0});
}

TEST(LeadingEdge, KeptAlongTheTool) {
  // By hand: VT = (3,0,4)/5; the second block runs along it, so the vector at the end of the first is kept.
  const ProgramRun run(setup(), started("I3 J0 K4", "X100\nX160 Z80\nX160 Y50 Z80\nG40\n"));
  expect_vector(run, 2, {-8, 0, 6});
  expect_vector(run, 3, {0, -10, 0});
}

TEST(LeadingEdge, OneBlockWithoutMovement) {
  // By hand: at the end of X100 the next movement is +Y with the tool before it turns: VC = -R Y.
  const ProgramRun run(head(), "B30\nG41.3 D1\nG01 X100\nB0 C90\nY100\nG40\n");
  expect_vector(run, 2, {0, -10, 0});
  expect_vector(run, 3, {0, -10, 0});
  // G40: own movement +Y, tool upright at exactly 90 degrees with a backward history.
  expect_vector(run, 4, {0, -10, 0});
  expect_vector(run, 5, {0, 0, 0});
}

TEST(LeadingEdge, TwoBlocksWithoutMovementKeep) {
  const ProgramRun run(setup(), started("I0 J0 K1", "X100\nX100\nM08\nY100\nG40\n"));
  ASSERT_EQ(run.events.size(), 6U);
  for (std::size_t i = 1; i <= 3; ++i) expect_vector(run, i, {-10, 0, 0});
  expect_vector(run, 4, {0, -10, 0});
}

TEST(LeadingEdge, LookAheadStops) {
  for (const char* stop : {"M00\n", "M01\n", "M30\n", "G05\n", "G04 P1\n", ""}) {
    const ProgramRun run(setup(), started("I0 J0 K1", std::string("X100\nY100\n") + stop));
    expect_vector(run, 2, {0, -10, 0});
    // The vector at the end of Y100 is that at the end of X100.
    expect_vector(run, 3, {0, -10, 0});
  }
  // A cancel block that stops the look-ahead keeps it too: the own movement would give -R Y.
  const ProgramRun run(setup(), started("I0 J0 K1", "X100\nY100\nX0\nG40 M01\n"));
  expect_vector(run, 4, {10, 0, 0});
}

TEST(LeadingEdge, BeforeCancelOwnMovement) {
  const ProgramRun run(setup(), started("I0 J0 K1", "X100\nY100\nG40\n"));
  expect_vector(run, 3, {0, -10, 0});
  const ProgramRun kept(setup(), started("I0 J0 K1", "X100\nY100\nM08\nM09\nG40\n"));
  expect_vector(kept, 3, {0, -10, 0});
}

TEST(LeadingEdge, NumberChanges) {
  // The vector at the end of the block with D2 has its length.
  const ProgramRun run(setup(), started("I0 J0 K1", "X100\nX200 D2\nX300\nD4\nX400\nG40\n"));
  expect_vector(run, 2, {-10, 0, 0});
  expect_vector(run, 3, {-6, 0, 0});
  // D4 in a block without movement: the vector there is shared; the next one is negative.
  expect_vector(run, 4, {-6, 0, 0});
  expect_vector(run, 5, {10, 0, 0});
  const ProgramRun zero(setup(), started("I0 J0 K1", "X100\nD0\nX200\n", "D3"));
  ASSERT_EQ(zero.events.size(), 5U);
  EXPECT_EQ(zero.events[1].cause, spec::Cause::start_up);
  EXPECT_EQ(zero.events[3].cause, spec::Cause::cancel);
  EXPECT_EQ(zero.point(2, 'X'), 100);
  EXPECT_EQ(ProgramRun(setup(), started("I0 J0 K1", "X100\nG02 X200 R100\n", "D0")).moves(), 3U);
}

TEST(LeadingEdge, LengthOffsetAlongTheTool) {
  // By hand: VT = (3,0,4)/5, L = 20: axes are 12 and 16 off the point.
  const ProgramRun run(setup(), "G43.5 H2 I3 J0 K4\nG41.3 D1\nG01 X100\nG40\nG49\nG91 X1\n");
  EXPECT_NEAR(run.axis(1, 'X'), -8 + 12, 1e-14);
  EXPECT_NEAR(run.axis(1, 'Z'), 6 + 16, 1e-14);
  EXPECT_NEAR(run.machine(1, 'Z'), 22, 1e-14);
  // G49 makes no move; the programmed position becomes (112, 0, 16), exactly.
  ASSERT_EQ(run.events.size(), 5U);
  EXPECT_EQ(run.programmed(4, 'X'), 113);
  EXPECT_EQ(run.axis(4, 'Z'), 16);
}

TEST(LeadingEdge, DirectionOfThePoseWithoutWords) {
  // By hand: G43.5 without I J K takes the direction of B90: the tool lies along X, L = 20. C then turns to 90.
  const ProgramRun run(head(), "B90\nG43.5 H1\nI0 J1 K0\nG49\nB90 X30\n");
  EXPECT_EQ(run.axis(1, 'X'), 20);
  EXPECT_EQ(run.axis(1, 'Z'), 0);
  EXPECT_EQ(run.axis(2, 'Y'), 20);
  EXPECT_EQ(run.programmed(3, 'Y'), 20);
  EXPECT_EQ((*run.events[3].tool_axis)[1], 1);
}

TEST(LeadingEdge, LengthChangeWithStartAndCancelIsOneMove) {
  const ProgramRun run(head(), "B30\nG41.3 D1 G43 H1\nG01 X100\nG40 G49\n");
  ASSERT_EQ(run.events.size(), 4U);
  EXPECT_EQ(run.axis(2, 'Z') - run.point(2, 'Z'), 20);
  EXPECT_EQ(run.events[3].cause, spec::Cause::cancel);
  EXPECT_EQ(run.axis(3, 'Z'), 0);
}

TEST(LeadingEdge, Alarms) {
  const std::string s = head();
  const auto alarm = [&](const std::string& program) { return ProgramRun(s, "B30\n" + program).alarm(); };
  EXPECT_EQ(alarm("G41.3 D1 X1\n"), "PS5406@2");
  EXPECT_EQ(alarm("G41.3 D1 M01\n"), "PS5406@2");
  EXPECT_EQ(alarm("G02\nG41.3 D1\n"), "PS5408@3");
  EXPECT_EQ(alarm("G41.3 D1\nG40\n"), "PS5407@2");
  EXPECT_EQ(alarm("G41.3 D1\nC5\nX1\n"), "PS5407@2");
  EXPECT_EQ(alarm("G41.3 D1\n"), "PS5407@2");
  EXPECT_EQ(alarm("G41.3 D1\nG05\n"), "PS5407@2");
  EXPECT_EQ(alarm("G41.3 D1\nX10\nG40 X20\n"), "PS5406@4");
  EXPECT_EQ(alarm("G41.3 D1\nX10\nG02 X20 R50\n"), "PS5407@4");
  EXPECT_EQ(alarm("G41.3 D1\nX10\nG41.3\n"), "PS5407@4");
  EXPECT_EQ(alarm("G41.3 D1\nX10\nX20 M08\n"), "FORBIDDEN_IN_3D_COMPENSATION@4");
  EXPECT_EQ(alarm("G43.5 H1 I0 J0 K1\nI1 K2\nG41.3 D1\nX10\nI0 K1 M08\n"), "FORBIDDEN_IN_3D_COMPENSATION@6");
  EXPECT_EQ(alarm("G41.3 D1\nX10\nG28 X0\n"), "FORBIDDEN_IN_3D_COMPENSATION@4");
  EXPECT_EQ(alarm("G41.3 D1\nX10\nG20\n"), "FORBIDDEN_IN_3D_COMPENSATION@4");
  EXPECT_EQ(alarm("G41.3 D1\nX10\nM08\nX20\nG40\n"), "");
  EXPECT_EQ(alarm("G43.5 H1 I0 J0 K0\n"), "PS5421@2");
  EXPECT_EQ(alarm("G43.5 H1\nB5\n"), "PS5421@3");
  EXPECT_EQ(alarm("G43.5 H1\nG54\n"), "FORBIDDEN_UNDER_TOOL_DIRECTION@3");
  EXPECT_EQ(alarm("G43 H1\nG43.5\n"), "LENGTH_OFFSET_EXCLUSION@3");
  EXPECT_EQ(alarm("G43.5 H1\nG43\n"), "LENGTH_OFFSET_EXCLUSION@3");
  EXPECT_EQ(alarm("G43.5 H1\nG41.3 D1\nX5\nG49\n"), "TOOL_DIRECTION_FORMAT@5");
  // The move before the alarm is given, with the vector from before it.
  const ProgramRun run(s, "B30\nG41.3 D1\nX10\nY10\nG41.3\n");
  EXPECT_EQ(run.moves(), 4U);
}

// 19631 with angles whose squared sine is rational: ends of the ranges belong to them.
TEST(LeadingEdge, RangesAreClosed) {
  // VT = Z, VM = (1,0,1): exactly 45 degrees.
  EXPECT_EQ(ProgramRun(setup("\"19631\"=45"), started("I0 J0 K1", "X10 Z10\n")).alarm(), "PS5408@2");
  EXPECT_EQ(ProgramRun(setup("\"19631\"=\"44.999999999999\""), started("I0 J0 K1", "X10 Z10\nG40\n")).alarm(), "");
  // Through the trigonometric route: B45 and VM along X.
  EXPECT_EQ(ProgramRun(head("\"19631\"=45"), "B45\nG41.3 D1\nX10\n").alarm(), "PS5408@2");
  // B45 and VM = (1,0,-1): exactly 90 degrees, in no range if 19631 = 0 but that of the right angle itself. Backward.
  const ProgramRun right(head("\"19631\"=0"), "B45\nG41.3 D1\nX10 Z-10\nG40\n");
  expect_vector(right, 1, {-10 / std::sqrt(2.0), 0, 10 / std::sqrt(2.0)});
  // B45 and VM = (1,0,1): exactly 0.
  EXPECT_EQ(ProgramRun(head("\"19631\"=0"), "B45\nG41.3 D1\nX10 Z10\n").alarm(), "PS5408@2");
  EXPECT_EQ(ProgramRun(head("\"19631\"=0"), "B45\nG41.3 D1\nX10 Z10.000000001\nG40\n").alarm(), "");
}

}  // namespace
}  // namespace toolcomp::fast
