// SPDX-License-Identifier: Apache-2.0
// Tool side compensation in the fast engine, by hand. The worked examples TS1 to TS11 stand in
// golden/fanuc/corpus_examples_tool_side.cpp. Tool directions are exact, by I J K under G43.5; by rotary words where a
// test says so.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tests/unit/fanuc/fast_run.h"

namespace toolcomp::fast {
namespace {

using Vector = std::array<double, 3>;
using Heads = std::vector<Vector>;

constexpr double kTolerance = 2e-13;

const std::string kTypeB = "\"5003#0\"=1\n";
const std::string kTypeC = "\"5003#1\"=1\n";
const std::string kUntilted = "G43.5 H0 I0 J0 K1\n";
const std::string kTilted = "G43.5 H0 I3 J0 K4\n";  // VT = (3/5, 0, 4/5)

std::string setup(const std::string& parameters, double x, double y, double z = 0) {
  return "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\"]\n[position]\nX=" + std::to_string(x) +
         "\nY=" + std::to_string(y) + "\nZ=" + std::to_string(z) + "\n[parameters]\n" + parameters +
         "\n[offsets.H]\n1=20\n[offsets.D]\n1=10\n2=5\n3=-10\n4=0\n5=20\n";
}

// A head: C carries B; or C carries A.
std::string machine(const std::string& parameters, char tilting, double x, double y, double z = 0) {
  return std::string("control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\",\"") + tilting +
         "\",\"C\"]\n[position]\nX=" + std::to_string(x) + "\nY=" + std::to_string(y) + "\nZ=" + std::to_string(z) +
         "\n[parameters]\n19680=2\n19681=5\n19682=3\n19686=4\n19687=" + (tilting == 'A' ? "1\n" : "2\n") + parameters +
         "\n[offsets.H]\n1=20\n[offsets.D]\n1=10\n2=5\n3=-10\n4=0\n5=20\n";
}

Vector point(const ProgramRun& run, std::size_t i) { return {run.point(i, 'X'), run.point(i, 'Y'), run.point(i, 'Z')}; }
Vector programmed(const ProgramRun& run, std::size_t i) {
  return {run.programmed(i, 'X'), run.programmed(i, 'Y'), run.programmed(i, 'Z')};
}

// The vectors of the moves at a programmed point, in order; one of several moves to the same head counts once.
Heads vectors_at(const ProgramRun& run, const Vector& corner) {
  Heads heads;
  for (std::size_t i = 0; i < run.events.size(); ++i)
    if (run.events[i].kind == spec::EventKind::move && programmed(run, i) == corner) {
      const Vector p = point(run, i);
      heads.push_back({p[0] - corner[0], p[1] - corner[1], p[2] - corner[2]});
    }
  return heads;
}

void expect_near(const Vector& actual, const Vector& expected, const std::string& what, double tolerance = kTolerance) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(actual[k], expected[k], tolerance) << what << ", component " << k;
}

void expect_heads(const Heads& actual, const Heads& expected, const std::string& what, double tolerance = kTolerance) {
  ASSERT_EQ(actual.size(), expected.size()) << what;
  for (std::size_t i = 0; i < actual.size(); ++i)
    expect_near(actual[i], expected[i], what + ", head " + std::to_string(i), tolerance);
}

void check(const std::string& what, const std::string& toml, const std::string& program, const Vector& corner,
           const Heads& heads, const std::string& alarm = "") {
  const ProgramRun run(toml, program);
  EXPECT_EQ(run.alarm(), alarm) << what;
  expect_heads(vectors_at(run, corner), heads, what);
}

// A negative value exchanges the sides: TS3 with G42.6.
TEST(FastToolSideCompensation, NegativeValue) {
  check("TS3, negative", setup("", 0, -40), kTilted + "G42.6 D3 G01 Y0 F100\nY100\nX94 Y40 Z-8\nG40 X188 Y-20 Z-16\n",
        {0, 100, 0}, {{-8, 10, 6}, {-1.6, 14, 1.2}});
}

// The second reading of type B.
TEST(FastToolSideCompensation, WithoutPerpendicularVector) {
  const std::string bare = "type_b_without_perpendicular = true\n";
  check("TS7b type B, bare", bare + setup(kTypeB, 0, 0), kTilted + "G41.6 D1 G01 Y100 F100\nX94 Y40 Z-8\n", {0, 100, 0},
        {{-8, 10, 6}, {-1.6, 14, 1.2}});
  check("TS7 cancel, bare", bare + setup(kTypeB, 0, -40), kTilted + "G41.6 D1 G01 Y0 F100\nY100\nG40 X100\n",
        {0, 100, 0}, {{-8, 10, 6}});
}

TEST(FastToolSideCompensation, NumberBehindQ) {
  EXPECT_EQ(ProgramRun(machine("", 'A', 0, 40, 40),
                       "G00 A46\nG01 G41.2 D1 Y0 Z0 F100\nY-200 Z-200 Q4\nA-45\nY-400 Z0\nG40 Y-440 Z40\n")
                .alarm(),
            "Q_FORMAT@3");
}

// Q1 comes before the change of side, with the code repeated too (a value of the other sign changes the side).
TEST(FastToolSideCompensation, Q1BeforeTheChangeOfSide) {
  const std::string q1 = kUntilted + "G41.6 D1 G01 X0 F100\nX100 Q1\n";
  check("Q1, then the side changes", setup("", -40, 0), q1 + "G42.6 Y100\nG40 Y140\n", {100, 0, 0}, {{0, 10, 0}});
  check("Q1, then a repeated code", setup("", -40, 0), q1 + "G41.6 D3 Y100\nG40 Y140\n", {100, 0, 0}, {{0, 10, 0}});
}

// By hand: TS1 seen from below; VT = -Z exchanges left and right.
TEST(FastToolSideCompensation, SeenFromBelow) {
  const std::string below = "G43.5 H0 I0 J0 K-1\n";
  const std::string path = " D2 G01 X0 F100\nX100\nY100\nG40 Y150\n";
  check("line, left", setup("", -40, 0), below + "G41.6" + path, {100, 0, 0}, {{5, -5, 0}});
  check("line, right", setup("", -40, 0), below + "G42.6" + path, {100, 0, 0}, {{-5, 5, 0}});
  const std::string arc = " D1 G01 X0 F100\nX100\nG02 X90 Y-70 R50\nG01 G40 X300 Y300\n";
  const ProgramRun above(setup("", -40, 0), kUntilted + "G42.6" + arc);
  const ProgramRun seen(setup("", -40, 0), below + "G41.6" + arc);
  ASSERT_EQ(above.events.size(), seen.events.size());
  for (std::size_t i = 1; i < above.events.size(); ++i) expect_near(point(seen, i), point(above, i), "arc");
}

// By hand: a quarter circle of radius 50 about (0, 0) in which the tool turns over. It starts on the left of a
// clockwise arc, outside; seen from below left is the other side, and it ends inside.
TEST(FastToolSideCompensation, ToolTurnsOverInAnArc) {
  const ProgramRun run(machine("", 'B', -100, 50),
                       "G41.2 D1 G01 X-50 Y50 F100\nX0\nG02 X50 Y0 I0 J-50 B180\nG01 Y-50\nG40 X100\n");
  EXPECT_EQ(run.alarm(), "");
  ASSERT_GT(run.events.size(), 3U);
  ASSERT_TRUE(run.events[2].arc && run.events[2].arc->radius);
  EXPECT_NEAR(run.events[2].arc->radius->first, 60, kTolerance);
  EXPECT_NEAR(run.events[2].arc->radius->second, 40, kTolerance);
}

// Coplanar path and tool: the turn is exactly zero, and the tool goes round the end.
TEST(FastToolSideCompensation, Coplanar) {
  for (const char* const b : {"30", "45", "12.345", "60"}) {
    // The tool leans in the plane of X and Z, the path stays in it: straight back in the compensation plane.
    const ProgramRun run(machine("", 'B', -40, 0),
                         std::string("G01 B") + b + " F100\nG41.2 D1 X0\nX100 Z3\nX20 Z7\nG40 X-40\n");
    EXPECT_EQ(run.alarm(), "") << b;
    const Heads heads = vectors_at(run, {100, 0, 3});
    ASSERT_EQ(heads.size(), 2U) << b;
    EXPECT_NEAR(heads[0][1], 10, kTolerance);
    EXPECT_NEAR(heads[1][1], -10, kTolerance);
  }
  // The same turned by C 45 degrees: only identities of sine and cosine make the turn zero.
  const ProgramRun run(machine("", 'B', -40, -40),
                       "G01 B30 C45 F100\nG41.2 D1 X0 Y0\nX100 Y100 Z3\nX20 Y20 Z7\nG40 X-40 Y-40\n");
  EXPECT_EQ(run.alarm(), "");
  EXPECT_EQ(vectors_at(run, {100, 100, 3}).size(), 2U);
}

std::string owners(const ProgramRun& run) {
  std::string text;
  for (const Event& event : run.events) {
    if (event.kind != spec::EventKind::move) continue;
    text += std::to_string(event.line);
    text += event.cause == spec::Cause::corner
                ? "c"
                : (event.cause == spec::Cause::start_up ? "s" : (event.cause == spec::Cause::cancel ? "x" : "p"));
    text += event.type == spec::MoveType::rapid ? "r " : (event.type == spec::MoveType::arc ? "a " : " ");
  }
  return text;
}

TEST(FastToolSideCompensation, StopPoint) {
  const std::string head = kTilted + "G41.6 D1 G01 Y0 F100\n";
  // K1 is the stop point: the move to K2 belongs to the latter block.
  EXPECT_EQ(owners(ProgramRun(setup("", 0, -40), head + "Y100\nX94 Y40 Z-8\nG40 X188 Y-20 Z-16\n")),
            "1pr 2s 3p 4c 4p 5x ");
  // A block between the two that makes a move owns it; one without a move does not.
  EXPECT_EQ(owners(ProgramRun(setup("", 0, -40), head + "Y100\nI3 J0 K4\nX94 Y40 Z-8\nG40 X188 Y-20 Z-16\n")),
            "1pr 2s 3p 4c 4p 5p 6x ");
  EXPECT_EQ(owners(ProgramRun(setup("", 0, -40), head + "Y100\nM08\nX94 Y40 Z-8\nG40 X188 Y-20 Z-16\n")),
            "1pr 2s 3p 5c 5p 6x ");
  // Rapid as its owner.
  EXPECT_EQ(owners(ProgramRun(setup("", 0, -40), head + "Y100\nG00 X94 Y40 Z-8\nG40 X188 Y-20 Z-16\n")),
            "1pr 2s 3p 4cr 4pr 5xr ");
  // Type B: the moves to V_in and K1 belong to the start-up block.
  EXPECT_EQ(owners(ProgramRun(setup(kTypeB, 0, 0), kTilted + "G41.6 D1 G01 Y100 F100\nX94 Y40 Z-8\n")),
            "1pr 2s 2c 3c 3p ");
  EXPECT_EQ(owners(ProgramRun(setup(kTypeB, 0, 0), kTilted + "G41.6 D1 G01 Y100 F100\nX100\nX150\n")),
            "1pr 2s 2c 3p 4p ");
  // Before an arc: V_i, then V_out of the arc.
  EXPECT_EQ(owners(ProgramRun(machine("", 'B', -40, 0),
                              "G41.2 D1 G01 X0 F100\nX100\nG02 X90 Y-70 I-40 J-30\nG01 G40 X300 Y300\n")),
            "1s 2p 3c 3pa 4x ");
}

// Blocks that name the code in force again, once or twice, or another one are blocks like those without.
TEST(FastToolSideCompensation, CodesOfMotion) {
  const auto points = [](const std::string& first, const std::string& second, const std::string& third) {
    const ProgramRun run(setup("", -40, 0), kUntilted + "G41.6 D2 G01 X0 F100\nX100\n" + first + "Y100 I1 J0 K3\n" +
                                                second + "X200 I0 J0 K1\n" + third + "Y0\nG40 Y-50\n");
    std::vector<Vector> result;
    for (std::size_t i = 0; i < run.events.size(); ++i) result.push_back(point(run, i));
    return result;
  };
  const std::vector<Vector> expected = points("", "", "");
  ASSERT_GE(expected.size(), 6U);
  EXPECT_EQ(points("G01", "G1", "G01.0"), expected);
  EXPECT_EQ(points("G01G01", "", "G94G01"), expected);
  EXPECT_EQ(points("G00", "G01", "G00"), expected);
}

// The line before a block that takes the length offset back keeps it.
TEST(FastToolSideCompensation, LengthOffsetTakenBackBehindLines) {
  const ProgramRun run(setup("", -40, 0), "G41.2 D2 G01 X0 F100\nG43 H1\nX100\nX150\nX200\nH0\nX250\nX300\nG40 X350\n");
  for (std::size_t i = 0; i < run.events.size(); ++i) {
    const std::uint64_t line = run.events[i].line;
    if (line >= 2) {
      EXPECT_EQ(run.axis(i, 'Z'), line < 6 ? 20 : 0) << line;
    }
  }
}

TEST(FastToolSideCompensation, BlocksWithoutMovement) {
  const std::string head = kUntilted + "G41.6 D2 G01 X0 F100\nX100\n";
  const Vector q{100, 0, 0};
  check("one", setup("", -40, 0), head + "M08\nY100\nG40 Y150\n", q, {{-5, 5, 0}});
  check("two", setup("", -40, 0), head + "M08\nM09\nY100\nG40 Y150\n", q, {{0, 5, 0}});
  check("stop", setup("", -40, 0), head + "M00\nY100\nG40 Y150\n", q, {{0, 5, 0}});
  // Along the tool, and by nothing.
  check("along", setup("", -40, 0), head + "Z5\nY100\nG40 Y150\n", q, {{-5, 5, 0}});
  check("zero", setup("", -40, 0), head + "X100\nY100\nG40 Y150\n", q, {{-5, 5, 0}, {-5, 5, 0}});
  // No. 19630: under 3 in the plane counts as none, exactly 3 moves.
  const std::string limit = "19630=3\n";
  const std::string right = kUntilted + "G42.6 D2 G01 X0 F100\nX100\n";
  check("under the limit", setup(limit, -40, 0), right + "Y2.999 Z50\nX50\nG40 X-40\n", q, {{5, -5, 0}, {5, 5, 0}});
  check("at the limit", setup(limit, -40, 0), right + "Y3 Z50\nX50\nG40 X-40\n", q, {{5, -5, 0}});
  // A block that turns into the tool: it keeps the vector it starts with, and the next one starts from there.
  const ProgramRun kept(setup("", -40, 0), head + "Y100 I0 J1 K0\nX50\nG40 X-40\n");
  EXPECT_EQ(kept.alarm(), "");
  expect_heads(vectors_at(kept, q), {{-5, 5, 0}}, "kept, start");
  expect_heads(vectors_at(kept, {100, 100, 0}), {{-5, 5, 0}}, "kept, end");
}

// Whether a block moves is asked at each corner by itself; the derivations stand beside the same programs in the test
// of the model.
TEST(FastToolSideCompensation, MovesAtItsOwnEnd) {
  const auto mode = [](const std::string& parameters, const std::string& rest) {
    return ProgramRun(setup(parameters, -40, 0), kUntilted + "G01 G41.6 D1 X0 F100\nX100\n" + rest);
  };
  const auto expect = [](const std::string& what, const ProgramRun& run, const std::vector<Vector>& points,
                         const std::string& alarm = "") {
    EXPECT_EQ(run.alarm(), alarm) << what;
    const std::size_t moves = run.events.size() - (alarm.empty() ? 0U : 1U);
    ASSERT_EQ(moves, points.size() + 2) << what;  // the G43.5 block and the start-up
    for (std::size_t i = 0; i < points.size(); ++i) expect_near(point(run, i + 2), points[i], what);
  };
  expect("passed over", mode("", "Z50 I3 J0 K4\nY100\nG40 Y150\n"),
         {{90, 10, 0}, {92, -10, 56}, {92, 100, 56}, {100, 150, 50}});
  expect("behind the tool alone", mode("", "I3 J0 K4\nZ50\nY100\n"),
         {{100, 10, 0}, {100, 10, 0}, {92, -10, 56}, {92, 100, 56}});
  expect("two", mode("", "Z50 I3 J0 K4\nX130 Z90\nY100\n"),
         {{100, 10, 0}, {92, -10, 56}, {122, -10, 96}, {122, 100, 96}});
  expect("reversal", mode("\"19605#5\"=1\n", "Z50 I0 J3 K4\nX0\n"),
         {{110, 10, 0}, {110, -10, 0}, {110, -8, 56}, {0, -8, 56}});
  expect("interference", mode("", "Z3 I3 J0 K4\nY-100\n"), {{110, 10, 0}}, "PS0041@4");
  expect("Q", mode("", "Z50 I3 J0 K4 Q1\nY100\n"), {{90, 10, 0}, {100, -10, 50}, {92, 100, 56}});
  expect("value", mode("", "Z50 I3 J0 K4 D2\nY100\n"), {{90, 10, 0}, {96, -5, 53}, {96, 100, 53}});
  expect("repeated in it", mode("", "G41.6 Z50 I3 J0 K4\nY100\n"), {{100, 10, 0}, {92, -10, 56}, {92, 100, 56}});
  expect("repeated behind", mode("", "Z50 I3 J0 K4\nG41.6 Y100\n"), {{100, 10, 0}, {100, -10, 50}, {92, 100, 56}});
  expect("stop", mode("", "Z50 I3 J0 K4\nM00\n"), {{100, 10, 0}, {100, -10, 50}});
  expect("cancel", mode("", "G40 Z50 I3 J0 K4\n"), {{100, 10, 0}, {100, 0, 50}});
  expect("cancel along its tool", mode(kTypeB, "G40 Y-30 Z40 I0 J-3 K4\nX200\n"),
         {{110, 10, 0}, {110, 0, 0}, {110, -30, 40}, {200, -30, 40}});
  expect("cancel behind", mode("", "Z50 I3 J0 K4\nG40 Y100\n"), {{100, 10, 0}, {100, -10, 50}, {100, 100, 50}});
  // No. 19630 in its own plane, where Z is 3/5 as long.
  const std::string limit = "19630=6\n";
  expect("at the limit", mode(limit, "Z10 I3 J0 K4\nY100\n"), {{90, 10, 0}, {92, -10, 16}, {92, 100, 16}});
  expect("under it", mode(limit, "Z9.999 I3 J0 K4\nY100\n"), {{90, 10, 0}, {90, 10, 9.999}, {92, 100, 15.999}});
  expect("under it at its end alone", mode(limit, "X106 Z8.5 I3 J0 K4\nY100\n"),
         {{100, 10, 0}, {106, 10, 8.5}, {98, 100, 14.5}});
}

// Back the same way, which the tool sees as 7e-16 of its length. By hand: B30 points the tool along T = (1/2, 0, √3/2),
// the movement U = (10, 0, 10 √3 + h), h = 2.7e-14 by the digits of Z; u = U − (U.T) T = h/2 (−√3/2, 0, 1/2), and left
// of it is T x u/|u| = (0, −1, 0). Type B, a reversal under 1 degree: the start-up ends perpendicular to the way back,
// to the right of it, which is left of the way out.
TEST(FastToolSideCompensation, BackTheSameWayAlmostAlongTheTool) {
  const ProgramRun run(machine(kTypeB, 'B', 0, 0),
                       "G91 G01 B30. F100\nG42.2 D1 X10. Z17.3205080756888\n"
                       "X-10. Z-17.3205080756888\nG40 X50.\n");
  EXPECT_EQ(run.alarm(), "");
  ASSERT_GE(run.events.size(), 3U);
  expect_near(point(run, 1), {10, -10, 17.3205080756888}, "start-up");
  expect_near(point(run, 2), {0, -10, 0}, "end of the way back");
}

TEST(FastToolSideCompensation, Alarms) {
  const auto alarm = [](const std::string& parameters, const std::string& program) {
    return ProgramRun(machine(parameters, 'B', -40, 0), program).alarm();
  };
  const std::string on = "G41.2 D1 G01 X0 F100\n";
  EXPECT_EQ(alarm("", on + "G18 X5\n"), "PS0037@2");
  EXPECT_EQ(alarm("", on + "G04 X1\n"), "FORBIDDEN_IN_3D_COMPENSATION@2");
  EXPECT_EQ(alarm("", on + "G55\n"), "FORBIDDEN_IN_3D_COMPENSATION@2");
  EXPECT_EQ(alarm("", on + "X5 M08\n"), "FORBIDDEN_IN_3D_COMPENSATION@2");
  EXPECT_EQ(alarm("", on + "M08\nX5\n"), "");
  EXPECT_EQ(alarm("", on + "G41 X5\n"), "FORBIDDEN_IN_3D_COMPENSATION@2");
  EXPECT_EQ(alarm("", on + "G40 G53 X5\n"), "FORBIDDEN_IN_3D_COMPENSATION@2");
  EXPECT_EQ(alarm("", on + "G39\n"), "FORBIDDEN_IN_3D_COMPENSATION@2");
  EXPECT_EQ(alarm("", on + "G43.5\n"), "TOOL_DIRECTION_FORMAT@2");
  EXPECT_EQ(alarm("", "G41 D1 G01 X0 F100\nG41.2 X5\n"), "FORBIDDEN_IN_CUTTER_COMPENSATION@2");
  EXPECT_EQ(alarm("", "G41.3 D1 G01 F100\nX0\nG41.2\n"), "FORBIDDEN_IN_3D_COMPENSATION@3");
  EXPECT_EQ(alarm("", "G41.6 D1 G01 X0 F100\n"), "TOOL_SIDE_MODE@1");
  EXPECT_EQ(alarm("", "G43.5 H0\nG41.2 D1 G01 X0 F100\n"), "TOOL_SIDE_MODE@2");
  EXPECT_EQ(alarm("", "G43.5 H0\nG41.6 D1 G01 X0 F100\nB5\n"), "PS5460@3");
  EXPECT_EQ(alarm("", "G43.5 H0\nB5\n"), "PS5421@2");
  EXPECT_EQ(alarm("", "G43.5 H0\nX5 Q7\n"), "");
  EXPECT_EQ(alarm("", on + "X5 Q0\n"), "Q_FORMAT@2");
  EXPECT_EQ(alarm("", "G41.2 D1 G02 X0 R30 F100\n"), "PS0034@1");
  EXPECT_EQ(alarm("", on + "G40 G02 X5 R30\n"), "PS0034@2");
  EXPECT_EQ(alarm("", on + "X100\nG42.2 X50\nX0\n"), "");
  EXPECT_EQ(alarm("", on + "G42.2 X50\nX0\n"), "DIR_CHANGE_AT_STARTUP@2");
  // Against the programmed direction.
  EXPECT_EQ(alarm("", on + "X100\nY5\nX0\nX-50\n"), "PS0041@3");
  EXPECT_EQ(alarm("\"5008#0\"=1\n", on + "X100\nY5\nX0\nX-50\n"), "");

  EXPECT_EQ(alarm(kTypeC, on), "TYPE_C_FORMAT@1");
  EXPECT_EQ(alarm(kTypeC, "G01 G41.2 D1 F100\n"), "TYPE_C_FORMAT@1");
  EXPECT_EQ(alarm(kTypeC, "G01 G41.2 D1 F100\nZ5\n"), "TYPE_C_FORMAT@1");
  EXPECT_EQ(alarm(kTypeC, "G01 G41.2 D1 F100\nG40\n"), "TYPE_C_FORMAT@1");
  EXPECT_EQ(alarm(kTypeC, "G01 G41.2 D1 F100\nX5 E1\n"), "TYPE_C_FORMAT@1");
  EXPECT_EQ(alarm(kTypeC, "G01 G41.2 D1 F100\nX5\nG40 X0\n"), "TYPE_C_FORMAT@3");
  EXPECT_EQ(alarm(kTypeC, "G01 G41.2 D1 M00 F100\nX5\n"), "TYPE_C_FORMAT@1");
  EXPECT_EQ(alarm(kTypeC, "G02 G41.2 D1 F100\nX5 R200\n"), "TYPE_C_FORMAT@1");
  EXPECT_EQ(alarm(kTypeC, "G01 G41.2 D0 X5 F100\nG40 X0\n"), "");
}

TEST(FastToolSideCompensation, ArcPlane) {
  const auto warnings = [](const std::string& program) {
    const ProgramRun run(machine("", 'B', -40, 0), program);
    std::string text;
    for (const Event& event : run.events) {
      if (event.kind == spec::EventKind::warning)
        text += std::string(event.number.view()) + "@" + std::to_string(event.line) + " ";
      if (event.kind == spec::EventKind::undecided)
        text += std::string(event.number.view()) + "?" + std::to_string(event.line) + " ";
      if (event.kind == spec::EventKind::move) text += std::to_string(event.line) + " ";
    }
    return text;
  };
  const std::string arc = "X100\nG02 X90 Y-70 I-40 J-30\nG01 G40 X300 Y300\n";
  EXPECT_EQ(warnings("G41.2 D1 G01 X0 F100\n" + arc), "1 2 3 3 4 ");
  // Before the corner move that belongs to it.
  EXPECT_EQ(warnings("G01 B1 F100\nG41.2 D1 X0\n" + arc), "1 2 3 ARC_PLANE_MISMATCH@4 4 4 5 ");
  // On edge: undecided, the blocks before it given.
  EXPECT_EQ(warnings("G01 B90 F100\nG41.2 D1 Y-30\nY0\nG02 X90 Y-70 R80\n"), "1 2 3 fanuc.tool-side.arc-plane?4 ");
}

// No. 5010 at a corner behind an arc, the tool along Z: the vector along the perpendicular and the prolonged one are
// (-8, 6) and (-2, 14), exactly 10 apart, and (2, 14) follows 4 behind. Doubles tell neither limit from 10.
TEST(FastToolSideCompensation, SmallMovementBehindAnArcToTheLastDigit) {
  const auto behind_an_arc = [](const char* what, const std::string& limit, const Heads& heads) {
    check(what, machine("5010=\"" + limit + "\"\n", 'B', -40, -20),
          "G41.2 D1 G01 X0 F100\nX60\nG03 X100 Y0 J50\nG01 X130 Y-40\nG40 X160 Y-80\n", {100, 0, 0}, heads);
  };
  behind_an_arc("below", "9.999999999999", {{-8, 6, 0}, {-2, 14, 0}});
  behind_an_arc("tie", "10", {{-8, 6, 0}, {2, 14, 0}});
}

TEST(FastToolSideCompensation, CancelWithoutMovement) {
  const std::string head = kUntilted + "G41.6 D2 G01 X0 F100\nX100\n";
  const ProgramRun run(setup("", -40, 0), head + "G40\nZ5\nX150\n");
  EXPECT_EQ(run.alarm(), "");
  EXPECT_EQ(owners(run), "1pr 2s 3p 5p 6x ");
  expect_heads(vectors_at(run, {100, 0, 0}), {{0, 5, 0}}, "kept");
  expect_heads(vectors_at(run, {100, 0, 5}), {{0, 5, 0}}, "kept");
  expect_heads(vectors_at(run, {150, 0, 5}), {{0, 0, 0}}, "removed");
  const ProgramRun again(setup("", -40, 0), head + "G40\nG41.6 X150\n");
  ASSERT_FALSE(again.events.empty());
  EXPECT_EQ(again.events.back().number.view(), "fanuc.cutter-c.restart-before-removal");
}

TEST(FastToolSideCompensation, Setups) {
  EXPECT_ANY_THROW(ProgramRun(setup("6261=181\n", 0, 0), ""));
  EXPECT_ANY_THROW(ProgramRun(setup("6261=-1\n", 0, 0), ""));
  EXPECT_NO_THROW(ProgramRun(setup("6261=180\n", 0, 0), ""));
}

}  // namespace
}  // namespace toolcomp::fast
