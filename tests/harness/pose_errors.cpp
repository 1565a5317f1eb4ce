// SPDX-License-Identifier: Apache-2.0
// How far directions may be off, on events made by hand: expected values are derivatives of closed forms.
#include "judge/oracle/pose_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "judge/oracle/condition.h"
#include "judge/oracle/policy.h"

namespace toolcomp::judge {
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
  for (std::size_t i = 0; i < events.size(); ++i) all.push_back(errors.next(std::span(events).subspan(i)));
  return all;
}

const double kE = policy::ulp(1) / kDegree;  // an ulp of a direction, in degrees

// However near to a singular posture: what is ill-determined there is judged by what it does.
TEST(PoseErrors, PositionsOutOfDirections) {
  const spec::Setup setup = head();
  for (const double b : {0.0, 0.001, 1.0, 30.0, 179.99}) {
    const PoseScale s = scales(setup, {pose(setup, b, 20)}).front();
    EXPECT_NEAR(s.rotary[3] / kE, 1, 1e-9) << b;
    EXPECT_NEAR(s.rotary[4] / kE, 1, 1e-9) << b;
    EXPECT_NEAR(s.direction / policy::ulp(1), 1, 1e-9) << b;
    EXPECT_EQ(s.tip, 0);
  }
}

// On a great circle e · 2/|V + W|; nearly opposite ends have hardly a plane, |V + W| = 2 sin 0.05. Under conventional
// control, and between opposite ends, the positions make the direction.
TEST(PoseErrors, InsideABlock) {
  const spec::Setup setup = head();
  const auto inside = [&](double end, bool great_circle) {
    model::Event half = sample(setup, 1, 2, 45, 80);
    if (great_circle) half.clauses.add(spec::Clause::fanuc_tool_posture_great_circle);
    const model::Event start = pose(setup, 90, 0);
    model::Event last = pose(setup, 90, end);
    // Exactly opposite, which the sine of 180 degrees is not.
    if (end == 180)
      for (std::size_t i = 0; i < 3; ++i) (*last.tool_axis)[i] = -(*start.tool_axis)[i];
    return scales(setup, {start, half, last})[1].direction / policy::ulp(1);
  };
  EXPECT_NEAR(inside(179.9, true) * std::sin(0.05 * kDegree), 1, 1e-6);
  EXPECT_NEAR(inside(90, true) * std::cos(45 * kDegree), 1, 1e-6);
  EXPECT_NEAR(inside(180 - 1e-6, true) * std::sin(0.5e-6 * kDegree), 1, 1e-6);
  EXPECT_EQ(inside(179.9, false), 1);
  EXPECT_EQ(inside(180, true), 1);
  // No event before says where the block begins.
  model::Event first = sample(setup, 1, 2, 45, 80);
  first.clauses.add(spec::Clause::fanuc_tool_posture_great_circle);
  EXPECT_EQ(scales(setup, {first, pose(setup, 90, 179.9)})[0].direction, policy::ulp(1));
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
  const auto back =
      scales(setup, {at(pose(setup, 30, 0), 21.4), at(sample(setup, 1, 2, 30, 0), -0.05), at(pose(setup, 30, 0), -80)});
  EXPECT_EQ(back[1].rotary[5], policy::ulp(80));
  // Where no move follows, as good as the start.
  const auto cut = scales(setup, {at(pose(setup, 30, 0), -21.5), at(sample(setup, 1, 2, 30, 0), -0.05)});
  EXPECT_EQ(cut[1].rotary[5], policy::ulp(21.5));
}

// Mechanical angles: the zeros of G54 until an event shows others, machine less programmed; under the other reading
// none.
TEST(PoseErrors, ZerosOfRotaryAxes) {
  spec::Setup setup = head();
  setup.workpiece.front()['B'] = spec::decimal(7);
  setup.workpiece.front()['C'] = spec::decimal(30);
  const auto machine = RotaryMachine::of(setup);
  RotaryZeros zeros(setup, machine);
  EXPECT_EQ(zeros.tool(), 7);
  EXPECT_EQ(zeros.work(), 30);
  model::Event event = pose(setup, 10, 20);
  event.machine.set(3, real(15));
  event.machine.set(4, real(-70));
  zeros.follow(event);
  EXPECT_EQ(zeros.tool(), 5);
  EXPECT_EQ(zeros.work(), -90);
  setup.rotary_angles = spec::RotaryAngles::programmed;
  RotaryZeros none(setup, machine);
  none.follow(event);
  EXPECT_EQ(none.tool(), 0);
  EXPECT_EQ(none.work(), 0);
}

