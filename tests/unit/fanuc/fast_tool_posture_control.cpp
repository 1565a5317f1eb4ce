// SPDX-License-Identifier: Apache-2.0
// Plans and samples of tool posture control in the fast engine, beside the worked examples
// (golden/fanuc/corpus_examples_tool_posture.cpp): the rules of singular postures, and what holds of any block.
#include "fast/fanuc/tool_posture_control/posture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "tests/unit/fast_machines.h"

namespace toolcomp::fast {
namespace {

using Outcome = PosturePlan::Outcome;
using Law = PostureMotion::Law;

PostureSample sample(PosturePlan& plan, std::uint32_t k, std::uint32_t n) {
  PostureSample result;
  plan.motion.at(k, n, result);
  for (std::size_t i = 0; i < 2; ++i) {
    const SineCosine<double> turn = sine_cosine(result.degrees[i]);
    EXPECT_NEAR(turn.sine, result.turns[i].sine, 1e-13);
    EXPECT_NEAR(turn.cosine, result.turns[i].cosine, 1e-13);
  }
  return result;
}

void expect_sample(PosturePlan& plan, std::uint32_t k, std::uint32_t n, double first, double second,
                   double tolerance = kDegrees) {
  const PostureSample s = sample(plan, k, n);
  EXPECT_NEAR(s.degrees[0], first, tolerance) << k;
  EXPECT_NEAR(s.degrees[1], second, tolerance) << k;
}

PosturePlan run(TestMachine& m, const Pose& start, const Direction& tool, bool posture = true) {
  PosturePlan plan;
  m.control.plan(start, tool, posture, plan);
  return plan;
}
PosturePlan run(TestMachine& m, const Pose& start, const Pose& end, bool posture = true) {
  PosturePlan plan;
  m.control.plan(start, end, posture, plan);
  return plan;
}
// The pose for a direction, nearest to a pair.
Pose posed(TestMachine& m, const Direction& tool, const std::string& first, const std::string& second) {
  Pose pose;
  EXPECT_TRUE(m.machine.choose(tool, m.at(first, second), pose));
  return pose;
}

const Direction kEdge = TestMachine::direction(-1, 1, 2);

TEST(FastPosture, BranchOfTypeOne) {
  TestMachine m(kHC);
  PosturePlan plan = run(m, m.at("0", "20"), m.at("90", "40"));
  EXPECT_FALSE(plan.branch_warning);
  // More than half a turn, another whole turn, the other branch: conventional, with the warning.
  for (const auto& [c, b] :
       {std::pair{"200", "20"}, std::pair{"450", "40"}, std::pair{"90", "400"}, std::pair{"270", "-40"}}) {
    plan = run(m, m.at("0", "20"), m.at(c, b));
    EXPECT_TRUE(plan.branch_warning) << c;
    EXPECT_EQ(plan.motion.law(), Law::linear);
    expect_pair(plan.end, std::stod(c), std::stod(b), 0);
  }
  // The same work-side position: in its plane, also across the pole.
  plan = run(m, m.at("30", "20"), m.at("30", "-40"));
  EXPECT_FALSE(plan.branch_warning);
  EXPECT_EQ(plan.motion.law(), Law::meridian);
  for (std::uint32_t k = 1; k < 6; ++k) expect_sample(plan, k, 6, 30, 20 - 10.0 * k);
  plan = run(m, m.at("30", "20"), m.at("30", "50"));
  for (std::uint32_t k = 1; k < 3; ++k) expect_sample(plan, k, 3, 30, 20 + 10.0 * k);
}

// Ve of worked example 5: polar angle and azimuth in degrees, as a direction in double-double.
Direction polar(const std::string& angle, const std::string& azimuth) {
  const auto p = fine_sine_cosine(TestMachine::degrees(angle));
  const auto a = fine_sine_cosine(TestMachine::degrees(azimuth));
  return fine_direction({p.sine * a.cosine, p.sine * a.sine, p.cosine}, 0x1p-98);
}

TEST(FastPosture, LimitsOfNear) {
  // 19738 = 0: neither.
  TestMachine none(kHC + parameter(19739, 180) + parameter("19696#3", "1"));
  const PosturePlan plan = run(none, none.at("0", "10"), polar("12", "176"));
  EXPECT_EQ(plan.outcome, Outcome::good);
  EXPECT_FALSE(plan.changed);
  // delta = 4 exactly: the limit itself changes.
  TestMachine exact(kHC + parameter(19738, 1) + parameter(19739, 4));
  EXPECT_TRUE(run(exact, exact.at("0", "10"), polar("12", "176")).changed);
  TestMachine below(kHC + parameter(19738, 1) + parameter("19739", "\"3.999999999\""));
  EXPECT_FALSE(run(below, below.at("0", "10"), polar("12", "176")).changed);
}

TEST(FastPosture, ChangedEnd) {
  TestMachine m(kHC + parameter(19738, 1) + parameter(19739, 5));
  PosturePlan plan = run(m, m.at("0", "10"), polar("12", "176"));
  ASSERT_TRUE(plan.changed);
  EXPECT_EQ(plan.motion.law(), Law::linear);
  EXPECT_EQ(plan.end.axis[0].kind, RotaryPosition::Kind::exact);
  // The changed pair outside the range of the axes is refused; the unchanged one counts then.
  TestMachine ranged(kHC + parameter(19738, 1) + parameter(19739, 5) + parameter(19743, 90) + parameter(19744, 0));
  plan = run(ranged, ranged.at("0", "10"), polar("12", "176"));
  EXPECT_FALSE(plan.changed);
  expect_pair(plan.end, 176, 12);
}

// What a changed end is known to does not wear off from block to block: the work-side axis stands.
TEST(FastPosture, ChangedEndsInAChain) {
  TestMachine m(kHC + parameter(19738, 30) + parameter(19739, 5));
  Pose pose = posed(m, TestMachine::direction(3, 1, 17), "0", "10");
  for (int i = 0; i < 40; ++i) {
    const int side = i % 2 == 0 ? -10 : 10;
    const PosturePlan plan = run(m, pose, TestMachine::direction(3 * side, side + side / 10, 170));
    ASSERT_TRUE(plan.changed) << i;
    EXPECT_LT(plan.end.tool.fine_error, 0x1p-55) << i;
    pose = plan.end;
  }
}

// Exactly on the edge of reach the end is as well known as elsewhere: from near Z to X, B goes from 0 to -180.
TEST(FastPosture, ChangedOnTheEdge) {
  TestMachine m(kN45 + parameter(19738, 27) + parameter(19739, 90));
  const PosturePlan plan =
      run(m, posed(m, TestMachine::direction(0, 1, 10000), "90", "0"), TestMachine::direction(1, 0, 0));
  ASSERT_TRUE(plan.changed);
  EXPECT_LT(plan.end.tool.fine_error, 0x1p-55);
}

// Worked example 7 at its limits.
TEST(FastPosture, RationalNearTest) {
  const Direction end = whole_direction({-10, 1, 50});
  const auto changed = [&](const std::string& near, const std::string& veto) {
    TestMachine m(kHC + parameter("19738", "\"" + near + "\"") + parameter("19739", "\"" + veto + "\""));
    const PosturePlan plan = run(m, posed(m, TestMachine::direction(1, 0, 5), "0", "10"), end);
    EXPECT_EQ(plan.outcome, Outcome::good);
    return plan.changed;
  };
  EXPECT_TRUE(changed("1", "6"));
  EXPECT_TRUE(changed("0.5722239119074", "5.7105931374998"));
  EXPECT_FALSE(changed("0.5722239119072", "6"));
  EXPECT_FALSE(changed("1", "5.7105931374995"));
  EXPECT_FALSE(changed("1", "-1"));
}

TEST(FastPosture, Opposite) {
  TestMachine m(kHC);
  // Type 2: fanuc.tool-center-point.choice.
  const PosturePlan plan =
      run(m, posed(m, TestMachine::direction(1, 0, 1), "0", "40"), TestMachine::direction(-2, 0, -2));
  EXPECT_EQ(plan.motion.law(), Law::linear);
  expect_pair(plan.end, 0, 225);  // by hand: C stays, B moves 180 either way, one modulo 360: the larger position
}

TEST(FastPosture, SingularEnds) {
  TestMachine m(kHC);
  // Type 2 into the pole: the work side stays.
  PosturePlan plan = run(m, posed(m, kEdge, "135", "35"), TestMachine::direction(0, 0, 3));
  EXPECT_EQ(plan.outcome, Outcome::good);
  expect_pair(plan.end, 135, 0);
  EXPECT_EQ(plan.end.axis[1].degrees, 0);
  EXPECT_EQ(plan.end.branch, 0);
  for (std::uint32_t k = 1; k < 4; ++k) expect_sample(plan, k, 4, 135, 35.2643896827547 * (1 - k / 4.0));
  // Type 1: it turns behind the block.
  plan = run(m, m.at("20", "30"), m.at("50", "0"));
  EXPECT_TRUE(plan.post_turn);
  expect_pair(plan.arrived, 20, 0, 0);
  expect_pair(plan.end, 50, 0, 0);
  expect_sample(plan, 1, 2, 20, 15);
  plan = run(m, m.at("20", "30"), m.at("20", "0"));
  EXPECT_FALSE(plan.post_turn);
  plan = run(m, m.at("20", "30"), m.at("50", "360"));
  EXPECT_TRUE(plan.branch_warning);
  EXPECT_FALSE(plan.post_turn);
  // Type 1 out of the pole: before the block.
  plan = run(m, m.at("20", "0"), m.at("50", "30"));
  EXPECT_TRUE(plan.pre_turn);
  expect_pair(plan.turned, 50, 0, 0);
  expect_sample(plan, 1, 2, 50, 15);
  plan = run(m, m.at("20", "0"), m.at("20", "-30"));
  EXPECT_FALSE(plan.pre_turn);
  EXPECT_FALSE(plan.branch_warning);
  expect_sample(plan, 1, 2, 20, -15);
  plan = run(m, m.at("20", "0"), m.at("50", "390"));
  EXPECT_TRUE(plan.branch_warning);
  EXPECT_FALSE(plan.pre_turn);
}

TEST(FastPosture, OutOfReach) {
  TestMachine m(kN45);
  // The arc between two directions above the plane never goes below it; one to below it does.
  EXPECT_EQ(run(m, posed(m, TestMachine::direction(1, 0, 1), "0", "90"), TestMachine::direction(0, 1, -1)).outcome,
            Outcome::unreachable);
  TestMachine tilted(kHC + parameter(19698, 5));
  const Pose start = posed(tilted, TestMachine::direction(1, 0, 2), "0", "20");
  // Over the cone of 5 degrees around Z that cannot be reached.
  EXPECT_EQ(run(tilted, start, TestMachine::direction(-1, 0, 2)).outcome, Outcome::unreachable);
  EXPECT_EQ(run(tilted, start, TestMachine::direction(-10, 1, 20)).outcome, Outcome::unreachable);
  EXPECT_EQ(run(tilted, start, TestMachine::direction(-1, 1, 2)).outcome, Outcome::good);
}

// What holds of any block, at random ones: even angle in the plane, the axes give the direction, no jump.
TEST(FastPosture, Samples) {
  std::mt19937_64 random(5);
  const auto component = [&] { return static_cast<std::int64_t>(random() % 201) - 100; };
  for (const std::string& parameters :
       {kHC, kTAC, kMBC, kABHead, kMAB, kN45, kT45, kHC + parameter(19698, 5), kHC + parameter(19699, 20)}) {
    SCOPED_TRACE(parameters);
    TestMachine m(parameters);
    Pose pose = m.at("10", "20");
    m.machine.freeze(pose);
    int blocks = 0;
    for (int i = 0; i < 800; ++i) {
      const std::int64_t x = component();
      const std::int64_t y = random() % 4 == 0 ? 0 : component();
      const std::int64_t z = component();
      if (x == 0 && y == 0 && z == 0) continue;
      const Direction tool = TestMachine::direction(x, y, z);
      PosturePlan plan = run(m, pose, tool);
      if (plan.outcome != Outcome::good) continue;
      ++blocks;
      const Pose from = plan.pre_turn ? plan.turned : pose;
      if (plan.motion.law() == Law::circle || plan.motion.law() == Law::meridian) {
        const Vector3<double> s{pose.tool.unit[0], pose.tool.unit[1], pose.tool.unit[2]};
        const Vector3<double> e{tool.unit[0], tool.unit[1], tool.unit[2]};
        const Vector3<double> n = cross(s, e);
        const double theta = std::atan2(std::sqrt(dot(n, n)), dot(s, e));
        const std::uint32_t parts = 64;
        std::array<double, 2> last{from.axis[0].degrees, from.axis[1].degrees};
        double steepest = 0;
        for (std::uint32_t k = 1; k <= parts; ++k) {
          PostureSample at;
          if (k < parts)
            plan.motion.at(k, parts, at);
          else
            at.degrees = {plan.end.axis[0].degrees, plan.end.axis[1].degrees}, at.turns = turns(plan.end), at.tool = e;
          const Vector3<double> forward = m.machine.tool_at(at.turns);
          const double ill = 1 / std::sqrt(std::fmax(1e-9, 1 - std::pow(dot(at.tool, {0, 0, 1}), 2)));
          expect_vector(forward, at.tool.x, at.tool.y, at.tool.z, 1e-14 * std::fmin(ill, 1e4));
          const double angle = std::atan2(dot(cross(s, at.tool), n) / std::sqrt(dot(n, n)), dot(s, at.tool));
          ASSERT_NEAR(angle, theta * k / parts, 1e-13 / std::sqrt(dot(n, n)) + 1e-14);
          for (std::size_t j = 0; j < 2; ++j) {
            steepest = std::fmax(steepest, std::abs(at.degrees[j] - last[j]));
            last[j] = at.degrees[j];
          }
        }
        // A jump by a whole turn would be 180 or more.
        ASSERT_LT(steepest, 179);
      }
      pose = plan.end;
    }
    EXPECT_GT(blocks, 50);
  }
}

// By hand, as in the tests of the model: from the edge of reach to the pole, B half a turn up and C to -90.
TEST(FastPosture, FromTheEdgeOfReachToAPole) {
  const std::string mixed = machine_of(21, kB, 5, kC, 3, 0, 1) + parameter(19683, 45);
  for (const auto& [from, to] : {std::pair{-180, 0}, std::pair{180, 360}, std::pair{540, 720}}) {
    const std::string b = std::to_string(from);
    TestMachine head(kN45);
    PosturePlan plan = run(head, head.at("0", b), TestMachine::direction(0, 0, 1));
    ASSERT_EQ(plan.outcome, Outcome::good);
    expect_pair(plan.end, -90, to);
    expect_sample(plan, 1, 2, -65.53019947929781, from + 114.4698005207022);
    TestMachine tool_and_table(mixed);
    plan = run(tool_and_table, tool_and_table.at(b, "0"), TestMachine::direction(0, 0, 1));
    expect_pair(plan.end, to, -90);
    TestMachine table(kT45);
    Pose frozen = table.at(b, "0");
    table.machine.freeze(frozen);
    plan = run(table, frozen, TestMachine::direction(0, 1, 0));
    expect_pair(plan.end, to, -90);
  }
  // Type 1: toward the pair commanded.
  TestMachine head(kN45);
  EXPECT_FALSE(run(head, head.at("0", "180"), head.at("-90", "360")).branch_warning);
  EXPECT_FALSE(run(head, head.at("0", "180"), head.at("90", "0")).branch_warning);
  const PosturePlan turned = run(head, head.at("0", "180"), head.at("10", "360"));
  EXPECT_FALSE(turned.branch_warning);
  EXPECT_TRUE(turned.post_turn);
  expect_pair(turned.arrived, -90, 360);
  EXPECT_TRUE(run(head, head.at("0", "180"), head.at("-90", "720")).branch_warning);
}

// Every block between directions of small whole numbers, where exact ties are common: singular and opposite ones,
// through a pole, on the edge of reach. Doubles and double-double plan the same, and the motion has no jump.
TEST(FastPosture, SmallDirections) {
  std::vector<Direction> directions;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z)
        if (x % 2 != 0 || y % 2 != 0 || z % 2 != 0) directions.push_back(TestMachine::direction(x, y, z));
  for (const std::string& parameters :
       {kHC, kTAC, kMBC, kABHead, kABTable, kN45, kT45, kHC + parameter(19699, 45), kHC + parameter(19698, 45)}) {
    SCOPED_TRACE(parameters);
    TestMachine m(parameters + parameter(19738, 10) + parameter(19739, 30));
    int blocks = 0;
    int fine_ones = 0;
    for (const Direction& from : directions) {
      Pose start;
      if (!m.machine.choose(from, m.at("45", "-45"), start)) continue;
      for (const Direction& to : directions) {
        PosturePlan plan = run(m, start, to);
        Pose fine_start = start;
        fine_start.tool = fine_direction(m.kinematics.refine(from), 0x1p-98);
        for (std::size_t i = 0; i < 2; ++i) m.machine.set_rounded(fine_start, i, m.machine.count(start, i));
        const PosturePlan fine = run(m, fine_start, fine_direction(m.kinematics.refine(to), 0x1p-98));
        ASSERT_EQ(plan.outcome, fine.outcome) << from.unit.transpose() << " to " << to.unit.transpose();
        if (plan.outcome != Outcome::good) continue;
        ++blocks;
        ASSERT_EQ(plan.pre_turn, fine.pre_turn);
        ASSERT_EQ(plan.changed, fine.changed);
        ASSERT_EQ(plan.branch_warning, fine.branch_warning);
        for (std::size_t i = 0; i < 2; ++i)
          ASSERT_NEAR(plan.end.axis[i].degrees, fine.end.axis[i].degrees, 1e-12)
              << from.unit.transpose() << " to " << to.unit.transpose();
        fine_ones += plan.end.axis[0].kind == RotaryPosition::Kind::inverse ? 0 : 1;
        const Pose& begin = plan.pre_turn ? plan.turned : start;
        std::array<double, 2> last{begin.axis[0].degrees, begin.axis[1].degrees};
        constexpr std::uint32_t kParts = 90;
        for (std::uint32_t k = 1; k <= kParts; ++k) {
          PostureSample at;
          at.degrees = {plan.end.axis[0].degrees, plan.end.axis[1].degrees};
          if (k < kParts) plan.motion.at(k, kParts, at);
          for (std::size_t i = 0; i < 2; ++i) {
            ASSERT_LT(std::abs(at.degrees[i] - last[i]), 40)
                << from.unit.transpose() << " to " << to.unit.transpose() << " at " << k << " axis " << i;
            last[i] = at.degrees[i];
          }
        }
      }
    }
    EXPECT_GT(blocks, 1000);
    EXPECT_GT(fine_ones, 0);
  }
}

// The same for type 1, between positions that are multiples of 45 or a hair off them.
TEST(FastPosture, CommandedPositions) {
  const std::array<const char*, 8> first{"0", "45", "-90", "180", "405", "0.000001", "179.999999", "-45"};
  const std::array<const char*, 8> second{"0", "45", "-90", "180", "-135", "-0.000001", "89.999999", "360"};
  for (const std::string& parameters : {kHC, kTAC, kMBC, kABHead, kN45, kT45, kHC + parameter(19698, 45)}) {
    SCOPED_TRACE(parameters);
    TestMachine m(parameters);
    int lifted = 0;
    for (const char* a : first)
      for (const char* b : second)
        for (const char* c : first)
          for (const char* d : second) {
            const Pose start = m.at(a, b);
            const Pose end = m.at(c, d);
            PosturePlan plan = run(m, start, end);
            Pose rounded_start = start;
            Pose rounded_end = end;
            for (std::size_t i = 0; i < 2; ++i) {
              m.machine.set_rounded(rounded_start, i, start.axis[i].count);
              m.machine.set_rounded(rounded_end, i, end.axis[i].count);
            }
            rounded_start.tool = fine_direction(m.kinematics.refine(start.tool), 0x1p-98);
            rounded_end.tool = fine_direction(m.kinematics.refine(end.tool), 0x1p-98);
            rounded_start.relative = rounded_end.relative = false;
            const PosturePlan fine = run(m, rounded_start, rounded_end);
            const std::string which = std::string(a) + "," + b + " to " + c + "," + d;
            ASSERT_EQ(plan.outcome, fine.outcome) << which;
            if (plan.outcome != Outcome::good) continue;
            ASSERT_EQ(plan.pre_turn, fine.pre_turn) << which;
            ASSERT_EQ(plan.post_turn, fine.post_turn) << which;
            ASSERT_EQ(plan.branch_warning, fine.branch_warning) << which;
            if (plan.motion.law() == Law::linear) continue;
            ++lifted;
            const Pose& begin = plan.pre_turn ? plan.turned : start;
            const Pose& stop = plan.post_turn ? plan.arrived : end;
            std::array<double, 2> last{begin.axis[0].degrees, begin.axis[1].degrees};
            constexpr std::uint32_t kParts = 90;
            // Past a pole at a hair's breadth the work side swings by 180 at once.
            for (std::uint32_t k = 1; k <= kParts; ++k) {
              PostureSample at;
              at.degrees = {stop.axis[0].degrees, stop.axis[1].degrees};
              if (k < kParts) plan.motion.at(k, kParts, at);
              for (std::size_t i = 0; i < 2; ++i) {
                ASSERT_LT(std::abs(at.degrees[i] - last[i]), 181) << which << " at " << k << " axis " << i;
                last[i] = at.degrees[i];
              }
            }
          }
    EXPECT_GT(lifted, 100);
  }
}

}  // namespace
}  // namespace toolcomp::fast
