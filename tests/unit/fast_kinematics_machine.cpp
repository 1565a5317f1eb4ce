// SPDX-License-Identifier: Apache-2.0
// Inverse kinematics, choice of the pair and control point of the fast engine, beside the worked examples 1, 2, 9 and
// 11 (golden/fanuc/corpus_examples_tool_center_point.cpp); forward after inverse on every type.
#include "fast/kinematics/machine.h"
#include "tests/effort.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/unit/fast_machines.h"

namespace toolcomp::fast {
namespace {

TEST(FastMachine, EdgesOfReach) {
  TestMachine n45(kN45);
  Pose end;
  ASSERT_TRUE(n45.machine.choose(TestMachine::direction(1, 0, 0), n45.at("300", "170"), end));
  expect_pair(end, 270, 180);
  EXPECT_EQ(end.axis[0].degrees, 270);  // a double root is exact
  EXPECT_EQ(end.axis[1].degrees, 180);
  EXPECT_EQ(end.branch, 0);
  EXPECT_FALSE(n45.machine.choose(TestMachine::direction(0, 0, -1), n45.at("0", "0"), end));
  EXPECT_FALSE(n45.machine.choose(TestMachine::direction(1, 0, -1), n45.at("0", "0"), end));
  TestMachine hc(kHC);
  ASSERT_TRUE(hc.machine.choose(TestMachine::direction(0, 0, 1), hc.at("12.5", "20"), end));
  EXPECT_EQ(end.axis[0].degrees, 12.5);
  EXPECT_EQ(end.axis[0].kind, RotaryPosition::Kind::exact);
  EXPECT_EQ(end.axis[1].degrees, 0);
  TestMachine tilted(kHC + parameter(19698, 5));
  EXPECT_FALSE(tilted.machine.choose(TestMachine::direction(0, 0, 1), tilted.at("0", "0"), end));
}

TEST(FastMachine, Ranges) {
  Pose end;
  // The limit itself is inside: HC, 45 is the exact position of (1, 0, 1).
  TestMachine hc(kHC + parameter(19743, 45) + parameter(19744, 10));
  ASSERT_TRUE(hc.machine.choose(TestMachine::direction(1, 0, 1), hc.at("90", "20"), end));
  EXPECT_EQ(end.axis[1].degrees, 45);
  EXPECT_EQ(end.axis[0].degrees, 0);
  // Below it by the least that counts.
  TestMachine below(kHC + parameter("19743", "\"44.9999999\"") + parameter(19744, 10));
  EXPECT_FALSE(below.machine.choose(TestMachine::direction(1, 0, 1), below.at("90", "20"), end));
  // No shortcut through 0/360 in a range of 0 to 360.
  TestMachine round(kHC + parameter(19741, 360) + parameter(19742, 0));
  ASSERT_TRUE(round.machine.choose(TestMachine::direction(98, 17, 100), round.at("350", "45"), end));
  EXPECT_GT(end.axis[0].degrees, 180);
  TestMachine wrong(kHC + parameter(19741, 0) + parameter(19742, 10));
  EXPECT_FALSE(wrong.machine.ranges_valid());
}

TEST(FastMachine, MixedMachinesJudgeTheTableFirst) {
  TestMachine m(kMBC);
  Pose end;
  ASSERT_TRUE(m.machine.choose(TestMachine::direction(-1, 1, 2), m.at("30", "0"), end));
  expect_pair(end, -35.2643896827547, -45);  // by hand: 45 < 135
}

// Worked example 9 in double-double, and back.
TEST(FastMachine, ControlPointOfATable) {
  TestMachine m(kTAC + parameter(19702, -100) + parameter(19704, 30) + parameter(19705, 50));
  Pose start = m.at("0", "0");
  m.machine.freeze(start);
  const Vector3<double> w{5, 10, 20};
  const auto machine = [&](const Pose& pose, const Vector3<double>& tip) {
    return m.machine.from_table(tip, turns(pose), w) + w;
  };
  expect_vector(machine(start, {30, -30, 0}), 35, -20, 20, 1e-13);
  Pose end;
  ASSERT_TRUE(m.machine.choose(TestMachine::direction(-1, 1, 2), start, end));
  const Vector3<double> back = m.machine.to_table(m.machine.from_table({20, -20, 0}, turns(end), w), turns(end), w);
  expect_vector(back, 20, -20, 0, 1e-13);
  const auto fine = [](double x) { return DoubleDouble{x, 0}; };
  const Vector3<DoubleDouble> exact = m.machine.control_point<DoubleDouble>(
      {fine(20), fine(-20), fine(0)}, m.machine.fine_turns(end), fine(100), {fine(5), fine(10), fine(20)});
  expect_vector(nearest(exact) + w, -10.6066017177982, -82.314902372249, 88.7639589068648, 1e-12);
}

// The direction of worked example 9 in double-double, and back.
TEST(FastMachine, FrozenFrame) {
  TestMachine m(kTAC + parameter(19702, -100) + parameter(19704, 30) + parameter(19705, 50));
  Pose start = m.at("20", "45");
  m.machine.freeze(start);
  const Pose pose = m.at("-35", "10");
  const FineVector& fine = m.kinematics.refine(pose.tool);
  expect_vector({fine[0].hi, fine[1].hi, fine[2].hi}, 0.328989928337166, 0.72167761037298, 0.609054228898422);
  // The singular direction of the frame, and back to the positions from the direction.
  expect_vector(m.machine.in_frame({0, 0, 1}), 0, 0.342020143325669, 0.939692620785908, 1e-14);
  Pose end;
  ASSERT_TRUE(m.machine.choose(pose.tool, m.at("-30", "0"), end));
  expect_pair(end, -35, 10);
  m.machine.release();
}

TEST(FastMachine, NothingToLeanToward) {
  TestMachine hc(kHC);
  Direction leaned;
  EXPECT_FALSE(lean(hc.kinematics, TestMachine::direction(-1, 1, 2), std::array<Int128, 3>{2, -2, -4},
                    TestMachine::degrees("3"), leaned));
  EXPECT_FALSE(lean(hc.kinematics, TestMachine::direction(-1, 1, 2), std::array<Int128, 3>{0, 0, 0},
                    TestMachine::degrees("3"), leaned));
}

TEST(FastMachine, InverseThenForward) {
  std::mt19937_64 random(11);
  const auto component = [&] { return static_cast<std::int64_t>(random() % 2001) - 1000; };
  for (const std::string& parameters :
       {kHC, kCAHead, kTAC, kBCTable, kMBC, kMAC, kABHead, kABTable, kMAB, kN45, kT45, kHC + parameter(19698, 5),
        kHC + parameter(19699, 20), kMBC + parameter(19698, -7) + parameter(19699, 33)}) {
    SCOPED_TRACE(parameters);
    TestMachine m(parameters);
    Pose present = m.at("0", "0");
    int reached = 0;
    for (std::uint64_t i = 0; i < test::random_cases(3000); ++i) {
      const std::int64_t x = component();
      const std::int64_t y = i % 7 == 0 ? 0 : component();
      const std::int64_t z = component();
      if (x == 0 && y == 0 && z == 0) continue;
      const Direction tool = TestMachine::direction(x, y, z);
      Pose end;
      if (!m.machine.choose(tool, present, end)) continue;
      ++reached;
      const Vector3<double> v = m.machine.tool_at(turns(end));
      expect_vector(v, tool.unit[0], tool.unit[1], tool.unit[2], 3e-15);
      // The count of a position is the position.
      for (std::size_t k = 0; k < 2; ++k) {
        ASSERT_NEAR(m.machine.count(end, k).nearest(), end.axis[k].degrees, 4e-12);
        ASSERT_LE(std::abs(end.axis[k].degrees - present.axis[k].degrees), 180 + 1e-9);
      }
      const Turns<DoubleDouble> fine = m.machine.fine_turns(end);
      for (std::size_t k = 0; k < 2; ++k) {
        const auto of_count = fine_sine_cosine(m.machine.count(end, k));
        ASSERT_NEAR((of_count.sine - fine[k].sine).hi, 0, 0x1p-62);
        ASSERT_NEAR((of_count.cosine - fine[k].cosine).hi, 0, 0x1p-62);
      }
      present = end;
    }
    EXPECT_GT(reached, 100);
  }
}

TEST(FastMachine, NotInvertible) {
  TestMachine parallel(machine_of(2, kC, 3, kB, 3, 0, 0));
  EXPECT_FALSE(parallel.machine.invertible());
  TestMachine along(kHC + parameter(19697, 2));  // the tool along the tool-side axis
  EXPECT_FALSE(along.machine.invertible());
  TestMachine hypothetical(parameter(19680, 12) + parameter(19681, 0) + parameter(19682, 2) + parameter(19684, 1) +
                           parameter(19685, 30) + parameter("19696#0", "1") + parameter(19686, kC) +
                           parameter(19687, 3) + parameter(19689, 1));
  EXPECT_FALSE(hypothetical.machine.invertible());
  EXPECT_TRUE(TestMachine(kN45).machine.invertible());
}

}  // namespace
}  // namespace toolcomp::fast
