// G02, G03: which words make an arc, in the selected plane.
#include "fast/fanuc/interpreter/interpreter.h"
#include "fast/fanuc/interpreter/usual_words.h"
#include "fast/fanuc/program/arc.h"

namespace toolcomp::fast {

Alarm Interpreter::plan_arc(const Words& words, std::optional<spec::Arc<double>>& arc, ArcWords& arc_words,
                            bool with_geometry) const {
  if (!modal_.is_arc(words)) return alarm::kNone;
  const std::array<std::size_t, 2>& plane = modal_.plane_axis();
  std::array<Count, 2> start;
  std::array<Count, 2> end;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t axis = plane[i];
    if (axis == spec::Axes::kNone) continue;
    start[i] = end[i] = positions_.actual(axis);
    if ((words.axes() & bit(axis)) != 0) end[i] = target(words, axis) + positions_.tool_offset()[axis];
  }
  if (!end[0].in_range() || !end[1].in_range()) return alarm::kRange;
  modal_.read_arc(words, units_, arc_words);
  const auto& [clockwise, by_radius, to_center, radius] = arc_words;
  ArcGeometry geometry;
  Alarm a;
  // An arc about its start is refused by cutter compensation C, once the rest of the block is known.
  const bool about_start = !by_radius && to_center[0].is_zero() && to_center[1].is_zero();
  if (about_start && !is_b_ && cutter_wanted(words) && words.has_any(Words::set_of("IJK")))
    geometry.center = {start[0].nearest(), start[1].nearest()};
  else if (with_geometry)
    a = by_radius ? arc_by_radius(start, end, radius, clockwise, geometry)
                  : arc_by_center(start, end, to_center, clockwise, geometry);
  else
    a = by_radius ? center_by_radius(start, end, radius, clockwise, geometry.center)
                  : center_by_center(start, to_center, geometry.center);
  if (a) return a;
  arc.emplace();
  arc->plane = modal_.plane();
  arc->direction = clockwise ? spec::ArcDirection::cw : spec::ArcDirection::ccw;
  for (std::size_t i = 0; i < 2; ++i)
    if (plane[i] != spec::Axes::kNone) arc->center.set(plane[i], geometry.center[i]);
  arc->sweep = geometry.sweep;
  arc->radius = geometry.radius;
  return alarm::kNone;
}

}  // namespace toolcomp::fast
