// SPDX-License-Identifier: Apache-2.0
// The machines of the worked examples and a block of tool center point control on them, for tests of the fast
// engine. Pairs are (1st, 2nd).
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "fast/fanuc/tool_posture_control/posture.h"
#include "fast/kinematics/machine.h"
#include "spec/language/setup_format.h"

namespace toolcomp::fast {

inline std::string parameter(const std::string& number, const std::string& value) {
  return "\"" + number + "\"=" + value + "\n";
}
inline std::string parameter(int number, int value) { return parameter(std::to_string(number), std::to_string(value)); }

inline std::string machine_of(int type, int first, int direction1, int second, int direction2, int sense1, int sense2) {
  return parameter(19680, type) + parameter(19681, first) + parameter(19682, direction1) + parameter(19684, sense1) +
         parameter(19686, second) + parameter(19687, direction2) + parameter(19689, sense2);
}

// Controlled axes X Y Z A B C.
inline constexpr int kA = 4, kB = 5, kC = 6;
inline const std::string kHC = machine_of(2, kC, 3, kB, 2, 0, 0);
inline const std::string kCAHead = machine_of(2, kC, 3, kA, 1, 0, 0);
inline const std::string kTAC = machine_of(12, kA, 1, kC, 3, 1, 1);
inline const std::string kBCTable = machine_of(12, kB, 2, kC, 3, 1, 1);
inline const std::string kMBC = machine_of(21, kB, 2, kC, 3, 0, 1);
inline const std::string kMAC = machine_of(21, kA, 1, kC, 3, 0, 1);
inline const std::string kABHead = machine_of(2, kA, 1, kB, 2, 0, 0);
inline const std::string kABTable = machine_of(12, kA, 1, kB, 2, 1, 1);
inline const std::string kMAB = machine_of(21, kA, 1, kB, 2, 0, 1);
inline const std::string kN45 = machine_of(2, kC, 3, kB, 5, 0, 0) + parameter(19688, 45);
inline const std::string kT45 = machine_of(12, kB, 5, kC, 3, 1, 1) + parameter(19683, 45);

struct TestMachine {
  explicit TestMachine(const std::string& parameters)
      : setup(spec::read_setup_toml(
            "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\",\"A\",\"B\",\"C\"]\n[parameters]\n" + parameters,
            "setup")),
        kinematics(setup),
        machine(setup, kinematics),
        control(setup, machine) {}

  static Count degrees(const std::string& text) { return Count::of(spec::parse_decimal(text).value()); }
  Pose at(const std::string& first, const std::string& second) {
    std::array<Count, spec::kMaxAxes> position;
    position[machine.rotary_axis(0)] = degrees(first);
    position[machine.rotary_axis(1)] = degrees(second);
    Pose pose;
    machine.pose(position, 0, pose);
    return pose;
  }
  static Direction direction(std::int64_t i, std::int64_t j, std::int64_t k) { return whole_direction({i, j, k}); }

  spec::Setup setup;
  Kinematics kinematics;
  Machine machine;
  ToolPostureControl control;
};

// Half of the last digit of the figures typed in, and a few ulps of the size of a turn.
inline constexpr double kDegrees = 6e-13;

inline void expect_pair(const Pose& pose, double first, double second, double tolerance = kDegrees) {
  EXPECT_NEAR(pose.axis[0].degrees, first, tolerance);
  EXPECT_NEAR(pose.axis[1].degrees, second, tolerance);
  for (const RotaryPosition& axis : pose.axis) {
    const SineCosine<double> turn = sine_cosine(axis.degrees);
    EXPECT_NEAR(turn.sine, axis.turn.sine, 1e-14);
    EXPECT_NEAR(turn.cosine, axis.turn.cosine, 1e-14);
  }
}

inline void expect_vector(const Vector3<double>& v, double x, double y, double z, double tolerance = 4e-15) {
  EXPECT_NEAR(v.x, x, tolerance);
  EXPECT_NEAR(v.y, y, tolerance);
  EXPECT_NEAR(v.z, z, tolerance);
}

}  // namespace toolcomp::fast
