// SPDX-License-Identifier: Apache-2.0
// How a block of the mode moves, at the ends of those held and at its own.
#include <algorithm>
#include <utility>

#include "model/basis/alarm.h"
#include "model/basis/event.h"
#include "model/fanuc/tool_side_compensation/tool_side_compensation.h"

namespace toolcomp::model {
namespace {

// The arc of a leg, seen from its centre in the plane selected.
SideArc arc_of(const Leg& leg, const std::optional<Rational>& radius, const spec::Axes& axes) {
  const spec::Arc<Real>& arc = *leg.arc;
  const PlaneLetters in_plane = letters(arc.plane);
  // A machine without an axis of the plane stands at 0 in it.
  const auto from_center = [&](char letter) {
    if (!axes.has(letter)) return Real(0);
    const std::size_t axis = axes.index(letter);
    return leg.actual(axis).value() - arc.center[axis];
  };
  SideArc result;
  result.plane = arc.plane;
  result.ends.end = {from_center(in_plane.first), from_center(in_plane.second)};
  result.ends.start = result.ends.end - in_plane_of(arc.plane, leg.travel);
  result.ends.turn = arc.direction == spec::ArcDirection::ccw ? 1 : -1;
  result.ends.radius = radius;
  result.ends.one_radius = !arc.radius;
  return result;
}

// What was decided on |VT × U|². A line along the tool has no direction in the plane.
bool crosses(Sign decided, const Real& left2) {
  if (decided != Sign::positive) return false;
  if (left2.sign() != Sign::positive) throw NotFinite();  // only a forced outcome comes here
  return true;
}

}  // namespace

std::vector<bool> ToolSideCompensation::Movement::corners() const {
  std::vector<bool> moves(starts.size());
  for (std::size_t i = 0; i < starts.size(); ++i) moves[i] = starts[i].has_value();
  return moves;
}

// A line is asked in the plane of each corner that is still to be made, and in the one at its own end.
ToolSideCompensation::Movement ToolSideCompensation::movement_of(const Step& now) const {
  Movement movement;
  movement.own = CompensationPlane(now.rest.tool);
  movement.starts.resize(ahead_.held().size());
  if (now.moves.empty()) return movement;
  const Leg& leg = now.moves.front().leg;
  movement.path.travel = leg.travel;
  if (leg.arc) {
    movement.path.arc = arc_of(leg, said(now).radius, axes_);
    for (std::size_t i = 0; i < movement.starts.size(); ++i)
      if (!ahead_.held()[i].met) movement.starts[i].emplace();
    movement.end.emplace();
    return movement;
  }
  const auto seen_in = [&](const CompensationPlane& plane) {
    SideEnd line = line_end(plane, leg.travel, 0);
    return crosses_tool(plane, line) ? std::optional(std::move(line)) : std::nullopt;
  };
  const std::deque<Held>& held = ahead_.held();
  for (std::size_t i = 0; i < held.size(); ++i)
    if (!held[i].met) movement.starts[i] = seen_in(side_path_of(held[i]).plane);
  const bool same = !held.empty() && !held.back().met && movement.own.is_same_as(side_path_of(held.back()).plane);
  movement.end = same ? movement.starts.back() : seen_in(movement.own);
  return movement;
}

bool ToolSideCompensation::crosses_tool(const CompensationPlane& plane, const SideEnd& line) const {
  const Real& norm2 = plane.tool().norm2;
  const Real travel2 = squared_norm(line.travel);
  // fanuc.tool-side.along-the-tool: Without a limit (19630 is zero, negative or not given), a block moves if its
  // displacement is neither zero nor parallel to the tool.
  if (limit_ <= 0)
    return crosses(recorder().decide(Clause::fanuc_tool_side_along_the_tool, line.left2, norm2 * travel2), line.left2);
  const Rational limit2 = limit_ * limit_;
  // fanuc.tool-side.no-movement-limit: With 19630 positive (in setup units), a block whose ends differ by less than
  // 19630 in the compensation plane counts as one that does not move.
  const Sign decided = recorder().decide(Clause::fanuc_tool_side_no_movement_limit, line.left2 - limit2 * norm2,
                                         norm2 * (travel2 + limit2));
  return decided != Sign::negative && crosses(Sign::positive, line.left2);
}

// The side each corner sees, and the sense of an arc there.
void ToolSideCompensation::look_at_movement(Step& now, Movement& movement, const CutterOffset& offset) {
  if (movement.path.arc) look_at_arc(now, movement);
  for (std::size_t i = 0; i < movement.starts.size(); ++i)
    if (movement.starts[i]) movement.starts[i]->offset = offset.side * ahead_.held()[i].offset.distance;
  if (movement.end) movement.end->offset = offset.left();
}

// From which side the tool sees the plane of an arc: +1, -1, or 0 where it lies in it.
int ToolSideCompensation::sense(const Direction& tool, spec::Plane plane) const {
  const Real& upright = component(tool.vector, third_axis(plane));
  // fanuc.tool-side.arc-plane: N, the positive normal of the plane selected (Z of G17, Y of G18, X of G19), tells the
  // sense in which an arc is seen from the tool.
  const Sign seen = recorder().decide(Clause::fanuc_tool_side_arc_plane, upright, sqrt(tool.norm2));
  if (seen != Sign::zero && upright.sign() == Sign::zero) throw NotFinite();  // only a forced outcome comes here
  return static_cast<int>(seen);
}

bool ToolSideCompensation::leans(const Direction& tool, spec::Plane plane) const {
  // fanuc.tool-side.arc-plane-mismatch: An arc in the mode gives the warning ARC_PLANE_MISMATCH if VT at the end of the
  // block before it, or at its own end, is not at right angles to the plane selected. The warning comes once a block,
  // right before the first move that belongs to the block; the arc runs as computed.
  return recorder().decide(Clause::fanuc_tool_side_arc_plane_mismatch, squared_norm(in_plane_of(plane, tool.vector)),
                           tool.norm2) != Sign::zero;
}

void ToolSideCompensation::look_at_arc(Step& now, Movement& movement) {
  // fanuc.tool-side.arc: The start, end and centre of an arc, also of a helix, are projected onto the compensation
  // plane, and the vector found there is added to the programmed point. The machine then runs the arc in the plane
  // selected by G17, G18 or G19.
  recorder().reach(Clause::fanuc_tool_side_arc);
  constexpr const char* kOnEdge = "an arc whose plane contains the tool direction";
  SideArc& arc = *movement.path.arc;
  for (std::size_t i = 0; i < movement.starts.size(); ++i) {
    if (!movement.starts[i]) continue;
    arc.sense_at_start = sense(side_path_of(ahead_.held()[i]).plane.tool(), arc.plane);
    if (arc.sense_at_start == 0) ahead_.leave_open_at(now, Clause::fanuc_tool_side_arc_plane, kOnEdge);
    movement.starts[i] = arc_start(arc, 0);
  }
  arc.sense_at_end = sense(movement.own.tool(), arc.plane);
  if (arc.sense_at_end == 0) ahead_.leave_open_at(now, Clause::fanuc_tool_side_arc_plane, kOnEdge);
  if (movement.starts.empty() || !movement.starts.back()) arc.sense_at_start = arc.sense_at_end;
  movement.end = arc_end(arc, 0);
  if (leans(before_, arc.plane) || leans(movement.own.tool(), arc.plane)) {
    Warning warning{"ARC_PLANE_MISMATCH", "the tool is not at right angles to the plane of the arc", {}};
    warning.clauses.add(Clause::fanuc_tool_side_arc_plane_mismatch);
    now.warning = warning;
  }
}

}  // namespace toolcomp::model
