// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/corner/lent_path.h"

#include <cstdint>

#include "fast/arithmetic/count.h"
#include "fast/arithmetic/int128.h"

namespace toolcomp::fast {
namespace {

WholePair whole_pair(const std::array<Int128, 2>& whole) {
  return {static_cast<std::int64_t>(whole[0]), static_cast<std::int64_t>(whole[1])};
}

}  // namespace

bool set_usual_path(UsualPath& to, const PlanePath& path) {
  if (path.fine_units || path.seen) return false;
  if (path.arc && path.ends_in_center) return false;
  if (path.arc && path.by_radius) {
    constexpr Int128 kMost = Int128{1} << 30U;
    const auto is_usual = [](const Int128& x) { return x < kMost && x > -kMost; };
    if (!is_usual(path.whole[0]) || !is_usual(path.whole[1]) || !is_usual(path.radius_whole)) return false;
    const auto radius = static_cast<std::int64_t>(path.radius_whole);
    return set_usual_arc_by_radius(to, whole_pair(path.whole), path.over_half ? -radius : radius, path.sigma);
  }
  if (!path.start.narrow || !path.end().narrow) return false;
  if (path.arc) {
    const auto from_center = [&](const Heading& tangent) {
      const WholePair whole = whole_pair(tangent.whole);
      return WholePair{path.sigma * whole[1], -path.sigma * whole[0]};
    };
    return set_usual_arc(to, from_center(path.start), from_center(path.arc_end), path.sigma);
  }
  set_usual_line(to, whole_pair(path.start.whole));
  return true;
}

void set_plane_path(PlanePath& to, const UsualPath& path) {
  const auto count = [](std::int64_t small) {
    Count value;
    value.set_small(small);
    return value;
  };
  to.fine_units = false;
  if (!path.is_arc()) {
    to.arc = false;
    set_narrow_heading(to.start, path.start.whole[0], path.start.whole[1]);
  } else if (path.by_radius != 0) {
    const WholePair way = path.way();
    set_arc_by_radius(to, {}, {count(way[0]), count(way[1])}, count(path.by_radius), path.sigma < 0);
  } else {
    to.arc = true;
    to.sigma = path.sigma;
    to.by_radius = false;
    to.ends_in_center = false;
    set_narrow_arc(to, path.whole_start(), path.whole_end());
  }
}

bool is_on_circle(const PlanePath& arc, const Corner& corner, HeadKind kind) {
  const bool straight = corner.second == &arc && corner.turn.c == 0 && corner.turn.k > 0;
  return kind == HeadKind::paths_meet || kind == HeadKind::second_normal ||
         (kind == HeadKind::first_normal && straight);
}

bool moves_in_plane_only(const std::array<std::size_t, 2>& axis, const Event& before, const Event& event) {
  const unsigned others = event.axes.present & ~(1U << axis[0] | 1U << axis[1]);
  for (unsigned rest = others; rest != 0; rest &= rest - 1) {
    const auto other = static_cast<std::size_t>(__builtin_ctz(rest));
    if (before.axes.value[other] != event.axes.value[other]) return false;
  }
  return true;
}

}  // namespace toolcomp::fast
