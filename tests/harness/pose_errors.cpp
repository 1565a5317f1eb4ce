// How far rotary positions and what hangs on them may be off, on events made by hand: expected values are the
// derivatives of the closed forms of the sheet (section 3).
#include "fuzz/oracle/pose_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "fuzz/oracle/condition.h"
#include "fuzz/oracle/policy.h"

namespace toolcomp::fuzz {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

exact::Real real(double x) { return exact::Real(exact::Rational(x)); }

// C master about Z; the slave about Y, or about (0, 1, 1)/√2.
spec::Setup head(bool nutating = false) {
  spec::Setup setup;
  setup.axes = spec::Axes("XYZBC");
  setup.parameters[{19680, -1}] = spec::decimal(2);
  setup.parameters[{19681, -1}] = spec::decimal(5);
  setup.parameters[{19682, -1}] = spec::decimal(3);
  setup.parameters[{19686, -1}] = spec::decimal(4);
  setup.parameters[{19687, -1}] = spec::decimal(nutating ? 5 : 2);
  if (nutating) setup.parameters[{19688, -1}] = spec::decimal(45);
  setup.h[1].geometry = spec::decimal(100);
  return setup;
}

// A move under tool center point control, the tip standing in the origin.
model::Event pose(const spec::Setup& setup, double b, double c) {
  model::Event e;
  e.line = 2;
  const auto machine = RotaryMachine::of(setup);
  const Space v = machine->direction(b, c);
  e.tool_axis = {real(v[0]), real(v[1]), real(v[2])};
  for (std::size_t i = 0; i < 3; ++i) {
    e.programmed.set(i, 0);
    e.point.set(i, 0);
    e.axes.set(i, real(100 * v.at(i)));
  }
  e.axes.set(3, real(b));
  e.axes.set(4, real(c));
  e.machine = e.axes;
  return e;
}

model::Event sample(const spec::Setup& setup, std::uint32_t k, std::uint32_t n, double b, double c) {
  model::Event e = pose(setup, b, c);
  e.kind = spec::EventKind::sample;
  e.t_numerator = k;
  e.t_denominator = n;
  e.machine = {};
  e.programmed = {};
  return e;
}

std::vector<PoseScale> scales(const spec::Setup& setup, const std::vector<model::Event>& events,
                              std::string program = {}) {
  spec::Case c;
  c.setup = setup;
  c.program = std::move(program);
  const ProgramFacts facts = ProgramFacts::of(c);
  PoseErrors errors(setup, c.program.empty() ? nullptr : &facts);
  std::vector<PoseScale> all;
  for (std::size_t i = 0; i < events.size(); ++i) all.push_back(errors.next(std::span(events).subspan(i), 100));
  return all;
}

const double kE = policy::ulp(1) / kDegree;  // an ulp of a direction, in degrees

// V = (sin B cos C, sin B sin C, cos B): dB = e, dC = e/sin B.
TEST(PoseErrors, OfAHead) {
  const spec::Setup setup = head();
  for (const double b : {0.001, 1.0, 30.0, 90.0, 150.0, 179.99}) {
    const PoseScale s = scales(setup, {pose(setup, b, 20)}).front();
    EXPECT_NEAR(s.rotary[3] / kE, 1, 1e-3) << b;
    EXPECT_NEAR(s.rotary[4] / kE * std::sin(b * kDegree), 1, 1e-3) << b;
    EXPECT_NEAR(s.direction / policy::ulp(1), 1, 1e-9) << b;
    // L (dV + dB + sin B dC): the tool does not see what the work side is off by near its axis.
    EXPECT_NEAR(s.control_point / (100 * policy::ulp(1)), 3, 1e-2) << b;
  }
}

// V = R_z(C) (sin B/√2, (1 − cos B)/2, (1 + cos B)/2): at B = 180 the height has no slope, d²k/dB² = 1/2, so that
// dB = √(4e); the azimuth of the tilted tool goes with it.
TEST(PoseErrors, AtAnEdgeOfReach) {
  const spec::Setup setup = head(true);
  const PoseScale s = scales(setup, {pose(setup, 180, 20)}).front();
  EXPECT_NEAR(s.rotary[3] * kDegree / std::sqrt(4 * policy::ulp(1)), 1, 1e-3);
  EXPECT_GT(s.rotary[4], s.rotary[3] / 2);
  // Away from it both are well determined.
  const PoseScale away = scales(setup, {pose(setup, 90, 20)}).front();
  EXPECT_LT(away.rotary[3], 4 * kE);
  EXPECT_LT(away.rotary[4], 8 * kE);
}

TEST(PoseErrors, CommandedPositionsHaveNone) {
  const spec::Setup setup = head();
  const PoseScale s = scales(setup, {pose(setup, 0.001, 20)}, "G43.4 H1\nB.001 C20.\n").front();
  EXPECT_EQ(s.rotary[3], 0);
  EXPECT_EQ(s.rotary[4], 0);
  EXPECT_GT(scales(setup, {pose(setup, 0.001, 20)}, "G43.5 H1\nI1 K57296\n").front().rotary[4], 1000 * kE);
}

// Positions of the blocks before the first G43.5 are commanded, whatever comes after.
TEST(PoseErrors, CommandedUntilTheFirstDirection) {
  const spec::Setup setup = head();
  const std::vector<model::Event> events{pose(setup, 0.001, 20)};  // of line 2
  EXPECT_EQ(scales(setup, events, "G43.4 H1\nB.001 C20.\nG43.50 H1\n").front().rotary[4], 0);
  EXPECT_GT(scales(setup, events, "G43.4 H1\nG43.5 H1 I1 K57296\n").front().rotary[4], 1000 * kE);
}

// A changed end, or a direction along the work-side axis: the work side stays, and with it what it was off by.
TEST(PoseErrors, StayWithAPositionThatIsKept) {
  const spec::Setup setup = head();
  constexpr double c = 20.00000314159;  // out of inverse kinematics: no decimals of a program
  const auto s = scales(setup, {pose(setup, 0.00100000271828, c), pose(setup, -30.00000271828, c), pose(setup, 0, c),
                                pose(setup, 30.000001414, 50.000001732)});
  EXPECT_NEAR(s[1].rotary[4] / s[0].rotary[4], 1, 1e-9);
  EXPECT_NEAR(s[1].direction / (s[0].rotary[4] * kDegree * 0.5), 1, 1e-3);  // sin 30
  EXPECT_NEAR(s[2].rotary[4] / s[0].rotary[4], 1, 1e-9);
  EXPECT_LT(s[3].rotary[4], 4 * kE);
  EXPECT_LT(s[3].direction, 4 * policy::ulp(1));
}

// Inside a block: the angle to the nearest singular posture counts, not that of the ends, and nearly opposite ends have
// hardly a plane.
TEST(PoseErrors, InsideABlock) {
  const spec::Setup setup = head();
  // A great circle that is no straight run of both axes.
  const auto past = scales(setup, {pose(setup, 30, 0), sample(setup, 1, 2, 0.01, 85), pose(setup, 30, 179)});
  EXPECT_NEAR(past[1].rotary[4] / past[1].direction * kDegree * std::sin(0.01 * kDegree), 1, 0.2);
  EXPECT_LT(past[1].direction, 6 * policy::ulp(1) / std::cos(30 * kDegree));
  const auto opposite = scales(setup, {pose(setup, 90, 0), sample(setup, 1, 2, 45, 80), pose(setup, 90, 179.9)});
  EXPECT_GT(opposite[1].direction, policy::ulp(1) / std::sin(0.1 * kDegree));
  // Both axes evenly: the errors of the ends.
  const auto evenly = scales(setup, {pose(setup, 0.001, 0), sample(setup, 1, 2, 45.000501414, 45.000000866),
                                     pose(setup, 90.000002828, 90.000001732)});
  EXPECT_NEAR(evenly[1].rotary[4] / evenly[0].rotary[4], 1, 1e-4);
  EXPECT_NEAR(evenly[1].direction / (evenly[0].rotary[4] * kDegree * std::sin(45 * kDegree)), 1, 1e-2);
}

// An axis that does not turn the tool runs from -21.5 to 21.4: near 0 it is as good as its ends.
TEST(PoseErrors, OtherRotaryAxesRunEvenly) {
  spec::Setup setup = head();
  setup.axes = spec::Axes("XYZBCA");
  const auto at = [](model::Event e, double a) {
    e.axes.set(5, real(a));
    return e;
  };
  const auto s = scales(
      setup, {at(pose(setup, 30, 0), -21.5), at(sample(setup, 1, 2, 30, 0), -0.05), at(pose(setup, 30, 0), 21.4)});
  EXPECT_EQ(s[0].rotary[5], 0);
  EXPECT_EQ(s[1].rotary[5], policy::ulp(21.5));
  EXPECT_EQ(s[2].rotary[5], 0);
}

// V leant by Q in the plane of V and the travel: the plane is off by e/sin of their angle.
TEST(PoseErrors, OfALeanAlmostAlongTheTravel) {
  const spec::Setup setup = head();
  // 0.001 degrees off the travel before the lean.
  model::Event end = pose(setup, 5.001000001414, 0.000001732);
  end.point.set(2, 50);
  const auto s = scales(setup, {pose(setup, 10.000003141, 0), end}, "G43.5 H1 Q5.\n");
  EXPECT_NEAR(s[1].direction / policy::ulp(1) / (std::sin(5 * kDegree) / std::sin(0.001 * kDegree)), 1, 1e-2);
  EXPECT_NEAR(scales(setup, {pose(setup, 10.000003141, 0), end}, "G43.5 H1\n")[1].direction / policy::ulp(1), 1, 1e-9);
}

TEST(PoseErrors, WithoutKinematicsADirectionIsItself) {
  spec::Setup setup = head();
  model::Event e = pose(setup, 0.001, 20);
  setup.parameters.clear();
  const PoseScale s = scales(setup, {e}).front();
  EXPECT_EQ(s.direction, policy::ulp(1));
  EXPECT_EQ(s.rotary[4], 0);
}

// A sample between two heads has the worse of their conditions.
TEST(PoseErrors, SamplesTakeTheScaleOfTheirMove) {
  const spec::Setup setup = head();
  Conditions conditions(setup);
  model::Event far = pose(setup, 10, 0);
  far.point.set(0, real(5000));
  far.programmed.set(0, real(5000));
  const std::vector<model::Event> events{pose(setup, 10, 0), sample(setup, 1, 2, 10, 0), far};
  conditions.next(events);
  EXPECT_EQ(conditions.next(std::span(events).subspan(1)).position, 5000);
}

}  // namespace
}  // namespace toolcomp::fuzz
