// SPDX-License-Identifier: Apache-2.0
// Where the rotary axes stand, and the direction they give the tool.
#pragma once

#include <array>
#include <cstdint>

#include "fast/arithmetic/count.h"
#include "fast/arithmetic/trigonometry.h"
#include "fast/geometry/vector3.h"
#include "fast/kinematics/direction.h"

namespace toolcomp::fast {

// The angle of one rotary axis that turns tool or table, whole turns included: it is never wrapped. It is its machine
// position, or its programmed one (fanuc.tool-direction.rotary-angles).
struct RotaryPosition {
  enum class Kind : std::uint8_t {
    exact,    // `count`: commanded, or the fixed angle of a hypothetical axis
    rounded,  // `count`: computed, within kRounded rad of the truth
    inverse,  // of the pose's direction and branch; Machine::count makes the count when it is asked for
  };
  static constexpr double kRounded = 0x1p-63;
  double degrees = 0;
  SineCosine<double> turn{0, 1};  // sine and cosine of degrees
  Kind kind = Kind::exact;
  Count count;
};

// Both rotary axes, the one of 19681 first, and the tool.
struct Pose {
  std::array<RotaryPosition, 2> axis;
  Direction tool;         // tip to holder, programming coordinate system
  Vector3<double> seen;   // in the system of the work-side axis (PolarFrame), from the table at its zero pose
  bool relative = false;  // every component of `seen` has a small relative error
  // The mechanical angle of the tool-side axis from where it brings the tool nearest to the work-side axis, in
  // [-180, 180], and its sign; 0 at the edge of reach and in a singular posture.
  double psi = 0;
  int branch = 0;
};

}  // namespace toolcomp::fast
