// SPDX-License-Identifier: Apache-2.0
// A tool direction: tip to holder, in the programming coordinate system.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>

#include "fast/arithmetic/count.h"
#include "fast/arithmetic/double_double.h"
#include "fast/arithmetic/trigonometry.h"

namespace toolcomp::fast {

using FineVector = std::array<DoubleDouble, 3>;

// A unit vector in double with its error, and what it was made from, so that a decision can be refined.
struct Direction {
  Direction() = default;
  Direction(const Direction& other) = default;
  // Without the origins that the other one was not made from.
  Direction& operator=(const Direction& other);

  Eigen::Vector3d unit{0, 0, 1};
  double error = 0;  // |unit[i] - exact[i]| <= error
  // Not where is_whole: how long the vector from the truth to Kinematics::refine() may be.
  double fine_error = 0;
  // The exact direction is parallel to whole() (I J K words, or axes at multiples of 90 degrees). Otherwise it is
  // `fine` (leaned by Q, or the end of a block changed at a singular posture), or that of the kinematics at `angle`.
  bool is_whole = true;
  bool narrow = true;  // whole() fits into 64 bits: it is `small`, else `wide`
  bool is_fine = false;
  bool framed = false;        // of `angle`: turned with the table into the programming coordinate system
  std::uint8_t zero = 0b011;  // bit i: component i is exactly 0
  std::array<std::int64_t, 3> small{0, 0, 1};
  std::array<Int128, 3> wide{};
  std::array<Count, 2> angle;  // of the inner and the outer rotary axis, degrees
  FineVector fine{};           // unit

  // As fine_error, of any direction.
  [[nodiscard]] double refined_error() const { return is_whole ? kWholeError : fine_error; }
  static constexpr double kWholeError = 0x1p-100;

  // Only where is_whole.
  [[nodiscard]] std::array<Int128, 3> whole() const {
    if (narrow) return {small[0], small[1], small[2]};
    return wide;
  }
};

// By parts: a processor that copies many bytes at once waits where one of them has just been written.
// NOLINTNEXTLINE(cert-oop54-cpp): itself onto itself does nothing
[[gnu::always_inline]] inline Direction& Direction::operator=(const Direction& other) {
  unit[0] = other.unit[0];
  unit[1] = other.unit[1];
  unit[2] = other.unit[2];
  error = other.error;
  is_whole = other.is_whole;
  narrow = other.narrow;
  is_fine = other.is_fine;
  framed = other.framed;
  zero = other.zero;
  if (is_whole && narrow) [[likely]] {
    small[0] = other.small[0];
    small[1] = other.small[1];
    small[2] = other.small[2];
    return *this;
  }
  fine_error = other.fine_error;
  if (is_whole)
    wide = other.wide;
  else if (is_fine)
    fine = other.fine;
  else
    angle = other.angle;
  return *this;
}

// The direction of a vector of whole numbers, not all zero, each below 2^122.
Direction whole_direction(const std::array<Int128, 3>& whole);

// The direction of a vector in double-double, not zero; `error`: how long the vector from the truth to it may be, over
// its length.
Direction fine_direction(const FineVector& vector, double error);

class Kinematics;
// The direction leaned by `degrees` toward the travel (programming coordinate system), as Q commands. False where Q has
// no effect: no travel, or along the tool. `leaned` may not be `direction`.
[[nodiscard]] bool lean(const Kinematics& kinematics, const Direction& direction, const FineVector& travel,
                        const Count& degrees, Direction& leaned);
[[nodiscard]] bool lean(const Kinematics& kinematics, const Direction& direction, const std::array<Int128, 3>& travel,
                        const Count& degrees, Direction& leaned);

// As whole_direction, in place, for numbers up to 2^53.
[[gnu::always_inline]] inline void set_small_direction(Direction& direction, std::int64_t x, std::int64_t y,
                                                       std::int64_t z) {
  direction.is_whole = true;
  direction.narrow = true;
  direction.is_fine = false;
  direction.small[0] = x;
  direction.small[1] = y;
  direction.small[2] = z;
  direction.zero = static_cast<std::uint8_t>(static_cast<unsigned>(x == 0) | static_cast<unsigned>(y == 0) << 1U |
                                             static_cast<unsigned>(z == 0) << 2U);
  const auto vx = static_cast<double>(x);
  const auto vy = static_cast<double>(y);
  const auto vz = static_cast<double>(z);
  constexpr unsigned kAxes = 1U << 0b011U | 1U << 0b101U | 1U << 0b110U;
  if ((kAxes >> direction.zero & 1U) != 0) [[unlikely]] {
    direction.unit = Eigen::Vector3d(vx, vy, vz).cwiseSign();
    direction.error = 0;
    return;
  }
  // Relative errors, u = 2^-53: the norm 2.5u, the quotient u. Quotients, so that whole norms give the nearest doubles;
  // two side by side take the time of one.
  const double norm = std::sqrt(vx * vx + vy * vy + vz * vz);
  const DoublePair xy = DoublePair{vx, vy} / norm;
  direction.unit[0] = xy[0];
  direction.unit[1] = xy[1];
  direction.unit[2] = vz / norm;
  direction.error = 4 * 0x1p-53;
}

}  // namespace toolcomp::fast
