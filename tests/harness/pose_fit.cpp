// SPDX-License-Identifier: Apache-2.0
// Poses judged by what they do: controllers whose rotary positions are others than the model's, and right or wrong all
// the same. Where the axes have to stand is worked out by hand from the clauses fanuc.tool-direction.of-pose
// and fanuc.tool-center-point.control-point-*.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "judge/oracle/verdict.h"

namespace toolcomp::judge {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// C about Z carries B about Y: V = (sin B cos C, sin B sin C, cos B), control point = tip + 100 V.
spec::Setup head() {
  spec::Setup setup;
  setup.axes = spec::Axes("XYZBC");
  setup.parameters[{1411, -1}] = spec::decimal(100);
  setup.parameters[{19680, -1}] = spec::decimal(2);
  setup.parameters[{19681, -1}] = spec::decimal(5);
  setup.parameters[{19682, -1}] = spec::decimal(3);
  setup.parameters[{19686, -1}] = spec::decimal(4);
  setup.parameters[{19687, -1}] = spec::decimal(2);
  setup.h[1].geometry = spec::decimal(100);
  return setup;
}

// B turns the tool, C a table about the machine's zero: the tip goes to R_z(-C) of where it is programmed.
spec::Setup mixed() {
  spec::Setup setup = head();
  setup.parameters[{19680, -1}] = spec::decimal(21);
  setup.parameters[{19681, -1}] = spec::decimal(4);
  setup.parameters[{19682, -1}] = spec::decimal(2);
  setup.parameters[{19686, -1}] = spec::decimal(5);
  setup.parameters[{19687, -1}] = spec::decimal(3);
  setup.parameters[{19689, -1}] = spec::decimal(1);
  return setup;
}

constexpr std::size_t kB = 3;
constexpr std::size_t kC = 4;

using Change = std::function<void(std::vector<fast::Event>&)>;

Verdict judged(const spec::Setup& setup, const std::string& program, const Change& change, std::uint32_t samples = 0) {
  spec::Case c;
  c.section = "fanuc/tool-posture-control";
  c.setup = setup;
  c.program = program;
  c.samples = samples;
  std::vector<fast::Event> events = run_fast(c);
  change(events);
  return judge::judge(c, events);
}

void set(fast::Event& event, std::size_t axis, double value) {
  event.axes.set(axis, value);
  if (event.machine.has(axis)) event.machine.set(axis, value);
}

// The table of mixed() at another C, tool upright: X Y of the axes go with it.
void turn_table(fast::Event& event, double c) {
  const double x = event.point[0];
  const double y = event.point[1];
  set(event, kC, c);
  set(event, 0, x * std::cos(c * kDegree) + y * std::sin(c * kDegree));
  set(event, 1, -x * std::sin(c * kDegree) + y * std::cos(c * kDegree));
}

// The tool upright: where C stands is the controller's choice, and the axes follow it.
constexpr const char* kUpright = "G43.5 H1 P0\nG01 X10 Y20 I0 J0 K1\nX30 Y-5\nX0 Y5 I1 J0 K0\n";

TEST(PoseFit, AnyWorkSidePositionAtASingularPosture) {
  for (const double c : {1e-9, 1.0, -90.0, 179.0}) {
    const Verdict v = judged(mixed(), kUpright, [c](auto& events) { turn_table(events.at(1), c); });
    EXPECT_EQ(v.outcome, Outcome::agrees) << c << " " << (v.difference ? explain(*v.difference) : "");
    EXPECT_EQ(v.wide, 0U);
    // A head does not even move.
    EXPECT_EQ(judged(head(), kUpright, [c](auto& events) { set(events.at(1), kC, c); }).outcome, Outcome::agrees) << c;
  }
}

// It stands where it has it while it is not asked to turn.
TEST(PoseFit, ItGoesOnFromThere) {
  const Verdict v = judged(mixed(), kUpright, [](auto& events) {
    turn_table(events.at(1), 33);
    turn_table(events.at(2), 33);
  });
  EXPECT_EQ(v.outcome, Outcome::agrees) << (v.difference ? explain(*v.difference) : "");
}

// Behind the end of the mode too, where X Y Z do not go with it. The tip stands in the middle of the table till then.
TEST(PoseFit, ItStandsThereBehindTheMode) {
  const char* const program = "G43.5 H1 P0\nG01 Z20 I0 J0 K1\nG49\nX5\nY7\n";
  const auto judged_with = [&](double off) {
    return judged(mixed(), program, [off](auto& events) {
      turn_table(events.at(1), 33);
      for (std::size_t i = 2; i < events.size(); ++i) set(events[i], kC, 33);
      set(events.back(), 0, events.back().axes[0] + off);
    });
  };
  const Verdict v = judged_with(0);
  EXPECT_EQ(v.outcome, Outcome::agrees) << (v.difference ? explain(*v.difference) : "");
  EXPECT_EQ(judged_with(1e-6).outcome, Outcome::differs);
}

TEST(PoseFit, EverythingElseHasToFitIt) {
  EXPECT_EQ(judged(mixed(), kUpright, [](auto& events) { set(events.at(1), kC, 33); }).outcome, Outcome::differs);
  EXPECT_EQ(judged(mixed(), kUpright,
                   [](auto& events) {
                     turn_table(events.at(1), 33);
                     set(events.at(1), 0, events.at(1).axes[0] + 1e-6);
                   })
                .outcome,
            Outcome::differs);
  EXPECT_EQ(judged(mixed(), kUpright, [](auto& events) { (*events.at(1).tool_axis)[0] = 1e-6; }).outcome,
            Outcome::differs);
  // A whole turn is a decision.
  for (const double c : {360.0, -54321.0})
    EXPECT_EQ(judged(mixed(), kUpright, [c](auto& events) { turn_table(events.at(1), c); }).outcome, Outcome::differs);
}

// Commanded positions are what they are.
TEST(PoseFit, NoChoiceWhereThePositionIsCommanded) {
  const char* const program = "G43.4 H1 P0\nG01 X10 Y20 B0 C0\nX30\n";
  for (const double c : {1e-9, 1.0})
    EXPECT_EQ(judged(mixed(), program, [c](auto& events) { turn_table(events.at(1), c); }).outcome, Outcome::differs);
  // Inside a block too, where an axis of the head turns nothing; 1 degree went unseen once.
  for (const double c : {1e-9, 1.0})
    EXPECT_EQ(judged(
                  head(), program,
                  [c](auto& events) {
                    for (fast::Event& event : events)
                      if (event.kind == spec::EventKind::sample) return set(event, kC, c);
                  },
                  2)
                  .outcome,
              Outcome::differs);
}

// Away from singular postures the direction decides: a hair off, or the other pair, all of it consistent.
TEST(PoseFit, TheDirectionDecidesElsewhere) {
  const char* const program = "G43.5 H1 P0\nG01 X10 Y20 I1 J1 K1\n";
  const double b = std::acos(1 / std::sqrt(3)) / kDegree;
  const auto turn = [](fast::Event& event, double at_b, double at_c) {
    const double v[] = {std::sin(at_b * kDegree) * std::cos(at_c * kDegree),
                        std::sin(at_b * kDegree) * std::sin(at_c * kDegree), std::cos(at_b * kDegree)};
    set(event, kB, at_b);
    set(event, kC, at_c);
    for (std::size_t i = 0; i < 3; ++i) {
      (*event.tool_axis)[i] = v[i];
      set(event, i, event.point[i] + 100 * v[i]);
    }
  };
  const auto outcome = [&](double at_b, double at_c) {
    return judged(head(), program, [&](auto& events) { turn(events.at(1), at_b, at_c); }).outcome;
  };
  EXPECT_EQ(outcome(b, 45), Outcome::agrees);
  EXPECT_EQ(outcome(b, 45 + 1e-12), Outcome::agrees);
  EXPECT_EQ(outcome(b, 45 + 1e-10), Outcome::differs);
  EXPECT_EQ(outcome(b + 1e-10, 45), Outcome::differs);
  EXPECT_EQ(outcome(-b, -135), Outcome::differs);
  EXPECT_EQ(outcome(b, 405), Outcome::differs);
}

// 1e-7 from upright C is known to 1e-9 only, and what it does to 1e-16.
TEST(PoseFit, NearASingularPosture) {
  const char* const program = "G43.5 H1 P0\nG01 X10 Y20 I1 J1 K10000000\n";
  EXPECT_EQ(judged(head(), program, [](auto& events) { set(events.at(1), kC, 45 + 1e-9); }).outcome, Outcome::agrees);
  EXPECT_EQ(judged(head(), program, [](auto& events) { set(events.at(1), kC, 45 + 1e-5); }).outcome, Outcome::differs);
  EXPECT_EQ(judged(head(), program, [](auto& events) { set(events.at(1), kB, events.at(1).axes[kB] + 1e-9); }).outcome,
            Outcome::differs);
}

// Without kinematics the direction is that of I J K: a controller that rounds it to six places has its axes along what
// it gives, V = (1, 1, 1)/√3 and 100 V beyond the tip.
TEST(PoseFit, ADirectionThatIsRounded) {
  spec::Case c;
  c.section = "fanuc/tool-center-point-control";
  c.setup.axes = spec::Axes("XYZ");
  c.setup.h[1].geometry = spec::decimal(100);
  c.program = "G43.5 H1\nG01 X10 Y20 I1 J1 K1 F100\n";
  const ModelRun run = run_model(c);
  JudgeOptions options;
  options.resolution.vectors = 1e-6;
  const auto agrees = [&](double off) {
    std::vector<fast::Event> events = run_fast(c);
    fast::Event& last = events.back();
    for (std::size_t i = 0; i < 3; ++i) {
      const double rounded = i == 0 ? 0.577351 : 0.57735;
      (*last.tool_axis)[i] = rounded;
      set(last, i, last.point[i] + 100 * rounded + off);
    }
    return judge::judge(c, run, events, options).outcome == Outcome::agrees;
  };
  EXPECT_TRUE(agrees(0));
  EXPECT_FALSE(agrees(1e-6));
  EXPECT_FALSE(agrees(-1e-6));
}

// Inside a block, and what is programmed behind the end of the mode.
TEST(PoseFit, SamplesAndTheEndOfTheMode) {
  const char* const program = "G43.5 H1 P1\nG01 X10 Y20 I1 J1 K2\nX30 I1 J-1 K2\nG49\nX5\nY7\n";
  const auto outcome = [&](const Change& change) { return judged(head(), program, change, 3).outcome; };
  const auto last = [](std::vector<fast::Event>& events) -> fast::Event& { return events.back(); };
  EXPECT_EQ(outcome([](auto&) {}), Outcome::agrees);
  for (const double off : {1e-6, 1e-3, 1.0, 1e5}) {
    EXPECT_EQ(outcome([&](auto& events) { set(last(events), 0, last(events).axes[0] + off); }), Outcome::differs)
        << off;
    EXPECT_EQ(outcome([&](auto& events) {
                for (fast::Event& event : events)
                  if (event.kind == spec::EventKind::sample) return set(event, kC, event.axes[kC] + off);
              }),
              Outcome::differs)
        << off;
  }
}

}  // namespace
}  // namespace toolcomp::judge
