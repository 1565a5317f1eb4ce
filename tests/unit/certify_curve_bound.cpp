// SPDX-License-Identifier: Apache-2.0
// Bounds of chord errors against the model's own positions inside the moves of random five-axis programs.
#include "certify/trace/curve_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "certify/trace/jet.h"
#include "fuzz/gen/generator.h"
#include "judge/oracle/control.h"
#include "model/fanuc/engine.h"
#include "spec/language/setup_format.h"
#include "tests/effort.h"

namespace toolcomp::certify {
namespace {

using exact::Rational;

double value(const exact::Real& x) {
  const exact::DoubleEnclosure bounds = x.double_enclosure();
  return bounds.lower + (bounds.upper - bounds.lower) / 2;
}

TraceSpace all_of(const spec::Axes& axes) {
  TraceSpace space;
  for (std::size_t i = 0; i < axes.size(); ++i)
    (spec::is_rotary_axis(axes.letter(i)) ? space.rotary : space.linear).push_back(i);
  return space;
}

AxisPoint axes_at(const model::InsideMove& inside, const Rational& t) {
  const spec::AxisValues<exact::Real> exact = inside.axes_at(t);
  AxisPoint point{};
  for (std::size_t i = 0; i < point.size(); ++i) point.at(i) = value(exact[i]);
  return point;
}

// What the roundings of a place and of its distance from a chord come to.
double rounding(const AxisPoint& a, const AxisPoint& b) {
  double scale = 1;
  for (const AxisPoint* p : {&a, &b})
    for (const double x : *p) scale = std::max(scale, std::fabs(x));
  return 64 * std::numeric_limits<double>::epsilon() * scale;
}

// Looks into the moves as they come.
class Looker : public model::EventSink, public model::MotionSink {
 public:
  explicit Looker(const spec::Case& c) : axes_(c.setup.axes), space_(all_of(c.setup.axes)) {}
  void on(const model::Event&) override {}
  void stand(const model::SharedZero&, std::uint64_t, const std::optional<std::uint64_t>&) override {}
  void on(const model::MoveMotion& motion) override {
    if (!motion.inside) return;
    ++moves;
    const CurveBound bound(motion.inside->form(), axes_, space_);
    for (const int k : {1, 3, 6}) holds_the_exact_place(*motion.inside, bound, Rational(k, 7));
    chord(*motion.inside, bound, Rational(1, 32), Rational(31, 32));
    chord(*motion.inside, bound, Rational(5, 32), Rational(6, 32));
    fine_chord(*motion.inside, bound, Rational(1, 3), Rational(1, 3) + Rational(1, 1000));
    fine_chord(*motion.inside, bound, Rational(3, 4), Rational(3, 4) + Rational(1, 1000));
  }

  std::size_t moves = 0;
  std::size_t bent = 0;
  std::size_t loose = 0;

 private:
  void holds_the_exact_place(const model::InsideMove& inside, const CurveBound& bound, const Rational& t) const {
    const auto space = bound.space_at(t);
    const AxisPoint exact = axes_at(inside, t);
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      if (!model::is_space_axis(axes_.letter(i))) continue;
      const exact::DoubleEnclosure& bounds = space.at(model::space_index(axes_.letter(i)));
      EXPECT_LE(bounds.lower, exact.at(i) + rounding(exact, exact)) << axes_.letter(i) << " at " << t;
      EXPECT_GE(bounds.upper, exact.at(i) - rounding(exact, exact)) << axes_.letter(i) << " at " << t;
    }
  }

  // How far the place at the fraction `part` of the chord is off it.
  [[nodiscard]] Distance off(const AxisPoint& a, const AxisPoint& b, const AxisPoint& p, double part) const {
    Distance result;
    for (const std::size_t i : space_.linear)
      result.linear = std::hypot(result.linear, p.at(i) - a.at(i) - part * (b.at(i) - a.at(i)));
    for (const std::size_t i : space_.rotary)
      result.rotary = std::max(result.rotary, std::fabs(p.at(i) - a.at(i) - part * (b.at(i) - a.at(i))));
    return result;
  }

  void chord(const model::InsideMove& inside, const CurveBound& bound, const Rational& t0, const Rational& t1) const {
    const auto [sagitta, extent] = bound.part(t0, t1);
    const AxisPoint a = axes_at(inside, t0);
    const AxisPoint b = axes_at(inside, t1);
    for (const double part : {0.125, 0.25, 0.5, 0.75, 0.875}) {
      const Distance d = off(a, b, axes_at(inside, t0 + Rational(part) * (t1 - t0)), part);
      EXPECT_LE(d.linear, sagitta.linear + rounding(a, b)) << part;
      EXPECT_LE(d.linear, extent.linear + rounding(a, b)) << part;
      EXPECT_LE(d.rotary, sagitta.rotary + rounding(a, b)) << part;
      EXPECT_LE(d.rotary, extent.rotary + rounding(a, b)) << part;
    }
  }

