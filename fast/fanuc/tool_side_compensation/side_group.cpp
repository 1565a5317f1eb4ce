// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_side_compensation/side_group.h"

#include <cmath>

namespace toolcomp::fast {
namespace {

// 0: none. Less is none too.
Amount amount_parameter(const spec::Setup& setup, std::uint32_t number) {
  const Count length = length_parameter(setup, number);
  if (length < Count()) return {};
  return {length, length.nearest()};
}

}  // namespace

SideParameters::SideParameters(const spec::Setup& setup)
    : CornerParameters(setup),
      type(setup.bit(5003, 1) ? StartType::c : (type_b ? StartType::b : StartType::a)),
      bare_b(setup.type_b_without_perpendicular),
      no_plane_change(setup.bit(19605, 5)),
      tilt(setup),
      no_movement(amount_parameter(setup, 19630)) {
  type_b = type == StartType::b;
}

bool SideGroups::meet(const SideCorner& corner, HeadKind kind, Vector3<double>& vector) const {
  if (corner.flat) return SideGeometry::paths_meet(corner, kind, vector);
  geometry_.set_vector(corner, kind, vector);
  return true;
}

// What double-double cannot tell is taken for equal.
bool SideGroups::is_small_movement(const SideGroup& group, std::size_t a, std::size_t b) const {
  Vector3<double> difference = group.head[a].vector - group.head[b].vector;
  const double distance = std::sqrt(dot(difference, difference));
  const double over = distance - parameters_.limit_value;
  const double scale = 4 * group.corner.offset->nearest + parameters_.limit_value;
  if (std::abs(over) > 0x1p-42 * scale) return over < 0;
  const Vector3<DoubleDouble> refined = fine(group, a) - fine(group, b);
  return (sqrt(dot(refined, refined)) - parameters_.fine_limit()).hi <= 0x1p-86 * scale;
}

}  // namespace toolcomp::fast
