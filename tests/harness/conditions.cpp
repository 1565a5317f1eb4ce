// SPDX-License-Identifier: Apache-2.0
// Condition numbers of heads, on events made by hand: expected values are the derivatives of the formulas of the
// clauses.
#include "judge/oracle/condition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "certify/convert.h"
#include "judge/oracle/policy.h"
#include "judge/oracle/verdict.h"

namespace toolcomp::judge {
namespace {

using exact::Rational;
using exact::Real;

Real decimal(const std::string& text) {
  const std::size_t point = text.find('.');
  if (point == std::string::npos) return Rational(text);
  std::string digits = text;
  digits.erase(point, 1);
  const bool negative = digits[0] == '-';
  if (negative) digits.erase(0, 1);
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
  Rational scale = 1;
  for (std::size_t i = point + 1; i < text.size(); ++i) scale *= 10;
  const Rational value = Rational(digits) / scale;
  return negative ? Real(Rational(-value)) : Real(value);
}

model::Event move(spec::Cause cause, const std::string& px, const std::string& py, const Real& x, const Real& y) {
  model::Event e;
  e.kind = spec::EventKind::move;
  e.type = spec::MoveType::linear;
  e.cause = cause;
  e.programmed.set(0, decimal(px));
  e.programmed.set(1, decimal(py));
  e.programmed.set(2, Real(0));
  e.point.set(0, x);
  e.point.set(1, y);
  e.point.set(2, Real(0));
  e.axes = e.point;
  return e;
}

model::Event arc(model::Event e, const std::string& ox, const std::string& oy) {
  e.type = spec::MoveType::arc;
  e.arc.emplace();
  e.arc->center.set(0, decimal(ox));
  e.arc->center.set(1, decimal(oy));
  return e;
}

std::vector<Scale> scales(const std::vector<model::Event>& events, const spec::Setup& setup = {}) {
  Conditions conditions{setup};
  std::vector<Scale> all;
  for (std::size_t i = 0; i < events.size(); ++i) all.push_back(conditions.next(std::span(events).subspan(i)));
  return all;
}

constexpr spec::Cause kStart = spec::Cause::start_up;
constexpr spec::Cause kOwn = spec::Cause::programmed;
constexpr spec::Cause kCorner = spec::Cause::corner;

// A circle is left by the square of what a head is off at all over its radius, a line by nothing of it.
TEST(Conditions, OfALineAndOfACircle) {
  HeadCondition condition;
  condition.slide = 3;
  condition.error = 4;
  condition.weight = 2;
  const HeadBand line = band_of(condition, {0, 1, 0});
  EXPECT_EQ(line.width, 14);
  EXPECT_EQ(line.curvature, 0);
  EXPECT_EQ(line.normal, (Space{0, 1, 0}));
  condition.reach = 8;
  EXPECT_EQ(band_of(condition, {0, 1, 0}).curvature, 0.125);
}

// G41 d = 10 along X, then back at an angle θ to straight back: M = r(N1 + N2)/(1 + k), |M| = r·√(2/(1 + k)), and an
// error of a direction turns into √(2/(1 + k)) of it, relative to |M|.
TEST(Conditions, OfAnIntersectionNearAReversal) {
  for (const int n : {10, 1000, 100'000}) {
    // B = (-n, 1): inner on the left; M from the two line equations: y = 10, x = -(10·√(n² + 1) + 10·n) less 40.
    const double s = -10 * (std::sqrt(double(n) * n + 1) + n);
    const Real x = 40 + Real(-10) * (sqrt(Real(n) * Real(n) + 1) + Real(n));
    const auto list = scales({move(kStart, "0", "0", Real(0), Real(10)), move(kOwn, "40", "0", x, Real(10)),
                              move(kOwn, std::to_string(40 - 50 * n), "50", Real(0), Real(0))});
    EXPECT_EQ(list[0].condition, 1);
    EXPECT_NEAR(list[1].vector, std::hypot(s, 10), 1e-6);
    const double expected =
        2 * std::fabs(s) * std::sqrt(double(n) * n + 1) / list[1].vector;  // 2·slide/sin θ, over |M|
    EXPECT_NEAR(list[1].condition, 1 + expected, 1e-3 * expected);
    // Hardly determined it is judged by both offset lines: y = 10, and the one of the block back.
    if (n < 100'000) continue;
    ASSERT_EQ(list[1].heads.size(), 1U);
    EXPECT_NEAR(std::fabs(list[1].heads[0].bands[0].normal[1]), 1, 1e-15);
    EXPECT_NEAR(std::fabs(list[1].heads[0].bands[1].normal[0]), 1 / std::hypot(n, 1.0), 1e-15);
  }
}

// Type C by an offset of 0 starts with corner moves that go nowhere, and so without a start-up: the vector that a later
// offset makes is one none the less, and turns the sweep of an arc by what is off at its heads over 0.001.
TEST(Conditions, AVectorWithoutAStartUp) {
  model::Event first = move(kOwn, "40", "0", Real(40), Real(10));
  first.clauses.add(spec::Clause::fanuc_cutter_side);
  const auto list = scales({move(kOwn, "0", "0", Real(0), Real(0)), first,
                            arc(move(kOwn, "40", "20.002", Real(40), decimal("10.002")), "40", "10.001")});
  EXPECT_EQ(list[0].vector, 0);
  EXPECT_EQ(list[1].vector, 10);
  EXPECT_DOUBLE_EQ(list[2].vector, 10);
  EXPECT_GE(list[2].turn, 2 * policy::ulp(40) / 0.001);
  EXPECT_LE(list[2].turn, 8 * policy::ulp(40) / 0.001);
}

// X, Y, Z as Y, Z, X, or as Z, X, Y: of positions, centre and plane.
model::Event turned(const model::Event& e, std::size_t by) {
  model::Event other = e;
  const auto turn = [by](const spec::AxisValues<Real>& from, spec::AxisValues<Real>& to) {
    to = {};
    for (std::size_t i = 0; i < 3; ++i)
      if (from.has(i)) to.set((i + by) % 3, from[i]);
  };
  turn(e.programmed, other.programmed);
  turn(e.point, other.point);
  turn(e.axes, other.axes);
  if (!e.arc) return other;
  turn(e.arc->center, other.arc->center);
  other.arc->plane = by == 0 ? spec::Plane::xy : by == 1 ? spec::Plane::yz : spec::Plane::zx;
  return other;
}

// The same head in the comparison. It lies 2,000,000 mm out, where doubles are 2.3e-10 apart; the lines meet at an
// angle of 1e-5, so that an error of one double moves it by 100,000 of them along both, and by none of them across. A
// head 1e-4 further along is right; one that is 1e-5 beside the lines or their plane, 43,000 doubles, is not, whatever
// it may slide.
TEST(Conditions, AHeadBesideItsLinesIsFound) {
  const int n = 100'000;
  const Real x = 40 + Real(-10) * (sqrt(Real(n) * Real(n) + 1) + Real(n));
  for (const std::size_t by : {0U, 1U, 2U}) {
    ModelRun run;
    for (const model::Event& event : {move(kStart, "0", "0", Real(0), Real(10)), move(kOwn, "40", "0", x, Real(10)),
                                      move(kOwn, std::to_string(40 - 50 * n), "50", Real(0), Real(0))})
      run.events.push_back(turned(event, by));
    spec::Case c;
    c.section = "fanuc/cutter-compensation-c";
    c.setup.axes = spec::Axes("XYZ");
    JudgeOptions options;
    const auto agrees = [&](double along, double across, double out = 0) {
      std::vector<fast::Event> actual = certify::in_doubles(run.events);
      for (spec::AxisValues<double>* values : {&actual[1].point, &actual[1].axes}) {
        values->set(by, values->value.at(by) + along);
        values->set((by + 1) % 3, values->value.at((by + 1) % 3) + across);
        values->set((by + 2) % 3, values->value.at((by + 2) % 3) + out);
      }
      return judge::judge(c, run, actual, options).outcome == Outcome::agrees;
    };
    EXPECT_TRUE(agrees(0, 0)) << by;
    EXPECT_TRUE(agrees(1e-4, 0)) << by;
    EXPECT_TRUE(agrees(-1e-4, 0)) << by;
    EXPECT_TRUE(agrees(1e-4, 0, 1e-9)) << by;
    EXPECT_FALSE(agrees(0, 1e-5)) << by;
    EXPECT_FALSE(agrees(0, -1e-5)) << by;
    EXPECT_FALSE(agrees(1e-4, 1e-5)) << by;
    EXPECT_FALSE(agrees(1e-4, 0, 1e-5)) << by;
    EXPECT_FALSE(agrees(10, 0)) << by;
    // Each coordinate of a controller may be rounded as it says, on the line too.
    options.resolution = {1e-5, 1e-6, 1e-5, 1e-5};
    EXPECT_TRUE(agrees(1e-4, 1e-5)) << by;
    EXPECT_FALSE(agrees(1e-4, 1e-4)) << by;
  }
}

// The alarm of a block whose move is not made, and which the head before it was made with.
model::Event alarm_of(model::Event e) {
  model::Event alarm;
  alarm.kind = spec::EventKind::alarm;
  alarm.number = "PS0041";
  e.point = e.axes = {};
  alarm.unmade = std::make_shared<model::Event>(std::move(e));
  return alarm;
}

// The block back raises an alarm: the head before it is as well determined as with its move. So is that of a line and
// an arc (OfAnIntersectionNearATangent).
TEST(Conditions, OfTheHeadBeforeAnAlarm) {
  const int n = 1000;
  const Real x = 40 + Real(-10) * (sqrt(Real(n) * Real(n) + 1) + Real(n));
  const auto start = [] { return move(kStart, "0", "0", Real(0), Real(10)); };
  const auto list = scales({start(), move(kOwn, "40", "0", x, Real(10)),
                            alarm_of(move(kOwn, std::to_string(40 - 50 * n), "50", Real(0), Real(0)))});
  const double slide = 10 * (std::sqrt(double(n) * n + 1) + n);
  const double expected = 2 * slide * std::sqrt(double(n) * n + 1) / std::hypot(slide, 10);
  EXPECT_NEAR(list[1].condition, 1 + expected, 1e-3 * expected);

  const Real root = sqrt(decimal("10.001") * decimal("10.001") - 100);
  const auto close = scales({start(), move(kOwn, "40.001", "0", Real(20) + root, Real(10)),
                             alarm_of(arc(move(kOwn, "20", "20.001", Real(0), Real(0)), "20", "0"))});
  const double half = std::sqrt(10.001 * 10.001 - 100);
  const double length = std::hypot(20.001 - half, 10);
  EXPECT_NEAR(close[1].condition, 1 + (20.001 - half + 10 + 30.002 + length) / (half / 10.001) / length, 1e-3);
}

// A block between them that moves nowhere in the plane hides neither.
TEST(Conditions, OfAnIntersectionBesideABlockWithoutMovement) {
  const int n = 1000;
  const Real x = 40 + Real(-10) * (sqrt(Real(n) * Real(n) + 1) + Real(n));
  model::Event still = move(kOwn, "40", "0", x, Real(10));
  for (spec::AxisValues<Real>* values : {&still.programmed, &still.point, &still.axes}) values->set(2, Real(5));
  const auto list = scales({move(kStart, "0", "0", Real(0), Real(10)), move(kOwn, "40", "0", x, Real(10)), still,
                            move(kOwn, std::to_string(40 - 50 * n), "50", Real(0), Real(0))});
  const double slide = 10 * (std::sqrt(double(n) * n + 1) + n);
  const double expected = 2 * slide * std::sqrt(double(n) * n + 1) / std::hypot(slide, 10);
  EXPECT_NEAR(list[1].condition, 1 + expected, 1e-3 * expected);
  EXPECT_NEAR(list[2].condition, 1 + expected, 1e-3 * expected);
}

// Straight on, or nearly: the intersection hardly slides, whatever the angle.
TEST(Conditions, OfAnIntersectionNearlyStraightOn) {
  // B = (n, 1): M = (-r·tan(θ/2), r), tan(θ/2) = 1/(n + √(n² + 1)).
  for (const int n : {10, 1000, 1'000'000}) {
    const Real slide = Real(10) / (Real(n) + sqrt(Real(n) * Real(n) + 1));
    const auto list = scales({move(kStart, "0", "0", Real(0), Real(10)), move(kOwn, "40", "0", 40 - slide, Real(10)),
                              move(kOwn, std::to_string(40 + 10 * n), "10", Real(0), Real(0))});
    EXPECT_GE(list[1].condition, 1);
    EXPECT_LE(list[1].condition, 3);
  }
}

// Perpendicular and prolonged vectors are made of one direction.
TEST(Conditions, OfPerpendicularAndProlongedVectors) {
  // α = 0.57° at an acute corner: P1, Q1, Q2.
  const auto list = scales({move(kStart, "0", "0", Real(0), Real(10)), move(kOwn, "100", "0", Real(110), Real(10)),
                            move(kCorner, "100", "0", decimal("110.098995"), decimal("-9.8995")),
                            move(kOwn, "0", "-1", Real(0), Real(-11))});
  EXPECT_EQ(list[1].condition, 1);
  EXPECT_NEAR(list[2].condition, 1, 1e-6);
}

// Line and arc, G41 r = 10: with the centre at height h over the offset line the meeting point moves by R'/√(R'² - h²)
// times the errors of centre and radius.
TEST(Conditions, OfAnIntersectionNearATangent) {
  // Chapter 14, 14.6.3: (0,0)→(40,0), G03 about (0,30), R = 50, R' = 40, h = 20: q = 34.64.
  const Real q = sqrt(Real(1200));
  const auto well = scales({move(kStart, "0", "0", Real(0), Real(10)), move(kOwn, "40", "0", q, Real(10)),
                            arc(move(kOwn, "0", "80", Real(0), Real(70)), "0", "30")});
  const double sine = std::sqrt(1200.0) / 40;
  const double along_line = 40 - std::sqrt(1200.0);
  const double along_arc = 10 * 0.8 - along_line * 0.6;  // the tangent at the corner is (3, 4)/5
  const double vector = std::hypot(along_line, 10);
  EXPECT_NEAR(well[1].condition, 1 + (along_line + along_arc + 90 + vector) / sine / vector, 1e-6);
  // O = (20, 0), R = 20: R' = 10 touches the offset line; a micrometre more and q² = 10.001² - 10².
  const Real root = sqrt(decimal("10.001") * decimal("10.001") - 100);
  const auto close =
      scales({move(kStart, "0", "0", Real(0), Real(10)), move(kOwn, "40.001", "0", Real(20) + root, Real(10)),
              arc(move(kOwn, "20", "20.001", Real(20), decimal("10.001")), "20", "0")});
  const double half = std::sqrt(10.001 * 10.001 - 100);  // of the chord
  const double back = 20.001 - half;
  const double length = std::hypot(back, 10);
  EXPECT_NEAR(close[1].condition, 1 + (back + 10 + 30.002 + length) / (half / 10.001) / length, 1e-3);
  EXPECT_GT(close[1].condition, 200);
}

// The offset circle of R' = 10 + 1e-9 hardly reaches the offset line 10 above its middle: √(2e-8) to one side, and they
// cross at 1.4e-5, so that a head may slide by 1e-8. The arc starts where the controller has its head, turned by 1e-9
// of a radian: its sweep is that much less, and known as well as ever.
TEST(Conditions, AnArcThatStartsAtAHeadThatSlides) {
  constexpr double degrees = 57.29577951308232;  // in a radian
  const Real root = sqrt(decimal("10.000000001") * decimal("10.000000001") - 100);
  const double sweep = degrees * std::atan(std::sqrt(2e-8 + 1e-18) / 10);
  ModelRun run;
  run.events = {move(kStart, "0", "0", Real(0), Real(10)), move(kOwn, "40.000000001", "0", 20 + root, Real(10)),
                arc(move(kOwn, "20", "20.000000001", Real(20), decimal("10.000000001")), "20", "0")};
  run.events[2].arc->direction = spec::ArcDirection::ccw;
  run.events[2].arc->sweep = Real(Rational(sweep));
  spec::Case c;
  c.section = "fanuc/cutter-compensation-c";
  c.setup.axes = spec::Axes("XYZ");
  const auto agrees = [&](double slide, double turned) {
    std::vector<fast::Event> actual = certify::in_doubles(run.events);
    for (spec::AxisValues<double>* values : {&actual[1].point, &actual[1].axes})
      values->set(0, values->value.at(0) + slide);
    *actual[2].arc->sweep += turned;
    return judge::judge(c, run, actual).outcome == Outcome::agrees;
  };
  EXPECT_TRUE(agrees(0, 0));
  EXPECT_TRUE(agrees(1e-8, degrees * 1e-9));
  EXPECT_TRUE(agrees(-1e-8, -degrees * 1e-9));
  EXPECT_FALSE(agrees(1e-8, degrees * 2e-9));
  EXPECT_FALSE(agrees(0, degrees * 1e-9));
  EXPECT_FALSE(agrees(1e-6, degrees * 1e-7));
}

// G40 with I J: the direction is not in the events, the distance of the head from the corner and the path tells it.
TEST(Conditions, OfAnIntersectionWithADirectionOfTheCancelBlock) {
  // A along X to (40, 0), direction (-100, 1), G41 r = 10.
  const Real x = 40 + Real(-10) * (sqrt(Real(10'001)) + Real(100));
  model::Event cancel = move(spec::Cause::cancel, "40", "80", Real(40), Real(80));
  const auto list =
      scales({move(kStart, "0", "0", Real(0), Real(10)), move(kOwn, "40", "0", x, Real(10)), std::move(cancel)});
  EXPECT_GT(list[1].condition, 150);
  EXPECT_LT(list[1].condition, 1500);
}

// A shift of G45 stands between programmed and actual positions before the start-up: it is no vector.
TEST(Conditions, AShiftIsNoVector) {
  const auto list = scales({move(kOwn, "10", "0", Real(15), Real(5)), move(kStart, "20", "0", Real(25), Real(15)),
                            move(kOwn, "60", "0", Real(65), Real(15)), move(kOwn, "90", "0", Real(95), Real(15))});
  EXPECT_EQ(list[0].vector, 0);
  EXPECT_NEAR(list[1].vector, 10, 1e-9);
  EXPECT_EQ(list[2].condition, 1);
}

// Short offset arcs turn more for the same error of their ends; in every plane.
TEST(Conditions, OfTheSweepOfASmallArc) {
  // A quarter about (40, 10.001) with R = 10.001, R' = 0.001.
  for (const std::size_t by : {0U, 1U, 2U}) {
    const auto list = scales(
        {turned(move(kStart, "0", "0", Real(0), Real(10)), by), turned(move(kOwn, "40", "0", Real(40), Real(10)), by),
         turned(arc(move(kOwn, "50.001", "10.001", decimal("40.001"), decimal("10.001")), "40", "10.001"), by)});
    const double unit = policy::ulp(list[2].position) + policy::ulp(10);
    EXPECT_NEAR(list[2].turn, 2 * unit / 0.001, 0.5 * unit / 0.001) << by;
    EXPECT_EQ(list[1].turn, 0) << by;
  }
  // A vector of half a millimetre.
  const auto list =
      scales({move(kStart, "0", "0", Real(0), decimal("0.5")), move(kOwn, "40", "0", Real(40), decimal("0.5")),
              arc(move(kOwn, "60", "20", decimal("59.5"), Real(20)), "40", "20")});
  EXPECT_EQ(list[2].start, policy::ulp(0.5));
}

// A perpendicular vector at the end of an arc by R hardly longer than half its chord: the centre is R/h times off what
// R is, and turns the vector by that over R; in every plane.
TEST(Conditions, OfAVectorAtAnArcByRadius) {
  const Real r = decimal("10.000001");
  const Real h = sqrt(r * r - 100);
  for (const std::size_t by : {0U, 1U, 2U}) {
    model::Event event = arc(move(kOwn, "20", "0", 20 + 10 / r, -h / r), "10", "0");
    event.arc->center.set(1, h);
    event.clauses.add(policy::kByRadius);
    const auto list = scales({turned(move(kStart, "0", "0", Real(0), Real(1)), by), turned(event, by)});
    const double expected = policy::ulp(21) / std::sqrt(2e-5 + 1e-12) / (policy::ulp(1) / 2);
    EXPECT_NEAR(list[1].condition, 2 + expected, 1e-3 * expected) << by;
  }
}

// Of all parameters only the vectors of table and head, 19700 to 19714, are lengths that positions are made of.
TEST(Conditions, OfParameters) {
  const auto position = [](std::uint32_t number) {
    spec::Setup setup;
    setup.parameters[{number, -1}] = spec::decimal(5000);
    return scales({move(kOwn, "40", "0", Real(40), Real(0))}, setup)[0].position;
  };
  for (const std::uint32_t number : {19700U, 19702U, 19709U, 19714U}) EXPECT_EQ(position(number), 5000) << number;
  for (const std::uint32_t number : {1410U, 5010U, 6241U, 19699U, 19715U}) EXPECT_EQ(position(number), 40) << number;
}

// Found by fuzzing: an end nearer to the centre than an estimate sees has no direction in double. One in the centre has
// none at all, and says so.
TEST(Conditions, OfTheSweepOfAnArcThatEndsBesideItsCentre) {
  for (const bool sweeps : {true, false}) {
    model::Event beside = arc(move(kOwn, "50", "10", Real(40), decimal("10.00000000000000000001")), "40", "10");
    if (sweeps) beside.arc->sweep = Real(90);
    const auto list =
        scales({move(kStart, "0", "0", Real(0), Real(10)), move(kOwn, "40", "0", Real(40), Real(9)), beside});
    EXPECT_EQ(std::isinf(list[2].turn), sweeps);
  }
}

using Triple = std::array<Real, 3>;

// A move of a machine with a tool axis: programmed point, vector, and the tool at the end.
model::Event beside(spec::Cause cause, const Triple& programmed, const Triple& vector, const Triple& tool) {
  model::Event e;
  e.kind = spec::EventKind::move;
  e.type = spec::MoveType::linear;
  e.cause = cause;
  for (std::size_t i = 0; i < 3; ++i) {
    e.programmed.set(i, programmed[i]);
    e.point.set(i, programmed[i] + vector[i]);
  }
  e.axes = e.point;
  e.tool_axis = tool;
  return e;
}

// A movement of slope n along the tool Z: its projection is 1/√(1 + n²) of it, and an error e of the tool turns its
// perpendicular by e·√(1 + n²).
TEST(Conditions, OfAPerpendicularVectorNearTheTool) {
  const Triple tool = {Real(0), Real(0), Real(1)};
  const Triple up = {Real(0), Real(10), Real(0)};
  const Triple prolonged = {Real(10), Real(10), Real(0)};  // by the radius, along the movement as the tool sees it
  for (const int n : {0, 10, 1000, 100'000})
    for (const Triple& vector : {up, prolonged}) {
      const Triple end = {Real(1), Real(0), Real(n)};
      const auto list = scales({beside(kStart, end, vector, tool)});
      EXPECT_NEAR(list[0].condition, 1 + std::sqrt(1 + double(n) * n), 1e-6 * (n + 1));
    }
}

// The corner of OfAnIntersectionNearAReversal, turned to the plane of the tool (3, 0, 4)/5: X becomes (4, 0, -3)/5.
TEST(Conditions, OfAnIntersectionNearAReversalBesideATiltedTool) {
  const Triple tool = {decimal("0.6"), Real(0), decimal("0.8")};
  const auto turned = [](const Real& x, const Real& y) { return Triple{decimal("0.8") * x, y, decimal("-0.6") * x}; };
  for (const int n : {10, 1000, 100'000}) {
    const Real slide = Real(-10) * (sqrt(Real(n) * Real(n) + 1) + Real(n));
    const double s = -10 * (std::sqrt(double(n) * n + 1) + n);
    const auto list = scales({beside(kStart, turned(Real(0), Real(0)), turned(Real(0), Real(10)), tool),
                              beside(kOwn, turned(Real(40), Real(0)), turned(slide, Real(10)), tool),
                              beside(kOwn, turned(Real(40 - 50 * n), Real(50)), turned(Real(0), Real(0)), tool)});
    const double expected = 2 * std::fabs(s) * std::sqrt(double(n) * n + 1) / list[1].vector;
    EXPECT_NEAR(list[1].condition, 1 + expected, 1e-3 * expected);
  }
}

// In the comparison as AHeadBesideItsLinesIsFound, in the plane of that tool and out of it; and the same corner turned
// in that plane by (3, 4)/5.
TEST(Conditions, AHeadBesideItsLinesIsFoundBesideATiltedTool) {
  const Triple tool = {decimal("0.6"), Real(0), decimal("0.8")};
  const int n = 100'000;
  const Real slide = Real(-10) * (sqrt(Real(n) * Real(n) + 1) + Real(n));
  for (const auto& [c1, s1] : {std::pair("1", "0"), std::pair("0.6", "0.8")}) {
    const Real cosine = decimal(c1);
    const Real sine = decimal(s1);
    const auto turned = [&](const Real& x, const Real& y) {
      const Real along = cosine * x - sine * y;
      return Triple{decimal("0.8") * along, sine * x + cosine * y, decimal("-0.6") * along};
    };
    ModelRun run;
    run.events = {beside(kStart, turned(Real(0), Real(0)), turned(Real(0), Real(10)), tool),
                  beside(kOwn, turned(Real(40), Real(0)), turned(slide, Real(10)), tool),
                  beside(kOwn, turned(Real(40 - 50 * n), Real(50)), turned(Real(0), Real(0)), tool)};
    spec::Case c;
    c.section = "fanuc/tool-side-compensation";
    c.setup.axes = spec::Axes("XYZ");
    const auto agrees = [&](double along, double across, double out = 0) {
      const double x = std::stod(c1) * along - std::stod(s1) * across;
      std::vector<fast::Event> actual = certify::in_doubles(run.events);
      for (spec::AxisValues<double>* values : {&actual[1].point, &actual[1].axes}) {
        values->set(0, values->value.at(0) + 0.8 * x + 0.6 * out);
        values->set(1, values->value.at(1) + std::stod(s1) * along + std::stod(c1) * across);
        values->set(2, values->value.at(2) - 0.6 * x + 0.8 * out);
      }
      return judge::judge(c, run, actual).outcome == Outcome::agrees;
    };
    EXPECT_TRUE(agrees(0, 0)) << s1;
    EXPECT_TRUE(agrees(1e-4, 0)) << s1;
    EXPECT_FALSE(agrees(0, 1e-5)) << s1;
    EXPECT_FALSE(agrees(1e-4, 1e-5)) << s1;
    EXPECT_FALSE(agrees(1e-4, 0, 1e-5)) << s1;
    EXPECT_FALSE(agrees(10, 0)) << s1;
  }
}

// Nor does it matter there that the block back raises an alarm.
TEST(Conditions, OfTheHeadBeforeAnAlarmBesideATiltedTool) {
  const Triple tool = {decimal("0.6"), Real(0), decimal("0.8")};
  const auto turned = [](const Real& x, const Real& y) { return Triple{decimal("0.8") * x, y, decimal("-0.6") * x}; };
  const int n = 1000;
  const Real slide = Real(-10) * (sqrt(Real(n) * Real(n) + 1) + Real(n));
  const auto list =
      scales({beside(kStart, turned(Real(0), Real(0)), turned(Real(0), Real(10)), tool),
              beside(kOwn, turned(Real(40), Real(0)), turned(slide, Real(10)), tool),
              alarm_of(beside(kOwn, turned(Real(40 - 50 * n), Real(50)), turned(Real(0), Real(0)), tool))});
  const double s = 10 * (std::sqrt(double(n) * n + 1) + n);
  const double expected = 2 * s * std::sqrt(double(n) * n + 1) / std::hypot(s, 10);
  EXPECT_NEAR(list[1].condition, 1 + expected, 1e-3 * expected);
}

// Both lines lean against the tool Z by a slope m: the same corner, each direction known 1/√(1 + m²) as well.
TEST(Conditions, OfAnIntersectionOfLinesNearTheTool) {
  const Triple tool = {Real(0), Real(0), Real(1)};
  const int n = 100;
  const Real slide = Real(-10) * (sqrt(Real(n) * Real(n) + 1) + Real(n));
  const auto corner = [&](int m) {
    const Real rise = Real(40 * m);
    const auto list =
        scales({beside(kStart, {Real(0), Real(0), Real(0)}, {Real(0), Real(10), Real(0)}, tool),
                beside(kOwn, {Real(40), Real(0), rise}, {slide, Real(10), Real(0)}, tool),
                beside(kOwn, {Real(40 - 40 * n), Real(40), rise + Real(40 * m) * sqrt(Real(n) * Real(n) + 1)},
                       {Real(0), Real(0), Real(0)}, tool)});
    return list[1].condition - 1;
  };
  const double flat = corner(0);
  for (const int m : {1, 10, 100}) EXPECT_NEAR(corner(m), flat * std::sqrt(1 + double(m) * m), 1e-3 * flat * m);
}

// R·V/|V|, V = (VM × VT) × VT: an error of VM or VT turns it by that error over sin(VM, VT), here 1/√(1 + n²). The
// vector lies in the plane of X and Z, square to the tool (n, 0, 1); what is kept keeps its condition, and samples have
// that of their move.
TEST(Conditions, OfALeadingEdgeNearTheTool) {
  spec::Setup setup;
  setup.parameters[{19631, -1}] = spec::decimal(0);  // no direction counts as along the tool
  for (const int n : {10, 1000, 100'000}) {
    const Real norm = sqrt(Real(n) * Real(n) + 1);
    const Triple tool = {Real(n) / norm, Real(0), Real(1) / norm};
    const Triple vector = {Real(-10) / norm, Real(0), Real(10 * n) / norm};
    const Triple across = {Real(0), Real(1), Real(0)};
    model::Event sample = beside(kOwn, {Real(90), Real(40), Real(0)}, vector, across);
    sample.kind = spec::EventKind::sample;
    const auto list = scales({beside(kStart, {Real(50), Real(0), Real(0)}, vector, tool),
                              beside(kOwn, {Real(90), Real(0), Real(0)}, vector, tool),
                              beside(kOwn, {Real(90), Real(30), Real(0)}, vector, across), sample,
                              beside(kOwn, {Real(90), Real(50), Real(0)}, {Real(10), Real(0), Real(0)}, across)},
                             setup);
    const double sine = 1 / std::sqrt(double(n) * n + 1);
    for (const std::size_t i : {0U, 1U, 2U}) {
      EXPECT_GE(list[i].condition, (1 - 1e-6) / sine) << n << ' ' << i;
      EXPECT_LE(list[i].condition, 3 / sine) << n << ' ' << i;
    }
    // Of the start that the sample's move has.
    EXPECT_GE(list[3].start, (1 - 1e-6) / sine * policy::ulp(10)) << n;
    EXPECT_LE(list[4].condition, 4) << n;
  }
}

// What a machine has no axis for is 0, whatever stands beside it.
TEST(Conditions, OfAMachineWithoutY) {
  spec::Setup setup;
  setup.axes = spec::Axes("XZ");
  setup.position['X'] = spec::decimal(7);
  const auto at = [](spec::Cause cause, int x, int z, int off) {
    model::Event e;
    e.kind = spec::EventKind::move;
    e.cause = cause;
    e.programmed.set(0, Real(x));
    e.programmed.set(1, Real(z));
    e.point.set(0, Real(x));
    e.point.set(1, Real(z + off));
    e.axes = e.point;
    return e;
  };
  const auto list = scales({at(kStart, 30, 0, 3), at(kOwn, 60, 0, 3), at(kOwn, 90, 0, 3)}, setup);
  for (const Scale& scale : list) EXPECT_EQ(scale.vector, 3);
  EXPECT_EQ(list[2].position, 90);
  EXPECT_EQ(list[2].condition, 1);
}

// The start of OfALeadingEdgeNearTheTool along every axis, the tool leaning to either of the others.
TEST(Conditions, OfALeadingEdgeAlongAnyAxis) {
  spec::Setup setup;
  setup.parameters[{19631, -1}] = spec::decimal(0);
  const int n = 1000;
  const Real norm = sqrt(Real(n) * Real(n) + 1);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const std::size_t other : {(axis + 1) % 3, (axis + 2) % 3}) {
      Triple end{};
      Triple tool{};
      Triple vector{};
      end.at(axis) = Real(50);
      tool.at(axis) = Real(n) / norm;
      tool.at(other) = Real(1) / norm;
      vector.at(axis) = Real(-10) / norm;
      vector.at(other) = Real(10 * n) / norm;
      EXPECT_NEAR(scales({beside(kStart, end, vector, tool)}, setup)[0].condition, 1000, 1) << axis << other;
    }
}

// A vector that rests on clauses of cutter compensation was not made of tool and movement; one that rests on no clause
// that makes vectors may be anything. The pair of OfALeadingEdgeNearTheTool.
TEST(Conditions, OfTheSectionThatMakesTheVector) {
  spec::Setup setup;
  setup.parameters[{19631, -1}] = spec::decimal(0);
  const int n = 1000;
  const Real norm = sqrt(Real(n) * Real(n) + 1);
  const auto condition = [&](spec::Clause clause) {
    model::Event event = beside(kStart, {Real(50), Real(0), Real(0)}, {Real(-10) / norm, Real(0), Real(10 * n) / norm},
                                {Real(n) / norm, Real(0), Real(1) / norm});
    event.clauses.add(spec::Clause::fanuc_program_own_move);
    event.clauses.add(clause);
    return scales({event}, setup)[0].condition;
  };
  EXPECT_NEAR(condition(spec::Clause::fanuc_leading_edge_sign), 1000, 1);
  EXPECT_NEAR(condition(spec::Clause::fanuc_program_arc_sweep), 1000, 1);
  EXPECT_LE(condition(spec::Clause::fanuc_cutter_c_corner_side), 4);
}

}  // namespace
}  // namespace toolcomp::judge
