// G02, G03: which words make an arc, in the selected plane.
#include "fast/program/arc.h"
#include "fast/program/interpreter.h"

namespace toolcomp::fast {

std::size_t Interpreter::normal_axis() const {
  if (plane_ == spec::Plane::xy) return xyz_[2];
  return plane_ == spec::Plane::zx ? xyz_[1] : xyz_[0];
}

// An axis of the plane, I J K or R make an arc; anything else under G02 or G03 is straight.
Alarm Interpreter::plan_arc(const Words& words, std::optional<spec::Arc<double>>& arc) const {
  const std::size_t first = plane_ == spec::Plane::xy ? 0 : (plane_ == spec::Plane::zx ? 2 : 1);
  const std::array<std::size_t, 2> in_plane{first, (first + 1) % 3};  // of X, Y, Z
  std::array<Count, 2> start;
  std::array<Count, 2> end;
  std::array<Count, 2> to_center;
  bool is_arc = words.has('R') || words.has_any(Words::set_of("IJK"));
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t axis = xyz_[in_plane[i]];
    const char letter = static_cast<char>('I' + in_plane[i]);
    if (axis != spec::Axes::kNone) {
      start[i] = end[i] = programmed_[axis];
      if ((words.axes() & bit(axis)) != 0) {
        end[i] = target(words, axis);
        is_arc = true;
      }
    }
    if (words.has(letter)) to_center[i] = value(words[letter], true, inch_program_);
  }
  if (!is_arc) return alarm::kNone;
  if (!end[0].in_range() || !end[1].in_range()) return alarm::kRange;
  const bool clockwise = motion_ == 20;
  ArcGeometry geometry;
  const Alarm a = words.has('R')
                      ? arc_by_radius(start, end, value(words['R'], true, inch_program_), clockwise, geometry)
                      : arc_by_center(start, end, to_center, clockwise, geometry);
  if (a) return a;
  arc.emplace();
  arc->plane = plane_;
  arc->direction = clockwise ? spec::ArcDirection::cw : spec::ArcDirection::ccw;
  for (std::size_t i = 0; i < 2; ++i)
    if (const std::size_t axis = xyz_[in_plane[i]]; axis != spec::Axes::kNone)
      arc->center.set(axis, geometry.center[i]);
  arc->sweep = geometry.sweep;
  arc->radius = geometry.radius;
  return alarm::kNone;
}

}  // namespace toolcomp::fast
