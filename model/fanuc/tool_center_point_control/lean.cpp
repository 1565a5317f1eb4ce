#include "model/fanuc/tool_center_point_control/lean.h"

#include <optional>

#include "model/basis/event.h"
#include "model/fanuc/corner/plane_vector.h"

namespace toolcomp::model {
namespace {

bool known_zero(const Real& x) { return x.is_rational() && x.sign() == Sign::zero; }

// The tangent in space at the end of the arc: square to the radius there, and as long as that; on a helix with what it
// climbs in an angle of 1 radian. Only that part is no algebraic number.
Vector end_tangent(const Leg& leg, const spec::Axes& axes) {
  const spec::Arc<Real>& arc = *leg.arc;
  const PlaneLetters in_plane = letters(arc.plane);
  const auto from_center = [&](char letter) {
    if (!axes.has(letter)) return Real(0);
    const std::size_t axis = axes.index(letter);
    return leg.actual(axis).value() - arc.center[axis];
  };
  const PlanePoint counter_clockwise = left(PlanePoint{from_center(in_plane.first), from_center(in_plane.second)});
  Vector tangent =
      in_space(arc.plane, arc.direction == spec::ArcDirection::ccw ? counter_clockwise : -counter_clockwise);
  const std::size_t normal = 3 - space_index(in_plane.first) - space_index(in_plane.second);
  const Real& climb = component(leg.travel, normal);
  constexpr int half_turn = 180;
  if (arc.sweep && !known_zero(climb)) component(tangent, normal) = half_turn * climb / (*arc.sweep * exact::pi());
  return tangent;
}

// The unit vector of one that is not zero and known to lie along a coordinate axis: it needs no root.
std::optional<Vector> along_coordinate(const Vector& v) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!known_zero(component(v, (i + 1) % 3)) || !known_zero(component(v, (i + 2) % 3))) continue;
    Vector unit;
    component(unit, i) = component(v, i).sign() == Sign::positive ? 1 : -1;
    return unit;
  }
  return std::nullopt;
}

}  // namespace

Vector lean_travel(const Leg& leg, const spec::Axes& axes) { return leg.arc ? end_tangent(leg, axes) : leg.travel; }

// V' = cos Q V + sin Q n × V, with n = V × d / |V × d|.
Direction leaned(Recorder& recorder, const Direction& tool, const Leg& leg, const spec::Axes& axes,
                 const Rational& degrees) {
  if (leg.arc) recorder.reach(Clause::fanuc_tool_center_point_lean_in_an_arc);
  const Vector travel = lean_travel(leg, axes);
  const Vector normal = cross(tool.vector, travel);
  const Real normal2 = squared_norm(normal);
  const Real scale = tool.norm2 * squared_norm(travel);
  // No travel is no near tie.
  const Sign leans = recorder.decide(Clause::fanuc_tool_center_point_lean_along_the_travel, normal2,
                                     scale.sign() == Sign::zero ? Real(1) : scale);
  if (leans != Sign::positive) return tool;
  if (normal2.sign() == Sign::zero) throw NotFinite();  // only a forced outcome comes here
  recorder.reach(Clause::fanuc_tool_center_point_lean);
  const auto coordinate = along_coordinate(normal);
  const Vector across =
      coordinate ? cross(*coordinate, tool.unit) : cross(normal, tool.vector) / sqrt(normal2 * tool.norm2);
  const Vector unit = exact::cos_degrees(degrees) * tool.unit + exact::sin_degrees(degrees) * across;
  return {unit, 1, unit, true};
}

}  // namespace toolcomp::model
