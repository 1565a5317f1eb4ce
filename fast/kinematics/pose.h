// Where the rotary axes stand, and the direction they give the tool.
#pragma once

#include <array>
#include <cstdint>

#include "fast/arithmetic/count.h"
#include "fast/arithmetic/trigonometry.h"
#include "fast/geometry/vector3.h"
#include "fast/kinematics/direction.h"

namespace toolcomp::fast {

// The position of one rotary axis, whole turns included (fanuc.tool-posture: positions are not wrapped).
struct RotaryPosition {
  enum class Kind : std::uint8_t {
    exact,    // `count`: commanded, or the fixed angle of a hypothetical axis
    rounded,  // `count`: computed, within 2^-72 rad of the truth
    inverse,  // of the pose's direction and branch: degrees + 360 n; count is made when it is asked for
  };
  double degrees = 0;
  SineCosine<double> turn{0, 1};  // sine and cosine of degrees
  Kind kind = Kind::exact;
  Count count;
};

// Both rotary axes, the one of 19681 first, and the tool.
struct Pose {
  std::array<RotaryPosition, 2> axis;
  Direction tool;        // tip to holder, programming coordinate system
  Vector3<double> seen;  // the same in the system of the work-side axis (PolarFrame), within seen_error
  double seen_error = 0;
  // The tool-side axis on one branch of the inverse kinematics: the sign of psi; 0 at the edge of reach or in a
  // singular posture. Whole turns of psi and of the work-side axis on top of the principal values.
  std::int8_t branch = 0;
};

}  // namespace toolcomp::fast
