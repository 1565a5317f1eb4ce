// SPDX-License-Identifier: Apache-2.0
#include "judge/oracle/radius_arc.h"

#include <cmath>

#include "judge/oracle/policy.h"

namespace toolcomp::judge {

// The ulp of a number is half an ulp of 1 of it at least.
double RadiusArc::weight() const { return 1 + turned / (policy::ulp(1) / 2); }

RadiusArc radius_arc(const model::Event& event, const Space& way, const Space& out, const Rounded& rounded) {
  if (!event.arc || !event.clauses.contains(policy::kByRadius)) return {};
  const auto& axes = kInPlane.at(static_cast<std::size_t>(event.arc->plane));
  const Flat chord = {way.at(axes[0]), way.at(axes[1])};
  const Flat to_end = {out.at(axes[0]), out.at(axes[1])};
  const double radius = length(to_end);
  const double from_start = length(to_end - chord);
  if (length(chord) == 0 || !(std::fabs(from_start - radius) <= policy::kSameStart * radius)) return {};
  const double height = std::fabs(cross(chord, to_end)) / length(chord);
  RadiusArc arc;
  arc.center = policy::height_error(radius, height, policy::ulp(std::fmax(rounded.position, radius)), rounded.k);
  arc.turned = arc.center / radius;
  arc.hardly = rounded.k * arc.center > policy::kHardly * std::fmin(radius, 1);
  return arc;
}

}  // namespace toolcomp::judge
