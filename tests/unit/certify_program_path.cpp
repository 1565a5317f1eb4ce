// SPDX-License-Identifier: Apache-2.0
// The pieces of programs, by hand and by formulas of their own; under tool center point control also against the
// samples of the model.
#include "certify/trace/program_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "certify/convert.h"
#include "fuzz/gen/generator.h"
#include "judge/oracle/verdict.h"
#include "spec/language/event_names.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"
#include "tests/effort.h"

namespace toolcomp::certify {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
// Of coordinates up to a thousand.
constexpr double kRounding = 1e-12;

spec::Case make(const std::string& setup, std::string program) {
  spec::Case c;
  c.setup = spec::read_setup_toml("control=\"fanuc\"\nunits=\"mm\"\n" + setup, "setup.toml");
  c.program = std::move(program);
  return c;
}
const std::string kXyz = "axes=[\"X\",\"Y\",\"Z\"]\n";

TraceSpace recorded(const spec::Case& c, const std::string& letters) {
  TraceSpace space;
  for (const char letter : letters)
    (spec::is_rotary_axis(letter) ? space.rotary : space.linear).push_back(c.setup.axes.index(letter));
  return space;
}

struct Ran {
  std::vector<PathPiece> pieces;
  std::string alarm;
  std::string undecided;
};

Ran run(const spec::Case& c, const std::string& letters, double tolerance = 1, const ProgramPathOptions& options = {}) {
  ProgramPath path(c, recorded(c, letters), {tolerance, tolerance}, options);
  Ran result;
  for (PathPiece piece; path.next(piece);) result.pieces.push_back(piece);
  result.alarm = path.alarm();
  result.undecided = path.undecided();
  // One behind the other, and within what is promised.
  for (std::size_t i = 0; i < result.pieces.size(); ++i) {
    const PathPiece& piece = result.pieces[i];
    if (i > 0) {
      EXPECT_EQ(piece.begin, result.pieces[i - 1].end) << i;
    }
    EXPECT_LE(piece.error.linear, tolerance / 100) << i;
    EXPECT_LE(piece.error.rotary, tolerance / 100) << i;
    EXPECT_EQ(piece.curved, piece.error.linear > 0 || piece.error.rotary > 0) << i;
  }
  return result;
}

void expect_straight(const PathPiece& piece, const AxisPoint& begin, const AxisPoint& end, std::uint64_t line) {
  EXPECT_EQ(piece.begin, begin);
  EXPECT_EQ(piece.end, end);
  EXPECT_EQ(piece.line, line);
  EXPECT_EQ(piece.error.linear, 0);
  EXPECT_TRUE(piece.corner);
  EXPECT_FALSE(piece.curved);
}

// Lines and arcs

TEST(ProgramPath, LinesAreOnePieceEach) {
  const spec::Case c = make(kXyz + "[position]\nX=1.5\n", "G90 G01 X10. F100\nN20 Y10. Z3.\nG04 X1.\nZ5.\nG00 X0\n");
  const Ran all = run(c, "XYZ");
  ASSERT_EQ(all.pieces.size(), 4U);
  expect_straight(all.pieces[0], {1.5}, {10}, 1);
  expect_straight(all.pieces[1], {10}, {10, 10, 3}, 2);
  expect_straight(all.pieces[2], {10, 10, 3}, {10, 10, 5}, 4);
  expect_straight(all.pieces[3], {10, 10, 5}, {0, 10, 5}, 5);
  EXPECT_EQ(all.pieces[0].n, std::nullopt);
  EXPECT_EQ(all.pieces[1].n, 20U);
  // Only what is recorded is in them, and line 4 moves none of that.
  const Ran some = run(c, "Y");
  ASSERT_EQ(some.pieces.size(), 1U);
  expect_straight(some.pieces[0], {}, {0, 10}, 2);
}

// A quarter of a circle of radius 10 about (0, 0) from the first axis of the plane to the second: the chords of n parts
// are off by 10 (1 - cos(45°/n)), which 10 (90°/n)²/8 bounds; n = 19 would do for 15/16 of a hundredth, and two halves
// of 10 are made of it.
TEST(ProgramPath, ArcsInAllPlanes) {
  struct Plane {
    std::string position;
    std::string words;
    std::size_t first;
    std::size_t second;
  };
  for (const Plane& plane :
       {Plane{"X=10\n", "G17 G03 X0 Y10. I-10. F100\n", 0, 1}, Plane{"Z=10\n", "G18 G03 Z0 X10. K-10. F100\n", 2, 0},
        Plane{"Y=10\n", "G19 G03 Y0 Z10. J-10. F100\n", 1, 2}}) {
    SCOPED_TRACE(plane.words);
    const Ran ran = run(make(kXyz + "[position]\n" + plane.position, plane.words), "XYZ");
    ASSERT_EQ(ran.pieces.size(), 20U);
    const double step = std::numbers::pi / 2 / 20;
    for (std::size_t i = 0; i < 20; ++i) {
      const PathPiece& piece = ran.pieces[i];
      const double angle = static_cast<double>(i + 1) * step;
      EXPECT_NEAR(piece.end[plane.first], 10 * std::cos(angle), kRounding);
      EXPECT_NEAR(piece.end[plane.second], 10 * std::sin(angle), kRounding);
      EXPECT_EQ(piece.corner, i == 19);
      EXPECT_TRUE(piece.curved);
      EXPECT_GE(piece.error.linear, 10 * (1 - std::cos(step / 2)));
      EXPECT_LE(piece.error.linear, 1.1 * 10 * step * step / 8);
    }
  }
}

// Down from (10, 0) by half a turn clockwise; Z goes evenly with the angle.
TEST(ProgramPath, AHelixGoesEvenly) {
  const Ran ran = run(make(kXyz + "[position]\nX=10\n", "G02 X-10. Y0 Z-6. I-10. F100\nG01 X-10. Y0\n"), "XYZ", 0.1);
  ASSERT_GT(ran.pieces.size(), 40U);
  EXPECT_LT(ran.pieces.size(), 200U);
  for (const PathPiece& piece : ran.pieces) {
    const double angle = -std::atan2(piece.end[1], piece.end[0]);
    const double turned = piece.corner ? std::numbers::pi : angle;
    EXPECT_NEAR(std::hypot(piece.end[0], piece.end[1]), 10, kRounding);
    EXPECT_NEAR(piece.end[2], -6 * turned / std::numbers::pi, kRounding);
  }
  EXPECT_TRUE(ran.pieces.back().corner);
}

// From radius 10 at 0 degrees to radius 30 at 90: r = 10 + 20 t, and |f"| = √((r (π/2)²)² + (2 20 π/2)²) by the
// fraction t of the angle.
TEST(ProgramPath, ASpiralGrowsEvenly) {
  const Ran ran = run(make(kXyz + "[position]\nX=10\n", "G03 X0 Y30. I-10. F100\n"), "XYZ", 0.1);
  double before = 0;
  for (const PathPiece& piece : ran.pieces) {
    const double part = std::atan2(piece.end[1], piece.end[0]) / (std::numbers::pi / 2);
    EXPECT_NEAR(std::hypot(piece.end[0], piece.end[1]), 10 + 20 * part, kRounding);
    // The curve in the middle of the part is within the error of the middle of the chord.
    const double middle = (before + part) / 2;
    const double radius = 10 + 20 * middle;
    const double x = radius * std::cos(middle * std::numbers::pi / 2);
    const double y = radius * std::sin(middle * std::numbers::pi / 2);
    const double off = std::hypot(x - (piece.begin[0] + piece.end[0]) / 2, y - (piece.begin[1] + piece.end[1]) / 2);
    EXPECT_LE(off, piece.error.linear);
    EXPECT_GE(off * 2, piece.error.linear);
    const double all = std::hypot((10 + 20 * part) * std::numbers::pi / 2, 2 * 20) * std::numbers::pi / 2;
    EXPECT_LE(piece.error.linear, 1.5 * all * (part - before) * (part - before) / 8);
    before = part;
  }
  EXPECT_NEAR(before, 1, kRounding);
}

// The length offset moves the circle: in G18 its centre is at Z 100 above the programmed one.
TEST(ProgramPath, AnArcWithLengthOffset) {
  const Ran ran = run(make(kXyz + "[offsets.H]\n1=100\n", "G43 G00 X0 Z0 H1\nG18 G03 X20. Z0 I10. F100\n"), "XZ");
  ASSERT_GT(ran.pieces.size(), 10U);
  expect_straight(ran.pieces[0], {}, {0, 0, 100}, 1);
  for (std::size_t i = 1; i < ran.pieces.size(); ++i)
    EXPECT_NEAR(std::hypot(ran.pieces[i].end[0] - 10, ran.pieces[i].end[2] - 100), 10, kRounding);
  EXPECT_EQ(ran.pieces.back().end, (AxisPoint{20, 0, 100}));
}

// A whole circle ends where it begins, and of one recorded axis there and back is left.
TEST(ProgramPath, AWholeCircle) {
  const spec::Case c = make(kXyz, "G02 I10. F100\n");
  const Ran both = run(c, "XY");
  EXPECT_GT(both.pieces.size(), 60U);
  const Ran one = run(c, "X");
  double greatest = 0;
  for (const PathPiece& piece : one.pieces) greatest = std::max(greatest, piece.end[0]);
  EXPECT_NEAR(greatest, 20, 0.01);
  EXPECT_EQ(one.pieces.back().end, AxisPoint{});
  EXPECT_TRUE(run(c, "Z").pieces.empty());
}

// Coordinates

const std::string kOrigins =
    "[workpiece.G54]\nX=100\nY=50\n[workpiece.G55]\nX=130\nY=50\n[workpiece.G56]\nX=100\nY=50\n";

TEST(ProgramPath, TheSystemInForceIsNoJump) {
  const Ran ran = run(make(kXyz + kOrigins, "G90 G54 G01 X10. F100\nG54 X20.\nG56 X30.\n"), "XYZ");
  ASSERT_EQ(ran.pieces.size(), 3U);
  for (const PathPiece& piece : ran.pieces) EXPECT_FALSE(piece.jump);
}

// The origin of G55 is 30 further: X10 in G54 is X-20 in it.
TEST(ProgramPath, AnotherSystemIsAJump) {
  const spec::Case c = make(kXyz + kOrigins, "G90 G01 X10. F100\nN20 G55 X5.\nG54\nM30\n");
  const Ran ran = run(c, "XYZ");
  ASSERT_EQ(ran.pieces.size(), 4U);
  EXPECT_TRUE(ran.pieces[1].jump);
  expect_straight(ran.pieces[1], {10}, {-20}, 2);
  EXPECT_EQ(ran.pieces[1].n, 20U);
  EXPECT_FALSE(ran.pieces[2].jump);
  expect_straight(ran.pieces[2], {-20}, {5}, 2);
  EXPECT_TRUE(ran.pieces[3].jump);
  expect_straight(ran.pieces[3], {5}, {35}, 3);
  // Of the axes that are recorded none jumps.
  EXPECT_TRUE(run(c, "Y").pieces.empty());
}

TEST(ProgramPath, ShiftsJumpBehindTheirBlock) {
  const Ran ran = run(make(kXyz, "G90 G01 X10. Y4. F100\nG92 X0 Z2.\nX5.\n"), "XYZ");
  ASSERT_EQ(ran.pieces.size(), 3U);
  EXPECT_TRUE(ran.pieces[1].jump);
  expect_straight(ran.pieces[1], {10, 4}, {0, 4, 2}, 2);
  expect_straight(ran.pieces[2], {0, 4, 2}, {5, 4, 2}, 3);
}

// An arc behind a jump goes about its centre by the new name: from (10, 0) in G54, (-20, 0) in G55, about (-10, 0).
TEST(ProgramPath, AnArcBehindAJump) {
  const Ran ran = run(make(kXyz + kOrigins, "G90 G01 X10. F100\nG55 G03 X0 Y0 I10.\n"), "XY");
  ASSERT_GT(ran.pieces.size(), 10U);
  for (std::size_t i = 2; i < ran.pieces.size(); ++i)
    EXPECT_NEAR(std::hypot(ran.pieces[i].end[0] + 10, ran.pieces[i].end[1]), 10, kRounding) << i;
}

// A held block of cutter compensation C goes out behind the block of the jump, and before the jump.
TEST(ProgramPath, JumpsKeepTheOrderOfHeldBlocks) {
  const Ran ran = run(make("cutter_compensation=\"C\"\n" + kXyz + kOrigins + "[offsets.D]\n1=1\n",
                           "G90 G00 X0 Y0\nG41 D1 G01 Y10. F100\nY20.\nG40 X10.\nG55\nG01 X0\n"),
                      "XYZ");
  EXPECT_TRUE(std::ranges::is_sorted(ran.pieces, {}, &PathPiece::line));
  const auto jump = std::ranges::find_if(ran.pieces, [](const PathPiece& piece) { return piece.jump; });
  ASSERT_NE(jump, ran.pieces.end());
  EXPECT_EQ(jump->line, 5U);
  EXPECT_EQ(jump->begin, (AxisPoint{10, 20}));
  EXPECT_EQ(jump->end, (AxisPoint{-20, 20}));
}

TEST(ProgramPath, MachineCoordinatesNeverJump) {
  ProgramPathOptions options;
  options.frame = PathFrame::machine;
  const Ran ran =
      run(make(kXyz + kOrigins, "G90 G01 X10. F100\nG55 X5.\nG92 X0\nX1.\nG03 X1. Y0 I-10.\n"), "XY", 1, options);
  ASSERT_GT(ran.pieces.size(), 10U);
  expect_straight(ran.pieces[0], {100, 50}, {110, 50}, 1);
  expect_straight(ran.pieces[1], {110, 50}, {135, 50}, 2);
  expect_straight(ran.pieces[2], {135, 50}, {136, 50}, 4);
  for (std::size_t i = 3; i < ran.pieces.size(); ++i)
    EXPECT_NEAR(std::hypot(ran.pieces[i].end[0] - 126, ran.pieces[i].end[1] - 50), 10, kRounding) << i;
  for (const PathPiece& piece : ran.pieces) EXPECT_FALSE(piece.jump);
}

// Rapids, ends

TEST(ProgramPath, RapidsMayBeFree) {
  const spec::Case c = make(kXyz, "G90 G00 X10. Y5.\nG01 X20. F100\n");
  const Ran judged = run(c, "XYZ");
  EXPECT_FALSE(judged.pieces[0].free);
  ProgramPathOptions options;
  options.judge_rapids = false;
  const Ran ran = run(c, "XYZ", 1, options);
  ASSERT_EQ(ran.pieces.size(), 2U);
  EXPECT_TRUE(ran.pieces[0].free);
  EXPECT_FALSE(ran.pieces[1].free);
}

TEST(ProgramPath, EndsWithTheAlarm) {
  std::size_t events = 0;
  ProgramPathOptions options;
  options.on_event = [&events](const model::Event&) { ++events; };
  const Ran ran = run(make(kXyz, "G90 G01 X10. F100\nG02 X20.\nX30.\n"), "XYZ", 1, options);
  EXPECT_EQ(ran.pieces.size(), 1U);
  EXPECT_EQ(ran.alarm, "PS0022 in line 2");
  EXPECT_EQ(ran.undecided, "");
  EXPECT_EQ(events, 2U);
}

TEST(ProgramPath, SaysWhatIsNotDecided) {
  spec::Case c;
  c.setup = spec::read_setup_toml("control=\"heidenhain\"\naxes=[\"X\",\"Y\",\"Z\"]\n[[tool]]\nnumber=1\nR=5\n",
                                  "setup.toml");
  c.program =
      "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 L X+0 Y+0 Z+0 R0 FMAX\n3 L X+10 RL F100\n4 L X+20\n5 END PGM A MM\n";
  const Ran ran = run(c, "XYZ");
  EXPECT_NE(ran.undecided.find("line 4 (heidenhain.peripheral.out-of-scope)"), std::string::npos) << ran.undecided;
  ProgramPathOptions options;
  options.frame = PathFrame::machine;
  EXPECT_THROW(run(c, "XYZ", 1, options), spec::InputError);
}

TEST(ProgramPath, TolerancesArePositive) {
  const spec::Case c = make(kXyz, "G00 X1.\n");
  for (const double tolerance :
       {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(ProgramPath(c, recorded(c, "X"), {tolerance, 1}), spec::InputError) << tolerance;
}

// Pieces are made as they are asked for: what stands far behind is not read.
TEST(ProgramPath, ReadsNoFurtherThanItMust) {
  std::uint64_t seen = 0;
  ProgramPathOptions options;
  options.on_event = [&seen](const model::Event& event) { seen = event.line; };
  const spec::Case c = make(kXyz, "G90 G01 X10. F100\nX20.\nX30.\nX40.\n");
  ProgramPath path(c, recorded(c, "X"), {1, 1}, options);
  PathPiece piece;
  ASSERT_TRUE(path.next(piece));
  EXPECT_EQ(seen, 1U);
  ASSERT_TRUE(path.next(piece));
  EXPECT_EQ(seen, 2U);
}

// Tool center point control

const std::string kFive = "[offsets.H]\n1=100\n2=150\n";
// The A table carries the C table.
const std::string kTable =
    "axes=[\"X\",\"Y\",\"Z\",\"A\",\"C\"]\n[parameters]\n19680=12\n19681=4\n19682=1\n19684=1\n19686=5\n19687=3\n"
    "19689=1\n";
// C carries B.
const std::string kHead =
    "axes=[\"X\",\"Y\",\"Z\",\"B\",\"C\"]\n[parameters]\n19680=2\n19681=5\n19682=3\n19686=4\n19687=2\n";
// The slave about (0, 1, 1).
const std::string kNutating =
    "axes=[\"X\",\"Y\",\"Z\",\"B\",\"C\"]\n[parameters]\n19680=2\n19681=5\n19682=3\n19686=4\n19687=5\n19688=45\n";
// B turns the tool, C the table.
const std::string kMixed =
    "axes=[\"X\",\"Y\",\"Z\",\"B\",\"C\"]\n[parameters]\n19680=21\n19681=4\n19682=2\n19686=5\n19687=3\n19689=1\n";

// The curve at t, by a formula of its own.
using Formula = std::function<AxisPoint(double)>;

// The last axis turns evenly, by `turn` degrees, and so tells the fraction of the block. Inside every piece the curve
// is within the error of the place at the same fraction, and the error is not many times what it is off.
void expect_curve(const Ran& ran, std::uint64_t line, double turn, const Formula& at, double most = 4) {
  std::size_t seen = 0;
  double last = 0;
  double loosest = 0;
  for (const PathPiece& piece : ran.pieces) {
    if (piece.line != line) continue;
    ++seen;
    const double from = piece.begin[4] / turn;
    const double to = piece.end[4] / turn;
    EXPECT_NEAR(from, last, kRounding);
    EXPECT_GT(to, from);
    last = to;
    double worst = 0;
    for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const AxisPoint exact = at(from + part * (to - from));
      double off = 0;
      for (const std::size_t i : {0U, 1U, 2U})
        off = std::hypot(off, exact.at(i) - piece.begin.at(i) - part * (piece.end.at(i) - piece.begin.at(i)));
      EXPECT_LE(off, piece.error.linear + kRounding);
      worst = std::max(worst, off);
    }
    loosest = std::max(loosest, piece.error.linear / worst);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(seen, 0U);
  EXPECT_NEAR(last, 1, kRounding);
  EXPECT_LT(loosest, most);
}

// The tip goes from X100 to X20 on the table, which turns 16 times under it, left-handed.
TEST(ProgramPath, SixteenTurnsOfATable) {
  const Ran ran =
      run(make(kTable + kFive, "G90 G00 X100. Y0 Z50.\nG43.4 H1\nG01 X20. C5760. F1000\nG49\n"), "XYZAC", 0.1);
  expect_curve(ran, 3, 5760, [](double t) {
    const double radius = 100 - 80 * t;
    const double c = 5760 * t * kDegree;
    return AxisPoint{radius * std::cos(c), -radius * std::sin(c), 150};
  });
  // The best there is: ∫ √(|f"| / (8 · 0.001)) dt = 100.5 ∫ √((100 - 80 t) / 0.008) dt = 8531.
  EXPECT_LT(ran.pieces.size(), 2 * 8531U);
}

// In machine coordinates the same circle stands about the centre of the table.
TEST(ProgramPath, TurnsInMachineCoordinates) {
  ProgramPathOptions options;
  options.frame = PathFrame::machine;
  const Ran ran =
      run(make(kTable + kFive + "[workpiece.G54]\nX=30\nZ=7\n", "G90 G00 X70. Y0 Z50.\nG43.4 H1\nG01 C3600. F1000\n"),
          "XYZAC", 1, options);
  expect_curve(ran, 3, 3600, [](double t) {
    const double c = 3600 * t * kDegree;
    return AxisPoint{100 * std::cos(c), -100 * std::sin(c), 157};
  });
}

// B stands at 30 degrees, and the control point runs about the tip at 100 sin 30 = 50; the tip climbs by 20.
TEST(ProgramPath, TenTurnsOfAHead) {
  const Ran ran = run(make(kHead + kFive, "G90 G00 X5. Y0 Z50.\nB30.\nG43.4 H1\nG01 Z70. C3600. F1000\n"), "XYZBC");
  expect_curve(ran, 4, 3600, [](double t) {
    const double c = 3600 * t * kDegree;
    return AxisPoint{5 + 50 * std::cos(c), 50 * std::sin(c), 50 + 20 * t + 100 * std::cos(30 * kDegree)};
  });
}

// The tool grows from 100 to 150 on the way.
TEST(ProgramPath, TheLengthGrowsEvenly) {
  const Ran ran = run(make(kHead + kFive, "G90 G00 X0 Y0 Z0\nB90.\nG43.4 H1\nG01 X0 C720. H2 F1000\n"), "XYZBC");
  expect_curve(ran, 4, 720, [](double t) {
    const double c = 720 * t * kDegree;
    const double length = 100 + 50 * t;
    return AxisPoint{length * std::cos(c), length * std::sin(c), 0};
  });
}

// The table turns the tip, and the head tilts the tool to X: B goes from 0 to 90.
TEST(ProgramPath, TenTurnsOfAMixedMachine) {
  const Ran ran = run(make(kMixed + kFive, "G90 G00 X40. Y0 Z0\nG43.4 H1\nG01 B90. C3600. F1000\n"), "XYZBC");
  expect_curve(ran, 3, 3600, [](double t) {
    const double c = 3600 * t * kDegree;
    const double b = 90 * t * kDegree;
    return AxisPoint{40 * std::cos(c) + 100 * std::sin(b), -40 * std::sin(c), 100 * std::cos(b)};
  });
}

// An arc of the tip on a table that turns: radius 10 about (50, 0), by half a turn, while C goes by 90 degrees.
TEST(ProgramPath, AnArcOnATurningTable) {
  const Ran ran =
      run(make(kTable + kFive, "G90 G00 X60. Y0 Z0\nG43.4 H1\nG03 X40. Y0 I-10. C90. F1000\n"), "XYZAC", 0.1);
  expect_curve(ran, 3, 90, [](double t) {
    const double angle = 180 * t * kDegree;
    const double x = 50 + 10 * std::cos(angle);
    const double y = 10 * std::sin(angle);
    const double c = 90 * t * kDegree;
    return AxisPoint{x * std::cos(c) + y * std::sin(c), y * std::cos(c) - x * std::sin(c), 100};
  });
}

// Against the samples of the model

// The least number of errors that the piece has to be off the position: the greater of both kinds at the best place.
double errors_off(const PathPiece& piece, const AxisPoint& p, const TraceSpace& space) {
  double scale = 1;
  for (const double x : p) scale = std::max(scale, std::fabs(x));
  const double rounding = 64 * std::numeric_limits<double>::epsilon() * scale;
  for (const auto& [axes, error] : {std::pair(&space.linear, piece.error.linear), {&space.rotary, piece.error.rotary}})
    for (const std::size_t i : *axes) {
      const auto [low, high] = std::minmax(piece.begin.at(i), piece.end.at(i));
      if (p.at(i) < low - error - rounding || p.at(i) > high + error + rounding)
        return std::numeric_limits<double>::infinity();
    }
  const auto off = [&](double part) {
    Distance d;
    for (const std::size_t i : space.linear)
      d.linear = std::hypot(d.linear, p.at(i) - piece.begin.at(i) - part * (piece.end.at(i) - piece.begin.at(i)));
    for (const std::size_t i : space.rotary)
      d.rotary =
          std::max(d.rotary, std::fabs(p.at(i) - piece.begin.at(i) - part * (piece.end.at(i) - piece.begin.at(i))));
    return std::max(d.linear / (piece.error.linear + rounding), d.rotary / (piece.error.rotary + rounding));
  };
  double low = 0;
  double high = 1;
  for (int i = 0; i < 100; ++i) {
    const double a = low + (high - low) / 3;
    const double b = high - (high - low) / 3;
    (off(a) < off(b) ? high : low) = off(a) < off(b) ? b : a;
  }
  return std::min({off(low), off(0), off(1)});
}

// Every sample lies on a piece of its block that is not before those of the samples before it, and every move has its
// corner, up to where the path is not known any more.
std::size_t expect_samples(spec::Case c, const std::string& letters, double tolerance, std::uint32_t samples) {
  const Ran ran = run(c, letters, tolerance);
  const TraceSpace space = recorded(c, letters);
  c.samples = samples;
  std::size_t seen = 0;
  std::size_t at = 0;
  const bool calls = c.program.find("M98") != std::string::npos;
  AxisPoint last = ran.pieces.empty() ? AxisPoint{} : ran.pieces.front().begin;
  const auto search = [&](const spec::Event<double>& event, const auto& is_it) {
    // Where programs are called lines do not ascend.
    for (std::size_t i = at; i < ran.pieces.size() && (calls || ran.pieces[i].line <= event.line); ++i) {
      if (ran.pieces[i].jump) last = ran.pieces[i].end;
      if (ran.pieces[i].line != event.line || ran.pieces[i].jump || !is_it(ran.pieces[i])) continue;
      at = i;
      return true;
    }
    return false;
  };
  for (const model::Event& exact : judge::run_model(c).events) {
    const spec::Event<double> event = in_double(exact);
    if (event.kind == spec::EventKind::undecided) break;
    if (ran.undecided.find("line " + std::to_string(event.line) + " ") != std::string::npos) break;
    AxisPoint p = last;
    for (std::size_t i = 0; i < p.size(); ++i)
      if (event.axes.has(i)) p.at(i) = event.axes[i];
    bool found = true;
    if (event.kind == spec::EventKind::move) {
      // One that moves nothing has no piece.
      found = search(event, [&](const PathPiece& piece) { return piece.corner && piece.end == p; }) || p == last;
      last = p;
    } else if (event.kind == spec::EventKind::sample) {
      found = search(event, [&](const PathPiece& piece) { return errors_off(piece, p, space) <= 1; }) || p == last;
      ++seen;
    } else if (event.kind == spec::EventKind::hole) {
      last = p;
    }
    EXPECT_TRUE(found) << spec::name(event.kind) << " of line " << event.line << " at " << event.t_numerator << "/"
                       << event.t_denominator;
    if (!found) return seen;
  }
  return seen;
}

TEST(ProgramPath, DenseSamplesOfSixteenTurns) {
  const spec::Case c = make(kTable + kFive, "G90 G00 X100. Y0 Z50.\nG43.4 H1\nG01 X20. A30. C5760. F1000\nG49\n");
  const auto samples = static_cast<std::uint32_t>(test::random_cases(20'000));
  EXPECT_EQ(expect_samples(c, "XYZAC", 1, samples), samples - 1);
}

// Across the pole at a distance: from a direction in the plane of X and Z to the opposite side, J aside. The work-side
// axis swings by nearly half a turn within about that distance of the way.
TEST(ProgramPath, PastThePole) {
  struct Pass {
    std::string words;  // I and K of a direction 45 degrees from Z; J is 0.0017
    double degrees;
  };
  for (const Pass& pass : {Pass{"1.", 1e-1}, Pass{"100.", 1e-3}, Pass{"100000.", 1e-6}}) {
    for (const std::string& machine : {kHead, kNutating, kTable, kMixed}) {
      SCOPED_TRACE(pass.words + " " + machine);
      const spec::Case c =
          make(machine + kFive, "G90 G00 X10. Y20. Z30.\nG43.5 H1 P1\nG01 I" + pass.words + " J0.0017 K" + pass.words +
                                    "\nX20. Y30. I-" + pass.words + " J0.0017 K" + pass.words + " F1000\n");
      const std::string letters = c.setup.axes.letters();
      EXPECT_EQ(expect_samples(c, letters, 1, 100), 2 * 99U);
      const Ran ran = run(c, letters);
      EXPECT_TRUE(ran.alarm.empty() && ran.undecided.empty()) << ran.alarm << ran.undecided;
      if (machine == kNutating) continue;  // its tool side swings, too
      double swung = 0;
      for (const PathPiece& piece : ran.pieces)
        if (piece.line == 4) swung += std::fabs(piece.end[4] - piece.begin[4]);
      EXPECT_NEAR(swung, 180, 3 * pass.degrees);
    }
  }
}

// The tool stands along C and is to lean to X, which the A table can but do with C at a right angle: C turns first, and
// the control point with the tip on the table, about the centre at 50. Then A turns alone.
TEST(ProgramPath, ATurnBeforeABlockIsACircle) {
  const Ran ran = run(make(kTable + kFive, "G90 G00 X50. Y0 Z0\nG43.5 H1 P1\nG01 I1. K1. F1000\n"), "XYZAC", 0.1);
  std::vector<PathPiece> turn;
  std::ranges::copy_if(ran.pieces, std::back_inserter(turn), [](const PathPiece& piece) {
    return piece.line == 3 && piece.begin[3] == 0 && piece.end[3] == 0;
  });
  ASSERT_GT(turn.size(), 100U);
  EXPECT_LT(turn.size(), 400U);
  for (const PathPiece& piece : turn) {
    EXPECT_NEAR(std::hypot(piece.end[0], piece.end[1]), 50, kRounding);
    EXPECT_EQ(piece.end[2], 100);
    EXPECT_EQ(piece.corner, &piece == &turn.back());
  }
  EXPECT_NEAR(std::fabs(turn.back().end[4]), 90, kRounding);
  EXPECT_GT(ran.pieces.back().error.linear, 0);
}

// G49 leaves the axes where they are, by which an arc behind it counts: about (50, 0) in X and Y, on the level of Z.
TEST(ProgramPath, AnArcBehindToolCenterPointControl) {
  const Ran ran = run(make(kTable + kFive, "G90 G00 X60. Y0 Z0\nG43.4 H1\nG01 C360. F1000\nG49\nG03 X40. Y0 I-10.\n"),
                      "XYZAC", 0.1);
  std::size_t seen = 0;
  for (const PathPiece& piece : ran.pieces) {
    if (piece.line != 5) continue;
    ++seen;
    EXPECT_NEAR(std::hypot(piece.end[0] - 50, piece.end[1]), 10, kRounding);
    EXPECT_EQ(piece.end[2], 100);
  }
  EXPECT_GT(seen, 50U);
}

// Through it the work-side axis stands.
TEST(ProgramPath, ThroughThePole) {
  for (const std::string& machine : {kHead, kNutating, kTable, kMixed}) {
    SCOPED_TRACE(machine);
    const spec::Case c = make(machine + kFive,
                              "G90 G00 X10. Y20. Z30.\nG43.5 H1 P1\nG01 I1. K1.\nX20. Y30. I-1. K3. F1000\n"
                              "I1. J2. K2.\nI0. J0. K1.\nI1. J1. K4.\n");
    EXPECT_GT(expect_samples(c, c.setup.axes.letters(), 0.1, 100), 4 * 99U);
    const Ran ran = run(c, c.setup.axes.letters(), 0.1);
    EXPECT_TRUE(ran.alarm.empty() && ran.undecided.empty()) << ran.alarm << ran.undecided;
    EXPECT_LT(ran.pieces.size(), 3000U);
  }
}

// A horizontal tool of a nutating head stands at the edge of its reach.
TEST(ProgramPath, AlongTheEdgeOfReach) {
  const spec::Case c =
      make(kNutating + kFive, "G90 G00 X10. Y20. Z30.\nG43.5 H1 P1\nG01 I1. F1000\nX20. J1.\nI1. K1.\nI1. J1.\n");
  EXPECT_EQ(expect_samples(c, "XYZBC", 0.1, 50), 4 * 49U);
  EXPECT_LT(run(c, "XYZBC", 0.1).pieces.size(), 3000U);
}

// Where it leaves the edge doubles tell its angles to about the root of an ulp, which is more than a hundredth of this
// tolerance: those pieces, with B at 180 degrees, say so, and no others.
TEST(ProgramPath, TheEdgeOfReachAtAFineTolerance) {
  constexpr double tolerance = 0.001;
  const spec::Case c = make(kNutating + kFive, "G90 G00 X10. Y20. Z30.\nG43.5 H1 P1\nG01 I1. F1000\nI1. K1.\n");
  ProgramPath path(c, recorded(c, "XYZBC"), {tolerance, tolerance});
  double wide = 0;
  for (PathPiece piece; path.next(piece);) {
    EXPECT_LE(std::max(piece.error.linear, piece.error.rotary), tolerance * 16 / 100);
    if (std::max(piece.error.linear, piece.error.rotary) <= tolerance / 100) continue;
    EXPECT_NEAR(piece.end[3], 180, tolerance);
    wide += std::fabs(piece.end[3] - piece.begin[3]);
  }
  EXPECT_EQ(path.undecided(), "");
  EXPECT_GT(wide, 0);
  EXPECT_LT(wide, tolerance);
}

// Without rotary axes a direction goes along the great circle. To the opposite one there is none: the direction would
// jump at the end of the block, by two tool lengths in Y and Z here. No recording is judged by that.
TEST(ProgramPath, TheToolTurnsToTheOppositeDirection) {
  const spec::Case c = make(kXyz + kFive, "G43.5 H1 J-3 K4\nG01 X10. F1000\nX20. J3 K-4\nX30.\n");
  const Ran ran = run(c, "XYZ");
  EXPECT_NE(ran.undecided.find("inside line 3 the tool turns to the opposite direction"), std::string::npos)
      << ran.undecided;
  ASSERT_FALSE(ran.pieces.empty());
  EXPECT_EQ(ran.pieces.back().line, 2U);
}

// Random programs.
TEST(ProgramPath, SamplesOfRandomPrograms) {
  std::size_t seen = 0;
  for (const std::string_view section : fuzz::sections()) {
    const bool samples = section.starts_with("fanuc/tool-center") || section.starts_with("fanuc/tool-posture");
    for (std::uint64_t seed = 1; seed <= test::random_cases(samples ? 50 : 20); ++seed) {
      fuzz::SeededSource source(seed);
      const spec::Case c = fuzz::generate(section, fuzz::Mode::directed, source, 10);
      SCOPED_TRACE(std::string(section) + " " + std::to_string(seed) + "\n" + spec::write_setup_toml(c.setup) +
                   c.program);
      seen += expect_samples(c, c.setup.axes.letters(), 10, samples ? 12 : 0);
      if (testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GT(seen, test::random_cases(1000));
}

}  // namespace
}  // namespace toolcomp::certify
