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

// The same in place, for numbers up to 2^53.
inline void set_small_direction(Direction& direction, const std::array<std::int64_t, 3>& whole) {
  direction.is_whole = true;
  direction.whole = {whole[0], whole[1], whole[2]};
  direction.zero =
      static_cast<std::uint8_t>((whole[0] == 0 ? 1U : 0U) | (whole[1] == 0 ? 2U : 0U) | (whole[2] == 0 ? 4U : 0U));
  const Eigen::Vector3d v(static_cast<double>(whole[0]), static_cast<double>(whole[1]), static_cast<double>(whole[2]));
  const bool axis = direction.zero == 0b011 || direction.zero == 0b101 || direction.zero == 0b110;
  if (axis) {
    direction.unit = v.cwiseSign();
    direction.error = 0;
    return;
  }
  // Relative errors, u = 2^-53: the norm 2.5u, the quotient u.
  direction.unit = v / v.norm();
  direction.error = 4 * 0x1p-53;
}

}  // namespace toolcomp::fast
