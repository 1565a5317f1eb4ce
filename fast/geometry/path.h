// SPDX-License-Identifier: Apache-2.0
// One straight line or arc of the programmed path, in the compensation plane.
#pragma once

#include <array>

#include "fast/arithmetic/count.h"
#include "fast/geometry/heading.h"
#include "fast/geometry/vector2.h"

namespace toolcomp::fast {

// Lengths in setup units, all relative to the start or the end of the path itself, never to the origin: accuracy does
// not depend on where the path lies.
struct PlanePath {
  bool arc = false;
  int sigma = 0;    // arcs: +1 counterclockwise (G03), -1 clockwise
  Heading start;    // tangents
  Heading arc_end;  // of an arc
  [[nodiscard]] const Heading& end() const { return arc ? arc_end : start; }
  bool fine_units = false;  // whole numbers are Count::units(), not 10^-6
  // Arcs.
  std::array<Int128, 2> whole{};      // from start to end; of a line it is that of `start`
  Vector2<double> from_center_start;  // start - centre
  Vector2<double> from_center_end;    // end - centre
  double radius_start = 0;
  double radius_end = 0;
  bool spiral = false;          // the radii differ
  bool semicircle = false;      // 180 degrees or more
  bool over_half = false;       // more than 180 degrees
  bool ends_in_center = false;  // or starts there: then nothing else is set

  // The sweep has this sine and cosine (of any length); arcs by R: its half. `turned` is the exact sign of the sine.
  double sine = 0;
  double cosine = 1;
  int turned = 0;

  bool by_radius = false;   // the radius is that of an R word: Heading::radius (half circles: see radius_whole)
  Int128 radius_whole = 0;  // by_radius: |R| in units
  // Seen in a plane that no axis spans: an arc's radius at either end, setup units.
  bool seen = false;
  std::array<DoubleDouble, 2> fine_radius{};
};

// A line of some length.
void set_any_line(PlanePath& path, const std::array<Count, 2>& start, const std::array<Count, 2>& end);
constexpr bool is_narrow(std::int64_t x) { return x < (std::int64_t{1} << 31) && x > -(std::int64_t{1} << 31); }
// The same; the usual line, below 2^31, at once.
inline void set_line(PlanePath& path, const std::array<Count, 2>& start, const std::array<Count, 2>& end) {
  const std::int64_t x = end[0].small() - start[0].small();
  const std::int64_t y = end[1].small() - start[1].small();
  const bool small = start[0].is_small() && start[1].is_small() && end[0].is_small() && end[1].is_small();
  if (!small || !is_narrow(x) || !is_narrow(y)) [[unlikely]]
    return set_any_line(path, start, end);
  path.arc = false;
  path.fine_units = false;
  set_narrow_heading(path.start, x, y);
}
// An arc round start + to_center.
void set_arc(PlanePath& path, const std::array<Count, 2>& start, const std::array<Count, 2>& end,
             const std::array<Count, 2>& to_center, bool clockwise);
// The same of an arc from `from` to `to`, seen from its centre, in 10^-6 below 2^31, neither of them zero; the fields
// that say what arc it is are set.
void set_narrow_arc(PlanePath& path, const std::array<std::int64_t, 2>& from, const std::array<std::int64_t, 2>& to);
// An arc of |radius| at least half the chord; above 180 degrees where radius < 0.
void set_arc_by_radius(PlanePath& path, const std::array<Count, 2>& start, const std::array<Count, 2>& end,
                       const Count& radius, bool clockwise);

// Whole numbers of the headings in a setup unit.
inline double per_one(const PlanePath& path) {
  return path.fine_units ? static_cast<double>(Count::kRestPerOne) : static_cast<double>(Count::kSmallPerOne);
}
// The straight way from start to end, setup units.
inline Vector2<double> travel(const PlanePath& path) {
  const double unit = per_one(path);
  if (!path.arc) return path.start.unit * (path.start.norm / unit);
  return {static_cast<double>(path.whole[0]) / unit, static_cast<double>(path.whole[1]) / unit};
}
// The sweep of an arc whose end is not its centre, in degrees within (0, 360].
double programmed_sweep(const PlanePath& path);
// From start to end to about 100 bits.
Vector2<DoubleDouble> fine_travel(const PlanePath& path);
// The radius at the start or the end to about 100 bits.
DoubleDouble fine_radius(const PlanePath& path, bool at_end);
// By how much a path is offset, >= 0, setup units: exactly, and the nearest double.
struct Amount {
  Count exact;
  double nearest = 0;
};
// The sign of (radius at that end) - offset, exactly: in whole numbers, and where doubles are enough in those.
int compare_whole_radius(const PlanePath& path, bool at_end, const Amount& offset);
inline int compare_radius(const PlanePath& path, bool at_end, const Amount& offset) {
  const double radius = at_end ? path.radius_end : path.radius_start;
  // Both are within a few roundings of 2^-53.
  if (std::abs(radius - offset.nearest) > 0x1p-48 * radius) [[likely]]
    return radius > offset.nearest ? 1 : -1;
  return compare_whole_radius(path, at_end, offset);
}

}  // namespace toolcomp::fast
