#include "fast/tool_center_point_control/tip_path.h"

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
  if (arc.radius) growth_ = (arc.radius->second - arc.radius->first) / arc.radius->first;
}

Vector3<double> TipPath::on_arc(double t) const {
  std::array<double, 3> point{};
  for (std::size_t i = 0; i < 3; ++i) point[i] = start_[i] + t * way_[i];
  const double scale = 1 + t * growth_;
  const double sine = scale * std::sin(t * sweep_);
  const double cosine = scale * std::cos(t * sweep_);
  const double x = start_[in_[0]] - center_[0];
  const double y = start_[in_[1]] - center_[1];
  point[in_[0]] = center_[0] + (cosine * x - sine * y);
  point[in_[1]] = center_[1] + (sine * x + cosine * y);
  return {point[0], point[1], point[2]};
}

}  // namespace toolcomp::fast
