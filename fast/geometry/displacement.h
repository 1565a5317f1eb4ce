// SPDX-License-Identifier: Apache-2.0
// The movement of a block in X, Y, Z, exactly.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

#include "fast/arithmetic/count.h"

namespace toolcomp::fast {

// Only the direction of a movement matters, so it is kept as whole numbers of whatever unit makes all three whole.
struct Displacement {
  Eigen::Vector3d value{0, 0, 0};  // the doubles nearest to whole(): where `narrow` they are exact
  bool narrow = false;
  bool zero = true;
  // How far each of whole() may be from the truth, in units of 1 / (127 * 10^18): not 0 only after a G49 that ended
  // G43.5 at an irrational position.
  double slack = 0;
  std::array<Int128, 3> wide{};  // not narrow: whole()

  [[nodiscard]] std::array<Int128, 3> whole() const {
    if (!narrow) return wide;
    return {static_cast<std::int64_t>(value[0]), static_cast<std::int64_t>(value[1]),
            static_cast<std::int64_t>(value[2])};
  }
};

// By 10^-6 of a setup unit. The difference of two whole doubles is below 2^54 and still a double up to its last bit.
inline void set_displacement(Displacement& displacement, std::int64_t x, std::int64_t y, std::int64_t z) {
  displacement.value[0] = static_cast<double>(x);
  displacement.value[1] = static_cast<double>(y);
  displacement.value[2] = static_cast<double>(z);
  displacement.slack = 0;
  displacement.zero = (x | y | z) == 0;
  displacement.narrow = Count::is_small(x) && Count::is_small(y) && Count::is_small(z);
  if (!displacement.narrow) [[unlikely]]
    displacement.wide = {x, y, z};
}

// From `from` to `to` (X, Y, Z).
inline void set_displacement(Displacement& displacement, const std::array<Count, 3>& from,
                             const std::array<Count, 3>& to, double slack) {
  bool small = slack == 0;
  for (std::size_t i = 0; i < 3; ++i) small = small && from[i].is_small() && to[i].is_small();
  if (small) {
    set_displacement(displacement, to[0].small() - from[0].small(), to[1].small() - from[1].small(),
                     to[2].small() - from[2].small());
    return;
  }
  displacement.slack = slack;
  displacement.narrow = false;
  displacement.zero = true;
  for (std::size_t i = 0; i < 3; ++i) {
    displacement.wide[i] = to[i].units() - from[i].units();
    const auto value = static_cast<double>(displacement.wide[i]);
    displacement.value[static_cast<Eigen::Index>(i)] = value;
    if (value > slack || value < -slack) displacement.zero = false;
  }
}

}  // namespace toolcomp::fast
