// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/fanuc/tool_direction.h"

#include <cmath>
#include "judge/oracle/number.h"

namespace toolcomp::fuzz {
namespace {

constexpr double kRadiansPerDegree = 0.017453292519943295;

double number(const spec::Setup& setup, std::uint32_t parameter, double otherwise = 0) {
  const auto value = setup.parameter(parameter);
  return value ? judge::approximate(*value) : otherwise;
}

Direction axis(int code) {
  Direction e{};
  e[static_cast<std::size_t>(code - 1) % 3] = 1;
  return e;
}

// Of the controlled axis of this number, in the first workpiece system; 0 where there is none.
double position(const spec::Setup& setup, const Pose& pose, double axis_number) {
  const auto index = static_cast<std::size_t>(axis_number);
  if (index < 1 || index > setup.axes.size()) return 0;
  const char letter = setup.axes.letter(index - 1);
  const auto found = pose.find(letter);
  const double programmed = found == pose.end() ? 0 : found->second;
  const spec::AxisTable& zeros = setup.workpiece.front();
  const auto zero = zeros.find(letter);
  const bool moved = zero != zeros.end() && setup.rotary_angles == spec::RotaryAngles::machine;
  return moved ? programmed + judge::approximate(zero->second) : programmed;
}

// Codes 4, 5, 6: tilted from X to Y, Y to Z, Z to X by an angle.
Direction rotary_axis(const spec::Setup& setup, std::uint32_t code_parameter, int otherwise) {
  const int code = static_cast<int>(number(setup, code_parameter, otherwise));
  if (code <= 3) return axis(code);
  const double angle = number(setup, code_parameter + 1) * kRadiansPerDegree;
  Direction u{};
  u[static_cast<std::size_t>(code - 4)] = std::cos(angle);
  u[static_cast<std::size_t>(code - 3) % 3] = std::sin(angle);
  return u;
}

Direction by_machine(const spec::Setup& setup, const Pose& pose, int type) {
  const int reference = static_cast<int>(number(setup, 19697, 3));
  const Direction e3 = axis(reference);
  const Direction e1 = axis(reference % 3 + 1);
  const Direction e2 = axis((reference + 1) % 3 + 1);
  const Direction t0 = turned(turned(e3, e1, number(setup, 19698)), e2, number(setup, 19699));
  const Direction u1 = rotary_axis(setup, 19682, 3);
  const Direction u2 = rotary_axis(setup, 19687, 2);
  const double s1 = number(setup, 19684) == 1 ? -1 : 1;
  const double s2 = number(setup, 19689) == 1 ? -1 : 1;
  const double a1 = s1 * position(setup, pose, number(setup, 19681));
  const double a2 = s2 * position(setup, pose, number(setup, 19686));
  if (type == 2) return turned(turned(t0, u2, a2), u1, a1);
  return turned(turned(t0, u1, type == 12 ? -a1 : a1), u2, -a2);
}

Direction by_groups(const spec::Setup& setup, const Pose& pose) {
  Direction v = turned(turned({0, 0, 1}, {1, 0, 0}, number(setup, 19622)), {0, 1, 0}, number(setup, 19623));
  for (const std::uint32_t group : {19610U, 19615U}) {
    const double rotary = number(setup, group);
    if (rotary == 0) continue;
    const Direction e1 = axis(std::max(1, static_cast<int>(number(setup, group + 1))));
    const Direction e2 = axis(std::max(1, static_cast<int>(number(setup, group + 2))));
    const Direction e3 = cross(e1, e2);
    const double tilt = number(setup, group + 4) * kRadiansPerDegree;
    Direction u{};
    for (std::size_t i = 0; i < 3; ++i) u[i] = std::sin(tilt) * e1[i] + std::cos(tilt) * e3[i];
    const double zero = number(setup, group == 19610 ? 19620 : 19621);
    v = turned(v, u, position(setup, pose, rotary) - zero);
  }
  return v;
}

}  // namespace

std::int64_t billionths(double x) {
  constexpr double in_one = 1e9;
  return std::llround(x * in_one);
}

double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Direction cross(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Direction unit(const Direction& v) {
  const double length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

Direction turned(const Direction& v, const Direction& axis, double degrees) {
  const double c = std::cos(degrees * kRadiansPerDegree);
  const double s = std::sin(degrees * kRadiansPerDegree);
  const Direction w = cross(axis, v);
  const double along = dot(axis, v) * (1 - c);
  Direction result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = v[i] * c + w[i] * s + axis[i] * along;
  return result;
}

Direction axis_off(const Direction& d) { return std::fabs(d[0]) < 0.6 ? Direction{1, 0, 0} : Direction{0, 1, 0}; }

Direction beside(const Direction& d) { return unit(cross(d, axis_off(d))); }

Direction as_direction(const SpaceCounts& whole) {
  return unit({static_cast<double>(whole[0]), static_cast<double>(whole[1]), static_cast<double>(whole[2])});
}

std::optional<SpaceCounts> whole_along(const Direction& d, double most) {
  double least = 1;
  for (const double x : d)
    if (billionths(x) != 0) least = std::min(least, std::fabs(x));
  SpaceCounts whole{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = d.at(i) / least;
    if (std::fabs(x) > most || billionths(x - std::round(x)) != 0) return std::nullopt;
    whole.at(i) = std::llround(x);
  }
  return whole;
}

std::optional<Direction> tool_direction(const spec::Setup& setup, const Pose& pose) {
  const int type = static_cast<int>(number(setup, 19680));
  if (type != 0) return by_machine(setup, pose, type);
  if (number(setup, 19610) != 0) return by_groups(setup, pose);
  return std::nullopt;
}

}  // namespace toolcomp::fuzz