  // A short part is bounded closely: mostly its sagitta is met in its middle.
  void fine_chord(const model::InsideMove& inside, const CurveBound& bound, const Rational& t0, const Rational& t1) {
    chord(inside, bound, t0, t1);
    const Distance sagitta = bound.part(t0, t1).sagitta;
    const AxisPoint a = axes_at(inside, t0);
    const AxisPoint b = axes_at(inside, t1);
    const Distance d = off(a, b, axes_at(inside, (t0 + t1) / 2), 0.5);
    constexpr double visible = 1e-9;
    for (const auto& [most, real] : {std::pair(sagitta.linear, d.linear), std::pair(sagitta.rotary, d.rotary)}) {
      if (most < visible) continue;
      ++bent;
      if (!(most <= 10 * real + rounding(a, b))) ++loose;
    }
  }

  spec::Axes axes_;
  TraceSpace space_;
};

struct Seen {
  std::size_t moves = 0;
  std::size_t bent = 0;
  std::size_t loose = 0;
};

Seen look(const std::string& section, std::uint64_t cases) {
  Seen seen;
  for (std::uint64_t seed = 1; seed <= test::random_cases(cases); ++seed) {
    fuzz::SeededSource source(seed);
    const spec::Case c = fuzz::generate(section, fuzz::Mode::directed, source, 12);
    SCOPED_TRACE(section + " " + std::to_string(seed) + "\n" + spec::write_setup_toml(c.setup) + c.program);
    model::Recorder recorder;
    Looker looker(c);
    model::Engine engine(c.setup, recorder, looker, 0, &looker);
    auto reader = judge::FanucControl::reader(spec::text_source(c.program), c.setup, "program");
    spec::Block block;
    while (!engine.stopped() && reader.next(block)) engine.block(block);
    engine.end();
    seen.moves += looker.moves;
    seen.bent += looker.bent;
    seen.loose += looker.loose;
    if (testing::Test::HasFailure()) break;
  }
  return seen;
}

// f = √(1 + t²): f' = t / f, f" = 1 / f³; and 1 / f: -t / f³, (2 t² - 1) / f⁵.
TEST(Jet, DerivativesOfARoot) {
  const Rounding upward;
  const double t = 0.75;
  const double f = 1.25;
  const Jet along{t, 1.0, 0.0};
  const Jet result = root(Jet(1.0) + square(along));
  const Jet inverted = inverse(result);
  const auto expect = [](const Interval& bounds, double value) {
    EXPECT_LE(bounds.lower(), value);
    EXPECT_GE(bounds.upper(), value);
    EXPECT_LT(bounds.upper() - bounds.lower(), 1e-14);
  };
  expect(result.value, f);
  expect(result.rate, t / f);
  expect(result.second, 1 / (f * f * f));
  expect(inverted.value, 1 / f);
  expect(inverted.rate, -t / (f * f * f));
  expect(inverted.second, (2 * t * t - 1) / (f * f * f * f * f));
}

// Of the angle 3 t + 1 there is no second derivative, and of t² it is 2.
TEST(Jet, SecondDerivativeOfAnAngle) {
  const Rounding upward;
  EXPECT_LT(std::fabs(second_of_angle(turning(0.5, 1.0, 3.0)).upper()), 1e-13);
  const double c = std::cos(0.25);
  const double s = std::sin(0.25);
  const Turned squared{{c, -s, -c - 2 * s}, {s, c, -s + 2 * c}};
  EXPECT_NEAR(second_of_angle(squared).upper(), 2, 1e-14);
}

TEST(CurveBound, HoldsUnderToolCenterPointControl) {
  const Seen seen = look("fanuc/tool-center-point-control", 300);
  EXPECT_GT(seen.bent, test::random_cases(500));
  EXPECT_LT(seen.loose * 20, seen.bent) << seen.loose << " of " << seen.bent;
}

TEST(CurveBound, HoldsUnderToolPostureControl) {
  const Seen seen = look("fanuc/tool-posture-control", 300);
  EXPECT_GT(seen.bent, test::random_cases(500));
  EXPECT_LT(seen.loose * 20, seen.bent) << seen.loose << " of " << seen.bent;
}

TEST(CurveBound, HoldsWithToolSideCompensation) {
  const Seen seen = look("fanuc/tool-side-compensation", 200);
  EXPECT_GT(seen.moves, test::random_cases(100));
}

}  // namespace
}  // namespace toolcomp::certify
