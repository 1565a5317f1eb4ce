// SPDX-License-Identifier: Apache-2.0
// The rules of tool center point control that need nothing but a block: the lean angle Q of G43.5, and arcs in the
// workpiece coordinate system. What follows from the words alone is in words.cpp, poses are in model/kinematics.
#include <optional>

#include "model/basis/alarm.h"
#include "model/basis/event.h"
#include "model/fanuc/tool_center_point_control/tool_center_point_control.h"
#include "model/geometry/plane_vector.h"

namespace toolcomp::model {
namespace {

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

// fanuc.tool-center-point.lean: Q of the block of G43.5 leans the tool in every block of the mode in which the tip
// moves. The tool leans by Q degrees from the direction V, commanded or kept, toward the travel d of that block, in the
// plane of V and d. A negative Q leans it the other way, against d. V and d are in the programming system, and d is
// that of the programmed travel. Everything else starts from the leaned direction. With a Q of 0, or without Q, the
// tool does not lean. In the blocks that follow Q is not the lean angle, and outside tool side compensation it means
// nothing.
// fanuc.tool-center-point.lean-along-the-travel: If V is parallel to d, or the tip does not travel, Q has no effect in
// that block: the direction is the one commanded or kept, without a lean. Asked if Q is not 0, in a block that has I J
// K or in which the tip travels.
//
// V' = cos Q V + sin Q n × V, with n = V × d / |V × d|.
Direction ToolCenterPointControl::leaned(const Direction& tool, const Leg& leg) const {
  if (leg.arc) recorder_.reach(Clause::fanuc_tool_center_point_lean_in_an_arc);
  const Vector travel = lean_travel(leg);
  const Vector normal = cross(tool.vector, travel);
  const Real normal2 = squared_norm(normal);
  const Real scale = tool.norm2 * squared_norm(travel);
  // No travel is no near tie.
  const Sign leans = recorder_.decide(Clause::fanuc_tool_center_point_lean_along_the_travel, normal2,
                                      scale.sign() == Sign::zero ? Real(1) : scale);
  if (leans != Sign::positive) return tool;
  if (normal2.sign() == Sign::zero) throw NotFinite();  // only a forced outcome comes here
  recorder_.reach(Clause::fanuc_tool_center_point_lean);
  const auto coordinate = along_coordinate(normal);
  const Vector across =
      coordinate ? cross(*coordinate, tool.unit) : cross(normal, tool.vector) / sqrt(normal2 * tool.norm2);
  return Direction::of_unit(exact::cos_degrees(lean_) * tool.unit + exact::sin_degrees(lean_) * across);
}

// fanuc.tool-center-point.lean-in-an-arc: In an arc d is the tangent in space at the end of the arc. It is
// perpendicular to the radius there, in the sense of the arc, and in a helix it has the pitch of the helix. An arc
// under G43.5 is given by R, so its radius is the same at both ends.
//
// As long as the radius there; on a helix with what it climbs in an angle of 1 radian. Only that part is no algebraic
// number.
Vector ToolCenterPointControl::lean_travel(const Leg& leg) const {
  if (!leg.arc) return leg.travel;
  const spec::Arc<Real>& arc = *leg.arc;
  const auto from_center = [&](std::size_t axis) { return leg.actual(axis).value() - arc.center[axis]; };
  const PlanePoint counter_clockwise = left(in_plane_of(arc.plane, in_space(axes_, from_center)));
  Vector tangent =
      in_space(arc.plane, arc.direction == spec::ArcDirection::ccw ? counter_clockwise : -counter_clockwise);
  const std::size_t normal = normal_axis(arc.plane);
  const Real& climb = component(leg.travel, normal);
  constexpr int half_turn = 180;
  if (arc.sweep && !known_zero(climb)) component(tangent, normal) = half_turn * climb / (*arc.sweep * exact::pi());
  return tangent;
}

// fanuc.tool-center-point.arc-in-workpiece-system: With WKP = 1 a table axis may turn in an arc only if it is normal to
// the selected plane, as it stands in the machine at the start of the block. Every other table axis must stand, at both
// ends, where it stood when tool center point control began, at the frozen pose (whole turns count). Otherwise PS5421
// is raised. Tool axes are free.
// fanuc.tool-center-point.arc-with-table-turned: With WKP = 1 an arc raises ARC_WITH_TABLE_TURNED, a name of ours, if a
// table axis normal to the plane turns in it or has turned since tool center point control began. The manual lets such
// an axis turn in an arc, but does not say what path the tip then has. PS5421 of
// fanuc.tool-center-point.arc-in-workpiece-system comes first. A turn before tool center point control began does not
// matter: if no table axis has moved since, the workpiece system is the table system.
//
// The first axis of a table carries the second. Where the first turns it is normal to the plane, so that the second
// keeps its angle to the normal: its line at the start decides for the whole block.
void ToolCenterPointControl::require_table_still(spec::Plane plane, const Pose& end) const {
  const Turn& tool = machine_->tool_side();
  const Turn& work = machine_->work_side();
  const Pose& start = tip_->pose;
  const Pose& frozen = tip_->frame->frame.frozen();
  Vector normal;
  component(normal, normal_axis(plane)) = 1;
  bool turned_about_normal = false;
  const auto look_at = [&](const Vector& line, Angle Pose::* position) {
    if (end.*position == start.*position && start.*position == frozen.*position) return;
    if (!is_zero(cross(line, normal)))
      raise(recorder_, Clause::fanuc_tool_center_point_arc_in_workpiece_system, AlarmCause::table_turned_in_arc);
    turned_about_normal = true;
  };
  const bool carries = machine_->type() == MachineType::table;
  if (carries) look_at(tool.line, &Pose::tool);
  look_at(carries ? tool.apply_back(work.line, start.tool) : work.line, &Pose::work);
  if (turned_about_normal)
    raise(recorder_, Clause::fanuc_tool_center_point_arc_with_table_turned, AlarmCause::arc_with_table_turned);
}

}  // namespace toolcomp::model
