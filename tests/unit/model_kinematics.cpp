// SPDX-License-Identifier: Apache-2.0
// Rotary positions and control points of machines with two rotary axes, beside the worked examples 1, 2, 9 and 11
// (golden/fanuc/corpus_examples_tool_center_point.cpp). Expected values follow from the formulas by hand, or were
// derived in 50 digits like those.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/basis/alarm.h"
#include "model/kinematics/inverse.h"
#include "model/kinematics/machine.h"
#include "model/kinematics/pair_choice.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"
#include "tests/support/usual_number.h"
#include "tests/unit/printed_digits.h"

namespace toolcomp::model {
namespace {

// Axes X1 Y2 Z3 A4 B5 C6.
spec::Setup setup(const std::string& parameters) {
  return spec::read_setup_toml(
      "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"A\", \"B\", \"C\"]\n[parameters]\n" + parameters, "setup");
}

// A machine by its type and two rotary axes, each with its letter and direction code; a table axis has sense 1.
std::string machine(int type, char first, int first_code, char second, int second_code, const std::string& more = "") {
  const auto number = [](char letter) { return std::to_string(letter - 'A' + 4); };
  const bool first_of_table = type == 12;
  const bool second_of_table = type != 2;
  return "19680 = " + std::to_string(type) + "\n19681 = " + number(first) + "\n19682 = " + std::to_string(first_code) +
         "\n19684 = " + (first_of_table ? "1" : "0") + "\n19686 = " + number(second) +
         "\n19687 = " + std::to_string(second_code) + "\n19689 = " + (second_of_table ? "1" : "0") + "\n" + more;
}

const std::string kHC = machine(2, 'C', 3, 'B', 2);
const std::string kTAC = machine(12, 'A', 1, 'C', 3);
const std::string kMBC = machine(21, 'B', 2, 'C', 3);
const std::string kN45 = machine(2, 'C', 3, 'B', 5, "19688 = 45\n");
const std::string kT45 = machine(12, 'B', 5, 'C', 3, "19683 = 45\n");
// Every machine of example 1, and some that are inclined or tilted.
const std::vector<std::string> kMachines{kHC,
                                         machine(2, 'C', 3, 'A', 1),
                                         kTAC,
                                         machine(12, 'B', 2, 'C', 3),
                                         kMBC,
                                         machine(21, 'A', 1, 'C', 3),
                                         machine(2, 'A', 1, 'B', 2),
                                         machine(2, 'B', 2, 'A', 1),
                                         machine(12, 'A', 1, 'B', 2),
                                         machine(21, 'A', 1, 'B', 2),
                                         kN45,
                                         kT45,
                                         machine(21, 'B', 5, 'C', 3, "19683 = 45\n"),
                                         machine(2, 'C', 3, 'B', 2, "19699 = 20\n"),
                                         machine(2, 'C', 3, 'B', 2, "19698 = 5\n"),
                                         machine(2, 'C', 3, 'B', 5, "19688 = 60\n"),
                                         machine(12, 'B', 6, 'C', 3, "19683 = 30\n19699 = 10\n")};

using test::printed_digits;

// A pair (first axis, second axis) as text.
std::string text(const Machine& of, const Pose& pose) {
  const bool tool_first = of.type() != MachineType::head;
  const Angle& first = tool_first ? pose.tool : pose.work;
  const Angle& second = tool_first ? pose.work : pose.tool;
  return printed_digits(first.degrees()) + " " + printed_digits(second.degrees());
}
std::string text(const Vector& v) {
  return printed_digits(v.x) + " " + printed_digits(v.y) + " " + printed_digits(v.z);
}

// In [0, 360).
Angle basic(const Angle& angle) { return angle.plus_turns(-angle.whole_turns()); }
Pose basic(const Pose& pose) { return {basic(pose.tool), basic(pose.work)}; }

// A pose by positions of the first and the second axis.
Pose pose(const Machine& of, const Angle& first, const Angle& second) {
  return of.type() == MachineType::head ? Pose{second, first} : Pose{first, second};
}

// The pairs of a direction in [0, 360), the lesser position of the first axis first, or the alarm.
std::string pairs(const std::string& parameters, const Vector& direction) {
  const Machine of(setup(parameters));
  Recorder recorder;
  try {
    std::vector<std::string> all;
    const Solutions solutions = inverse(of, recorder, Direction::of(direction));
    for (const Solution& solution : solutions) all.push_back(text(of, basic(solution.pose)));
    if (solutions.work_free) all.emplace_back("singular");
    std::string result;
    for (const std::string& pair : all) result += (result.empty() ? "" : ", ") + pair;
    return result;
  } catch (const Alarm& alarm) {
    return toolcomp::test::usual_number(alarm.cause);
  }
}

TEST(Inverse, EdgeOfReachUnreachableAndSingular) {
  EXPECT_EQ(pairs(kN45, {1, 0, 0}), "270 180");
  EXPECT_EQ(pairs(kN45, {0, 0, -1}), "PS5459");
  EXPECT_EQ(pairs(kN45, {1, 0, Rational(-1, 1000000)}), "PS5459");
  EXPECT_EQ(pairs(kHC, {0, 0, 1}), "0 0, singular");
  EXPECT_EQ(pairs(kHC, {0, 0, -5}), "0 180, singular");
  EXPECT_EQ(pairs(machine(2, 'C', 3, 'B', 2, "19698 = 5\n"), {0, 0, 1}), "PS5459");
  // RA = 5: the cone of 5 degrees around Z is out of reach; on it the two pairs are one, with B = 0.
  EXPECT_EQ(pairs(machine(2, 'C', 3, 'B', 2, "19698 = 5\n"), {0, -exact::sin_degrees(5), exact::cos_degrees(5)}),
            "0 0");
}

TEST(Inverse, ForwardOfEveryPairIsTheDirectionExactly) {
  int reached = 0;
  for (const std::string& parameters : kMachines) {
    const Machine of(setup(parameters));
    for (int i = -3; i <= 3; i += 2)
      for (int j = -2; j <= 2; ++j)
        for (int k = -1; k <= 3; k += 2) {
          const Direction direction = Direction::of({i, j, k});
          Recorder recorder;
          try {
            for (const Solution& solution : inverse(of, recorder, direction)) {
              EXPECT_TRUE(of.direction(solution.pose) == direction.unit) << parameters << i << ' ' << j << ' ' << k;
              EXPECT_EQ(static_cast<int>(branch_quantity(of, solution.pose.tool).sign()), solution.branch);
              ++reached;
            }
          } catch (const Alarm& alarm) {
            EXPECT_EQ(toolcomp::test::usual_number(alarm.cause), "PS5459");
          }
        }
  }
  EXPECT_GT(reached, 1500);
}

TEST(Inverse, ForwardInATurnedFrameIsTheDirectionExactly) {
  // Frames frozen at decimal positions, and at positions that inverse kinematics gave.
  int reached = 0;
  int open = 0;  // beyond the budget of a proof
  std::uint32_t random = 12345;
  const auto next = [&random](int bound) {
    random = random * 1664525U + 1013904223U;
    return static_cast<int>(random >> 16U) % (2 * bound + 1) - bound;
  };
  for (const std::string& parameters : kMachines) {
    const Machine of(setup(parameters));
    for (int i = 0; i < 40; ++i) {
      const Angle tool = i % 2 == 0 ? Angle(Rational(next(90000), 1000)) : Angle::of_direction(next(9), next(9) + 20);
      const Angle work = i % 3 == 0 ? Angle(Rational(next(90000), 1000)) : Angle::of_direction(next(9) + 20, next(9));
      const ProgrammingFrame frame(of, {tool, work}, {});
      const int x = next(2000);
      const int y = next(2000);
      const int z = next(2000);
      const Direction direction = Direction::of({Rational(x, 1000), Rational(y, 1000), Rational(z, 1000)});
      Recorder recorder;
      try {
        const Direction in_table{frame.to_table(direction.vector), direction.norm2, frame.to_table(direction.unit)};
        for (const Solution& solution : inverse(of, recorder, in_table)) {
          ++reached;
          try {
            EXPECT_TRUE(frame.from_table(of.direction(solution.pose)) == direction.unit) << parameters << i;
          } catch (const exact::Undecided&) {
            ++open;
          }
        }
      } catch (const Alarm& alarm) {
        EXPECT_EQ(toolcomp::test::usual_number(alarm.cause), "PS5459");
      }
    }
  }
  std::printf("%d directions, %d undecided\n", reached, open);
  EXPECT_GT(reached, 900);
  EXPECT_LT(open, reached / 5);
}

// The end of the arc from (-1, 1, 2) to (-1, -1, 2), from the pair of the start on one branch, with whole turns.
std::string lifted(const std::string& parameters, int branch, int tool_turns, int work_turns) {
  const Machine of(setup(parameters));
  const Vector from{-1, 1, 2};
  const Vector to{-1, -1, 2};
  Recorder recorder;
  const auto pair = [&](const Vector& v) {
    const Solutions solutions = inverse(of, recorder, Direction::of(v));
    return basic(solutions.at.at(branch > 0 ? 0 : 1).pose);
  };
  const Pose start{pair(from).tool.plus_turns(tool_turns), pair(from).work.plus_turns(work_turns)};
  const Pose end = pair(to);
  const Angle swing = azimuth(of, from, to);
  const Angle tilt_swing = azimuth(of, of.tilted(start.tool), of.tilted(end.tool));
  const Pose result{lifted_tool(start.tool, end.tool, branch, of),
                    lifted_work(start.work, end.work, swing, tilt_swing, of)};
  return text(of, start) + " to " + text(of, result);
}

TEST(Lifted, Example3) {
  EXPECT_EQ(lifted(kHC, 1, 0, 0), "135 35.2643896827547 to 225 35.2643896827547");
  EXPECT_EQ(lifted(kHC, -1, -1, 1), "675 -35.2643896827547 to 765 -35.2643896827547");
  EXPECT_EQ(lifted(kTAC, 1, 0, 0), "35.2643896827547 225 to 35.2643896827547 315");
  EXPECT_EQ(lifted(kTAC, -1, -1, 0), "-35.2643896827547 45 to -35.2643896827547 135");
  EXPECT_EQ(lifted(kMBC, 1, 0, -2), "35.2643896827547 -585 to 35.2643896827547 -495");
  EXPECT_EQ(lifted(kN45, 1, 0, 0), "116.467819046821 50.7287005490466 to 206.467819046821 50.7287005490466");
  EXPECT_EQ(lifted(kN45, 1, 1, -1), "-243.532180953179 410.728700549047 to -153.532180953179 410.728700549047");
}

TEST(SingularPostures, ExistByTheInclinations) {
  const auto positions = [](const std::string& parameters) {
    std::string result;
    const Machine of(setup(parameters));
    for (const SingularPosture& posture : of.singular_postures())
      result += (result.empty() ? "" : ", ") + text(posture.direction) + ": " + posture.tool.degrees().decimal(9);
    return result;
  };
  EXPECT_EQ(positions(kHC), "0 0 1: 0, 0 0 -1: 180");
  EXPECT_EQ(positions(kTAC), "0 0 1: 0, 0 0 -1: 180");
  EXPECT_EQ(positions(kMBC), "0 0 1: 0, 0 0 -1: 180");
  EXPECT_EQ(positions(machine(2, 'A', 1, 'B', 2)), "1 0 0: 90, -1 0 0: -90");
  EXPECT_EQ(positions(machine(12, 'A', 1, 'B', 2)), "0 1 0: -90, 0 -1 0: 90");
  EXPECT_EQ(positions(machine(21, 'A', 1, 'B', 2)), "0 1 0: -90, 0 -1 0: 90");
  EXPECT_EQ(positions(kN45), "0 0 1: 0");
  EXPECT_EQ(positions(kT45), "0 0 1: 0");
  EXPECT_EQ(positions(machine(2, 'C', 3, 'B', 2, "19699 = 20\n")), "0 0 1: -20, 0 0 -1: 160");
  EXPECT_EQ(positions(machine(2, 'C', 3, 'B', 2, "19698 = 5\n")), "");
}

// The pair taken from positions of the first and the second axis.
std::string chosen(const std::string& parameters, const Angle& first, const Angle& second, const Vector& direction) {
  const spec::Setup with = setup(parameters);
  const Machine of(with);
  Recorder recorder;
  const PairChoice choice(with, of, recorder);
  try {
    return text(of, choice.choose(Direction::of(direction), pose(of, first, second)).pose);
  } catch (const Alarm& alarm) {
    return toolcomp::test::usual_number(alarm.cause);
  }
}

TEST(PairChoice, ParallelToTheWorkSideAxisLeavesItWhereItIs) {
  EXPECT_EQ(chosen(kHC, 725, 10, {0, 0, 3}), "725 0");
  EXPECT_EQ(chosen(kHC, -30, 170, {0, 0, -3}), "-30 180");
  // Out of its range it goes to the nearest limit.
  EXPECT_EQ(chosen(kHC + "19741 = 90\n19742 = -90\n", 200, 10, {0, 0, 3}), "90 0");
  EXPECT_EQ(chosen(kHC + "19741 = 90\n19742 = -90\n", -91, 10, {0, 0, 3}), "-90 0");
  // Half a turn of the tool side is possible both ways: the greater position.
  EXPECT_EQ(chosen(kHC, 10, 0, {0, 0, -1}), "10 180");
}

TEST(PairChoice, KeepsToTheRanges) {
  // C from 0 to 360 does not take the short way through 0: from 350 to 10 it goes back by 340.
  const std::string circle = kHC + "19741 = 360\n19742 = 0\n19743 = 100\n19744 = 0\n";
  const Machine of(setup(circle));
  EXPECT_EQ(chosen(circle, 350, 20, of.direction(pose(of, 10, 20))), "10 20");
  EXPECT_EQ(chosen(kHC, 350, 20, of.direction(pose(of, 10, 20))), "370 20");
  // Limits are inside; a range may lie in other turns.
  EXPECT_EQ(chosen(kHC + "19741 = 810\n19742 = 730\n", 0, 0, of.direction(pose(of, 90, 20))), "810 20");
  EXPECT_EQ(chosen(kHC + "19741 = 809\n19742 = 730\n", 0, 0, of.direction(pose(of, 90, 20))), "PS5459");
}

TEST(PairChoice, TurnedRanges) {
  const spec::Setup with = setup(kHC + "19741 = -1\n19742 = 1\n");
  const Machine of(with);
  Recorder recorder;
  const PairChoice choice(with, of, recorder);
  EXPECT_THROW(choice.require_ranges(), Alarm);
}

TEST(PairChoice, WindingStaysWithThePresentPosition) {
  // Full turns of the present position turn the result alike.
  for (int turns = -3; turns <= 3; ++turns) {
    const Rational by = 360 * turns;
    const spec::Setup with = setup(kHC);
    const Machine of(with);
    Recorder recorder;
    const PairChoice choice(with, of, recorder);
    const Direction v = Direction::of({-1, 1, 2});
    const Pose at_zero = choice.choose(v, pose(of, 100, 20)).pose;
    const Pose turned = choice.choose(v, pose(of, 100 + by, 20)).pose;
    EXPECT_TRUE(turned.work == at_zero.work + Angle(by)) << turns;
    EXPECT_TRUE(turned.tool == at_zero.tool) << turns;
  }
}

TEST(ControlPoint, FrozenFrameThereAndBack) {
  const Machine of(setup(kTAC + "19702 = -100\n19704 = 30\n19705 = 50\n"));
  const ProgrammingFrame frame(of, pose(of, 20, 45), {5, 10, 20});
  const Pose now = pose(of, -35, 10);
  EXPECT_EQ(text(frame.from_table({0, 0, 1})), "0 0.342020143325669 0.939692620785908");
  EXPECT_TRUE(frame.to_table(frame.from_table(of.direction(now))) == of.direction(now));
  EXPECT_TRUE(frame.of_workpiece(frame.in_workpiece({20, -20, 5}, now), now) == (Vector{20, -20, 5}));
}

// The last of worked example 11, one offset after the other.
TEST(ControlPoint, HeadOffsets) {
  const Machine plain(setup(kHC));
  Recorder recorder;
  const PairChoice choice(setup(kHC), plain, recorder);
  const Pose at = choice.choose(Direction::of({-1, 1, 2}), pose(plain, 0, 0)).pose;
  const auto control = [&](const std::string& offsets) {
    const Machine of(setup(kHC + offsets));
    const ProgrammingFrame frame(of, pose(of, 0, 0), {7, 8, 9});
    return text(frame.control_point({20, -20, 0}, at, 130));
  };
  EXPECT_EQ(control(""), "-33.0722777603022 33.0722777603022 106.144555520604");
  EXPECT_EQ(control("19711 = 40\n"), "-49.4022093788567 49.4022093788567 138.804418757713");
}

TEST(Inverse, LeanedDirectionIsKnownAsWhole) {
  // Q 2 leans +Z toward +X: a whole number of degrees, and known as such.
  const Machine of(setup(kHC));
  Recorder recorder;
  const Solutions solutions = inverse(of, recorder, Direction::of({exact::sin_degrees(2), 0, exact::cos_degrees(2)}));
  EXPECT_TRUE(solutions.at[0].pose.tool.recognised().is_rational());
  EXPECT_EQ(solutions.at[0].pose.tool.recognised().rational(), 2);
}

}  // namespace
}  // namespace toolcomp::model
