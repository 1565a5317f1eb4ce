// Arcs of a path: as the block gives them, and as the tool runs them between the vectors at both ends.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fast/arithmetic/count.h"
#include "fast/geometry/path.h"
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
