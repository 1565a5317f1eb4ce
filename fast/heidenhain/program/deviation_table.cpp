// SPDX-License-Identifier: Apache-2.0
#include "fast/heidenhain/program/deviation_table.h"

#include <algorithm>
#include <cmath>

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
  for (std::size_t i = 0; i < point_.size(); ++i) {
    Point& a = point_[i];
    const Point& b = point_[std::min(i + 1, point_.size() - 1)];
    a.rate = &a == &b ? 0 : (b.value - a.value) / (b.degrees - a.degrees);
    a.bound = 2 * ContactAngle::kError * std::abs(a.rate) + kBound * (std::abs(a.value) + std::abs(b.value));
  }
}

std::size_t DeviationTable::segment(double degrees) const {
  const auto above = std::ranges::upper_bound(point_, degrees, {}, &Point::degrees);
  const auto index = static_cast<std::size_t>(above - point_.begin());
  return std::clamp<std::size_t>(index, 1, point_.size() - 1) - 1;
}

bool DeviationTable::find_anew(const ContactAngle& angle, Deviation& deviation) const {
  const Point& first = point_.front();
  const Point& last = point_.back();
  if (angle.compare(first.angle, first.degrees) < 0 || angle.compare(last.angle, last.degrees) > 0) return false;
  deviation.segment = point_.size() == 1 ? 0 : segment(angle.degrees());
  deviation.value = point_[deviation.segment].value_at(angle.degrees());
  return true;
}

bool DeviationTable::exactly_below(const Count& corner, const ContactAngle& angle, std::size_t segment) const {
  const Point& a = point_[segment];
  if (point_.size() == 1) return corner + a.deviation < Count{};
  const Point& b = point_[segment + 1];
  // (corner + v0)(b1 − b0) + (v1 − v0)(theta − b0) < 0.
  const Int128 rise = b.deviation.units() - a.deviation.units();
  const Wide exact = Wide((corner + a.deviation).units()) * Wide(b.angle.units() - a.angle.units()) +
                     Wide(rise) * Wide(angle.fine().units() - a.angle.units());
  const Wide slack = Wide(rise < 0 ? -rise : rise) * Wide(ContactAngle::kFineUnits);
  return (exact + slack).sign() < 0;
}

}  // namespace toolcomp::fast::klartext
