// SPDX-License-Identifier: Apache-2.0
// Distances of positions from straight lines, and the parts of a line that are near a position.
#pragma once

#include <cstddef>
#include <optional>

#include "certify/trace/space.h"

namespace toolcomp::certify {

// Parameters on a straight line, from 0 at its begin to 1 at its end.
struct Part {
  double low = 0;
  double high = 1;
};

// The limit of what counts as near: linear axes within `reach.linear` of each other, each rotary axis within
// `reach.rotary`. `magnitude` is the largest coordinate compared; it gives the size of roundings.
struct Limit {
  Distance reach;
  double magnitude = 0;
};

// The smallest box around positions. At first it is empty.
struct AxisBox {
  AxisPoint low;
  AxisPoint high;
  AxisBox();
  void add(const AxisPoint& p);
};

// Distances in the recorded axes. A length "in tolerances" is the larger of the linear one over the linear tolerance
// and the largest rotary one over the rotary tolerance: it is used for comparing, never for reporting.
class Metric {
 public:
  // Both tolerances positive.
  Metric(TraceSpace space, Distance tolerance);
  [[nodiscard]] const TraceSpace& space() const { return space_; }
  [[nodiscard]] const Distance& tolerance() const { return tolerance_; }

  // The largest coordinate of a recorded axis.
  [[nodiscard]] double magnitude(const AxisPoint& p) const;
  // The tolerance plus `error`, plus the possible rounding of coordinates up to `magnitude`, so that a distance of
  // exactly the tolerance is accepted.
  [[nodiscard]] Limit limit(const Distance& error, double magnitude) const;
  // The largest rounding of a distance between positions of this magnitude.
  [[nodiscard]] static double rounding(double magnitude);
  [[nodiscard]] bool exceeds(const Distance& d, const Limit& limit) const {
    return !(d.linear <= limit.reach.linear && d.rotary <= limit.reach.rotary);  // NaN exceeds the limit
  }

  // The part of the line from `a` to `b` near `p`. If the whole line is shorter than the rounding of coordinates, all
  // of it or nothing.
  [[nodiscard]] std::optional<Part> part_near(const AxisPoint& a, const AxisPoint& b, const AxisPoint& p,
                                              const Limit& limit) const;
  [[nodiscard]] Distance between(const AxisPoint& a, const AxisPoint& b) const;
  // From `p` to the point of the line at `t`.
  [[nodiscard]] Distance at(const AxisPoint& a, const AxisPoint& b, double t, const AxisPoint& p) const;
  // The parameter in [low, high] that is closest to `p` by the linear axes, by the rotary ones if no linear one moves.
  [[nodiscard]] double foot(const AxisPoint& a, const AxisPoint& b, const AxisPoint& p, const Part& within) const;
  // The parameter that is closest in tolerances; if there are several, the one that is closest by the linear axes.
  [[nodiscard]] double closest(const AxisPoint& a, const AxisPoint& b, const AxisPoint& p, const Part& within) const;
  // A lower bound of the distance of that part of the line, in tolerances.
  [[nodiscard]] double at_least(const AxisPoint& a, const AxisPoint& b, const AxisPoint& p, const Part& within) const;
  // The distance of `p` from the box: no point of the box is closer.
  [[nodiscard]] Distance outside(const AxisBox& box, const AxisPoint& p) const;

  [[nodiscard]] double in_tolerances(const Distance& d) const;
  // The same with the axes of one kind only.
  [[nodiscard]] Metric linear_only() const { return {{space_.linear, {}}, tolerance_}; }
  [[nodiscard]] Metric rotary_only() const { return {{{}, space_.rotary}, tolerance_}; }
  [[nodiscard]] bool mixed() const { return !space_.linear.empty() && !space_.rotary.empty(); }
  // The rotary axis in which the two positions differ most; std::nullopt if they do not differ.
  [[nodiscard]] std::optional<std::size_t> turned(const AxisPoint& a, const AxisPoint& b) const;

 private:
  TraceSpace space_;
  Distance tolerance_;
};

// The point of the line at `t`, from the nearer end, so that the ends are met exactly.
AxisPoint point_at(const AxisPoint& a, const AxisPoint& b, double t);

}  // namespace toolcomp::certify
