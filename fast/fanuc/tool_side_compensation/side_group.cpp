#include "fast/fanuc/tool_side_compensation/side_group.h"

#include <cmath>

namespace toolcomp::fast {

SideParameters::SideParameters(const spec::Setup& setup)
    : CornerParameters(setup),
      type(setup.bit(5003, 1) ? StartType::c : (type_b ? StartType::b : StartType::a)),
      bare_b(setup.type_b_without_perpendicular),
      no_plane_change(setup.bit(19605, 5)),
      tilt(setup),
      no_movement(length_parameter(setup, 19630)) {
  type_b = type == StartType::b;
}

bool SideGroups::meet(const SideCorner& corner, HeadKind kind, Vector3<double>& vector) const {
  if (corner.flat) return SideGeometry::paths_meet(corner, kind, vector);
  geometry_.set_vector(corner, kind, vector);
  return true;
}

// What double-double cannot tell is taken for equal.
bool SideGroups::is_small_movement(const SideGroup& group, std::size_t a, std::size_t b) const {
  const Vector3<double> difference = group.head[a].vector - group.head[b].vector;
  const double distance = std::sqrt(dot(difference, difference));
  const double over = distance - parameters_.limit_value;
  const double scale = 4 * group.corner.offset->nearest + parameters_.limit_value;
  if (std::abs(over) > 0x1p-42 * scale) return over < 0;
  const Vector3<DoubleDouble> refined = fine(group, a) - fine(group, b);
  return (sqrt(dot(refined, refined)) - parameters_.fine_limit()).hi <= 0x1p-86 * scale;
}

bool SideGroups::make(SideGroup& group, CornerRule rule, Treatment treatment) const {
  const bool in_mode = rule == CornerRule::ordinary || rule == CornerRule::repeated;
  if (treatment == Treatment::perpendicular && in_mode && group.corner.offset->nearest != 0) {
    set(group, HeadKind::first_normal);
    return true;
  }
  if (!CornerGroups::make(group, rule)) return false;
  const bool first_only = treatment == Treatment::first_only && rule == CornerRule::ordinary && !group.corner.flat;
  if (first_only && !fault(Fault::side_q2_ignored)) group.size = 1;
  return true;
}

}  // namespace toolcomp::fast
