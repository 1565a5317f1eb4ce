// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/fanuc/arc_words.h"

#include <cmath>

namespace toolcomp::fuzz {

void arc_words(Choices& choose, ProgramWriter& write, const Segment& arc, std::string_view letters) {
  if (arc.kind == Segment::Kind::radius_arc) {
    write.number('R', arc.radius);
    return;
  }
  const std::int64_t center[] = {arc.to_center.x, arc.to_center.y};
  for (const std::size_t i : {0U, 1U})
    if (center[i] != 0 || choose.chance(10)) write.number(letters[i], center[i]);
}

void arc_words_by_radius(ProgramWriter& write, const Segment& arc) {
  if (arc.kind == Segment::Kind::radius_arc) {
    write.number('R', arc.radius);
    return;
  }
  const double radius = std::hypot(static_cast<double>(arc.to_center.x), static_cast<double>(arc.to_center.y));
  const PlaneCounts out = arc.travel - arc.to_center;
  // The turn from start to end radius: over a half circle where it goes against the sense of the arc.
  const std::int64_t turn = arc.to_center.y * out.x - arc.to_center.x * out.y;
  const bool larger = arc.clockwise ? turn > 0 : turn < 0;
  const auto counts = static_cast<std::int64_t>(std::ceil(radius));
  write.number('R', larger ? -counts : counts);
}

}  // namespace toolcomp::fuzz
