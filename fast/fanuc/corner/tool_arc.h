// SPDX-License-Identifier: Apache-2.0
// Arcs of a path: as the block gives them, and as the tool runs them between the vectors at both ends.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fast/arithmetic/count.h"
#include "fast/geometry/angle.h"
#include "fast/geometry/path.h"
#include "fast/geometry/vector2.h"
#include "spec/language/axes.h"
#include "spec/language/event.h"

namespace toolcomp::fast {

// How the distances of the two heads from the centre compare, where it is known without computing them.
enum class Radii : std::uint8_t { agree, differ, unknown };
// Sweep and radii of the arc from start + v to end + w.
void set_tool_arc(spec::Arc<double>& arc, const PlanePath& path, const Vector2<double>& v, const Vector2<double>& w,
                  Radii radii);
// The same of the arc as programmed.
void set_programmed_arc(spec::Arc<double>& arc, const PlanePath& path);

// Lengths that are equal in truth differ by a few roundings.
constexpr double kEqualLength = 0x1p-46;
// A head `a` from the centre, by a vector of a path whose radius is `radius` there. Each end by its own size: a
// programmed spiral may grow from next to nothing.
inline bool is_off_center(double radius, const Vector2<double>& vector, const Vector2<double>& a) {
  return extent(a) > kEqualLength * (radius + extent(vector));
}
// The sweep from head `a` to head `b`, seen from the centre, away from a half and a whole turn and from the centre;
// false: nearer. `start`, `end`: of the programmed arc.
inline bool set_clear_sweep(int sigma, const Vector2<double>& start, const Vector2<double>& end,
                            const Vector2<double>& a, const Vector2<double>& b, double& sweep) {
  const double sine = sigma * cross(a, b);
  const double size = extent(a) * extent(b);
  if (std::abs(sine) <= 0x1p-10 * size || 16 * size <= extent(start) * extent(end)) return false;
  const double angle = polar_angle(dot(a, b), sine);
  sweep = angle < 0 ? angle + 360 : angle;
  return true;
}

// The path of a block with an arc.
template <class Block>
void set_arc_path(PlanePath& path, const Block& block) {
  if (block.by_radius)
    set_arc_by_radius(path, block.start, block.end, block.radius, block.clockwise);
  else
    set_arc(path, block.start, block.end, block.to_center, block.clockwise);
}

// Its event gets the centre of an arc that is given by the radius.
template <class Block>
void set_center(Block& block, const PlanePath& path) {
  if (!block.by_radius) return;
  const std::array<double, 2> from_center{path.from_center_start.x, path.from_center_start.y};
  for (std::size_t i = 0; i < 2; ++i)
    if (block.axis[i] != spec::Axes::kNone)
      block.event.arc->center.set(block.axis[i], block.start[i].nearest() - from_center[i]);
}

}  // namespace toolcomp::fast
