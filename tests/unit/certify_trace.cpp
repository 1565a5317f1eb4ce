// SPDX-License-Identifier: Apache-2.0
// Traces of small programs, sample by sample by hand.
#include "certify/trace/trace.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <utility>
#include <vector>

#include "spec/language/input_error.h"

namespace toolcomp::certify {
namespace {

spec::Case program(std::string text) {
  spec::Case c;
  c.id = "trace";
  c.section = "fanuc/tool-length-offset";
  c.program = std::move(text);
  return c;
}

TraceResult judge(const spec::Case& c, const std::string& csv, double tolerance = 0.01, bool rapids = true) {
  std::istringstream stream(csv);
  TraceOptions options;
  options.tolerance = tolerance;
  options.judge_rapids = rapids;
  return judge_trace(c, stream, "trace.csv", options);
}

std::string line(double x, double y) { return std::to_string(x) + "," + std::to_string(y) + "\n"; }

// An L: along X to 10, then along Y to 10.
const spec::Case kCorner = program("G90 G01 X10. F100\nN20 Y10.\n");

TEST(Trace, AcceptsTheExactPath) {
  const TraceResult r = judge(kCorner, "time,X,Y\n0,0,0\n0.1,5,0\n0.2,10,0\n0.3,10,5\n0.4,10,10\n");
  EXPECT_EQ(exit_status(r), 0);
  EXPECT_EQ(r.samples, 5U);
  EXPECT_EQ(r.corners, 2U);
  EXPECT_EQ(r.worst.upper, 0);
  EXPECT_EQ(r.recorded, "XY");
  EXPECT_EQ(r.not_recorded, "Z");
}

TEST(Trace, TheToleranceItselfIsAccepted) {
  const TraceResult at = judge(kCorner, "X,Y\n0,0\n5,0.01\n10,0\n10,10\n");
  EXPECT_EQ(exit_status(at), 0);
  EXPECT_DOUBLE_EQ(at.worst.upper, 0.01);
  EXPECT_EQ(at.worst_sample, 3U);
  const TraceResult beyond = judge(kCorner, "X,Y\n0,0\n5,0.0101\n10,0\n10,10\n");
  ASSERT_EQ(beyond.findings.size(), 1U);
  EXPECT_EQ(beyond.findings[0].kind, "off the path");
  EXPECT_EQ(beyond.findings[0].sample, 3U);
  EXPECT_EQ(beyond.findings[0].line, 1U);
  EXPECT_NEAR(beyond.findings[0].distance.upper, 0.0101, 1e-12);
  EXPECT_EQ(exit_status(beyond), 1);
}

// From (9.99, 0) to (10, 0.01) the straight line passes the corner at 0.01/√2 = 0.00707; ten times as far, at 0.0707.
TEST(Trace, ACornerIsReachedBetweenSamples) {
  EXPECT_EQ(exit_status(judge(kCorner, "X,Y\n0,0\n9.99,0\n10,0.01\n10,10\n")), 0);
  const TraceResult cut = judge(kCorner, "X,Y\n0,0\n9.9,0\n10,0.1\n10,10\n");
  ASSERT_EQ(cut.findings.size(), 1U);
  EXPECT_EQ(cut.findings[0].kind, "corner not reached");
  EXPECT_EQ(cut.findings[0].line, 1U);
  EXPECT_NEAR(cut.findings[0].distance.upper, 0.1 / std::numbers::sqrt2, 1e-12);
  EXPECT_EQ(cut.corners_missed, 1U);
}

TEST(Trace, SamplesComeInOrder) {
  const TraceResult r = judge(kCorner, "X,Y\n0,0\n5,0\n4,0\n6,0\n10,0\n10,10\n");
  ASSERT_EQ(r.findings.size(), 1U);
  EXPECT_EQ(r.findings[0].kind, "out of order");
  EXPECT_NEAR(r.findings[0].distance.upper, 1, 0.02);
  EXPECT_EQ(r.off, 1U);
}

// Between two samples corners are passed in order, too: 10 is passed at 9.99 at the earliest, and 9.97 at 9.98 at the
// latest, which was before. 9.985 between them may be passed at either.
TEST(Trace, CornersBetweenTwoSamplesComeInOrder) {
  const spec::Case jog = program("G90 G01 X10. F100\nX9.985\nX9.97\nX9.99\nY10.\n");
  EXPECT_EQ(exit_status(judge(jog, "X,Y\n0,0\n9.991,0\n9.991,10\n")), 1);
  EXPECT_EQ(exit_status(judge(jog, "X,Y\n0,0\n9.991,0\n9.979,0\n9.991,0\n9.991,10\n")), 0);
}

TEST(Trace, TheEndMustBeReached) {
  const TraceResult r = judge(kCorner, "X,Y\n0,0\n10,0\n10,9\n");
  ASSERT_EQ(r.findings.size(), 1U);
  EXPECT_EQ(r.findings[0].kind, "end not reached");
  EXPECT_EQ(r.findings[0].line, 2U);
  EXPECT_EQ(r.findings[0].n, 20U);
  EXPECT_NEAR(r.findings[0].distance.upper, 1, 1e-12);
}

TEST(Trace, MayBeginAnywhereOnTheFirstMove) {
  const TraceResult later = judge(kCorner, "X,Y\n3,0\n10,0\n10,10\n");
  EXPECT_EQ(exit_status(later), 0);
  EXPECT_NEAR(later.covered, 17, 0.011);
  // Half a circle, from its middle.
  const spec::Case arc = program("G90 G17 G03 X20. I10. F100\n");
  std::string half = "X,Y\n";
  for (int degrees = 270; degrees <= 360; ++degrees)
    half += line(10 + 10 * std::cos(degrees * std::numbers::pi / 180), 10 * std::sin(degrees * std::numbers::pi / 180));
  EXPECT_EQ(exit_status(judge(arc, half)), 0);
  EXPECT_EQ(exit_status(judge(kCorner, "X,Y\n10,0\n10,10\n")), 0);
  EXPECT_EQ(exit_status(judge(kCorner, "X,Y\n10,3\n10,10\n")), 1);
}

TEST(Trace, ARunOfSamplesOffThePathIsOneFinding) {
  const TraceResult r = judge(kCorner, "X,Y\n0,0\n2,1\n3,2\n4,1\n5,0\n10,0\n10,1\n11,2\n10,10\n");
  EXPECT_EQ(r.off, 4U);
  ASSERT_EQ(r.findings.size(), 2U);
  EXPECT_EQ(r.findings[0].samples, 3U);
  EXPECT_EQ(r.findings[0].sample, 3U);  // the first, not the worst
  EXPECT_EQ(r.findings[0].worst_sample, 4U);
  EXPECT_NEAR(r.findings[0].distance.upper, 2, 1e-12);
  EXPECT_EQ(r.findings[1].line, 2U);
}

// Down and up twice on the same line: every turn counts.
TEST(Trace, CountsEveryTurnOfADrillingCycle) {
  const spec::Case drill = program("G90 G01 Z-10. F100\nZ0\nZ-10.\nZ0\n");
  EXPECT_EQ(exit_status(judge(drill, "Z\n0\n-5\n-10\n-5\n0\n-5\n-10\n-5\n0\n")), 0);
  const TraceResult once = judge(drill, "Z\n0\n-5\n-10\n-5\n0\n");
  ASSERT_EQ(once.findings.size(), 1U);
  EXPECT_EQ(once.findings[0].kind, "end not reached");
  EXPECT_EQ(once.corners_missed, 1U);
  const TraceResult shallow = judge(drill, "Z\n0\n-5\n-10\n-5\n0\n-5\n-9\n-5\n0\n");
  ASSERT_GE(shallow.findings.size(), 1U);
  EXPECT_EQ(shallow.findings[0].kind, "corner not reached");
  EXPECT_EQ(shallow.findings[0].line, 3U);
}

TEST(Trace, FollowsAFullCircle) {
  const spec::Case circle = program("G90 G01 X10. F100\nG17 G03 I-10.\nG01 X20.\n");
  const auto turn = [](int from, int to, int step) {
    std::string csv;
    for (int degrees = from; degrees <= to; degrees += step)
      csv += line(10 * std::cos(degrees * std::numbers::pi / 180), 10 * std::sin(degrees * std::numbers::pi / 180));
    return csv;
  };
  EXPECT_EQ(exit_status(judge(circle, "X,Y\n0,0\n10,0\n" + turn(0, 360, 5) + "20,0\n")), 0);
  // It was accepted once that samples a quarter apart lie on the circle. But nothing is known of the arcs between: as
  // far as the record goes, the machine may have gone along the chords, 10·(1 - cos 45°) off.
  const TraceResult square = judge(circle, "X,Y\n0,0\n10,0\n" + turn(0, 360, 90) + "20,0\n");
  ASSERT_EQ(square.findings.size(), 1U);
  EXPECT_EQ(square.findings[0].kind, "gap");
  EXPECT_EQ(square.findings[0].line, 2U);
  EXPECT_LE(square.findings[0].distance.lower, 10 * (1 - std::numbers::sqrt2 / 2));
  EXPECT_GE(square.findings[0].distance.upper, 10 * (1 - std::numbers::sqrt2 / 2));
  EXPECT_NEAR(square.findings[0].distance.lower, square.findings[0].distance.upper, 0.01);
  const TraceResult half = judge(circle, "X,Y\n0,0\n10,0\n" + turn(0, 180, 5));
  EXPECT_EQ(half.findings.at(0).kind, "end not reached");
  const TraceResult skipped = judge(circle, "X,Y\n0,0\n10,0\n11,0\n20,0\n");
  ASSERT_EQ(skipped.findings.size(), 1U);
  EXPECT_EQ(skipped.findings[0].kind, "move left out");
  EXPECT_EQ(skipped.findings[0].line, 2U);
  // The far side of the circle is its diameter away.
  EXPECT_LE(skipped.findings[0].distance.lower, 20);
  EXPECT_GE(skipped.findings[0].distance.upper, 20);
  EXPECT_NEAR(skipped.findings[0].distance.lower, skipped.findings[0].distance.upper, 0.03);
  // The other way round.
  EXPECT_EQ(
      exit_status(judge(circle, "X,Y\n0,0\n10,0\n" + line(9.9619, -0.8716) + line(9.8481, -1.7365) + "10,0\n20,0\n")),
      1);
}

// The axes run at Z + 20: the recording shows machine-side positions.
TEST(Trace, IncludesTheLengthOffset) {
  spec::Case c = program("G90 G00 G43 Z100. H1\nG01 X10. F100\n");
  c.setup.h[1] = {spec::decimal(20), {}};
  EXPECT_EQ(exit_status(judge(c, "X,Z\n0,0\n0,120\n10,120\n")), 0);
  EXPECT_EQ(exit_status(judge(c, "X,Z\n0,0\n0,100\n10,100\n")), 1);
}

TEST(Trace, RapidMovesMayBeJudgedAtTheirEndsOnly) {
  const spec::Case rapid = program("G90 G00 X10. Y5.\nG01 X20. F100\n");
  const std::string dogleg = "X,Y\n0,0\n5,5\n10,5\n20,5\n";
  EXPECT_EQ(exit_status(judge(rapid, dogleg)), 1);
  const TraceResult r = judge(rapid, dogleg, 0.01, false);
  EXPECT_EQ(exit_status(r), 0);
  EXPECT_EQ(r.not_judged_moves, 1U);
  EXPECT_EQ(exit_status(judge(rapid, "X,Y\n0,0\n5,5\n10,4\n20,4\n", 0.01, false)), 1);
  // Two samples lie on it, the end and what follows are judged: the largest distance is that of the last sample but
  // one.
  const TraceResult kinds = judge(rapid, "X,Y\n0,0\n5,5\n10,5\n15,5.008\n20,5\n", 0.01, false);
  EXPECT_EQ(exit_status(kinds), 0);
  EXPECT_EQ(kinds.deviations.not_judged(), 2U);
  EXPECT_EQ(kinds.deviations.off(), 0U);
  EXPECT_EQ(kinds.deviations.histogram()[0], 2U);
  EXPECT_EQ(kinds.deviations.histogram()[16], 1U);
  EXPECT_EQ(kinds.deviations.points()[1].kind, SampleKind::not_judged);
  EXPECT_EQ(kinds.deviations.points()[3].kind, SampleKind::followed);
  EXPECT_NEAR(kinds.worst.upper, 0.008, 1e-12);
  EXPECT_EQ(kinds.worst_sample, 5U);
}

TEST(Trace, ComparesRotaryAxesByThemselves) {
  spec::Case c = program("G90 G01 X10. C90. F100\n");
  c.setup.axes = spec::Axes("XYZC");
  EXPECT_EQ(exit_status(judge(c, "X,C\n0,0\n5,45\n10,90\n")), 0);
  EXPECT_EQ(exit_status(judge(c, "X,C\n0,0\n5,46\n10,90\n")), 1);
}

// The end of a rapid move is missed by a millimetre; behind it the path is followed, and a bump there is found too.
TEST(Trace, TheEndOfARapidMoveThatWasMissed) {
  const spec::Case rapid = program("G90 G00 X10. Y5.\nG01 X20. F100\nY20.\n");
  const TraceResult r = judge(rapid, "X,Y\n0,0\n5,5\n10,4\n12,5\n14,5\n16,5.5\n18,5\n20,5\n20,20\n", 0.01, false);
  ASSERT_EQ(r.findings.size(), 2U);
  EXPECT_EQ(r.findings[0].kind, "corner not reached");
  EXPECT_EQ(r.findings[0].line, 1U);
  // From (10, 5) to the line from (10, 4) to (12, 5).
  EXPECT_NEAR(r.findings[0].distance.upper, 2 / std::sqrt(5), 1e-9);
  EXPECT_EQ(r.findings[1].kind, "off the path");
  EXPECT_EQ(r.findings[1].line, 2U);
  EXPECT_NEAR(r.findings[1].distance.upper, 0.5, 1e-9);
}

// Each axis comes from its begin to its end in its own time: that lies in the box of both, and nothing else does.
TEST(Trace, ARapidMoveGoesAxisByAxis) {
  const spec::Case rapid = program("G90 G00 X10. Y5.\nG01 X4. F100\nY20.\n");
  const auto judged = [&](const std::string& positions) {
    return exit_status(judge(rapid, "X,Y\n0,0\n" + positions + "4,5\n4,20\n", 0.01, false));
  };
  EXPECT_EQ(judged("10,0\n10,5\n"), 0);
  EXPECT_EQ(judged("0,5\n10,5\n"), 0);
  EXPECT_EQ(judged("4,4\n10,4\n10.005,5.005\n"), 0);
  EXPECT_EQ(judged("10,-0.02\n10,5\n"), 1);
  EXPECT_EQ(judged("11,0\n10,5\n"), 1);
  EXPECT_EQ(judged("4,20\n10,5\n"), 1) << "along a later move";
}

// A head whose C carries its B, 100 mm above the tip. Behind G49 the programmed position is that of the axes: with B at
// 90 degrees that is (100, 0, 0), and half a circle about the origin begins there.
TEST(Trace, BehindTipControlProgramsGoOnWhereTheAxesAre) {
  spec::Case c = program("G90 G01 G43.4 H1 F1000\nB90.\nG49\nG17 G03 X-100. Y0 I-100. J0\n");
  c.setup.axes = spec::Axes("XYZBC");
  const std::vector<std::pair<std::uint32_t, std::int64_t>> head{
      {19680, 2}, {19681, 5}, {19682, 3}, {19686, 4}, {19687, 2}};
  for (const auto& [number, value] : head) c.setup.parameters[{number, -1}] = spec::decimal(value);
  c.setup.h[1] = {spec::decimal(100), {}};
  std::string csv = "X,Y,Z,B,C\n0,0,0,0,0\n0,0,100,0,0\n";
  constexpr int kParts = 2000;
  for (int i = 1; i <= kParts; ++i) {
    const double b = std::numbers::pi / 2 * i / kParts;
    csv += fmt::format("{},0,{},{},0\n", 100 * std::sin(b), 100 * std::cos(b), 90.0 * i / kParts);
  }
  for (int i = 1; i <= kParts; ++i) {
    const double turn = std::numbers::pi * i / kParts;
    csv += fmt::format("{},{},0,90,0\n", 100 * std::cos(turn), 100 * std::sin(turn));
  }
  const TraceResult r = judge(c, csv);
  EXPECT_EQ(exit_status(r), 0);
  EXPECT_LT(r.worst.upper, 0.001);
}

TEST(Trace, RotaryAxesHaveATolerance) {
  spec::Case c = program("G90 G01 X10. C90. F100\n");
  c.setup.axes = spec::Axes("XYZC");
  std::istringstream csv("X,C\n0,0\n5.0005,45.4\n10,90\n");
  TraceOptions options;
  options.tolerance = 0.001;
  options.rotary_tolerance = 0.5;
  const TraceResult r = judge_trace(c, csv, "trace.csv", options);
  EXPECT_EQ(exit_status(r), 0);
  // C is nine times X. Nearest, in tolerances, is where both are off alike: (x - 5.0005) / 0.001 = (45.4 - 9 x) / 0.5.
  const double x = (45.4 + 500 * 5.0005) / 509;
  EXPECT_NEAR(r.worst.upper, x - 5.0005, 1e-12);
  EXPECT_NEAR(r.worst_rotary.upper, 45.4 - 9 * x, 1e-10);
  options.rotary_tolerance = 0;
  std::istringstream again("X,C\n0,0\n10,90\n");
  EXPECT_THROW(judge_trace(c, again, "trace.csv", options), spec::InputError);
}

TEST(Trace, WithoutPicturesTheVerdictIsTheSame) {
  std::istringstream csv("X,Y\n0,0\n5,0.5\n10,0\n10.005,5\n10,10\n");
  TraceOptions options;
  options.tolerance = 0.01;
  options.pictures = false;
  const TraceResult r = judge_trace(kCorner, csv, "trace.csv", options);
  EXPECT_EQ(r.findings_total, 1U);
  EXPECT_NEAR(r.worst.upper, 0.005, 1e-12);
  EXPECT_TRUE(r.deviations.points().empty());
  EXPECT_TRUE(r.course.empty());
  EXPECT_TRUE(r.events.empty());
}

// C alone is off, by two degrees: degrees are not added to millimetres, and the axis has a name.
TEST(Trace, DegreesAndLengthsAreToldApart) {
  spec::Case c = program("G90 G01 X10. C0 F100\n");
  c.setup.axes = spec::Axes("XYZC");
  const TraceResult r = judge(c, "X,C\n0,0\n4,0\n5,2\n6,0\n10,0\n");
  ASSERT_EQ(r.findings.size(), 1U);
  EXPECT_EQ(r.findings[0].kind, "off the path");
  EXPECT_EQ(r.findings[0].rotary_axis, 'C');
  EXPECT_NEAR(r.findings[0].rotary.lower, 2, 1e-12);
  EXPECT_NEAR(r.findings[0].rotary.upper, 2, 1e-12);
  EXPECT_NEAR(r.findings[0].distance.upper, 0, 1e-9);
}

// A bump inside a block that is followed again behind it: one finding, and nothing left out.
TEST(Trace, ABlockThatIsFollowedAgain) {
  const TraceResult r = judge(kCorner, "X,Y\n0,0\n3,0\n4,0.5\n5,0\n6,0\n10,0\n10,10\n");
  ASSERT_EQ(r.findings.size(), 1U);
  EXPECT_EQ(r.findings[0].kind, "off the path");
  EXPECT_EQ(r.findings[0].sample, 4U);
  EXPECT_EQ(r.findings[0].samples, 1U);
  EXPECT_NEAR(r.findings[0].distance.lower, 0.5, 1e-12);
  EXPECT_NEAR(r.findings[0].distance.upper, 0.5, 1e-12);
  EXPECT_EQ(r.corners_missed, 0U);
  EXPECT_NEAR(r.covered, 18, 0.05);
}

// The corner was reached, then the recording leaves the second leg.
TEST(Trace, ACornerThatWasReachedIsNotMissed) {
  const TraceResult r = judge(kCorner, "X,Y\n0,0\n10,0\n10.2,1\n10.2,2\n10,3\n10,10\n");
  ASSERT_EQ(r.findings.size(), 1U);
  EXPECT_EQ(r.findings[0].kind, "off the path");
  EXPECT_EQ(r.findings[0].line, 2U);
  EXPECT_EQ(r.findings[0].samples, 2U);
  EXPECT_NEAR(r.findings[0].distance.upper, 0.2, 1e-12);
  EXPECT_EQ(r.corners_missed, 0U);
}

// A zigzag of 100 rows of 50 mm, 1 mm apart, recorded 0.02 beside it from the second row on: the distance is 0.02
// however long it lasts, and not that from some row that is matched by mistake. At the end of a row the recording is on
// the way to the next one: 99 samples lie on the path.
TEST(Trace, ARecordingThatIsLostForLongIsMeasuredAllTheSame) {
  std::string text = "G90 G01 X50. F100\n";
  std::string csv = "X,Y\n0,0\n25,0\n50,0\n";
  for (int row = 1; row <= 100; ++row) {
    const int from = row % 2 == 1 ? 50 : 0;
    text += "Y" + std::to_string(row) + ".\nX" + std::to_string(50 - from) + ".\n";
    for (int i = 0; i <= 50; ++i) csv += line(from + (row % 2 == 1 ? -i : i), row + 0.02);
  }
  csv += "0,100\n";
  const TraceResult r = judge(program(text), csv);
  ASSERT_EQ(r.findings.size(), 1U);
  EXPECT_EQ(r.findings[0].kind, "off the path");
  EXPECT_EQ(r.findings[0].sample, 5U);
  EXPECT_EQ(r.findings[0].samples, 5100U - 99U);
  EXPECT_NEAR(r.findings[0].distance.lower, 0.02, 1e-9);
  EXPECT_NEAR(r.findings[0].distance.upper, 0.02, 1e-9);
  EXPECT_EQ(r.findings[0].line, 2U);
}

// Two blocks of a staircase are left out: the match goes on behind them, at the block it names.
TEST(Trace, BlocksLeftOutAreOneFinding) {
  const spec::Case stairs = program("N10 G90 G01 X10. F100\nN20 Y10.\nN30 X20.\nN40 Y20.\nN50 X30.\n");
  const TraceResult r = judge(stairs, "X,Y\n0,0\n5,0\n10,0\n20,10\n20,15\n20,20\n30,20\n");
  ASSERT_EQ(r.findings.size(), 1U);
  EXPECT_EQ(r.findings[0].kind, "move left out");
  EXPECT_EQ(r.findings[0].n, 20U);
  EXPECT_EQ(r.findings[0].sample, 5U);
  EXPECT_EQ(r.corners_missed, 1U);  // (10, 10), 10/√2 from the line past it; (20, 10) was reached
  EXPECT_LE(r.findings[0].distance.lower, 10 / std::numbers::sqrt2);
  EXPECT_GE(r.findings[0].distance.upper, 10 / std::numbers::sqrt2);
  EXPECT_NEAR(r.findings[0].distance.lower, r.findings[0].distance.upper, 0.01);
}

TEST(Trace, ARecordingThatBeginsLater) {
  const spec::Case stairs = program("N10 G90 G01 X10. F100\nN20 Y10.\nN30 X20.\nN40 Y20.\n");
  const TraceResult later = judge(stairs, "X,Y\n12,10\n20,10\n20,20\n");
  ASSERT_EQ(later.findings.size(), 1U);
  EXPECT_EQ(later.findings[0].kind, "begin not reached");
  EXPECT_EQ(later.findings[0].sample, 2U);
  // From the way to the first block it comes to it.
  const TraceResult before = judge(stairs, "X,Y\n0,5\n0,3\n0,0\n10,0\n10,10\n20,10\n20,20\n");
  ASSERT_EQ(before.findings.size(), 1U);
  EXPECT_EQ(before.findings[0].kind, "off the path");
  EXPECT_EQ(before.findings[0].sample, 2U);
  EXPECT_EQ(before.findings[0].samples, 2U);
  EXPECT_NEAR(before.findings[0].distance.lower, 5, 1e-12);
}

// Samples of kCorner every millimetre and tenth of a second, but for those at which `missing` says so.
template <class Missing>
std::string timed(Missing missing, double period = 0.1, int digits = 6) {
  std::string csv = "time,X,Y\n";
  for (int i = 0; i <= 80; ++i) {
    // It stands at the corner from 20 to 60.
    const double x = std::min(i, 20) / 2.0;
    const double y = std::max(0, i - 60) / 2.0;
    const std::string stamp = std::to_string(i * period);
    if (!missing(i)) csv += stamp.substr(0, stamp.find('.') + 1 + static_cast<std::size_t>(digits)) + "," + line(x, y);
  }
  return csv;
}

TEST(Trace, AGapInTimeIsAFinding) {
  EXPECT_EQ(exit_status(judge(kCorner, timed([](int) { return false; }))), 0);
  // On a straight move, and where the machine stands: nothing is known of what it did.
  for (const int from : {10, 40}) {
    const TraceResult r = judge(kCorner, timed([&](int i) { return i >= from && i < from + 5; }));
    ASSERT_EQ(r.findings.size(), 1U) << from;
    EXPECT_EQ(r.findings[0].kind, "gap");
    EXPECT_EQ(r.findings[0].sample, static_cast<std::uint64_t>(from + 2));
    EXPECT_NEAR(r.findings[0].duration, 0.6, 1e-9);
    EXPECT_EQ(r.findings[0].line, 1U);
    EXPECT_EQ(exit_status(r), 1);
  }
  // One sample is more than one and a half periods.
  EXPECT_EQ(judge(kCorner, timed([](int i) { return i == 30; })).findings.size(), 1U);
}

// Every second sample from 40 on: the recorder has another period there.
TEST(Trace, AnotherPeriodIsNoGap) {
  EXPECT_EQ(exit_status(judge(kCorner, timed([](int i) { return i > 40 && i % 2 == 1; }))), 0);
}

// A period of 0.133 s written in tenths: steps of one and two tenths.
TEST(Trace, StepsOfTheClockAreNoGaps) {
  EXPECT_EQ(exit_status(judge(kCorner, timed([](int) { return false; }, 0.133, 1))), 0);
  // Five samples missing are.
  EXPECT_EQ(judge(kCorner, timed([](int i) { return i > 30 && i < 36; }, 0.133, 1)).findings.size(), 1U);
}

// One sample a block, whenever it ends: there is no period, and that is said.
TEST(Trace, StepsWithoutAPeriodAreNotJudged) {
  const TraceResult r = judge(kCorner, "time,X,Y\n0,0,0\n1,2,0\n5,8,0\n5.5,10,0\n9,10,10\n");
  EXPECT_EQ(exit_status(r), 0);
  EXPECT_GT(r.steps_not_judged, 0U);
}

// A quarter circle between two lines without a sample on it: the recording goes straight from end to end.
TEST(Trace, AWholeArcLeftOut) {
  const spec::Case rounded = program("G90 G01 X10. F100\nG17 G03 X20. Y10. R10.\nG01 Y20.\n");
  const TraceResult r = judge(rounded, "X,Y\n0,0\n10,0\n20,10\n20,20\n");
  ASSERT_EQ(r.findings.size(), 1U);
  EXPECT_EQ(r.findings[0].kind, "move left out");
  EXPECT_EQ(r.findings[0].line, 2U);
  EXPECT_EQ(r.findings[0].sample, 4U);
  EXPECT_EQ(r.corners_missed, 0U);
  EXPECT_LE(r.findings[0].distance.lower, 10 * (1 - std::numbers::sqrt2 / 2));
  EXPECT_GE(r.findings[0].distance.upper, 10 * (1 - std::numbers::sqrt2 / 2));
  EXPECT_NEAR(r.findings[0].distance.lower, r.findings[0].distance.upper, 0.01);
}

// A gap on a curve is one finding, with its duration and how far the curve is from the chord.
TEST(Trace, AGapOnACurveHasBoth) {
  const spec::Case circle = program("G90 G01 X10. F100\nG17 G03 I-10.\n");
  std::string csv = "t [ms];Y;X\n-1;0;0\n0;0;10\n";
  for (int degrees = 1; degrees <= 360; ++degrees)
    if (degrees <= 90 || degrees >= 150)
      csv += std::to_string(degrees) + ";" + std::to_string(10 * std::sin(degrees * std::numbers::pi / 180)) + ";" +
             std::to_string(10 * std::cos(degrees * std::numbers::pi / 180)) + "\n";
  const TraceResult r = judge(circle, csv);
  ASSERT_EQ(r.findings_total, 1U);
  EXPECT_EQ(r.findings[0].kind, "gap");
  EXPECT_NEAR(r.findings[0].duration, 0.06, 1e-12);
  // 60 degrees: 10·(1 - cos 30°).
  EXPECT_NEAR(r.findings[0].distance.lower, 10 * (1 - std::numbers::sqrt3 / 2), 0.01);
  EXPECT_NEAR(r.findings[0].distance.upper, 10 * (1 - std::numbers::sqrt3 / 2), 0.01);
}

TEST(Trace, SaysWhenNothingWasJudged) {
  EXPECT_EQ(exit_status(judge(kCorner, "X,Y\n")), 3);
  EXPECT_EQ(exit_status(judge(program("G04 P100\n"), "X,Y\n0,0\n")), 3);
}

struct BadTrace {
  const char* csv;
  std::uint64_t line;
  std::uint64_t column;
};
class MalformedTrace : public testing::TestWithParam<BadTrace> {};

TEST_P(MalformedTrace, IsReportedWithItsPlace) {
  try {
    judge(kCorner, GetParam().csv);
    FAIL() << "accepted";
  } catch (const spec::InputError& error) {
    EXPECT_EQ(error.file(), "trace.csv");
    EXPECT_EQ(error.line(), GetParam().line) << error.what();
    EXPECT_EQ(error.column(), GetParam().column) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Csv, MalformedTrace,
    testing::Values(BadTrace{"", 1, 1}, BadTrace{"X,Q\n0,0\n", 1, 3}, BadTrace{"X, X\n", 1, 4},
                    BadTrace{"time\n0\n", 1, 1}, BadTrace{"X,Y\n1,\n", 2, 3}, BadTrace{"X,Y\n1, two\n", 2, 4},
                    BadTrace{"X,Y\n1,2,3\n", 2, 5}, BadTrace{"X,Y\n1,2\n\n1\n", 4, 2}, BadTrace{"X,Y\n1,nan\n", 2, 3},
                    BadTrace{"X,Y\n1,1e999\n", 2, 3}, BadTrace{"time,X\n1,0\n0.5,0\n", 3, 1}, BadTrace{"X,Y;Z\n", 1, 4},
                    BadTrace{"X;Y\n1,2\n", 2, 1}, BadTrace{"X [deg],Y\n", 1, 1}, BadTrace{"X,Y_s\n", 1, 3},
                    BadTrace{"X,time [mm]\n", 1, 3}, BadTrace{"X,Y [mm\n", 1, 3}, BadTrace{"X,Y_\n", 1, 3},
                    BadTrace{"X,t,time\n", 1, 5}, BadTrace{"# X,Y\n", 1, 1}, BadTrace{"X\tY\n1\t\n", 2, 3}));

TEST(Trace, ReadsBlanksCarriageReturnsAndAByteOrderMark) {
  EXPECT_EQ(exit_status(judge(kCorner, "\xEF\xBB\xBFtime, x ,y\r\n0, 0,0\r\n\r\n1, 10 ,+0\r\n2,1e1,10\r\n")), 0);
}

// Names and units in any order, comments, other separators; one tenth of an inch is 2.54 mm.
TEST(Trace, ReadsUnitsAndSeparators) {
  EXPECT_EQ(
      exit_status(judge(kCorner, "# of a controller\nY [um];t [us];X (mm)\n0;0;0\n# half way\n0;5;10\n10000;7;10\n")),
      0);
  EXPECT_EQ(exit_status(judge(kCorner, "X_in\tY_m\n0\t0\n0.39370078740157483\t0\n0.39370078740157483\t0.01\n")), 0);
  spec::Case inch = program("G90 G01 X1. F100\n");
  inch.setup.units = spec::Units::inch;
  EXPECT_EQ(exit_status(judge(inch, "x_mm\n0\n25.4\n")), 0);
  EXPECT_EQ(exit_status(judge(inch, "x\n0\n1\n")), 0);
  spec::Case both = program("G90 G01 X1. C90. F100\n");
  both.setup.units = spec::Units::inch;
  both.setup.axes = spec::Axes("XYZC");
  EXPECT_EQ(exit_status(judge(both, "x_mm,C (deg)\n0,0\n25.4,90\n")), 0);
  spec::Case turn = program("G90 G01 C180. F100\n");
  turn.setup.axes = spec::Axes("XYZC");
  EXPECT_EQ(exit_status(judge(turn, "C (rad)\n0\n3.141592653589793\n")), 0);
}

TEST(Trace, NeedsAPositiveTolerance) { EXPECT_THROW(judge(kCorner, "X,Y\n0,0\n", 0), spec::InputError); }

}  // namespace
}  // namespace toolcomp::certify
