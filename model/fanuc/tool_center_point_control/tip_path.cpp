#include "model/fanuc/tool_center_point_control/tip_path.h"

#include <utility>

#include "model/fanuc/corner/plane_vector.h"

namespace toolcomp::model {

TipPath::TipPath(Vector from, Vector to, const spec::Arc<Real>& arc, const spec::Axes& axes)
    : TipPath(std::move(from), std::move(to)) {
  if (!arc.sweep) return;
  const PlaneLetters in_plane = letters(arc.plane);
  const auto center = [&](char letter) { return axes.has(letter) ? arc.center[axes.index(letter)] : Real(0); };
  Turn turn;
  turn.plane = arc.plane;
  turn.center = {center(in_plane.first), center(in_plane.second)};
  turn.sweep = arc.direction == spec::ArcDirection::ccw ? *arc.sweep : -*arc.sweep;
  if (arc.radius) turn.growth = (arc.radius->second - arc.radius->first) / arc.radius->first;
  turn_ = turn;
}

// fanuc.tool-center-point.tip-path: Inside a block the tip is at the fraction t of its path in the system fixed to the
// table, with either WKP: on the line, or on the arc, where t is the fraction of the sweep, the radius and the travel
// across the plane going evenly with it (an arc that has no sweep because an end lies in its centre counts as the line
// between its ends). A block that does not move the tip has the fraction of its rotation for t. Axes that are neither X
// Y Z nor rotary axes of 19681 and 19686 go evenly.
Vector TipPath::at(const Rational& t) const {
  const Vector straight = from_ + Real(t) * (to_ - from_);
  if (!turn_) return straight;
  const Real angle = t * turn_->sweep;
  const Real cosine = exact::cos_real_degrees(angle);
  const Real sine = exact::sin_real_degrees(angle);
  const PlanePoint radius = in_plane_of(turn_->plane, from_) - turn_->center;
  const PlanePoint turned = turn_->center + (1 + t * turn_->growth) * (cosine * radius + sine * left(radius));
  // What lies across the plane goes evenly.
  Vector result = straight;
  component(result, space_index(letters(turn_->plane).first)) = turned[0];
  component(result, space_index(letters(turn_->plane).second)) = turned[1];
  return result;
}

}  // namespace toolcomp::model
