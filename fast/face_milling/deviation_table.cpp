#include "fast/face_milling/deviation_table.h"

#include <algorithm>
#include <cmath>

#include "fast/fault.h"

namespace toolcomp::fast::klartext {

DeviationTable::DeviationTable(const spec::DeviationTable& points) : points_(points), point_(points.size()) {
  for (std::size_t i = 0; i < point_.size(); ++i) {
    point_[i].angle = Count::of(points_[i].first);
    point_[i].degrees = point_[i].angle.nearest();
  }
  set_units(Factor::one);
}

void DeviationTable::set_units(Factor factor) {
  for (std::size_t i = 0; i < point_.size(); ++i) {
    point_[i].deviation = Count::of(points_[i].second, factor);
    point_[i].value = point_[i].deviation.nearest();
  }
}

std::size_t DeviationTable::segment(double degrees) const {
  const auto above = std::ranges::upper_bound(point_, degrees, {}, &Point::degrees);
  const auto index = static_cast<std::size_t>(above - point_.begin());
  return std::clamp<std::size_t>(index, 1, point_.size() - 1) - 1;
}

bool DeviationTable::find(const ContactAngle& angle, double& deviation) const {
  const Point& first = point_.front();
  const Point& last = point_.back();
  if (angle.compare(first.angle, first.degrees) < 0 || angle.compare(last.angle, last.degrees) > 0) return false;
  if (point_.size() == 1) {
    deviation = first.value;
    return true;
  }
  const std::size_t index = segment(angle.degrees());
  const Point& a = point_[index];
  const Point& b = point_[index + 1];
  if (fault(Fault::face_deviation_steps)) {
    deviation = a.value;
    return true;
  }
  deviation = a.value + (b.value - a.value) * ((angle.degrees() - a.degrees) / (b.degrees - a.degrees));
  return true;
}

bool DeviationTable::below(const Count& corner, const ContactAngle& angle, double deviation) const {
  if (point_.size() == 1) return corner + point_.front().deviation < Count{};
  const std::size_t index = segment(angle.degrees());
  const Point& a = point_[index];
  const Point& b = point_[index + 1];
  const double sum = corner.nearest() + deviation;
  const double slope = std::abs(b.value - a.value) / (b.degrees - a.degrees);
  const double bound =
      2 * ContactAngle::kError * slope + 0x1p-48 * (std::abs(corner.nearest()) + std::abs(a.value) + std::abs(b.value));
  if (sum > bound) return false;
  if (sum < -bound) return true;
  // (corner + v0)(b1 − b0) + (v1 − v0)(theta − b0) < 0.
  const Int128 rise = b.deviation.units() - a.deviation.units();
  const Wide exact = Wide((corner + a.deviation).units()) * Wide(b.angle.units() - a.angle.units()) +
                     Wide(rise) * Wide(angle.fine().units() - a.angle.units());
  const Wide slack = Wide(rise < 0 ? -rise : rise) * Wide(ContactAngle::kFineUnits);
  return (exact + slack).sign() < 0;
}

}  // namespace toolcomp::fast::klartext
