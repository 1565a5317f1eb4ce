// Traces of small programs, sample by sample by hand.
#include "certify/trace/trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

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

TEST(Trace, TheEndMustBeReached) {
  const TraceResult r = judge(kCorner, "X,Y\n0,0\n10,0\n10,9\n");
  ASSERT_EQ(r.findings.size(), 1U);
  EXPECT_EQ(r.findings[0].kind, "end not reached");
  EXPECT_EQ(r.findings[0].line, 2U);
  EXPECT_EQ(r.findings[0].n, 20U);
  EXPECT_DOUBLE_EQ(r.findings[0].distance.upper, 1);
}

TEST(Trace, MayBeginAnywhereOnTheFirstMove) {
  EXPECT_EQ(exit_status(judge(kCorner, "X,Y\n3,0\n10,0\n10,10\n")), 0);
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
  EXPECT_DOUBLE_EQ(r.findings[0].distance.upper, 2);
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
}

TEST(Trace, ComparesRotaryAxesByThemselves) {
  spec::Case c = program("G90 G01 X10. C90. F100\n");
  c.setup.axes = spec::Axes("XYZC");
  EXPECT_EQ(exit_status(judge(c, "X,C\n0,0\n5,45\n10,90\n")), 0);
  EXPECT_EQ(exit_status(judge(c, "X,C\n0,0\n5,46\n10,90\n")), 1);
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

INSTANTIATE_TEST_SUITE_P(Csv, MalformedTrace,
                         testing::Values(BadTrace{"", 1, 1}, BadTrace{"X,Q\n0,0\n", 1, 3}, BadTrace{"X, X\n", 1, 4},
                                         BadTrace{"time\n0\n", 1, 1}, BadTrace{"X,Y\n1,\n", 2, 3},
                                         BadTrace{"X,Y\n1, two\n", 2, 4}, BadTrace{"X,Y\n1,2,3\n", 2, 5},
                                         BadTrace{"X,Y\n1,2\n\n1\n", 4, 2}, BadTrace{"X,Y\n1,nan\n", 2, 3},
                                         BadTrace{"X,Y\n1,1e999\n", 2, 3}, BadTrace{"time,X\n1,0\n0.5,0\n", 3, 1}));

TEST(Trace, ReadsBlanksCarriageReturnsAndAByteOrderMark) {
  EXPECT_EQ(exit_status(judge(kCorner, "\xEF\xBB\xBFtime, x ,y\r\n0, 0,0\r\n\r\n1, 10 ,+0\r\n2,1e1,10\r\n")), 0);
}

TEST(Trace, NeedsAPositiveTolerance) { EXPECT_THROW(judge(kCorner, "X,Y\n0,0\n", 0), spec::InputError); }

}  // namespace
}  // namespace toolcomp::certify