// V leant by Q toward the travel, in the plane of the two: the plane is off by e/sin of their angle before the lean.
TEST(PoseErrors, OfALeanAlmostAlongTheTravel) {
  const spec::Setup setup = head();
  const auto leant = [&](double angle, const char* program) {
    model::Event end = pose(setup, angle, 0);
    end.point.set(2, 50);
    return scales(setup, {pose(setup, 10, 0), end}, program)[1].direction / policy::ulp(1);
  };
  // 5 - 4.999 = 0.001 degrees off the travel before a lean that carried it past the travel.
  EXPECT_NEAR(leant(4.999, "G43.5 H1 Q5.\n") / (std::sin(5 * kDegree) / std::sin(0.001 * kDegree)), 1, 1e-2);
  // 10.001 before one that did not.
  EXPECT_NEAR(leant(5.001, "G43.5 H1 Q5.\n"), 1 + std::sin(5 * kDegree) / std::sin(10.001 * kDegree), 1e-6);
  EXPECT_NEAR(leant(4.999, "G43.5 H1\n"), 1, 1e-9);
  // An event that says what it rests on says whether it leant.
  const auto resting_on = [&](spec::Clause clause) {
    model::Event end = pose(setup, 5.001, 0);
    end.point.set(2, 50);
    end.clauses.add(clause);
    return scales(setup, {pose(setup, 10, 0), end}, "G43.5 H1 Q5.\n")[1].direction / policy::ulp(1);
  };
  EXPECT_NEAR(resting_on(policy::kLeant), 1 + std::sin(5 * kDegree) / std::sin(10.001 * kDegree), 1e-6);
  EXPECT_EQ(resting_on(spec::Clause::fanuc_program_own_move), 1);
}

// Without travel there is no lean, of an arc the tangent counts, of a helix with its pitch; Q of other blocks is
// another word, and the end of the mode ends it.
TEST(PoseErrors, LeansTowardsTheTangent) {
  const spec::Setup setup = head();
  const auto ulps = [&](const model::Event& end, const char* program) {
    return scales(setup, {pose(setup, 0, 0), end}, program)[1].direction / policy::ulp(1);
  };
  model::Event still = pose(setup, 0.001, 0);
  EXPECT_EQ(ulps(still, "G43.5 H1 Q5.\n"), 1);
  // The tool almost along -X; a half turn about (5, 0), counter-clockwise from (0, 0), ends with the tangent +Y.
  model::Event arc = pose(setup, -90, 0);
  arc.arc.emplace();
  for (std::size_t i = 0; i < 3; ++i) arc.arc->center.set(i, i == 0 ? 5 : 0);
  arc.arc->direction = spec::ArcDirection::ccw;
  arc.arc->sweep = 180;
  arc.point.set(0, 10);
  EXPECT_NEAR(ulps(arc, "G43.5 H1 Q5.\n"), 1 + std::tan(5 * kDegree), 1e-9);
  // The chord, along the tool, would be 2^30.
  EXPECT_EQ(ulps(arc, "G43.5 H1\nQ1\n"), 1);
  EXPECT_EQ(ulps(arc, "G43.5 H1 Q5. G49\n"), 1);
  // The same arc climbs 10: over half a turn its tangent is (0, 5, 10/π). The tool stands 30 degrees beyond it.
  model::Event helix = pose(setup, std::atan2(5, 10 / std::numbers::pi) / kDegree + 30, 90);
  helix.arc = arc.arc;
  helix.point = arc.point;
  helix.point.set(2, 10);
  EXPECT_NEAR(ulps(helix, "G43.5 H1 Q5.\n"), 1 + std::sin(5 * kDegree) / std::sin(35 * kDegree), 1e-9);
  // Less than a radian of it, and less climb: 30 degrees, to (5 - 5 cos, -5 sin); the tangent there is 30 degrees off.
  const double c = std::cos(30 * kDegree);
  model::Event piece = pose(setup, 0, 0);
  piece.arc = arc.arc;
  piece.arc->sweep = 30;
  piece.point.set(0, real(5 - 5 * c));
  piece.point.set(1, real(-2.5));
  piece.point.set(2, 1);
  // By the slope from the horizontal: 1/(π/6) against 5.
  const double slope = std::atan2(5, 6 / std::numbers::pi);
  EXPECT_NEAR(ulps(piece, "G43.5 H1 Q5.\n"), 1 + std::sin(5 * kDegree) / std::sin(slope + 5 * kDegree), 1e-9);
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
}  // namespace toolcomp::judge
