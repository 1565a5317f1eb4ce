// SPDX-License-Identifier: Apache-2.0
// Arcs G02 G03 in the selected plane: centre, sweep, radii.
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "fast/arithmetic/count.h"
#include "fast/arithmetic/double_double.h"
#include "fast/basis/alarm.h"

namespace toolcomp::fast {

struct ArcGeometry {
  std::array<double, 2> center{};                   // absolute, setup units
  std::optional<double> sweep;                      // degrees, in (0, 360]; none where the end lies in the centre
  std::optional<std::pair<double, double>> radius;  // start and end, where they differ
};

// The words of an arc, exactly.
struct ArcWords {
  bool clockwise = false;
  bool by_radius = false;
  std::array<Count, 2> to_center{};  // I J K of the plane, where !by_radius
  Count radius;                      // R, where by_radius
};

// The centre from the start, in units of 1 / (127 * 10^18): exact with I J K, with R within 2^-100 of the chord or R.
// Only for arcs that are.
std::array<DoubleDouble, 2> fine_center(const std::array<Count, 2>& start, const std::array<Count, 2>& end,
                                        const ArcWords& words);

// The polar angle of (x, y), not both zero, in degrees within (0, 360]: exact at multiples of 90, elsewhere rounded
// from about 100 bits. With x = a . b and y = a x b it is the sweep from a to b counterclockwise.
double positive_angle(const DoubleDouble& x, const DoubleDouble& y);

// The alarms of the two functions below and the centre in doubles (by radius: within a few ulp of the radius and the
// coordinates), without sweep and radii.
Alarm center_by_any_center(const std::array<Count, 2>& start, const std::array<Count, 2>& to_center,
                           std::array<double, 2>& center);
inline Alarm center_by_center(const std::array<Count, 2>& start, const std::array<Count, 2>& to_center,
                              std::array<double, 2>& center) {
  const std::int64_t x = start[0].small() + to_center[0].small();
  const std::int64_t y = start[1].small() + to_center[1].small();
  const bool small = start[0].is_small() && start[1].is_small() && to_center[0].is_small() && to_center[1].is_small();
  const bool zero = to_center[0].small() == 0 && to_center[1].small() == 0;
  if (!small || zero || !Count::is_small(x) || !Count::is_small(y)) [[unlikely]]
    return center_by_any_center(start, to_center, center);
  center[0] = Count::nearest_small(x);
  center[1] = Count::nearest_small(y);
  return AlarmCause::none;
}
Alarm center_by_radius(const std::array<Count, 2>& start, const std::array<Count, 2>& end, const Count& radius,
                       bool clockwise, std::array<double, 2>& center);

// The alarm where the distances of start and end from start + `to_center` differ by more than `most`, which is not 0.
Alarm check_radii(const std::array<Count, 2>& start, const std::array<Count, 2>& end,
                  const std::array<Count, 2>& to_center, const Count& most);

// The arc from `start` to `end` round start + `to_center`; the alarm where `to_center` is zero.
Alarm arc_by_center(const std::array<Count, 2>& start, const std::array<Count, 2>& end,
                    const std::array<Count, 2>& to_center, bool clockwise, ArcGeometry& arc);

// The arc from `start` to `end` of the given radius: at most 180 degrees if it is positive, the larger one if negative.
// The alarm where there is none; start and end differ.
Alarm arc_by_radius(const std::array<Count, 2>& start, const std::array<Count, 2>& end, const Count& radius,
                    bool clockwise, ArcGeometry& arc);

}  // namespace toolcomp::fast
