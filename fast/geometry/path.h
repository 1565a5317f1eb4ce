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
  std::array<Int128, 2> whole{};  // arcs: from start to end; lines: that of `start`
  Vector2<double> travel;         // from start to end, setup units
  double length = 0;              // of `travel`
  // Arcs.
  Vector2<double> from_center_start;  // start - centre
  Vector2<double> from_center_end;    // end - centre
  double radius_start = 0;
  double radius_end = 0;
  bool spiral = false;      // the radii differ
  bool semicircle = false;  // 180 degrees or more
  bool over_half = false;   // more than 180 degrees
  bool center_in_end = false;

  // The sweep has this sine and cosine (of any length); arcs by R: its half. `turned` is the exact sign of the sine.
  double sine = 0;
  double cosine = 1;
  int turned = 0;

  double unit = 1;          // whole numbers of the headings in a setup unit
  bool fine_units = false;  // ... is that of Count::units(), not 10^-6
  bool by_radius = false;   // the radius is that of an R word: Heading::radius (half circles: see radius_whole)
  Int128 radius_whole = 0;  // by_radius: |R| in units
  // Seen in a plane that no axis spans: an arc's radius at either end, setup units.
  bool seen = false;
  std::array<DoubleDouble, 2> fine_radius{};
};

// A line of some length.
void set_line(PlanePath& path, const std::array<Count, 2>& start, const std::array<Count, 2>& end);
// An arc round start + to_center, which is not zero.
void set_arc(PlanePath& path, const std::array<Count, 2>& start, const std::array<Count, 2>& end,
             const std::array<Count, 2>& to_center, bool clockwise);
// An arc of |radius| at least half the chord; above 180 degrees where radius < 0.
void set_arc_by_radius(PlanePath& path, const std::array<Count, 2>& start, const std::array<Count, 2>& end,
                       const Count& radius, bool clockwise);

// The sweep of an arc whose end is not its centre, in degrees within (0, 360].
double programmed_sweep(const PlanePath& path);
// From start to end to about 100 bits.
Vector2<DoubleDouble> fine_travel(const PlanePath& path);
// The radius at the start or the end to about 100 bits.
DoubleDouble fine_radius(const PlanePath& path, bool at_end);
// The sign of (radius at that end) - offset, exactly; offset >= 0.
int compare_radius(const PlanePath& path, bool at_end, const Count& offset);

}  // namespace toolcomp::fast
