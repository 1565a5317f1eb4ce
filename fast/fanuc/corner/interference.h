// SPDX-License-Identifier: Apache-2.0
// The interference check of a path between the vectors at its two ends, and the removal of vectors (chapter 14.6.5).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "fast/geometry/path.h"

namespace toolcomp::fast {

enum class Interference : std::uint8_t {
  none,
  straightened,  // an arc that lost a vector: a straight move
  alarm,         // PS0041
};

// What parameters change of the check.
struct InterferenceParameters {
  bool keeps_vectors = false;       // none is dropped: the first pair that interferes is the last one
  bool no_direction_alarm = false;  // a way against the programmed one is run all the same
};

// Angles of the tool's arc that are equal in truth differ by a few roundings.
constexpr double kEqualAngle = 0x1p-40;

// Of an arc: the signs of the radii of the offset circles at its ends, and the sweep of the tool's own arc.
inline bool arc_interferes(const PlanePath& path, int start_sign, int end_sign, const std::optional<double>& sweep) {
  if (start_sign < 0 || end_sign < 0) return true;
  if (start_sign == 0 || end_sign == 0 || !sweep) return false;
  // Both up to 180 degrees, or both over it, never differ by more.
  if ((*sweep > 180) == path.over_half) return false;
  return std::abs(*sweep - programmed_sweep(path)) > 180 + kEqualAngle;
}

// The pairs of vectors around a path, from the inside out: the last of `start` with the first of `end`, and on. A pair
// that interferes is dropped, but not the last vector of a group. Where all interfere the answer is an alarm, and none
// is dropped. Of an arc only the first pair is tested as one, by arc_interferes(); else line_interferes(v, w) tests the
// way from vector v of `start` to w of `end`.
template <class Group, class ArcTest, class LineTest>
Interference check_pairs(bool arc, Group& start, Group& end, const ArcTest& arc_interferes,
                         const LineTest& line_interferes, const InterferenceParameters& parameters = {}) {
  const std::size_t last = start.size - 1U;
  if (!(arc ? arc_interferes() : line_interferes(last, 0))) [[likely]]
    return Interference::none;
  const std::size_t pairs = parameters.keeps_vectors ? 1 : std::max(start.size, end.size);
  for (std::size_t q = 1; q < pairs; ++q) {
    const std::size_t from_start = std::min(q, last);
    const std::size_t from_end = std::min<std::size_t>(q, end.size - 1U);
    if (line_interferes(last - from_start, from_end)) continue;
    start.drop_last(from_start);
    end.drop_first(from_end);
    return arc ? Interference::straightened : Interference::none;
  }
  if (!parameters.no_direction_alarm || (arc && pairs == 1)) return Interference::alarm;
  if (pairs == 1) return Interference::none;
  start.drop_last(last);
  end.drop_first(end.size - 1U);
  return arc ? Interference::straightened : Interference::none;
}

}  // namespace toolcomp::fast
