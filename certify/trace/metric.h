// SPDX-License-Identifier: Apache-2.0
// How far positions are from straight lines, and which parts of a line lie near a position.
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

// What is near: the linear axes within `reach.linear` of each other, each rotary axis within `reach.rotary`.
// `magnitude`: the largest coordinate compared, by which roundings are judged.
struct Limit {
  Distance reach;
  double magnitude = 0;
};

// The least box around positions; empty at first.
struct AxisBox {
  AxisPoint low;
  AxisPoint high;
  AxisBox();
  void add(const AxisPoint& p);
};

// Distances in the recorded axes. A length "in tolerances" is the larger of the linear one over the linear tolerance
// and the largest rotary one over the rotary tolerance: for comparing, never for reporting.
class Metric {
 public:
  // Both tolerances positive.
  Metric(TraceSpace space, Distance tolerance);
  [[nodiscard]] const TraceSpace& space() const { return space_; }
  [[nodiscard]] const Distance& tolerance() const { return tolerance_; }

  // The largest coordinate of a recorded axis.
  [[nodiscard]] double magnitude(const AxisPoint& p) const;
  // The tolerance and `error`, wider by what coordinates up to `magnitude` may have been rounded: a distance of exactly
  // the tolerance is accepted.
  [[nodiscard]] Limit limit(const Distance& error, double magnitude) const;
  // What a distance between positions of that magnitude may have been rounded.
  [[nodiscard]] static double rounding(double magnitude);
  [[nodiscard]] bool exceeds(const Distance& d, const Limit& limit) const {
    return !(d.linear <= limit.reach.linear && d.rotary <= limit.reach.rotary);  // what is no number exceeds
  }

  // The part of the line from `a` to `b` near `p`. Where the whole line moves less than coordinates are rounded, all of
  // it or nothing.
  [[nodiscard]] std::optional<Part> part_near(const AxisPoint& a, const AxisPoint& b, const AxisPoint& p,
                                              const Limit& limit) const;
  [[nodiscard]] Distance between(const AxisPoint& a, const AxisPoint& b) const;
  // From `p` to the point of the line at `t`.
  [[nodiscard]] Distance at(const AxisPoint& a, const AxisPoint& b, double t, const AxisPoint& p) const;
  // The parameter in [low, high] that is closest to `p` by the linear axes, by the rotary ones if no linear one moves.
  [[nodiscard]] double foot(const AxisPoint& a, const AxisPoint& b, const AxisPoint& p, const Part& within) const;
  // The parameter that is closest in tolerances; of several the one closest by the linear axes.
  [[nodiscard]] double closest(const AxisPoint& a, const AxisPoint& b, const AxisPoint& p, const Part& within) const;
  // No point of that part of the line is closer, in tolerances.
  [[nodiscard]] double at_least(const AxisPoint& a, const AxisPoint& b, const AxisPoint& p, const Part& within) const;
  // No point of the box is closer to `p`.
  [[nodiscard]] Distance outside(const AxisBox& box, const AxisPoint& p) const;

  [[nodiscard]] double in_tolerances(const Distance& d) const;
  // The same with the axes of one kind only.
  [[nodiscard]] Metric linear_only() const { return {{space_.linear, {}}, tolerance_}; }
  [[nodiscard]] Metric rotary_only() const { return {{{}, space_.rotary}, tolerance_}; }
  [[nodiscard]] bool mixed() const { return !space_.linear.empty() && !space_.rotary.empty(); }
  // The rotary axis on which the two positions differ most; none where they do not differ.
  [[nodiscard]] std::optional<std::size_t> turned(const AxisPoint& a, const AxisPoint& b) const;

 private:
  TraceSpace space_;
  Distance tolerance_;
};

// The point of the line at `t`, from the nearer end, so that the ends are met exactly.
AxisPoint point_at(const AxisPoint& a, const AxisPoint& b, double t);

}  // namespace toolcomp::certify
