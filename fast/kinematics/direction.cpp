#include "fast/kinematics/direction.h"

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

}  // namespace toolcomp::fast
