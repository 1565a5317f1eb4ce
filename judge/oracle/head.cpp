// SPDX-License-Identifier: Apache-2.0
#include "judge/oracle/head.h"

#include <algorithm>
#include <cmath>

#include "judge/oracle/policy.h"

namespace toolcomp::judge {

double length(const Flat& a) { return std::hypot(a[0], a[1]); }

std::array<std::optional<HeadCondition>, 2> head_conditions(const FlatPiece& piece, const Flat& corner,
                                                            const Flat& vector) {
  std::array<std::optional<HeadCondition>, 2> found;
  const Flat out = piece.center ? corner - *piece.center : left_of(piece.way);
  const double radius = length(out);
  if (radius == 0) return found;
  const Flat normal = {out[0] / radius, out[1] / radius};
  HeadCondition& tangent = found[0].emplace();
  tangent.normal = normal;
  tangent.distance = std::fabs(dot(vector, normal));
  tangent.slide = std::fabs(cross(vector, normal));
  tangent.size = length(vector);
  tangent.weight = piece.weight;
  if (!piece.center) return found;
  const Flat head = out + vector;
  const double reach = length(head);
  if (reach == 0) return found;
  HeadCondition& circle = found[1].emplace();
  circle.normal = {head[0] / reach, head[1] / reach};
  circle.distance = std::fabs(reach - radius);
  circle.slide = tangent.slide;
  circle.error = circle.size = reach + radius;
  circle.weight = piece.weight;
  circle.reach = reach;
  return found;
}

HeadBand band_of(const HeadCondition& condition, const Space& normal) {
  return {normal, condition.off(), condition.reach > 0 ? 1 / condition.reach : 0};
}

double alone(const HeadCondition& a, double length) {
  const double noise = std::max(policy::kSlack, policy::kEstimateNoise * a.weight) * length;
  const bool fits = a.error == 0 && (a.slide <= noise || std::fabs(a.slide - a.distance) <= noise);
  return fits ? a.weight * length : 0;
}

double crossing(const HeadCondition& a, const HeadCondition& b, double length) {
  const double size = a.size + b.size;
  // Directions of this weight are no better known here.
  const double noise = policy::kEstimateNoise * std::max(a.weight, b.weight);
  if (std::fabs(a.distance - b.distance) > std::max(policy::kSlack, noise) * size) return 0;
  // On a perpendicular of both paths: made of one direction.
  if (std::max(a.slide, b.slide) <= noise * size) return 0;
  const double sine = std::fabs(cross(a.normal, b.normal));
  if (sine < policy::kParallel) return 0;
  const bool circles = a.error > 0 || b.error > 0;
  return (a.off() + b.off() + (circles ? length : 0)) / sine;
}

}  // namespace toolcomp::judge
