// The movement of a block in X, Y, Z, exactly.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "fast/arithmetic/count.h"

namespace toolcomp::fast {

// Only the direction of a movement matters, so it is kept as whole numbers of whatever unit makes all three whole.
struct Displacement {
  std::array<Int128, 3> whole{};
  Eigen::Vector3d value{0, 0, 0};  // the doubles nearest to `whole`
  bool zero = true;
  // How far each of `whole` may be from the truth, in units of 1 / (127 * 10^18): not 0 only after a G49 that ended
  // G43.5 at an irrational position.
  double slack = 0;
};

// From `from` to `to` (X, Y, Z).
inline void set_difference(Displacement& displacement, const std::array<Count, 3>& from, const std::array<Count, 3>& to,
                           double slack) {
  bool small = slack == 0;
  for (std::size_t i = 0; i < 3; ++i) small = small && from[i].is_small() && to[i].is_small();
  displacement.slack = slack;
  displacement.zero = true;
  for (std::size_t i = 0; i < 3; ++i) {
    // The difference of two whole doubles is below 2^54 and still a double up to its last bit: convert, do not assume.
    const Int128 whole = small ? Int128{to[i].small() - from[i].small()} : to[i].units() - from[i].units();
    const double value = small ? static_cast<double>(to[i].small() - from[i].small()) : static_cast<double>(whole);
    displacement.whole[i] = whole;
    displacement.value[static_cast<Eigen::Index>(i)] = value;
    if (value > slack || value < -slack) displacement.zero = false;
  }
}

}  // namespace toolcomp::fast
