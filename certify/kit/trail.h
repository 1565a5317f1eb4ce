// SPDX-License-Identifier: Apache-2.0
// The path of a run, for distinguishing two runs.
#pragma once

#include <span>
#include <vector>

#include "model/basis/event.h"
#include "spec/language/axes.h"

namespace toolcomp::certify::kit {

// The corners of the path of the axes, with arcs in eight parts. No corner comes twice in a row, and no corner is on
// the straight line between its neighbours, within `tolerance`.
class Trail {
 public:
  Trail(std::span<const model::Event> events, double tolerance);

  // Whether a recording judged with the tolerance can agree with only one of the two paths: they have different
  // corners, or a corner of one is more than two tolerances away from the other.
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
