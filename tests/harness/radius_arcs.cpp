// SPDX-License-Identifier: Apache-2.0
// Arcs by R hardly longer than half their chord: what a controller in plain doubles gives is right, a lie of a few
// times what doubles leave open is none. The controller here is a few lines of its own; bounds are worked out by hand.
#include "judge/oracle/radius_arc.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "judge/oracle/policy.h"
#include "judge/oracle/verdict.h"
#include "tests/harness/liar.h"

namespace toolcomp::judge {
namespace {

constexpr double kDegrees = 57.29577951308232;  // in a radian
using Point = std::array<double, 2>;

// A counterclockwise arc by R, as any textbook has it.
struct PlainArc {
  Point start;
  Point end;
  double radius;  // negative: the larger arc
  Point center{};
  double sweep = 0;  // degrees

  PlainArc(const Point& from, const Point& to, double r) : start(from), end(to), radius(r) {
    const Point chord = {to[0] - from[0], to[1] - from[1]};
    const double half2 = (chord[0] * chord[0] + chord[1] * chord[1]) / 4;
    const double over = std::sqrt(std::fmax(r * r - half2, 0));
    const double height = r < 0 ? -over : over;
    const double half = std::sqrt(half2);
    center = {(from[0] + to[0]) / 2 - height * chord[1] / (2 * half),
              (from[1] + to[1]) / 2 + height * chord[0] / (2 * half)};
    sweep = 2 * kDegrees * std::atan2(half, height);
  }
  // Beside an end, by `offset` towards the centre.
  [[nodiscard]] Point beside(const Point& corner, double offset) const {
    const double size = std::fabs(radius);
    return {corner[0] + offset * (center[0] - corner[0]) / size, corner[1] + offset * (center[1] - corner[1]) / size};
  }
};

struct Example {
  std::string start;
  std::string end;
  std::string radius;
  PlainArc plain;
};

// Along an axis and aslant, small and large, near and far from the origin; half circles that doubles miss.
const std::vector<Example>& examples() {
  static const std::vector<Example> all = {
      {"X0 Y0", "X20. Y0", "R10.000001", {{0, 0}, {20, 0}, 10.000001}},
      {"X0 Y0", "X20. Y0", "R-10.000001", {{0, 0}, {20, 0}, -10.000001}},
      {"X0.1 Y0.7", "X12.1 Y16.7", "R10.0001", {{0.1, 0.7}, {12.1, 16.7}, 10.0001}},
      {"X0.1 Y0.7", "X12.1 Y16.7", "R10.00000001", {{0.1, 0.7}, {12.1, 16.7}, 10.00000001}},
      {"X0.1 Y0.7", "X12.1 Y16.7", "R10.", {{0.1, 0.7}, {12.1, 16.7}, 10}},
      {"X1000.1 Y-2000.3", "X1000.4 Y-2000.3", "R0.1500001", {{1000.1, -2000.3}, {1000.4, -2000.3}, 0.1500001}},
      {"X-0.3 Y0.1", "X0.3 Y-0.7", "R.5", {{-0.3, 0.1}, {0.3, -0.7}, 0.5}},
      {"X0.1 Y0", "X0.8 Y0", "R0.35", {{0.1, 0}, {0.8, 0}, 0.35}},
  };
  return all;
}

spec::Case arc_case(const Example& example) {
  spec::Case c;
  c.section = "fanuc/cutter-compensation-c";
  c.program = "G90 G01 F100 " + example.start + "\nG03 " + example.end + " " + example.radius + "\n";
  return c;
}

void expect_agrees(const spec::Case& c, const ModelRun& run, const std::vector<fast::Event>& events) {
  const Verdict v = judge::judge(c, run, events);
  EXPECT_EQ(v.outcome, Outcome::agrees) << c.program << (v.difference ? explain(*v.difference) : v.undecided);
  EXPECT_EQ(v.wide, 0U);
}

TEST(RadiusArcs, PlainDoublesAreRight) {
  double farthest = 0;
  for (const Example& example : examples()) {
    const spec::Case c = arc_case(example);
    const ModelRun run = run_model(c);
    std::vector<fast::Event> events = test::in_doubles(run);
    ASSERT_EQ(events.size(), 2U) << c.program;
    spec::Arc<double>& arc = *events[1].arc;
    for (const std::size_t i : {0U, 1U}) {
      farthest = std::fmax(farthest, std::fabs(arc.center[i] - example.plain.center[i]));
      arc.center.set(i, example.plain.center[i]);
    }
    arc.sweep = example.plain.sweep;
    expect_agrees(c, run, events);
  }
  EXPECT_GT(farthest, 1e-9) << "some are far from the exact centre";
}

// R10.000001 over 20: h² = 2e-5, R/h = 2236, and an ulp of 20 is 2^-48: 32 · 2236 · 2^-48 = 2.54e-10; its sweep turns
// by twice that over R, 2.9e-9 degrees. The half circle: √(32 · 2 · 10 · 2^-48) = 1.51e-6 at most, and 1.73e-5 degrees.
TEST(RadiusArcs, ALieOfAFewTimesTheBoundIsFound) {
  struct Bound {
    std::string radius;
    double center;
    double sweep;
  };
  for (const Bound& bound : {Bound{"R10.000001", 2.54e-10, 2.92e-9}, Bound{"R-10.000001", 2.54e-10, 2.92e-9},
                             Bound{"R10.", 1.51e-6, 1.73e-5}}) {
    const spec::Case c = arc_case({"X0 Y0", "X20. Y0", bound.radius, {{0, 0}, {20, 0}, 10}});
    const ModelRun run = run_model(c);
    const std::vector<fast::Event> honest = test::in_doubles(run);
    for (const double by : {1.0, -1.0}) {
      std::vector<fast::Event> events = honest;
      test::lie_in_axis(events[1].arc->center, 1, by * 0.9 * bound.center);
      expect_agrees(c, run, events);
      test::lie_in_axis(events[1].arc->center, 1, by * 2 * bound.center);
      EXPECT_EQ(judge::judge(c, run, events).outcome, Outcome::differs) << bound.radius;
      events = honest;
      *events[1].arc->sweep += by * 0.9 * bound.sweep;
      expect_agrees(c, run, events);
      *events[1].arc->sweep += by * 2 * bound.sweep;
      EXPECT_EQ(judge::judge(c, run, events).outcome, Outcome::differs) << bound.radius;
    }
  }
}

// I and J give the centre itself: the same arc is granted 32 ulps of 20, 1.1e-13.
TEST(RadiusArcs, OnlyWhereRGivesTheArc) {
  spec::Case c;
  c.section = "fanuc/cutter-compensation-c";
  c.program = "G90 G01 F100 X0 Y0\nG03 X20. Y0 I10. J0.001\n";
  const ModelRun run = run_model(c);
  std::vector<fast::Event> events = test::in_doubles(run);
  test::lie_in_axis(events[1].arc->center, 1, 3e-13);
  EXPECT_EQ(judge::judge(c, run, events).outcome, Outcome::differs);
}

// G41, 2 towards the centre: both heads lie on the radii, and the tool's own arc has the programmed sweep. A head is
// off by 2/10 of the centre at most: 32 · 0.2 · (2236 · 2^-48), which the estimate doubles.
TEST(RadiusArcs, HeadsBesideThem) {
  spec::Case c;
  c.section = "fanuc/cutter-compensation-c";
  c.setup.d[1].geometry = spec::decimal(2);
  c.program = "G90 G00 X0 Y30.\nG41 D1 G01 X0 Y0 F100\nG03 X20. Y0 R10.000001\n";
  const ModelRun run = run_model(c);
  const PlainArc plain({0, 0}, {20, 0}, 10.000001);
  std::vector<fast::Event> events = test::in_doubles(run);
  ASSERT_EQ(events.size(), 3U);
  const std::array<Point, 2> heads = {plain.beside({0, 0}, 2), plain.beside({20, 0}, 2)};
  for (const std::size_t e : {0U, 1U})
    for (const std::size_t i : {0U, 1U}) {
      EXPECT_NEAR(events[e + 1].point[i], heads.at(e).at(i), 1e-11);
      events[e + 1].point.set(i, heads.at(e).at(i));
      events[e + 1].axes.set(i, heads.at(e).at(i));
    }
  for (const std::size_t i : {0U, 1U}) events[2].arc->center.set(i, plain.center.at(i));
  events[2].arc->sweep = plain.sweep;
  events[2].arc->radius.reset();
  expect_agrees(c, run, events);
  test::lie_in_axis(events[2].point, 1, 5e-10);
  EXPECT_EQ(judge::judge(c, run, events).outcome, Outcome::differs);
}

// Tool center point control, the tool upright: the samples lie on the arc.
TEST(RadiusArcs, SamplesOnThem) {
  spec::Case c;
  c.section = "fanuc/tool-center-point-control";
  c.setup.axes = spec::Axes("XYZBC");
  for (const auto& [number, value] :
       std::vector<std::pair<std::uint32_t, std::int64_t>>{{19680, 2}, {19681, 5}, {19682, 3}, {19686, 4}, {19687, 2}})
    c.setup.parameters[{number, -1}] = spec::decimal(value);
  c.program = "G90 G01 F1000\nG43.4 H1\nX0 Y0\nG03 X20. Y0 R10.000001\n";
  c.samples = 4;
  const ModelRun run = run_model(c);
  const PlainArc plain({0, 0}, {20, 0}, 10.000001);
  std::vector<fast::Event> events = test::in_doubles(run);
  std::size_t samples = 0;
  for (fast::Event& event : events) {
    if (event.kind != spec::EventKind::sample || event.line != 4) continue;
    ++samples;
    const double t = event.t_numerator / static_cast<double>(event.t_denominator);
    const double angle = t * plain.sweep / kDegrees;
    const Point out = {-plain.center[0], -plain.center[1]};
    const Point at = {plain.center[0] + std::cos(angle) * out[0] - std::sin(angle) * out[1],
                      plain.center[1] + std::sin(angle) * out[0] + std::cos(angle) * out[1]};
    for (const std::size_t i : {0U, 1U}) {
      EXPECT_NEAR(event.point[i], at.at(i), 1e-11);
      event.point.set(i, at.at(i));
      event.axes.set(i, at.at(i));
    }
  }
  EXPECT_EQ(samples, 3U);
  for (const std::size_t i : {0U, 1U}) events.back().arc->center.set(i, plain.center.at(i));
  events.back().arc->sweep = plain.sweep;
  expect_agrees(c, run, events);
}

// With u = 1e-15, R = 10, k = 8: E = 1.6e-13, √E = 4e-7. Far above the chord k · R/h · u; from √E down √E.
TEST(RadiusArcs, TheHeightIsBounded) {
  const auto granted = [](double height) { return 8 * policy::height_error(10, height, 1e-15, 8); };
  EXPECT_NEAR(granted(1), 8e-14, 1e-20);
  EXPECT_NEAR(granted(0.01), 8e-12, 1e-18);
  EXPECT_NEAR(granted(4e-7), 4e-7, 1e-15);
  EXPECT_NEAR(granted(1e-9), 4e-7, 1e-15);
  EXPECT_NEAR(granted(0), 4e-7, 1e-15);
  double before = granted(0);
  for (double height = 1e-9; height < 10; height *= 1.1) {
    EXPECT_LE(granted(height), before * (1 + 1e-12)) << height;
    before = granted(height);
  }
}

}  // namespace
}  // namespace toolcomp::judge
