// SPDX-License-Identifier: Apache-2.0
#include "fast/kinematics/direction.h"

#include "fast/kinematics/kinematics.h"

namespace toolcomp::fast {

Direction whole_direction(const std::array<Int128, 3>& whole) {
  Direction direction;
  direction.narrow = false;
  direction.wide = whole;
  direction.zero = 0;
  Eigen::Vector3d v;
  for (std::size_t i = 0; i < 3; ++i) {
    v[static_cast<Eigen::Index>(i)] = static_cast<double>(whole[i]);
    if (whole[i] == 0) direction.zero = static_cast<std::uint8_t>(direction.zero | 1U << i);
  }
  // Relative errors, u = 2^-53: component u, squares 2u + u, their sum 2u more, half of it in the root, root u,
  // quotient u: at most u + 2.5u + u + u.
  direction.unit = v / v.norm();
  direction.error = direction.zero == 0b011 || direction.zero == 0b101 || direction.zero == 0b110 ? 0 : 6 * 0x1p-53;
  return direction;
}

namespace {

DoubleDouble dot(const FineVector& a, const FineVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace

Direction fine_direction(const FineVector& vector, double error) {
  Direction direction;
  direction.is_whole = false;
  direction.is_fine = true;
  direction.zero = 0;
  const DoubleDouble length = sqrt(dot(vector, vector));
  for (std::size_t i = 0; i < 3; ++i) {
    direction.fine[i] = vector[i] / length;
    direction.unit[static_cast<Eigen::Index>(i)] = direction.fine[i].hi;
    if (direction.fine[i].hi == 0) direction.zero = static_cast<std::uint8_t>(direction.zero | 1U << i);
  }
  direction.fine_error = error + 0x1p-98;
  direction.error = 0x1p-53 + direction.fine_error;
  return direction;
}

bool lean(const Kinematics& kinematics, const Direction& direction, const std::array<Int128, 3>& travel,
          const Count& degrees, Direction& leaned) {
  FineVector fine;
  for (std::size_t i = 0; i < 3; ++i) fine[i] = to_double_double(travel[i]);
  return lean(kinematics, direction, fine, degrees, leaned);
}

bool lean(const Kinematics& kinematics, const Direction& direction, const FineVector& travel, const Count& degrees,
          Direction& leaned) {
  const FineVector v = kinematics.refine(direction);
  const DoubleDouble length = sqrt(dot(travel, travel));
  if (length.hi == 0) return false;
  // The part of the travel at right angles to the tool.
  const DoubleDouble along = dot(travel, v);
  FineVector across;
  for (std::size_t i = 0; i < 3; ++i) across[i] = travel[i] - v[i] * along;
  const DoubleDouble width = sqrt(dot(across, across));
  constexpr double kParallel = 0x1p-66;  // of the travel: what double-double cannot tell from along the tool
  if (width.hi <= kParallel * length.hi) return false;
  auto q = fine_sine_cosine(degrees);
  FineVector turned;
  for (std::size_t i = 0; i < 3; ++i) turned[i] = v[i] * q.cosine + across[i] * (q.sine / width);
  // An error of V turns the unit vector across by up to 2 |travel| / |across| of it, and so do roundings.
  constexpr double kFine = 0x1p-96;
  const double error = direction.refined_error();
  leaned = fine_direction(turned, error + kFine + std::abs(q.sine.hi) * 2 * (error + kFine) * (length.hi / width.hi));
  return true;
}

}  // namespace toolcomp::fast
