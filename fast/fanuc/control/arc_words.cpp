// SPDX-License-Identifier: Apache-2.0
// G02, G03: which words make an arc, in the selected plane.
#include "fast/fanuc/control/control.h"
#include "fast/fanuc/program/arc.h"

namespace toolcomp::fast {

Alarm Control::plan_arc(const Words& words, BlockArc& arc, bool geometry, bool about_start) const {
  if (!modal.is_arc(words)) {
    arc.event.reset();
    return AlarmCause::none;
  }
  const std::array<std::size_t, 2>& plane = modal.plane_axis();
  std::array<Count, 2> start;
  std::array<Count, 2> end;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t axis = plane[i];
    if (axis == spec::Axes::kNone) continue;
    start[i] = end[i] = positions.actual(axis);
    if ((words.axes() & bit(axis)) != 0) end[i] = target(words, axis) + positions.tool_offset()[axis];
  }
  if (!end[0].in_range() || !end[1].in_range()) return AlarmCause::position_range;
  if (!modal.runs_arc(words, start, end)) {
    arc.event.reset();
    return AlarmCause::none;
  }
  modal.read_arc(words, units, arc.words);
  const auto& [clockwise, by_radius, to_center, radius] = arc.words;
  ArcGeometry made;
  Alarm a;
  const bool in_start = !by_radius && to_center[0].is_zero() && to_center[1].is_zero();
  if (in_start && about_start && words.has_any(Words::set_of("IJK")))
    made.center = {start[0].nearest(), start[1].nearest()};
  else if (geometry)
    a = by_radius ? arc_by_radius(start, end, radius, clockwise, made)
                  : arc_by_center(start, end, to_center, clockwise, made);
  else
    a = by_radius ? center_by_radius(start, end, radius, clockwise, made.center)
                  : center_by_center(start, to_center, made.center);
  if (!a && !by_radius && !in_start) a = check_radii(start, end, to_center);
  if (a) return a;
  // One that is there is not cleared: what is not present in it is not looked at.
  spec::Arc<double>& event = arc.event ? *arc.event : arc.event.emplace();
  event.center.present = 0;
  event.plane = modal.plane();
  event.direction = clockwise ? spec::ArcDirection::cw : spec::ArcDirection::ccw;
  for (std::size_t i = 0; i < 2; ++i)
    if (plane[i] != spec::Axes::kNone) event.center.set(plane[i], made.center[i]);
  event.sweep = made.sweep;
  event.radius = made.radius;
  return AlarmCause::none;
}

}  // namespace toolcomp::fast
