// SPDX-License-Identifier: Apache-2.0
#include "judge/oracle/arc_fit.h"

#include <cmath>

#include "judge/oracle/head.h"
#include "judge/oracle/number.h"
#include "judge/oracle/policy.h"

namespace toolcomp::judge {
namespace {

using exact::Real;
using exact::Sign;

// In the plane of an arc, from its centre.
struct Ray {
  Real u;
  Real v;
};

// How far `to` is turned from `from` counterclockwise, in degrees; nothing for a right angle and more.
std::optional<Real> turned(const Ray& from, const Ray& to) {
  const Real cosine = from.u * to.u + from.v * to.v;
  if (cosine.sign() != Sign::positive) return std::nullopt;
  return arctangent_degrees((from.u * to.v - from.v * to.u) / cosine);
}

Real length(const Ray& ray) { return sqrt(square(ray.u) + square(ray.v)); }

// Whether the arc runs from one to the other, to a millionth: behind a change of the workpiece system the head before
// it is called otherwise.
bool runs(const spec::Arc<Real>& arc, const Ray& start, const Ray& end) {
  const auto size = [](const Ray& ray) { return std::hypot(approximate(ray.u), approximate(ray.v)); };
  const double first = arc.radius ? approximate(arc.radius->first) : size(end);
  if (!(std::fabs(size(start) - first) <= policy::kSameStart * first)) return false;
  if (!arc.sweep) return true;
  constexpr double degrees = 57.29577951308232;  // in a radian
  const auto angle = [](const Ray& ray) { return degrees * std::atan2(approximate(ray.v), approximate(ray.u)); };
  const double swept = arc.direction == spec::ArcDirection::ccw ? angle(end) - angle(start) : angle(start) - angle(end);
  return std::fabs(std::remainder(swept - approximate(*arc.sweep), 360)) <= policy::kSameStart;
}

}  // namespace

std::optional<spec::Arc<Real>> fitted(const spec::Arc<Real>& arc, const ArcEnd& start, const ArcEnd& end,
                                      const std::array<std::size_t, 3>& index) {
  const auto& axes = kInPlane.at(static_cast<std::size_t>(arc.plane));
  const auto ray = [&](const model::Vector& point) {
    return Ray{model::component(point, axes.at(0)) - arc.center[index.at(axes.at(0))],
               model::component(point, axes.at(1)) - arc.center[index.at(axes.at(1))]};
  };
  spec::Arc<Real> own = arc;
  if (!runs(arc, ray(start.head), ray(end.head))) return std::nullopt;
  const Ray own_start = ray(start.head + start.off);
  const Ray own_end = ray(end.head + end.off);
  if (arc.radius) own.radius = {length(own_start), length(own_end)};
  if (!arc.sweep) return own;
  const auto at_start = turned(ray(start.head), own_start);
  const auto at_end = turned(ray(end.head), own_end);
  if (!at_start || !at_end) return std::nullopt;
  const Real more = *at_end - *at_start;
  own.sweep = arc.direction == spec::ArcDirection::ccw ? *arc.sweep + more : *arc.sweep - more;
  return own;
}

}  // namespace toolcomp::judge
