// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_center_point_control/tip_path.h"

#include "model/geometry/plane_vector.h"

namespace toolcomp::model {

// fanuc.tool-center-point.tip-path: Inside a block the tip is at the fraction t of its path in the system fixed to the
// table, whatever WKP is. On an arc t is the fraction of the sweep, and the radius and the travel across the plane go
// evenly with it. An arc that has no sweep, because an end lies in its centre, counts as the line between its ends. In
// a block that does not move the tip, t is the fraction of the rotation. Axes that are neither X Y Z nor rotary axes of
// 19681 and 19686 go evenly.
Vector TipPath::at(const Rational& t) const {
  Vector straight = path_.from + Real(t) * (path_.to - path_.from);
  if (!path_.turn) return straight;
  const PointPath::Turn& turn = *path_.turn;
  const Real angle = t * turn.sweep;
  const Real cosine = exact::cos_real_degrees(angle);
  const Real sine = exact::sin_real_degrees(angle);
  const PlanePoint radius = in_plane_of(turn.plane, path_.from) - turn.center;
  const PlanePoint turned = turn.center + (1 + t * turn.growth) * (cosine * radius + sine * left(radius));
  // What lies across the plane goes evenly.
  Vector result = straight;
  component(result, space_index(letters(turn.plane).first)) = turned[0];
  component(result, space_index(letters(turn.plane).second)) = turned[1];
  return result;
}

}  // namespace toolcomp::model
