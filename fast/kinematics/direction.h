// A tool direction: tip to holder, in the programming coordinate system.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "fast/arithmetic/count.h"

namespace toolcomp::fast {

// A unit vector in double with its error, and what it was made from, so that a decision can be refined.
struct Direction {
  Eigen::Vector3d unit{0, 0, 1};
  double error = 0;  // |unit[i] - exact[i]| <= error
  // The exact direction is parallel to `whole` (I J K words, or axes at multiples of 90 degrees). Otherwise it is that
  // of the kinematics at `angle`.
  bool is_whole = true;
  std::uint8_t zero = 0b011;  // bit i: component i is exactly 0
  std::array<Int128, 3> whole{0, 0, 1};
  std::array<Count, 2> angle;  // of the inner and the outer rotary axis, degrees
};

// The direction of a vector of whole numbers, not all zero, each below 2^122.
Direction whole_direction(const std::array<Int128, 3>& whole);

}  // namespace toolcomp::fast
