// Inverse kinematics, choice of the pair and control point of the fast engine: worked examples 1, 2, 9 and 11,
// and forward after inverse on every type.
#include "fast/kinematics/machine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/unit/fast_machines.h"

namespace toolcomp::fast {
namespace {

double basic(double degrees) {
  const double rest = std::fmod(degrees, 360);
  return rest < 0 ? rest + 360 : rest;
}

// Both pairs in 0 to 360: those nearest to themselves.
void expect_pairs(const std::string& parameters, std::int64_t i, std::int64_t j, std::int64_t k, double first1,
                  double second1, double first2, double second2) {
  SCOPED_TRACE(parameters);
  TestMachine m(parameters);
  const Direction tool = TestMachine::direction(i, j, k);
  for (const auto& [first, second] : {std::pair{first1, second1}, std::pair{first2, second2}}) {
    const Pose present = m.at(std::to_string(std::lround(first)), std::to_string(std::lround(second)));
    Pose end;
    ASSERT_TRUE(m.machine.choose(tool, present, end));
    EXPECT_NEAR(basic(end.axis[0].degrees), first, kDegrees);
    EXPECT_NEAR(basic(end.axis[1].degrees), second, kDegrees);
    const Vector3<double> forward = m.machine.tool_at(turns(end));
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(forward[c], tool.unit[static_cast<Eigen::Index>(c)], 1e-15);
  }
}

TEST(FastMachine, Example1) {
  expect_pairs(kHC, -1, 1, 2, 135, 35.2643896827547, 315, 324.735610317245);
  expect_pairs(kCAHead, -1, 1, 2, 225, 35.2643896827547, 45, 324.735610317245);
  expect_pairs(kTAC, 1, 2, 3, 36.6992252004899, 153.434948822922, 323.30077479951, 333.434948822922);
  expect_pairs(kBCTable, 1, 2, 3, 36.6992252004899, 63.434948822922, 323.30077479951, 243.434948822922);
  expect_pairs(kMBC, 1, 2, 3, 36.6992252004899, 63.434948822922, 323.30077479951, 243.434948822922);
  expect_pairs(kMAC, 1, 2, 3, 36.6992252004899, 153.434948822922, 323.30077479951, 333.434948822922);
  expect_pairs(kABHead, 1, 2, 3, 146.30993247402, 164.498640433063, 326.30993247402, 15.501359566937);
  expect_pairs(kABTable, 1, 2, 3, 327.688466762576, 18.434948822922, 212.311533237424, 198.434948822922);
  expect_pairs(kMAB, 1, 2, 3, 327.688466762576, 18.434948822922, 212.311533237424, 198.434948822922);
  expect_pairs(kN45, 1, 1, 1, 13.8260478038529, 81.1005711201888, 256.173952196147, 278.899428879811);
  expect_pairs(kT45, 1, 2, 3, 52.8741729167231, 44.0642169567833, 307.125827083277, 262.805680689061);
}

TEST(FastMachine, Example1Edges) {
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

TEST(FastMachine, Example2) {
  const auto expect = [](const std::string& parameters, const char* first, const char* second, const Direction& tool,
                         double first_end, double second_end) {
    SCOPED_TRACE(parameters + first);
    TestMachine m(parameters);
    Pose end;
    ASSERT_TRUE(m.machine.choose(tool, m.at(first, second), end));
    expect_pair(end, first_end, second_end);
  };
  const Direction v = TestMachine::direction(-1, 1, 2);
  expect(kHC, "0", "0", v, -45, -35.2643896827547);
  expect(kHC, "100", "0", v, 135, 35.2643896827547);
  expect(kHC, "350", "0", v, 315, -35.2643896827547);
  expect(kHC, "45", "0", v, -45, -35.2643896827547);
  expect(kHC, "0", "0", TestMachine::direction(0, 1, 1), 90, 45);
  expect(kTAC, "0", "0", v, -35.2643896827547, 45);
  expect(kMBC, "30", "0", v, -35.2643896827547, -45);  // by hand: the table first, 45 < 135
}

TEST(FastMachine, Example2Ranges) {
  TestMachine m(kTAC + parameter(19741, 30) + parameter(19742, -30));
  Pose end;
  EXPECT_FALSE(m.machine.choose(TestMachine::direction(-1, 1, 2), m.at("0", "0"), end));
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
  // V of (30, 170) on MBC, and the pair it shares with (-30, -10).
  TestMachine mbc(kMBC);
  const Pose mixed = mbc.at("30", "170");
  // A direction out of rotary positions belongs to its own machine: refined where it was made.
  Pose end;
  ASSERT_TRUE(mbc.machine.choose(fine_direction(mbc.kinematics.refine(mixed.tool), 0x1p-98), mbc.at("30", "0"), end));
  expect_pair(end, -30, -10);
  const std::string pri = parameter("19608#5", "1");
  TestMachine other(kMBC + pri);
  ASSERT_TRUE(other.machine.choose(other.at("30", "170").tool, other.at("30", "0"), end));
  expect_pair(end, 30, 170);
  TestMachine tac(kTAC);
  ASSERT_TRUE(tac.machine.choose(tac.at("30", "170").tool, tac.at("30", "0"), end));
  expect_pair(end, 30, 170);
  TestMachine turned(kTAC + pri);
  ASSERT_TRUE(turned.machine.choose(turned.at("30", "170").tool, turned.at("30", "0"), end));
  expect_pair(end, -30, -10);
}

TEST(FastMachine, Example9) {
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
  expect_pair(end, -35.2643896827547, 45);
  expect_vector(machine(end, {20, -20, 0}), -10.6066017177982, -82.314902372249, -11.2360410931352, 1e-12);
  expect_vector(m.machine.control_point({20, -20, 0}, turns(end), 100.0, w) + w, -10.6066017177982, -82.314902372249,
                88.7639589068648, 1e-12);
  const Vector3<double> back = m.machine.to_table(m.machine.from_table({20, -20, 0}, turns(end), w), turns(end), w);
  expect_vector(back, 20, -20, 0, 1e-13);
  // The same in double-double.
  const auto fine = [](double x) { return DoubleDouble{x, 0}; };
  const Vector3<DoubleDouble> exact = m.machine.control_point<DoubleDouble>(
      {fine(20), fine(-20), fine(0)}, m.machine.fine_turns(end), fine(100), {fine(5), fine(10), fine(20)});
  expect_vector(nearest(exact) + w, -10.6066017177982, -82.314902372249, 88.7639589068648, 1e-12);
}

TEST(FastMachine, Example9FrozenFrame) {
  TestMachine m(kTAC + parameter(19702, -100) + parameter(19704, 30) + parameter(19705, 50));
  Pose start = m.at("20", "45");
  m.machine.freeze(start);
  const Pose pose = m.at("-35", "10");
  const Vector3<double> w{5, 10, 20};
  expect_vector(m.machine.from_table({20, -20, 5}, turns(pose), w) + w, 67.5977865158401, -84.213831437203,
                -19.7483455042551, 1e-12);
  const Eigen::Vector3d& v = pose.tool.unit;
  expect_vector({v[0], v[1], v[2]}, 0.328989928337166, 0.72167761037298, 0.609054228898422);
  const FineVector& fine = m.kinematics.refine(pose.tool);
  expect_vector({fine[0].hi, fine[1].hi, fine[2].hi}, 0.328989928337166, 0.72167761037298, 0.609054228898422);
  // The singular direction of the frame, and back to the positions from the direction.
  expect_vector(m.machine.in_frame({0, 0, 1}), 0, 0.342020143325669, 0.939692620785908, 1e-14);
  Pose end;
  ASSERT_TRUE(m.machine.choose(pose.tool, m.at("-30", "0"), end));
  expect_pair(end, -35, 10);
  m.machine.release();
}

TEST(FastMachine, Example11) {
  // Q leans toward the travel.
  TestMachine hc(kHC);
  Direction leaned;
  ASSERT_TRUE(lean(hc.kinematics, TestMachine::direction(0, 0, 1), std::array<Int128, 3>{1, 0, 0},
                   TestMachine::degrees("2"), leaned));
  expect_vector({leaned.unit[0], leaned.unit[1], leaned.unit[2]}, 0.034899496702501, 0, 0.999390827019096);
  ASSERT_TRUE(lean(hc.kinematics, TestMachine::direction(-1, 1, 2), std::array<Int128, 3>{0, 7, 0},
                   TestMachine::degrees("3"), leaned));
  expect_vector({leaned.unit[0], leaned.unit[1], leaned.unit[2]}, -0.398133605769323, 0.45546477337505,
                0.796267211538646);
  Pose end;
  ASSERT_TRUE(hc.machine.choose(leaned, hc.at("130", "30"), end));
  expect_pair(end, 131.157551336705, 37.2248886695106);
  ASSERT_TRUE(hc.machine.choose(leaned, hc.at("310", "30"), end));
  expect_pair(end, 311.157551336705, 322.775111330489 - 360);
  EXPECT_FALSE(lean(hc.kinematics, TestMachine::direction(-1, 1, 2), std::array<Int128, 3>{2, -2, -4},
                    TestMachine::degrees("3"), leaned));
  EXPECT_FALSE(lean(hc.kinematics, TestMachine::direction(-1, 1, 2), std::array<Int128, 3>{0, 0, 0},
                    TestMachine::degrees("3"), leaned));

  // Head offsets.
  TestMachine head(kHC + parameter(19711, 40) + parameter(19712, 25) + parameter(19714, 60));
  ASSERT_TRUE(head.machine.choose(TestMachine::direction(-1, 1, 2), head.at("0", "0"), end));
  expect_pair(end, -45, -35.2643896827547);
  expect_vector(head.machine.control_point<double>({20, -20, 0}, turns(end), 130.0, {0, 0, 0}), -31.724539849193,
                31.724539849193, 198.804418757713, 1e-12);
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
    for (int i = 0; i < 3000; ++i) {
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
