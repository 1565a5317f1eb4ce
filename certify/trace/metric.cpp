// SPDX-License-Identifier: Apache-2.0
#include "certify/trace/metric.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace toolcomp::certify {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

double off_at(double a, double b, double t, double p) {
  return t <= 0.5 ? p - a - t * (b - a) : p - b + (1 - t) * (b - a);
}

}  // namespace

AxisBox::AxisBox() {
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
}

void AxisBox::add(const AxisPoint& p) {
  for (std::size_t axis = 0; axis < p.size(); ++axis) {
    low[axis] = std::min(low[axis], p[axis]);
    high[axis] = std::max(high[axis], p[axis]);
  }
}

AxisPoint point_at(const AxisPoint& a, const AxisPoint& b, double t) {
  AxisPoint p;
  for (std::size_t axis = 0; axis < p.size(); ++axis)
    p[axis] = t <= 0.5 ? a[axis] + t * (b[axis] - a[axis]) : b[axis] - (1 - t) * (b[axis] - a[axis]);
  return p;
}

Metric::Metric(TraceSpace space, Distance tolerance) : space_(std::move(space)), tolerance_(tolerance) {}

double Metric::magnitude(const AxisPoint& p) const {
  double most = 0;
  for (const std::size_t axis : space_.linear) most = std::max(most, std::fabs(p[axis]));
  for (const std::size_t axis : space_.rotary) most = std::max(most, std::fabs(p[axis]));
  return most;
}

double Metric::rounding(double magnitude) {
  // An offset of an axis carries up to six roundings of numbers up to 2 · magnitude, and six linear axes add up.
  constexpr double kRoundings = 64 * kEpsilon;
  return kRoundings * magnitude;
}

Limit Metric::limit(const Distance& error, double magnitude) const {
  const double linear = tolerance_.linear + error.linear;
  const double rotary = tolerance_.rotary + error.rotary;
  // What is no length grants nothing.
  const auto reach = [magnitude](double tolerance) {
    const double most = tolerance + rounding(std::max(tolerance, magnitude));
    return std::isfinite(most) ? most : -1;
  };
  return {{reach(linear), reach(rotary)}, magnitude};
}

std::optional<Part> Metric::part_near(const AxisPoint& a, const AxisPoint& b, const AxisPoint& p,
                                      const Limit& limit) const {
  const double still = kEpsilon * limit.magnitude;
  double square = 0;
  double along = 0;
  for (const std::size_t axis : space_.linear) {
    const double d = b[axis] - a[axis];
    square += d * d;
    along += d * (p[axis] - a[axis]);
  }
  const bool moves = square > still * still;
  const double foot = moves ? along / square : 0;
  double height = 0;
  for (const std::size_t axis : space_.linear) {
    const double off = moves ? off_at(a[axis], b[axis], foot, p[axis]) : p[axis] - a[axis];
    height += off * off;
  }
  height = std::sqrt(height);
  // Every comparison here refuses what is no number.
  if (!(height <= limit.reach.linear)) return std::nullopt;
  Part part;
  if (moves) {
    const double half = std::sqrt((limit.reach.linear - height) * (limit.reach.linear + height) / square);
    if (!std::isfinite(foot) || !std::isfinite(half)) return std::nullopt;
    part = {std::max(0.0, foot - half), std::min(1.0, foot + half)};
  }
  for (const std::size_t axis : space_.rotary) {
    const double d = b[axis] - a[axis];
    const double off = p[axis] - a[axis];
    if (!std::isfinite(d) || !std::isfinite(off)) return std::nullopt;
    if (std::fabs(d) <= still) {
      if (!(std::fabs(off) <= limit.reach.rotary)) return std::nullopt;
      continue;
    }
    const auto [from, to] = std::minmax({(off - limit.reach.rotary) / d, (off + limit.reach.rotary) / d});
    part = {std::max(part.low, from), std::min(part.high, to)};
  }
  if (!(part.low <= part.high)) return std::nullopt;
  return part;
}

Distance Metric::between(const AxisPoint& a, const AxisPoint& b) const { return at(a, a, 0, b); }

