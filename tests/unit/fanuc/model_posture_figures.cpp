// SPDX-License-Identifier: Apache-2.0
// The figures of the worked examples 2 to 5 and 7 to 9 beside their positions: angles between directions, distances
// from the singular posture, moments and errors. Expected values are typed in from a derivation in 50 digits, to 15.
// Where a program can show a figure both engines run it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/unit/fanuc/fast_run.h"
#include "tests/unit/fanuc/posture_run.h"
#include "tests/unit/fast_machines.h"
#include "tests/unit/model_run.h"
#include "tests/unit/printed_digits.h"

namespace {

using namespace toolcomp;
using model::Angle;
using model::Direction;
using model::GreatCircle;
using model::Pose;
using model::PosturePlan;
using model::Rational;
using model::Real;
using model::Vector;
using test::kHC;
using test::kMBC;
using test::kTAC;
using test::polar;
using test::PostureMachine;
using test::printed_digits;

// What the fast engine may be off in a figure.
constexpr double kFast = 1e-12;

// The same questions to exact numbers and to doubles.
template <class Number>
using Triple = std::array<Number, 3>;

Real degrees(const Real& x, const Real& y) { return Angle::of_direction(x, y).degrees(); }
double degrees(double x, double y) { return std::atan2(y, x) * 180 / std::numbers::pi; }

template <class Number>
Number product(const Triple<Number>& a, const Triple<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class Number>
Number between(const Triple<Number>& a, const Triple<Number>& b) {
  using std::sqrt;
  const Triple<Number> normal{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  return degrees(product(a, b), sqrt(product(normal, normal)));
}
Real between(const Vector& a, const Vector& b) {
  return between(Triple<Real>{a.x, a.y, a.z}, Triple<Real>{b.x, b.y, b.z});
}

template <class Number>
struct Events {
  std::vector<spec::Event<Number>> all;

  // The last move of a line.
  [[nodiscard]] const spec::Event<Number>& move(std::uint64_t line) const {
    return last([line](const auto& event) { return event.line == line && event.kind == spec::EventKind::move; });
  }
  [[nodiscard]] const spec::Event<Number>& sample(std::uint64_t line, std::uint32_t k, std::uint32_t n) const {
    return last([line, k, n](const auto& event) {
      return event.line == line && event.t_numerator == k && event.t_denominator == n;
    });
  }
  [[nodiscard]] Triple<Number> tool(std::uint64_t line) const { return move(line).tool_axis.value(); }
  [[nodiscard]] Triple<Number> tool(std::uint64_t line, std::uint32_t k, std::uint32_t n) const {
    return sample(line, k, n).tool_axis.value();
  }

 private:
  template <class Wanted>
  [[nodiscard]] const spec::Event<Number>& last(const Wanted& wanted) const {
    const auto found = std::find_if(all.rbegin(), all.rend(), wanted);
    if (found == all.rend()) throw std::out_of_range("no such event");
    return *found;
  }
};

// A program under both engines; `more` holds tables of the setup.
struct Both {
  Both(const std::string& parameters, const std::string& more, const std::string& program, std::uint32_t samples)
      : exact{test::run(test::machine_setup(parameters) + more, program, nullptr, samples).events()},
        fast{fast::ProgramRun(test::machine_setup(parameters) + more, program, samples).events} {}

  Events<Real> exact;
  Events<double> fast;
};

template <class Figure, class... Runs>
void expect_figure(const std::string& printed, const Figure& figure, const Runs&... runs) {
  EXPECT_EQ(printed_digits(figure(runs.exact...)), printed);
  EXPECT_NEAR(figure(runs.fast...), std::stod(printed), kFast) << printed;
}

std::string printed_text(const Vector& v) {
  return printed_digits(v.x) + ' ' + printed_digits(v.y) + ' ' + printed_digits(v.z);
}

// The point of an arc that is nearest to a direction along the work-side axis: f = s - (s·N/N²)N, inside the arc.
struct Nearest {
  Nearest(const GreatCircle& arc, const Vector& singular)
      : foot(singular - dot(singular, arc.normal()) / arc.normal2() * arc.normal()),
        distance(between(foot, singular)),
        moment(GreatCircle(arc.from(), Direction::of(foot)).swept(1) / arc.swept(1)) {}

  Vector foot;
  Real distance;  // d, degrees
  Real moment;    // t
};
const Vector kUp{0, 0, 1};
const Vector kDown{0, 0, -1};

// A figure with 15 decimals as it is printed, and the limits of what is printed so.
struct Printed {
  explicit Printed(std::int64_t units)
      : value(units, kDigits), lower(2 * units - 1, 2 * kDigits), upper(2 * units + 1, 2 * kDigits) {}

  static constexpr std::int64_t kDigits = 1'000'000'000'000'000;
  Rational value;
  Rational lower;
  Rational upper;
};

std::string near_limits(const std::string& near, const std::string& veto) {
  return "19738 = " + near + "\n19739 = " + veto + "\n";
}

// The fast engine inside a type 2 block, at k/n; pairs are (C, B).
fast::PostureSample fast_at(fast::TestMachine& machine, const fast::Pose& start, const fast::Direction& tool,
                            std::uint32_t k, std::uint32_t n) {
  fast::PosturePlan plan;
  machine.control.plan(start, tool, true, plan);
  fast::PostureSample sample;
  plan.motion.at(k, n, sample);
  return sample;
}

// What G43.5 with P1 does instead of the P0 answers of the table: the lift keeps the branch of the start. The arc
// passes the singular posture at 2.88..., which is what 19738 is held against.
TEST(Example2Figures, LiftInsteadOfTheChosenPair) {
  for (const std::string& machine : {kHC, kMBC}) {
    const PostureMachine m(machine);
    const PosturePlan plan = m.to({30, 0}, m.direction({30, 170}));
    EXPECT_EQ(test::text(plan.end), "30 170");
    const Nearest nearest(GreatCircle(m.direction({30, 0}), m.direction({30, 170})), kUp);
    EXPECT_EQ(printed_digits(nearest.distance), "2.88065908640527");
    const auto changed = [&machine](const std::string& limit) {
      const PostureMachine near(machine + near_limits(limit, "10"));
      return near.to({30, 0}, near.direction({30, 170})).changed;
    };
    EXPECT_TRUE(changed("2.88065908640527"));
    EXPECT_FALSE(changed("2.88065908640526"));
  }
}

// The edge of the pyramid; C 100 leads to the pair with C 135.
Both edge(const std::string& posture) {
  return {kHC, "[offsets.H]\n1 = 100\n",
          "G90 G00 X20 Y-20 Z0\nC100\nG43.5 H1 " + posture + "\nG01 X20 Y-20 I-1 J1 K2 F500\nX20 Y20 I-1 J-1 K2\n", 4};
}

TEST(Example3Figures, SweptAngles) {
  const Both run = edge("P1");
  expect_figure("48.1896851042214", [](const auto& p1) { return between(p1.tool(4), p1.tool(5)); }, run);
  expect_figure("12.0474212760554", [](const auto& p1) { return between(p1.tool(4), p1.tool(5, 1, 4)); }, run);
  expect_figure("24.0948425521107", [](const auto& p1) { return between(p1.tool(4), p1.tool(5, 1, 2)); }, run);
  const GreatCircle arc(Direction::of({-1, 1, 2}), Direction::of({-1, -1, 2}));
  EXPECT_EQ(printed_digits(arc.swept(1)), "48.1896851042214");
  EXPECT_EQ(printed_digits(arc.swept(Rational(1, 4))), "12.0474212760554");
  EXPECT_EQ(printed_digits(arc.swept(Rational(1, 2))), "24.0948425521107");
}

// "Off by" is the angle from the direction of P1 at the same moment (from the plane it is 6.42721596021743 at 1/4).
TEST(Example3Figures, ConventionalControlIsOff) {
  const Both p1 = edge("P1");
  const Both p0 = edge("P0");
  expect_figure(
      "6.47649209618839",
      [](const auto& plane, const auto& axes) { return between(plane.tool(5, 1, 4), axes.tool(5, 1, 4)); }, p1, p0);
  expect_figure(
      "8.69933850567666",
      [](const auto& plane, const auto& axes) { return between(plane.tool(5, 1, 2), axes.tool(5, 1, 2)); }, p1, p0);
  // n·V with the face normal n = (2, 0, 1)/√5.
  const auto lean = []<class Number>(const Events<Number>& run) {
    using std::sqrt;
    const Triple<Number> tool = run.tool(5, 1, 2);
    return (2 * tool[0] + tool[2]) / sqrt(Number(5));
  };
  expect_figure("-0.151249407824212", lean, p0);
  EXPECT_EQ(lean(p1.exact).decimal(30), "0");
}

TEST(Example4Figures, TypeOne) {
  const auto program = [](const std::string& posture) {
    return Both(kHC, "[offsets.H]\n1 = 150\n", "G90 G00 X0 Y0 Z0 B20\nG43.4 H1 " + posture + "\nG01 C90 B40 F500\n", 4);
  };
  const Both p1 = program("P1");
  const Both p0 = program("P0");
  expect_figure("43.9582070026178", [](const auto& run) { return between(run.tool(2), run.tool(3)); }, p1);
  EXPECT_EQ(printed_digits(GreatCircle(polar(20, 0), polar(40, 90)).swept(1)), "43.9582070026178");
  const auto off = [](std::uint32_t k, std::uint32_t n) {
    return [k, n](const auto& plane, const auto& axes) { return between(plane.tool(3, k, n), axes.tool(3, k, n)); };
  };
  expect_figure("7.44077318557069", off(1, 4), p1, p0);
  expect_figure("10.1887612640002", off(1, 2), p1, p0);
  expect_figure("7.69304549301491", off(3, 4), p1, p0);
}

// d and its moment belong to the foot of the singular posture on the arc, an irrational fraction of the block.
TEST(Example5Figures, NearestToTheSingularPosture) {
  const GreatCircle arc(polar(10, 0), polar(12, 176));
  const Nearest nearest(arc, kUp);
  EXPECT_EQ(printed_digits(arc.swept(1)), "21.986544776471");
  EXPECT_EQ(printed_digits(nearest.distance), "0.385422146761062");
  EXPECT_EQ(printed_digits(nearest.moment), "0.454489113510327");
  EXPECT_EQ(printed_digits(degrees(nearest.foot.x, nearest.foot.y)), "87.8135988222767");

  const PostureMachine hc(kHC + "19738 = 1\n19739 = 3\n");
  const PosturePlan plan = hc.to({10, 0}, polar(12, 176));
  const auto at = [&plan](const Rational& t) { return plan.motion->at(t).pose; };
  // B is flat there: the moment as printed gives all digits. C turns fastest, by 1.6e-12 in half a unit of the moment's
  // last digit, and is printed for the foot itself: between the moments that are printed so.
  const Printed moment(454489113510327);
  EXPECT_EQ(printed_digits(at(moment.value).tool.degrees()), "0.385422146761062");
  const Rational printed_work(878135988222767, 10'000'000'000'000);
  EXPECT_TRUE(at(moment.lower).work.degrees() < printed_work);
  EXPECT_TRUE(at(moment.upper).work.degrees() > printed_work);
  for (const int side : {-1, 1})
    EXPECT_TRUE(at(moment.value + Rational(side, 1000)).tool.degrees() > at(moment.value).tool.degrees());

  const auto changed = [](const std::string& limit, const std::string& veto) {
    return PostureMachine(kHC + near_limits(limit, veto)).to({10, 0}, polar(12, 176)).changed;
  };
  EXPECT_TRUE(changed("0.385422146761062", "5"));
  EXPECT_FALSE(changed("0.385422146761061", "5"));
  EXPECT_TRUE(changed("1", "4"));
  EXPECT_FALSE(changed("1", "3.999999999999"));

  fast::TestMachine machine(fast::kHC + fast::parameter(19738, 1) + fast::parameter(19739, 3));
  const auto end = fast::TestMachine::direction(-207405228388532, 14503186401626, 978147600733806);
  EXPECT_NEAR(fast_at(machine, machine.at("0", "10"), end, 454489114, 1'000'000'000).degrees[1], 0.385422146761062,
              kFast);
}

// All digits of the rows, from the exact pose and direction (a program gives that direction to 15 digits only). C, B.
TEST(Example5Figures, Rows) {
  EXPECT_EQ(printed_text(polar(12, 176).unit), "-0.207405228388532 0.0145031864016257 0.978147600733806");
  const PostureMachine unchanged(kHC + "19738 = 1\n19739 = 3\n");
  const PosturePlan swing = unchanged.to({10, 0}, polar(12, 176));
  const auto row = [&swing](int tenths) {
    const Pose pose = swing.motion->at(Rational(tenths, 10)).pose;
    return printed_digits(pose.work.degrees()) + ' ' + printed_digits(pose.tool.degrees());
  };
  EXPECT_EQ(row(1), "0.627160532895321 7.80345595842618");
  EXPECT_EQ(row(3), "4.27970316883873 3.41845337728643");
  EXPECT_EQ(row(4), "15.6447476915161 1.25849039506375");
  EXPECT_EQ(row(5), "156.749981593727 1.07228252285797");
  EXPECT_EQ(row(6), "170.951321299778 3.2223902158916");

  const PostureMachine hc(kHC + "19738 = 1\n19739 = 5\n");
  const PosturePlan plan = hc.to({10, 0}, polar(12, 176));
  const auto tool = [&plan](const Rational& t) { return plan.motion->at(t).tool; };
  // The tip runs to (50, 0, 0); L is 80.
  const auto control_point = [](const Rational& t, const Vector& direction) {
    return printed_text(Vector{50 * t, 0, 0} + 80 * direction);
  };
  const Rational quarter(1, 4);
  EXPECT_EQ(printed_text(tool(quarter)), "0.0784590957278449 0 0.996917333733128");
  EXPECT_EQ(printed_text(tool(2 * quarter)), "-0.0174524064372835 0 0.999847695156391");
  EXPECT_EQ(printed_text(plan.tool.unit), "-0.207911690817759 0 0.978147600733806");
  EXPECT_EQ(control_point(quarter, tool(quarter)), "18.7767276582276 0 79.7533866986502");
  EXPECT_EQ(control_point(2 * quarter, tool(2 * quarter)), "23.6038074850173 0 79.9878156125113");
  EXPECT_EQ(control_point(3 * quarter, tool(3 * quarter)), "28.4437428985675 0 79.485748454127");
  EXPECT_EQ(control_point(1, plan.tool.unit), "33.3670647345793 0 78.2518080587045");
}

// dC/dφ is greatest at the foot, 1/sin d there, φ being the swept angle.
TEST(Example5Figures, PeakOfTheSwing) {
  const GreatCircle arc(polar(10, 0), polar(12, 176));
  const Nearest nearest(arc, kUp);
  EXPECT_EQ(printed_digits(sqrt(arc.normal2() / square(pass(arc, kUp).side))), "148.658327270411");

  const PostureMachine hc(kHC + "19738 = 1\n19739 = 3\n");
  const PosturePlan plan = hc.to({10, 0}, polar(12, 176));
  // A difference over 2e-12 of the block; C is odd about the foot, the third power comes to 1e-21.
  const auto rate = [&plan, &arc](const Rational& t) {
    const Rational step(1, 1'000'000'000'000);
    const Real turned = plan.motion->at(t + step).pose.work.degrees() - plan.motion->at(t - step).pose.work.degrees();
    return turned / (arc.swept(t + step) - arc.swept(t - step));
  };
  const Rational moment = Printed(454489113510327).value;
  EXPECT_EQ(printed_digits(rate(moment)), "148.658327270411");
  for (const int side : {-1, 1}) EXPECT_TRUE(rate(moment + Rational(side, 1000)) < rate(moment));

  fast::TestMachine machine(fast::kHC + fast::parameter(19738, 1) + fast::parameter(19739, 3));
  const auto end = fast::TestMachine::direction(-207405228388532, 14503186401626, 978147600733806);
  const auto work = [&](std::uint32_t k) {
    return fast_at(machine, machine.at("0", "10"), end, k, 1'000'000'000).degrees[0];
  };
  constexpr double kApart = 2e-7;
  EXPECT_NEAR((work(454489214) - work(454489014)) / (kApart * 21.986544776471), 148.658327270411, 1e-5);
}

// The posture error of a changed end, 2 asin(sin b · sin(δ/2)): its cosine is 1 - 2 sin² b sin²(δ/2).
TEST(Example5Figures, ErrorOfTheChangedEnd) {
  const auto error = [](const Pose& start, int b, int azimuth, const Rational& half) {
    const PosturePlan plan = PostureMachine(kHC + "19738 = 1\n19739 = 5\n").to(start, polar(b, azimuth));
    EXPECT_TRUE(plan.changed);
    const Vector commanded = polar(b, azimuth).unit;
    const Real by_formula = 1 - 2 * square(exact::sin_degrees(b) * exact::sin_degrees(half));
    EXPECT_EQ((dot(plan.tool.unit, commanded) - by_formula).decimal(40), "0");
    return printed_digits(between(plan.tool.unit, commanded));
  };
  EXPECT_EQ(error({10, 0}, 12, 176, 2), "0.831485180519821");
  EXPECT_EQ(error({172, 0}, 170, 177, Rational(3, 2)), "0.52088682054418");

  const auto fast_error = [](const std::string& start, const std::string& words, const Triple<double>& commanded) {
    const fast::ProgramRun run(test::machine_setup(kHC + "19738 = 1\n19739 = 5\n"),
                               "G90 G00 X0 Y0 Z0 B" + start + "\nG43.5 H0 P1\nG01 X50 " + words + " F500\n");
    return between(run.events.back().tool_axis.value(), commanded);
  };
  EXPECT_NEAR(fast_error("10", "I-.207405228388532 J.014503186401626 K.978147600733806",
                         {-.207405228388532, .014503186401626, .978147600733806}),
              0.831485180519821, kFast);
  EXPECT_NEAR(fast_error("172", "I-.173410198874506 J.009088043428043 K-.984807753012208",
                         {-.173410198874506, .009088043428043, -.984807753012208}),
              0.52088682054418, kFast);
}

TEST(Example5Figures, AroundTheOtherPole) {
  const Nearest nearest(GreatCircle(polar(172, 0), polar(170, 177)), kDown);
  EXPECT_EQ(printed_digits(nearest.distance), "0.234590535913703");
  EXPECT_EQ(printed_digits(nearest.moment), "0.444406200134002");
  const auto changed = [](const std::string& limit, const std::string& veto) {
    return PostureMachine(kHC + near_limits(limit, veto)).to({172, 0}, polar(170, 177)).changed;
  };
  EXPECT_TRUE(changed("0.234590535913704", "5"));
  EXPECT_FALSE(changed("0.234590535913703", "5"));
  // δ is 3.
  EXPECT_TRUE(changed("1", "3"));
  EXPECT_FALSE(changed("1", "2.999999999999"));
  const PostureMachine hc(kHC);
  const PosturePlan plan = hc.to({172, 0}, polar(170, 177));
  const Real from_pole = 180 - plan.motion->at(Printed(444406200134002).value).pose.tool.degrees();
  EXPECT_EQ(printed_digits(from_pole), "0.234590535913703");

  fast::TestMachine machine(fast::kHC);
  const auto end = fast::TestMachine::direction(-173410198874506, 9088043428043, -984807753012208);
  EXPECT_NEAR(180 - fast_at(machine, machine.at("0", "172"), end, 444406200, 1'000'000'000).degrees[1],
              0.234590535913703, kFast);
}

TEST(Example7Figures, RationalNearTest) {
  const GreatCircle arc(Direction::of({1, 0, 5}), Direction::of({-1, Rational(1, 10), 5}));
  EXPECT_TRUE(arc.normal() == (Vector{Rational(-1, 2), -10, Rational(1, 10)}));
  const Real sine2 = square(pass(arc, kUp).side) / arc.normal2();
  EXPECT_EQ(sine2.rational(), Rational(1, 10026));  // 0.01/100.26
  EXPECT_EQ(printed_digits(sine2), "0.0000997406742469579");
  EXPECT_EQ(printed_digits(square(exact::sin_degrees(1))), "0.000304586490452135");
  const Nearest nearest(arc, kUp);
  EXPECT_EQ(printed_digits(nearest.distance), "0.572223911907299");
  EXPECT_EQ(printed_digits(nearest.moment), "0.498785329942942");
}

TEST(Example7Figures, ExactCrossing) {
  const GreatCircle arc(Direction::of({1, 0, 2}), Direction::of({-2, 0, 3}));
  EXPECT_EQ(printed_digits(arc.swept(1)), "60.2551187030578");
  EXPECT_EQ(printed_digits(Nearest(arc, kUp).moment), "0.440876256637926");
  // B goes through zero between the moments that are printed so.
  const PostureMachine hc(kHC);
  const PosturePlan plan = hc.to({Angle::of_direction(2, 1), 0}, Direction::of({-2, 0, 3}));
  const Printed moment(440876256637926);
  EXPECT_TRUE(plan.motion->at(moment.lower).pose.tool.degrees() > 0);
  EXPECT_TRUE(plan.motion->at(moment.upper).pose.tool.degrees() < 0);

  const Both run(kHC, "", "G90 G00 X0 Y0 Z0\nG43.5 H0 P1 I1 K2\nG01 X50 I-2 K3 F500\n", 2);
  expect_figure("60.2551187030578", [](const auto& p1) { return between(p1.tool(2), p1.tool(3)); }, run);
  fast::TestMachine machine(fast::kHC);
  fast::Pose start;
  ASSERT_TRUE(machine.machine.choose(fast::TestMachine::direction(1, 0, 2), machine.at("0", "26"), start));
  const auto tilt = [&](std::uint32_t k) {
    return fast_at(machine, start, fast::TestMachine::direction(-2, 0, 3), k, 1'000'000'000).degrees[1];
  };
  EXPECT_GT(tilt(440876256), 0);
  EXPECT_LT(tilt(440876257), 0);
}

// O0010, the whole pyramid (worked example 8); N50 is line 5.
Both pyramid(const std::string& posture) {
  return {kHC, "[offsets.H]\n1 = 100\n[offsets.D]\n2 = 5\n",
          "N10 G90 G00 X30 Y-30 Z0\nN20 G43.5 H1 " + posture +
              "\nN30 G42.6 D2\nN40 G01 X20 Y-20 I-1 J1 K2 F500\n"
              "N50 X20 Y20 I-1 J-1 K2\nN60 X-20 Y20 I1 J-1 K2\nN70 X-20 Y-20 I1 J1 K2\nN80 X20 Y-20 I-1 J1 K2\n"
              "N90 G40\nM30\n",
          4};
}

// The angle between the travels of two edges, projected along the tool at their corner.
TEST(Example8Figures, CornerOfThePyramid) {
  const Both run = pyramid("P1");
  const auto turn = []<class Number>(const Events<Number>& p1) {
    const Triple<Number> tool = p1.tool(5);
    const auto across = [&tool](const Triple<Number>& travel) {
      const Number along = product(travel, tool);
      return Triple<Number>{travel[0] - along * tool[0], travel[1] - along * tool[1], travel[2] - along * tool[2]};
    };
    return between(across({0, 1, 0}), across({-1, 0, 0}));
  };
  expect_figure("78.4630409671845", turn, run);
  // The offset vector there: its length, and the angle that this length belongs to, |D|² = 2R²/(1 + cos).
  const auto length2 = []<class Number>(const Events<Number>& p1) {
    const auto& event = p1.move(5);
    Number sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Number off = event.point[axis] - event.programmed[axis];
      sum = sum + off * off;
    }
    return sum;
  };
  const auto length = [&length2](const auto& p1) {
    using std::sqrt;
    return sqrt(length2(p1));
  };
  const auto turn_of_length = [&length2](const auto& p1) {
    using std::sqrt;
    const auto cosine = 50 / length2(p1) - 1;
    return degrees(cosine, sqrt(1 - cosine * cosine));
  };
  expect_figure("6.45497224367903", length, run);
  expect_figure("78.4630409671845", turn_of_length, run);
}

// The point 40 mm along the tool from the tip, in the middle of N50: its distance from the face 2x + z = 40.
TEST(Example8Figures, ConventionalControlGouges) {
  const auto distance = []<class Number>(const Events<Number>& run) {
    using std::sqrt;
    const auto& middle = run.sample(5, 1, 2);
    const Triple<Number> tool = middle.tool_axis.value();
    const Number x = middle.point[0] + 40 * tool[0];
    const Number z = middle.point[2] + 40 * tool[2];
    return (2 * x + z - 40) / sqrt(Number(5));
  };
  expect_figure("-1.04997631296846", distance, pyramid("P0"));
  expect_figure("5", distance, pyramid("P1"));
}

// The tip in machine coordinates: the control point stands L = 100 above it, the axes' coordinates begin at (5, 10,
// 20).
TEST(Example9Figures, TipOfATableMachine) {
  const Both run(kTAC + "19702 = -100\n19704 = 30\n19705 = 50\n",
                 "[offsets.H]\n1 = 100\n[workpiece.G54]\nX = 5\nY = 10\nZ = 20\n",
                 "G90 G00 X30 Y-30 Z0\nG43.5 H1 P1\nG01 X20 Y-20 I-1 J1 K2 F500\nX20 Y20 I-1 J-1 K2\n", 4);
  const auto expect = [&run](const auto& event, const Triple<std::string>& printed) {
    const std::array<int, 3> from_axes{5, 10, 20 - 100};
    for (std::size_t i = 0; i < 3; ++i)
      expect_figure(printed[i], [&](const auto& of) { return event(of).axes[i] + from_axes[i]; }, run);
  };
  const auto middle = [](std::uint32_t k, std::uint32_t n) {
    return [k, n](const auto& of) { return of.sample(4, k, n); };
  };
  expect([](const auto& of) { return of.move(3); }, {"-10.6066017177982", "-82.314902372249", "-11.2360410931352"});
  expect(middle(1, 4), {"-16.3075542211557", "-62.950174050187", "2.31002896251956"});
  expect(middle(1, 2), {"-20", "-49.1934955049954", "9.5673308974897"});
  expect(middle(3, 4), {"-19.7923489480995", "-47.8805445089336", "10.6588765871788"});
  expect([](const auto& of) { return of.move(4); }, {"-17.6776695296637", "-59.220891604664", "5.09389052541932"});
}

}  // namespace
