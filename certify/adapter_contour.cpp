// SPDX-License-Identifier: Apache-2.0
#include "certify/adapter_contour.h"

#include <cmath>
#include <numbers>

namespace toolcomp::certify {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kThousand = 1000;

// In [low, high], in hundredths.
double number(fuzz::Choices& choose, std::int64_t low, std::int64_t high) {
  return static_cast<double>(choose.between(low * 100, high * 100)) / 100;
}

Point polar(double angle, double length) {
  return {std::llround(std::cos(angle) * length * kThousand), std::llround(std::sin(angle) * length * kThousand)};
}

Point plus(const Point& a, const Point& b) { return {a.u + b.u, a.v + b.v}; }
Point minus(const Point& a, const Point& b) { return {a.u - b.u, a.v - b.v}; }

}  // namespace

Contour inside_contour(fuzz::Choices& choose, std::int64_t radius) {
  // A corner of 90 degrees takes a cutter's radius from either leg.
  const double least = 15 + 3 * static_cast<double>(radius) / kThousand;
  const auto length = [&] { return least + number(choose, 0, 20); };
  double heading = number(choose, 0, 359) * kDegree;
  Contour contour;
  contour.start = polar(number(choose, 0, 359) * kDegree, 20);
  const Point first = polar(heading, length());
  contour.approach = minus(contour.start, first);
  contour.legs.push_back({plus(contour.start, first), 0, false});
  const auto legs = choose.between(2, 5);
  for (std::int64_t i = 0; i < legs; ++i) {
    heading += number(choose, 15, 90) * kDegree;
    const bool last = i + 1 == legs;
    if (last || choose.chance(50)) {
      const Point line = polar(heading, length());
      contour.legs.push_back({plus(contour.legs.back().end, line), 0, false});
      if (last) contour.retract = plus(contour.legs.back().end, line);
      continue;
    }
    // The chord lies between the headings at both ends of the arc.
    const bool ccw = choose.chance(60);
    const double half = number(choose, 10, 30) * kDegree * (ccw ? 1 : -1);
    const double chord = length();
    Leg arc;
    arc.end = plus(contour.legs.back().end, polar(heading + half, chord));
    arc.radius = std::llround(chord / 2 / std::fabs(std::sin(half)) * kThousand);
    arc.ccw = ccw;
    contour.legs.push_back(arc);
    heading += 2 * half;
  }
  return contour;
}

}  // namespace toolcomp::certify
