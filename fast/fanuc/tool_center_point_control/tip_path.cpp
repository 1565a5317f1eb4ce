// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_center_point_control/tip_path.h"

#include <cmath>
#include <numbers>

namespace toolcomp::fast {

TipPath::TipPath(const Vector3<double>& start, const Vector3<double>& end, const spec::Arc<double>& arc,
                 const std::array<std::size_t, 3>& xyz)
    : start_(start), way_(end - start), arc_(arc.sweep.has_value()) {
  if (!arc_) return;
  const std::size_t first = arc.plane == spec::Plane::xy ? 0 : (arc.plane == spec::Plane::zx ? 2 : 1);
  for (std::size_t i = 0; i < 2; ++i) {
    in_[i] = (first + i) % 3;
    if (xyz[in_[i]] != spec::Axes::kNone) center_[i] = arc.center[xyz[in_[i]]];
  }
  sweep_ = *arc.sweep * (std::numbers::pi / 180);
  if (arc.direction == spec::ArcDirection::cw) sweep_ = -sweep_;
  if (arc.radius) {
    from_end_ = arc.radius->second > arc.radius->first;
    growth_ = (arc.radius->second - arc.radius->first) / (from_end_ ? arc.radius->second : arc.radius->first);
  }
  const Vector3<double>& known = from_end_ ? end : start;
  for (std::size_t i = 0; i < 2; ++i) radial_[i] = known[in_[i]] - center_[i];
}

Vector3<double> TipPath::on_arc(double t) const {
  std::array<double, 3> point{};
  for (std::size_t i = 0; i < 3; ++i) point[i] = start_[i] + t * way_[i];
  const double part = from_end_ ? t - 1 : t;
  const double scale = 1 + part * growth_;
  const double sine = scale * std::sin(part * sweep_);
  const double cosine = scale * std::cos(part * sweep_);
  point[in_[0]] = center_[0] + (cosine * radial_[0] - sine * radial_[1]);
  point[in_[1]] = center_[1] + (sine * radial_[0] + cosine * radial_[1]);
  return {point[0], point[1], point[2]};
}

}  // namespace toolcomp::fast
