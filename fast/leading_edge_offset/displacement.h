// The movement of a block in X, Y, Z, exactly.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>

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

// The displacement of X, Y, Z by `delta`.
inline void set(Displacement& displacement, const std::array<Count, 3>& delta, double slack) {
  const bool small = slack == 0 && delta[0].is_small() && delta[1].is_small() && delta[2].is_small();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    if (small) [[likely]] {
      displacement.whole[i] = delta[i].small();
      displacement.value[k] = static_cast<double>(delta[i].small());
    } else {
      displacement.whole[i] = delta[i].units();
      displacement.value[k] = static_cast<double>(displacement.whole[i]);
    }
  }
  displacement.slack = slack;
  displacement.zero = displacement.value.cwiseAbs().maxCoeff() <= slack;
}

}  // namespace toolcomp::fast
