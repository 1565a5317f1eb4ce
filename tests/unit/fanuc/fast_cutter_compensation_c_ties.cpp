// SPDX-License-Identifier: Apache-2.0
// Decisions of cutter compensation C that stand on an edge, in the fast engine: what is exactly tangent, exactly at
// right angles or exactly touching must be found so, in frames whose numbers are no doubles. Expected values by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/unit/fanuc/fast_run.h"

namespace toolcomp::fast {
namespace {

using Heads = std::vector<std::pair<double, double>>;

std::string setup(double x, double y, const std::string& parameters = "") {
  return "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\"]\n[position]\nX=" + std::to_string(x) +
         "\nY=" + std::to_string(y) + "\n[parameters]\n" + parameters + "\n[offsets.D]\n1=10\n2=5\n3=1\n4=\"0.1\"\n";
}

void expect_path(const ProgramRun& run, const Heads& expected, const char* what, double tolerance = 1e-13) {
  EXPECT_EQ(run.alarm(), "") << what;
  ASSERT_EQ(run.moves(), expected.size()) << what;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(run.point(i, 'X'), expected[i].first, tolerance) << what << ", move " << i;
    EXPECT_NEAR(run.point(i, 'Y'), expected[i].second, tolerance) << what << ", move " << i;
  }
}

TEST(FastCutterCompensationCTies, TangentJoins) {
  // A line along (3,4) into an arc by R: centre (3,4) + 10 (-0.8, 0.6) = (-5,10); the end is 10 (0.28, 0.96) from it.
  const ProgramRun line_arc(setup(-30, -40), "G41 D2 G01 X0 Y0\nX3 Y4\nG03 X-2.2 Y19.6 R10");
  expect_path(line_arc, {{-4, 3}, {-1, 7}, {-3.6, 14.8}}, "line and arc by R");
  EXPECT_FALSE(line_arc.events.at(2).arc->radius);
  // Two arcs by R with irrational centres and a common tangent of 30 degrees: one head, at 0.1 (-1/2, sqrt(3)/2).
  const double y = 0.1 * std::sqrt(3) / 2;
  const ProgramRun wave(setup(-10, 0), "G41 D4 G01 X0 Y0\nG03 X2 R2\nG02 X4 R2");
  expect_path(wave, {{0.05, y}, {1.95, y}, {4.05, y}}, "wave");
}

// No. 5010 at a corner of tool side compensation behind an arc, the tool along Z: the vector along the perpendicular
// and the prolonged one are (-8, 6) and (-2, 14), exactly 10 apart, and (2, 14) follows 4 behind. Doubles tell neither
// limit from 10.
TEST(FastCutterCompensationCTies, SmallMovementBehindAnArcToTheLastDigit) {
  const auto expect_corner = [](const std::string& limit, std::pair<double, double> last) {
    const std::string program = "G41.2 D1 G01 X0 F100\nX60\nG03 X100 Y0 J50\nG01 X130 Y-40\nG40 X160 Y-80\n";
    const ProgramRun run(
        "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\",\"B\",\"C\"]\n[position]\nX=-40\nY=-20\n"
        "[parameters]\n19680=2\n19681=5\n19682=3\n19686=4\n19687=2\n5010=\"" +
            limit + "\"\n[offsets.D]\n1=10\n",
        program);
    Heads heads;
    for (std::size_t i = 0; i < run.moves(); ++i)
      if (run.programmed(i, 'X') == 100 && run.programmed(i, 'Y') == 0)
        heads.emplace_back(run.point(i, 'X') - 100, run.point(i, 'Y'));
    ASSERT_EQ(heads.size(), 2U) << limit;
    EXPECT_NEAR(heads[0].first, -8, 1e-13);
    EXPECT_NEAR(heads[0].second, 6, 1e-13);
    EXPECT_NEAR(heads[1].first, last.first, 1e-13) << limit;
    EXPECT_NEAR(heads[1].second, last.second, 1e-13) << limit;
  };
  expect_corner("9.999999999999", {-2, 14});
  expect_corner("10", {2, 14});
}

TEST(FastCutterCompensationCTies, HalfCircle) {
  // Chord (12,16), R = 10: clockwise the tangents are (-4,3)/5 at the start and (4,-3)/5 at the end, those of the
  // lines.
  const ProgramRun half(setup(40, -30), "G41 D2 G01 X0 Y0\nG02 X12 Y16 R10\nG01 X52 Y-14");
  expect_path(half, {{-3, -4}, {15, 20}, {55, -10}}, "half circle");
  EXPECT_EQ(half.events.at(1).arc->sweep, 180);
}

TEST(FastCutterCompensationCTies, TurnBackAlongAnArc) {
  // G41 along a quarter circle, back along it with G42: parallel tangents, one vector.
  const ProgramRun back(setup(-10, 0), "G41 D2 G01 X0 Y0\nG03 X20 Y20 J20\nG42 G02 X0 Y0 I-20");
  expect_path(back, {{0, 5}, {15, 20}, {0, 5}}, "back along the arc");
}

TEST(FastCutterCompensationCTies, AnArcFromThePerpendicularOfTheOtherSide) {
  // R = 40 about (-32,24) from the start, clockwise, r = 1: the vector before is to the right of its tangent, 39 from
  // the centre; the one at its end is to the left, 41 from it. The vector comes from G39, which looks at the arc, or
  // from the line before, which is tangent to it and ends alone (two blocks without motion).
  const char* const arc = "G41 G02 X-8 Y56 I-32 J24\nG40 G01 X1";
  const std::string before[] = {"G91 G42 D3 G01 X1\nX1\nG39\n", "G91 G42 D3 G01 X1\nX-3 Y-4\nX0\n"};
  for (const std::string& start : before) {
    const ProgramRun run(setup(0, 0), start + arc);
    EXPECT_EQ(run.alarm(), "");
    const Event& tool = run.events.at(run.moves() - 2);
    ASSERT_TRUE(tool.arc && tool.arc->radius) << start;
    EXPECT_NEAR(tool.arc->radius->first, 39, 1e-13);
    EXPECT_NEAR(tool.arc->radius->second, 41, 1e-13);
  }
}

TEST(FastCutterCompensationCTies, CornerMovesKeepTheDigitsOfTheShift) {
  // The tool stands 0.1 beyond the program; straight back after X40 it goes round (40.1,0) from (10,10) to (10,-10)
  // beside it, however far the next block goes.
  const ProgramRun run(setup(0, 0), "G45 D4 G01 X1\nG41 D1 X10\nX40\nX-1000000\n");
  ASSERT_EQ(run.moves(), 5U);
  EXPECT_EQ(run.events[3].cause, spec::Cause::corner);
  EXPECT_DOUBLE_EQ(run.point(3, 'X'), 50.1);
  EXPECT_DOUBLE_EQ(run.point(3, 'Y'), -10);
}

TEST(FastCutterCompensationCTies, ShortPieceOfAHugeCircle) {
  // Straight on, 0.8 along a circle of 10^14: a sweep far below what angles of doubles tell from a
  // whole turn. The vector at the end is (-1, 8e-15).
  const ProgramRun piece(setup(0, 0), "G91 G41 D3 G01 Y5\nG02 Y0.8 I100000000000000\n");
  EXPECT_EQ(piece.alarm(), "");
  ASSERT_EQ(piece.moves(), 2U);
  ASSERT_TRUE(piece.events[1].arc);
  EXPECT_NEAR(*piece.events[1].arc->sweep * 1e14, 0.8 * 57.29577951308232, 1e-10);
  EXPECT_DOUBLE_EQ(piece.point(1, 'X'), -1);
  EXPECT_DOUBLE_EQ(piece.point(1, 'Y'), 5.8 + 8e-15);
}

TEST(FastCutterCompensationCTies, SpiralFromNextToTheCentre) {
  // sqrt(100 + 10^-8) - 10 = 5e-10 from the centre at the start, about 90000 at the end; radial vectors leave the
  // sweep as it is.
  const ProgramRun run(setup(0, 0), "G41 D1 G01 X-90000\nG03 X0 I0.0001 J10\n");
  EXPECT_EQ(run.alarm(), "");
  ASSERT_EQ(run.moves(), 2U);
  ASSERT_TRUE(run.events[1].arc && run.events[1].arc->sweep && run.events[1].arc->radius);
  EXPECT_NEAR(*run.events[1].arc->sweep, 90 + (std::atan(1e-5) - std::atan(10 / 89999.9999)) * 57.29577951308232,
              1e-13);
  EXPECT_NEAR(run.events[1].arc->radius->first, 5e-10, 1e-14);
}

TEST(FastCutterCompensationCTies, LongVectors) {
  // 359.998 degrees: s = -10 (1 + cos) / sin = -10 (L + 40) / 0.001, L = sqrt(1600 + 10^-6).
  const ProgramRun spike(setup(-50, 0, "\"5008#0\"=1\n"), "G41 D1 G01 X0\nX40\nX0 Y0.001");
  const double s = 1e4 * (std::sqrt(1600 + 1e-6) + 40);
  EXPECT_NEAR(spike.point(1, 'X'), 40 - s, 5e-10);
  EXPECT_NEAR(spike.point(1, 'Y'), 10, 1e-15);
}

TEST(FastCutterCompensationCTies, FarFromTheOrigin) {
  // The vector does not know where the corner lies: 45 degrees, at 10^6.
  const ProgramRun far(setup(999950, 1000000), "G41 D1 G01 X1000000 Y1000000\nX1000040\nX1000070 Y1000030");
  EXPECT_NEAR(far.point(1, 'X'), 1000035.857864376269, 1.2e-10);
  EXPECT_EQ(far.point(1, 'Y'), 1000010);
}

TEST(FastCutterCompensationCTies, PlanesAndOtherAxes) {
  // G18: Z is the first axis, X the second; the corner move keeps Y, the own moves take it along.
  const ProgramRun zx(setup(0, 0), "G18 G41 D1 G01 Z50\nZ90 Y1\nX-30 Y2\n");
  ASSERT_EQ(zx.moves(), 3U);
  EXPECT_NEAR(zx.point(1, 'Z'), 100, 1e-13);
  EXPECT_NEAR(zx.point(1, 'X'), 10, 1e-13);
  EXPECT_EQ(zx.point(1, 'Y'), 1);
  const ProgramRun acute(setup(-50, 0), "G41 D1 G01 X0\nX40 Z1\nX10 Y-40 Z2\n");
  ASSERT_EQ(acute.moves(), 4U);
  EXPECT_EQ(acute.events[2].cause, spec::Cause::corner);
  EXPECT_EQ(acute.events[2].line, 3U);
  EXPECT_EQ(acute.point(2, 'Z'), 1);
  EXPECT_EQ(acute.point(3, 'Z'), 2);
}

// Found by fuzzing: before G92 a lone G42 of SUV = 1 makes no vector, whether the mode ends in that block or goes on
// (fanuc.cutter-c.start-without-next-block).
TEST(FastCutterCompensationCTies, CoordinateShiftBehindALoneCode) {
  const std::string suv = "\"5003#1\"=1\n";
  const ProgramRun ends(setup(0, 0, suv), "G42 D1\nG40 Y0 G92\nX5\n");
  ASSERT_EQ(ends.events.size(), 1U);
  EXPECT_EQ(ends.point(0, 'X'), 5);
  const ProgramRun goes_on(setup(0, 0, suv), "G42 D1\nG92 Y0\nX5\n");
  ASSERT_EQ(goes_on.events.size(), 1U);
  EXPECT_EQ(goes_on.events[0].cause, spec::Cause::start_up);
  EXPECT_EQ(goes_on.point(0, 'X'), 5);
}

}  // namespace
}  // namespace toolcomp::fast
