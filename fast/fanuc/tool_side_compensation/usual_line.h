// SPDX-License-Identifier: Apache-2.0
// The usual line of tool side compensation: what block() does with it, by doubles alone and without the detours.
#pragma once

#include <cmath>

#include "fast/fanuc/control/event_in_space.h"
#include "fast/fanuc/tool_side_compensation/tool_side_compensation.h"

namespace toolcomp::fast {

// U and W: the movements before and behind the corner, V: the tool, u and w: what is seen of them along the tool.
// |u|^2 = |U|^2 - (V . U)^2, u . w = U . W - (V . U)(V . W).
[[gnu::always_inline]] inline bool ToolSideCompensation::see_line(const Vector3<double>& way,
                                                                  LineCorner& corner) const {
  const SidePath& from = paths_[path_];
  const Vector3<double> v{from.tool->unit[0], from.tool->unit[1], from.tool->unit[2]};
  const Vector3<double>& first = from.travel.value;
  const double square = way.x * way.x + way.y * way.y + way.z * way.z;
  const double along1 = dot(v, first);
  const double along2 = dot(v, way);
  const double square1 = from.travel.square - along1 * along1;
  const double square2 = square - along2 * along2;
  // Nearer than 30 degrees to the tool the projection loses digits; longer ways are not narrow.
  constexpr double kMostSquare = 0x1p60;
  if (4 * square1 < from.travel.square || 4 * square2 < square || square > kMostSquare) [[unlikely]]
    return false;
  corner.square = square;
  corner.length1 = std::sqrt(square1);
  corner.length2 = std::sqrt(square2);
  corner.product = dot(first, way) - along1 * along2;
  return true;
}

// Inner and obtuse corners of less than 90 degrees: against the movement before, the change of the plane may matter.
// The vector: r (V x U / |u| + V x W / |w|) / (1 + cosine). Whether it turns left or right makes no difference.
[[gnu::always_inline]] inline bool ToolSideCompensation::take_line(const Vector3<double>& way, const LineCorner& corner,
                                                                   const Direction& tool) {
  const double lengths = corner.length1 * corner.length2;
  // A direction is good to 2^-43, |U||W| is at most 4 |u||w|: 14 times that and a few roundings.
  constexpr double kUncertain = 0x1p-38;
  if (corner.product <= kUncertain * lengths || corner.length2 <= shortest_ || corner.length1 <= shortest_) [[unlikely]]
    return false;
  const double scale = line_.radius / (lengths + corner.product);
  const SidePath& from = paths_[path_];
  const Direction& seen_along = *from.tool;
  const Vector3<double> v{seen_along.unit[0], seen_along.unit[1], seen_along.unit[2]};
  const Vector3<double> vector = cross(v, from.travel.value * corner.length2 + way * corner.length1) * scale;
  // The tool goes forward for certain: the vector moves by less than the way.
  constexpr double kMost = (1 - 0x1p-30) / static_cast<double>(Count::kSmallPerOne);
  if (std::abs(vector.x - line_.vector.x) + std::abs(vector.y - line_.vector.y) + std::abs(vector.z - line_.vector.z) >=
          kMost * corner.length1 &&
      !goes_forward(from, corner.length1, vector)) [[unlikely]]
    return false;

  path_ = after(path_);
  Travel& travel = paths_[path_].travel;
  travel.value.x = way.x;
  travel.value.y = way.y;
  travel.value.z = way.z;
  travel.square = corner.square;
  paths_[path_].tool = &tool;
  line_.vector.x = vector.x;
  line_.vector.y = vector.y;
  line_.vector.z = vector.z;
  line_.taken = true;
  Event& event = ring_[first_].event;
  if (line_.held_plain) [[likely]]
    set_from_programmed(event, vector);
  else
    add(event, vector);
  line_.held_plain = line_.plain;
  sink_->on(event);
  if (count_ > 1) [[unlikely]] {
    free_first();
    send_held(line_.vector);
  }
  first_ = next_;
  count_ = 1;
  pass_slot();
  return true;
}

}  // namespace toolcomp::fast
