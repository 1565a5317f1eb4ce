// SPDX-License-Identifier: Apache-2.0
// The oracle's own kinematics: lines, references and directions by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "judge/oracle/rotary.h"

namespace toolcomp::judge {
namespace {

constexpr double kDegree = 0.017453292519943295;

void expect(const Space& actual, const Space& expected) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(actual.at(i), expected.at(i), 1e-15) << i;
}

// A head whose C axis, about Z, carries B, about Y.
spec::Setup head() {
  spec::Setup setup;
  setup.axes = spec::Axes("XYZBC");
  const auto set = [&](std::uint32_t number, int value) { setup.parameters[{number, -1}] = spec::decimal(value); };
  set(19680, 2);
  set(19681, 5);
  set(19682, 3);
  set(19686, 4);
  set(19687, 2);
  return setup;
}

RotaryMachine machine(spec::Setup setup, std::initializer_list<std::pair<std::uint32_t, int>> parameters) {
  for (const auto& [number, value] : parameters) setup.parameters[{number, -1}] = spec::decimal(value);
  return *RotaryMachine::of(setup);
}

// Half a turn about a: 2 (a.v) a - v.
TEST(RotaryMachines, RotateAboutAnyLine) {
  expect(rotated({1, 0, 0}, {0.6, 0.8, 0}, 180), {-0.28, 0.96, 0});
  expect(rotated({0, 1, 0}, {0.6, 0.8, 0}, 180), {0.96, 0.28, 0});
  expect(rotated({0, 0, 1}, {0, 0.6, 0.8}, 180), {0, 0.96, 0.28});
  expect(rotated({1, 0, 0}, {0, 0, 1}, 90), {0, 1, 0});
}

// R_z(C) R_y(B) e3 = (sin B cos C, sin B sin C, cos B).
TEST(RotaryMachines, TurnTheToolByBothAxes) {
  const RotaryMachine m = machine(head(), {});
  expect(m.direction(30, 90), {0, 0.5, std::sqrt(0.75)});
  expect(m.direction(-90, 60), {-0.5, -std::sqrt(0.75), 0});
  expect(m.work_line, {0, 0, 1});
  expect(m.tool_line, {0, 1, 0});
}

// No. 19682 is Z and No. 19697 is Z where they are not given; 19697 = 1 and 2: X and Y.
TEST(RotaryMachines, TakeLinesAndReferenceFromTheirParameters) {
  spec::Setup bare = head();
  bare.parameters.erase({19682, -1});
  expect(machine(bare, {}).work_line, {0, 0, 1});
  expect(machine(head(), {}).reference, {0, 0, 1});
  expect(machine(head(), {{19697, 1}}).reference, {1, 0, 0});
  expect(machine(head(), {{19697, 2}}).reference, {0, 1, 0});
  // R_y(90) e1 = -e3.
  expect(machine(head(), {{19697, 1}}).direction(90, 0), {0, 0, -1});
}

// 4, 5, 6: inclined from X to Y, from Y to Z, from Z to X by No. 19683.
TEST(RotaryMachines, TakeInclinedLines) {
  const double c = std::cos(40 * kDegree);
  const double s = std::sin(40 * kDegree);
  expect(machine(head(), {{19682, 4}, {19683, 40}}).work_line, {c, s, 0});
  expect(machine(head(), {{19682, 5}, {19683, 40}}).work_line, {0, c, s});
  expect(machine(head(), {{19682, 6}, {19683, 40}}).work_line, {s, 0, c});
}

// A head whose C about Z carries B about Y: cos B is the height of the tool, and no azimuth comes of B. Whatever B is,
// it is off by what the direction is; C by that over sin B.
TEST(RotaryMachines, PositionsOutOfDirections) {
  const RotaryMachine m = machine(head(), {});
  for (const double b : {1e-3, 5.0, 90.0, 150.0}) {
    const Posture p(m, b);
    EXPECT_TRUE(p.at_a_pole) << b;
    EXPECT_FALSE(p.singular) << b;
    EXPECT_NEAR(p.polar_sine, std::sin(b * kDegree), 1e-15) << b;
    EXPECT_NEAR(p.tool_error(1e-12) / 1e-12, 1, 1e-6) << b;
    EXPECT_NEAR(p.work_error(1e-12) * std::sin(b * kDegree) / 1e-12, 1, 1e-6) << b;
  }
  const Posture upright(m, 0);
  EXPECT_TRUE(upright.singular);
  EXPECT_EQ(upright.work_error(1e-12), 1e-12);
  EXPECT_NEAR(upright.tool_error(1e-12) / 1e-12, 1, 1e-6);
}

// B about (0, 1, 1)/√2: V = (sin B/√2, (1 - cos B)/2, (1 + cos B)/2), beyond 90 degrees nearer to the edge of reach at
// 180, no pole. At 120: height 1/4, its rate √3/4, its bend 1/4; sine of the polar angle √15/4, azimuth rate 2√2/5. In
// the edge itself an error e of the height is one of √(2e/bend) = 2√e.
TEST(RotaryMachines, PositionsOfANutatingHead) {
  const RotaryMachine m = machine(head(), {{19687, 5}, {19688, 45}});
  const Posture p(m, 120);
  EXPECT_FALSE(p.at_a_pole);
  EXPECT_NEAR(p.polar_sine, std::sqrt(15) / 4, 1e-15);
  EXPECT_NEAR(p.height_rate, std::sqrt(3) / 4, 1e-15);
  EXPECT_NEAR(p.height_bend, 0.25, 1e-15);
  EXPECT_NEAR(p.azimuth_rate, 0.4 * std::sqrt(2), 1e-15);
  const double e = 1e-12;
  EXPECT_NEAR(p.tool_error(e) / e, 4 / std::sqrt(3), 1e-9);
  EXPECT_NEAR(p.work_error(e) / e, 4 / std::sqrt(15) + 0.4 * std::sqrt(2) * 4 / std::sqrt(3), 1e-9);
  EXPECT_TRUE(Posture(m, 60).at_a_pole);
  EXPECT_NEAR(Posture(m, 180).tool_error(e), 2e-6, 1e-12);
}

}  // namespace
}  // namespace toolcomp::judge
