// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/control/modal_state.h"

namespace toolcomp::fast {

void ModalState::select_plane(spec::Plane plane) {
  plane_ = plane;
  plane_axis_ = axes_of(plane);
  plane_axes_ = 0;
  plane_letter_ = {direction_letter(plane, 0), direction_letter(plane, 1)};
  for (const std::size_t axis : plane_axis_)
    if (axis != spec::Axes::kNone) plane_axes_ = static_cast<Mask>(plane_axes_ | bit(axis));
}

std::size_t ModalState::normal_axis(spec::Plane plane) const {
  if (plane == spec::Plane::xy) return xyz_[2];
  return plane == spec::Plane::zx ? xyz_[1] : xyz_[0];
}

}  // namespace toolcomp::fast