Distance Metric::at(const AxisPoint& a, const AxisPoint& b, double t, const AxisPoint& p) const {
  double square = 0;
  for (const std::size_t axis : space_.linear) {
    const double off = off_at(a[axis], b[axis], t, p[axis]);
    square += off * off;
  }
  Distance distance{std::sqrt(square), 0};
  for (const std::size_t axis : space_.rotary)
    distance.rotary = std::max(distance.rotary, std::fabs(off_at(a[axis], b[axis], t, p[axis])));
  return distance;
}

double Metric::foot(const AxisPoint& a, const AxisPoint& b, const AxisPoint& p, const Part& within) const {
  for (const auto* axes : {&space_.linear, &space_.rotary}) {
    double along = 0;
    double square = 0;
    for (const std::size_t axis : *axes) {
      const double d = b[axis] - a[axis];
      along += d * (p[axis] - a[axis]);
      square += d * d;
    }
    if (square > 0) return std::clamp(along / square, within.low, within.high);
  }
  return within.low;
}

double Metric::at_least(const AxisPoint& a, const AxisPoint& b, const AxisPoint& p, const Part& within) const {
  double least = 0;
  if (!space_.linear.empty()) {
    const double t = foot(a, b, p, within);
    double square = 0;
    for (const std::size_t axis : space_.linear) {
      const double off = off_at(a[axis], b[axis], t, p[axis]);
      square += off * off;
    }
    least = std::sqrt(square) / tolerance_.linear;
  }
  for (const std::size_t axis : space_.rotary) {
    const double low = off_at(a[axis], b[axis], within.low, p[axis]);
    const double high = off_at(a[axis], b[axis], within.high, p[axis]);
    if (low < 0 ? high < 0 : high > 0 && low > 0)
      least = std::max(least, std::min(std::fabs(low), std::fabs(high)) / tolerance_.rotary);
  }
  return least;
}

double Metric::closest(const AxisPoint& a, const AxisPoint& b, const AxisPoint& p, const Part& within) const {
  const double foot_at = foot(a, b, p, within);
  if (space_.rotary.empty()) return foot_at;
  // The least distance, between what it is at least and what it is at the foot: within how much is any part near?
  double low = at_least(a, b, p, within);
  double high = in_tolerances(at(a, b, foot_at, p));
  const double magnitude_here = std::max({magnitude(a), magnitude(b), magnitude(p)});
  double best = foot_at;
  constexpr int kHalvings = 40;
  for (int i = 0; i < kHalvings && high - low > kEpsilon * magnitude_here; ++i) {
    const double middle = (low + high) / 2;
    const Limit limit{{middle * tolerance_.linear, middle * tolerance_.rotary}, magnitude_here};
    const auto part = part_near(a, b, p, limit);
    const double from = part ? std::max(part->low, within.low) : 1;
    const double to = part ? std::min(part->high, within.high) : 0;
    (from <= to ? high : low) = middle;
    if (from <= to) best = std::clamp(foot_at, from, to);
  }
  return best;
}

Distance Metric::outside(const AxisBox& box, const AxisPoint& p) const {
  const auto off = [&](std::size_t axis) {
    if (p[axis] >= box.low[axis] && p[axis] <= box.high[axis]) return 0.0;
    if (p[axis] < box.low[axis]) return box.low[axis] - p[axis];
    return p[axis] > box.high[axis] ? p[axis] - box.high[axis] : std::numeric_limits<double>::infinity();
  };
  double square = 0;
  for (const std::size_t axis : space_.linear) square += off(axis) * off(axis);
  Distance distance{std::sqrt(square), 0};
  for (const std::size_t axis : space_.rotary) distance.rotary = std::max(distance.rotary, off(axis));
  return distance;
}

double Metric::in_tolerances(const Distance& d) const { return certify::in_tolerances(d, tolerance_); }

std::optional<std::size_t> Metric::turned(const AxisPoint& a, const AxisPoint& b) const {
  std::optional<std::size_t> most;
  for (const std::size_t axis : space_.rotary)
    if (a[axis] != b[axis] && (!most || std::fabs(a[axis] - b[axis]) > std::fabs(a[*most] - b[*most]))) most = axis;
  return most;
}

}  // namespace toolcomp::certify
