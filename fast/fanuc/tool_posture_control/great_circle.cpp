// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_posture_control/great_circle.h"

#include <cmath>

namespace toolcomp::fast {

SineCosine<double> EvenAngle::afresh(std::uint32_t numerator, std::uint32_t denominator) {
  if (denominator != denominator_) {
    denominator_ = denominator;
    const double step = radians_ / denominator;
    const double half = std::sin(step / 2);
    sine_ = std::sin(step);
    versine_ = 2 * half * half;
  }
  const double angle = radians_ * (static_cast<double>(numerator) / denominator);
  return {std::sin(angle), std::cos(angle)};
}

Vector3<double> side_of(const Vector3<double>& s, const Vector3<double>& e, double& radians) {
  const Vector3<double> n = cross(s, e);
  const double length = std::sqrt(dot(n, n));
  radians = std::atan2(length, dot(s, e));
  return cross(n, s) * (1 / length);
}

Vector3<double> side_of(const Vector3<DoubleDouble>& s, const Vector3<DoubleDouble>& e, double& radians) {
  const Vector3<DoubleDouble> n = cross(s, e);
  const DoubleDouble length = sqrt(dot(n, n));
  radians = std::atan2(length.hi, dot(s, e).hi);
  return nearest(cross(n, s) * (DoubleDouble{1, 0} / length));
}

DirectionMotion::DirectionMotion(const Kinematics& kinematics, const Direction& start, const Direction& end) {
  const Vector3<double> s{start.unit[0], start.unit[1], start.unit[2]};
  const Vector3<double> e{end.unit[0], end.unit[1], end.unit[2]};
  circle_.start = s;
  double radians = 0;
  const Vector3<double> n = cross(s, e);
  if (dot(n, n) > kNearlyOpposite * kNearlyOpposite) {
    turns_ = true;
    circle_.side = side_of(s, e, radians);
  } else {
    const FineVector fs = kinematics.refine(start);
    const FineVector fe = kinematics.refine(end);
    const Vector3<DoubleDouble> a{fs[0], fs[1], fs[2]};
    const Vector3<DoubleDouble> b{fe[0], fe[1], fe[2]};
    const Vector3<DoubleDouble> m = cross(a, b);
    constexpr double kParallel = 0x1p-66;  // what double-double cannot tell from parallel
    turns_ = dot(m, m).hi > kParallel * kParallel;
    if (turns_) circle_.side = side_of(a, b, radians);
  }
  angle_.set(radians);
}

Vector3<double> DirectionMotion::at(std::uint32_t numerator, std::uint32_t denominator) {
  return turns_ ? circle_.at(angle_.at(numerator, denominator)) : circle_.start;
}

}  // namespace toolcomp::fast
