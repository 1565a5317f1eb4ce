// SPDX-License-Identifier: Apache-2.0
// Contours for cutter compensation that every control can follow, because they have only inside corners.
#pragma once

#include <cstdint>
#include <vector>

#include "fuzz/gen/choices.h"

namespace toolcomp::certify {

// A point in the plane, in thousandths of a millimetre: the first axis of the plane, and the second.
struct Point {
  std::int64_t u = 0;
  std::int64_t v = 0;
};

struct Leg {
  Point end;
  std::int64_t radius = 0;  // of an arc of less than half a turn; 0: a line
  bool ccw = false;
};

// Approach and retract are exactly in line with the first and the last leg, which are lines.
struct Contour {
  Point approach;
  Point start;
  std::vector<Leg> legs;
  Point retract;
};

// Every corner turns left, so that it is an inside corner for a cutter on the left. Legs are long enough, and arcs wide
// enough, for a cutter of this radius (in thousandths of a millimetre, up to 5 mm).
Contour inside_contour(fuzz::Choices& choose, std::int64_t radius);

}  // namespace toolcomp::certify
