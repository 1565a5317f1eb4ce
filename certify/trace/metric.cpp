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

Box::Box() {
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
}

void Box::add(const AxisPoint& p) {
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

Limit Metric::limit(const Distance& error, double magnitude) const {
  // An offset of an axis carries up to six roundings of numbers up to 2 · magnitude, and six linear axes add up.
  constexpr double kRoundings = 64 * kEpsilon;
  const double linear = tolerance_.linear + error.linear;
  const double rotary = tolerance_.rotary + error.rotary;
  return {{linear + kRoundings * std::max(linear, magnitude), rotary + kRoundings * std::max(rotary, magnitude)},
          magnitude};
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
  if (height > limit.reach.linear) return std::nullopt;
  Part part;
  if (moves) {
    const double half = std::sqrt((limit.reach.linear - height) * (limit.reach.linear + height) / square);
    part = {std::max(0.0, foot - half), std::min(1.0, foot + half)};
  }
  for (const std::size_t axis : space_.rotary) {
    const double d = b[axis] - a[axis];
    const double off = p[axis] - a[axis];
    if (std::fabs(d) <= still) {
      if (std::fabs(off) > limit.reach.rotary) return std::nullopt;
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

double Metric::closest(const AxisPoint& a, const AxisPoint& b, const AxisPoint& p, const Part& within) const {
  const double foot_at = foot(a, b, p, within);
  if (space_.rotary.empty()) return foot_at;
  // The distance is convex along the line.
  Part between = within;
  constexpr int kThirds = 80;  // (2/3)^80 of the line is below a rounding
  for (int i = 0; i < kThirds && between.low < between.high; ++i) {
    const double third = (between.high - between.low) / 3;
    const bool left =
        in_tolerances(at(a, b, between.low + third, p)) <= in_tolerances(at(a, b, between.high - third, p));
    (left ? between.high : between.low) += left ? -third : third;
  }
  const double least_at = (between.low + between.high) / 2;
  const double least = in_tolerances(at(a, b, least_at, p));
  Limit limit{{least * tolerance_.linear, least * tolerance_.rotary}, std::max(magnitude(a), magnitude(b))};
  limit.reach.linear += kEpsilon * limit.magnitude;
  limit.reach.rotary += kEpsilon * limit.magnitude;
  const auto part = part_near(a, b, p, limit);
  if (!part) return least_at;
  const double low = std::max(part->low, within.low);
  const double high = std::min(part->high, within.high);
  return low <= high ? std::clamp(foot_at, low, high) : least_at;
}

Distance Metric::outside(const Box& box, const AxisPoint& p) const {
  const auto off = [&](std::size_t axis) { return std::max({0.0, box.low[axis] - p[axis], p[axis] - box.high[axis]}); };
  double square = 0;
  for (const std::size_t axis : space_.linear) square += off(axis) * off(axis);
  Distance distance{std::sqrt(square), 0};
  for (const std::size_t axis : space_.rotary) distance.rotary = std::max(distance.rotary, off(axis));
  return distance;
}

double Metric::in_tolerances(const Distance& d) const {
  return std::max(d.linear / tolerance_.linear, d.rotary / tolerance_.rotary);
}

std::optional<std::size_t> Metric::turned(const AxisPoint& a, const AxisPoint& b) const {
  std::optional<std::size_t> most;
  for (const std::size_t axis : space_.rotary)
    if (a[axis] != b[axis] && (!most || std::fabs(a[axis] - b[axis]) > std::fabs(a[*most] - b[*most]))) most = axis;
  return most;
}

}  // namespace toolcomp::certify
