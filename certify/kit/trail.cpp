// SPDX-License-Identifier: Apache-2.0
#include "certify/kit/trail.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "certify/convert.h"

namespace toolcomp::certify::kit {
namespace {

// Letters of the axes do not matter here: an arc lies in the two axes in which its centre has coordinates.
std::vector<std::size_t> plane_of(const spec::Arc<double>& arc) {
  std::vector<std::size_t> axes;
  for (std::size_t i = 0; i < spec::kMaxAxes; ++i)
    if (arc.center.has(i)) axes.push_back(i);
  return axes;
}

}  // namespace

Trail::Trail(std::span<const model::Event> events, double tolerance) : tolerance_(tolerance) {
  constexpr int kParts = 8;
  for (const model::Event& exact : events) {
    const spec::Event<double> event = certify::in_double(exact);
    if (event.hole && event.axes.has(event.hole->axis)) {
      Point bottom = event.axes;
      bottom.value[event.hole->axis] += event.hole->bottom - event.hole->level;
      add(bottom);
      add(event.axes);
    }
    if (event.kind != spec::EventKind::move && event.kind != spec::EventKind::sample) continue;
    if (event.arc && !corners_.empty() && event.arc->sweep) {
      // Turning between both ends about the centre is enough to tell ways apart: the ends are those of the arc.
      const std::vector<std::size_t> plane = plane_of(*event.arc);
      const bool ccw = event.arc->direction == spec::ArcDirection::ccw;
      const double back = (ccw ? -1 : 1) * *event.arc->sweep * std::numbers::pi / 180;
      for (int k = 1; k < kParts && plane.size() == 2; ++k) {
        Point point = event.axes;
        const double turn = back * (kParts - k) / kParts;
        const double u = event.point[plane[0]] - event.arc->center[plane[0]];
        const double v = event.point[plane[1]] - event.arc->center[plane[1]];
        // The sense of a plane is another where its axes stand in another order; both runs have the same.
        point.value[plane[0]] += u * std::cos(turn) - v * std::sin(turn) - u;
        point.value[plane[1]] += u * std::sin(turn) + v * std::cos(turn) - v;
        add(point);
      }
    }
    add(event.axes);
  }
}

void Trail::add(const Point& point) {
  if (!corners_.empty() && near(corners_.back(), point, tolerance_)) return;
  if (corners_.size() >= 2 && on_the_way(corners_[corners_.size() - 2], corners_.back(), point)) corners_.pop_back();
  corners_.push_back(point);
}

bool Trail::near(const Point& a, const Point& b, double distance) const {
  for (std::size_t i = 0; i < spec::kMaxAxes; ++i)
    if (a.has(i) && b.has(i) && std::abs(a[i] - b[i]) > distance) return false;
  return true;
}

bool Trail::on_the_way(const Point& a, const Point& b, const Point& c) const {
  double along = 0;
  double length = 0;
  for (std::size_t i = 0; i < spec::kMaxAxes; ++i) {
    if (!a.has(i) || !b.has(i) || !c.has(i)) continue;
    along += (b[i] - a[i]) * (c[i] - a[i]);
    length += (c[i] - a[i]) * (c[i] - a[i]);
  }
  if (length <= 0 || along < 0 || along > length) return false;
  for (std::size_t i = 0; i < spec::kMaxAxes; ++i)
    if (a.has(i) && c.has(i) && std::abs(a[i] + (c[i] - a[i]) * along / length - b[i]) > tolerance_) return false;
  return true;
}

bool Trail::differs(const Trail& other) const {
  if (corners_.size() != other.corners_.size()) return true;
  return !std::ranges::equal(corners_, other.corners_,
                             [this](const Point& a, const Point& b) { return near(a, b, 2 * tolerance_); });
}

}  // namespace toolcomp::certify::kit
