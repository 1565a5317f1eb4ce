// SPDX-License-Identifier: Apache-2.0
// The way of a run, for telling two runs apart.
#pragma once

#include <span>
#include <vector>

#include "model/basis/event.h"
#include "spec/language/axes.h"

namespace toolcomp::certify::kit {

// The corners of the way of the axes, arcs in eight parts; nothing stands twice in a row, and no corner on the straight
// line between those beside it, but for `tolerance`.
class Trail {
 public:
  Trail(std::span<const model::Event> events, double tolerance);

  // Whether a recording judged with the tolerance agrees with one way alone: they have different corners, or one that
  // is more than two tolerances away.
  [[nodiscard]] bool differs(const Trail& other) const;

 private:
  using Point = spec::AxisValues<double>;
  void add(const Point& point);
  [[nodiscard]] bool near(const Point& a, const Point& b, double distance) const;
  [[nodiscard]] bool on_the_way(const Point& a, const Point& b, const Point& c) const;

  double tolerance_;
  std::vector<Point> corners_;
};

}  // namespace toolcomp::certify::kit
