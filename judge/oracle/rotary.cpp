// SPDX-License-Identifier: Apache-2.0
#include "judge/oracle/rotary.h"

#include <algorithm>
#include <cmath>

#include "judge/oracle/number.h"
#include "judge/oracle/policy.h"

namespace toolcomp::judge {
namespace {

constexpr double kRadiansPerDegree = 0.017453292519943295;

double number(const spec::Setup& setup, std::uint32_t parameter, double otherwise = 0) {
  const auto given = setup.parameter(parameter);
  return given ? approximate(*given) : otherwise;
}

Space vector(const spec::Setup& setup, std::uint32_t first) {
  return {number(setup, first), number(setup, first + 1), number(setup, first + 2)};
}

Space product(const Space& a, const Space& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double scalar(const Space& a, const Space& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double norm(const Space& a) { return std::hypot(a[0], a[1], a[2]); }

Space coordinate(int code) {
  Space e{};
  e.at(static_cast<std::size_t>((code - 1 + 3) % 3)) = 1;
  return e;
}

// Codes 4, 5, 6: inclined from X to Y, Y to Z, Z to X.
Space line(const spec::Setup& setup, std::uint32_t parameter, int otherwise) {
  const int code = static_cast<int>(number(setup, parameter, otherwise));
  if (code <= 3) return coordinate(code);
  const double angle = number(setup, parameter + 1) * kRadiansPerDegree;
  Space u{};
  u.at(static_cast<std::size_t>(code - 4) % 3) = std::cos(angle);
  u.at(static_cast<std::size_t>(code - 3) % 3) = std::sin(angle);
  return u;
}

std::size_t axis(const spec::Setup& setup, std::uint32_t parameter) {
  const double n = number(setup, parameter);
  return n >= 1 && n <= static_cast<double>(setup.axes.size()) ? static_cast<std::size_t>(n) - 1 : spec::Axes::kNone;
}

}  // namespace

Space rotated(const Space& v, const Space& about, double degrees) {
  const double c = std::cos(degrees * kRadiansPerDegree);
  const double s = std::sin(degrees * kRadiansPerDegree);
  const Space across = product(about, v);
  const double along = scalar(about, v) * (1 - c);
  Space result{};
  for (std::size_t i = 0; i < 3; ++i) result.at(i) = v.at(i) * c + across.at(i) * s + about.at(i) * along;
  return result;
}

std::optional<RotaryMachine> RotaryMachine::of(const spec::Setup& setup) {
  const int type = static_cast<int>(number(setup, 19680));
  if (type != 2 && type != 12 && type != 21) return std::nullopt;
  RotaryMachine m;
  m.type = type == 2 ? Type::head : type == 12 ? Type::table : Type::mixed;
  struct Axis {
    std::size_t index;
    Space line;
    double sense;
    double angle;
  };
  const auto sense = [&](std::uint32_t parameter) { return number(setup, parameter) == 1 ? -1.0 : 1.0; };
  const Axis first{axis(setup, 19681), judge::line(setup, 19682, 3), sense(19684), number(setup, 19685)};
  const Axis second{axis(setup, 19686), judge::line(setup, 19687, 2), sense(19689), number(setup, 19690)};
  const Axis& tool_side = m.type == Type::head ? second : first;
  const Axis& work_side = m.type == Type::head ? first : second;
  m.tool = tool_side.index;
  m.work = work_side.index;
  m.tool_angle = m.tool == spec::Axes::kNone ? tool_side.angle : 0;
  m.work_angle = m.work == spec::Axes::kNone ? work_side.angle : 0;
  m.tool_line = tool_side.line;
  m.work_line = work_side.line;
  // A table that turns the work turns the tool against it.
  m.tool_sense = m.type == Type::table ? -tool_side.sense : tool_side.sense;
  m.work_sense = m.type == Type::head ? work_side.sense : -work_side.sense;
  const int reference = static_cast<int>(number(setup, 19697, 3));
  const Space e3 = coordinate(reference);
  const Space e1 = coordinate(reference % 3 + 1);
  const Space e2 = coordinate((reference + 1) % 3 + 1);
  m.reference = rotated(rotated(e3, e1, number(setup, 19698)), e2, number(setup, 19699));
  m.table = vector(setup, 19700);
  m.table_step = vector(setup, 19703);
  m.head = vector(setup, 19709);
  m.head_step = vector(setup, 19712);
  m.length = longest_tool(setup);
  return m;
}

double longest_tool(const spec::Setup& setup) {
  double length = 0;
  for (const auto& entry : setup.h)
    length =
        std::max(length, std::fabs(approximate(entry.second.geometry)) + std::fabs(approximate(entry.second.wear)));
  return length + std::fabs(number(setup, 19666));
}

Space RotaryMachine::direction(double tool_position, double work_position) const {
  const Space tilted = rotated(reference, tool_line, tool_sense * (tool_position + tool_angle));
  return rotated(tilted, work_line, work_sense * (work_position + work_angle));
}

Posture::Posture(const RotaryMachine& machine, double tool_position) {
  const Space tilted = machine.direction(tool_position, -machine.work_angle);
  const Space rate = product(machine.tool_line, tilted);
  polar_sine = norm(product(machine.work_line, tilted));
  height_rate = std::fabs(scalar(machine.work_line, rate));
  height_bend = std::fabs(scalar(machine.work_line, product(machine.tool_line, rate)));
  singular = polar_sine < policy::kParallel;
  // The edge of reach on this side of the middle: a pole, or a cosine that the height is subtracted from.
  const double middle = scalar(machine.reference, machine.tool_line) * scalar(machine.work_line, machine.tool_line);
  const double swing = std::hypot(scalar(machine.work_line, tilted) - middle, height_rate);
  const double edge = scalar(machine.work_line, tilted) > middle ? middle + swing : middle - swing;
  at_a_pole = std::fabs(edge) >= 1 - policy::kSlack;
  if (!singular) azimuth_rate = std::fabs(scalar(machine.work_line, product(tilted, rate))) / (polar_sine * polar_sine);
}

double Posture::tool_error(double direction_error) const {
  const double off = at_a_pole ? polar_sine * direction_error + direction_error * direction_error / 2 : direction_error;
  const double root = std::sqrt(height_rate * height_rate + 2 * height_bend * off);
  const double sum = height_rate + root;
  return sum > 0 ? 2 * off / sum : direction_error;
}

double Posture::work_error(double direction_error) const {
  if (singular) return direction_error;
  return direction_error / polar_sine + azimuth_rate * tool_error(direction_error);
}

}  // namespace toolcomp::judge
