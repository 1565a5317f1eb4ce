// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_side_compensation/tool_plane.h"

#include <cmath>

#include "fast/arithmetic/wide.h"

namespace toolcomp::fast {
namespace {

// Rounding of one double-double expression of a few terms, over their magnitude.
constexpr double kFine = 0x1p-98;

using Fine = Vector3<DoubleDouble>;
using Exact = Vector3<Wide>;

Fine fine(const std::array<Int128, 3>& v) {
  return {to_double_double(v[0]), to_double_double(v[1]), to_double_double(v[2])};
}
Exact exact(const std::array<Int128, 3>& v) { return {Wide(v[0]), Wide(v[1]), Wide(v[2])}; }
Fine fine(const Exact& v) { return {v.x.to_double_double(), v.y.to_double_double(), v.z.to_double_double()}; }

// Bit i: component i is not 0.
unsigned live(const Travel& travel) {
  return static_cast<unsigned>(travel.value.x != 0) | static_cast<unsigned>(travel.value.y != 0) << 1U |
         static_cast<unsigned>(travel.value.z != 0) << 2U;
}
unsigned live(const Direction& tool) { return ~static_cast<unsigned>(tool.zero) & 7U; }

bool is_exact(const Travel& travel, const Direction& tool) { return tool.is_whole && travel.slack == 0; }

// A tool along one axis turns the other two only.
bool is_axis(const Direction& tool) { return tool.zero == 0b011 || tool.zero == 0b101 || tool.zero == 0b110; }

}  // namespace

bool ToolPlane::moves_by_little(const Travel& travel, const Amount& limit) const {
  // Every product of unlike components is zero: along the tool.
  if (travel.slack == 0 && live(tool_) == live(travel) && is_axis(tool_)) return false;
  const bool limited = Count() < limit.exact;
  const double shortest = limit.nearest * travel.unit;
  if (is_exact(travel, tool_)) {
    const bool fine_units = travel.fine_units || !limit.exact.is_small();
    std::array<Int128, 3> whole = travel.whole();
    if (fine_units && !travel.fine_units)
      for (Int128& component : whole) component *= Count::kRestPerSmall;
    const Exact tool = exact(tool_.whole());
    const Exact c = cross(tool, exact(whole));
    const Wide square = dot(c, c);
    if (square.sign() == 0 || !limited) return square.sign() != 0;
    const Wide least(fine_units ? limit.exact.units() : Int128{limit.exact.small()});
    return (square - least * least * dot(tool, tool)).sign() >= 0;
  }
  const Fine left = fine_left(travel);
  const double refined = std::sqrt(dot(left, left).hi);
  const double error = 4 * (fine_error() + kFine) * std::sqrt(travel.square) + 4 * travel.slack;
  if (refined <= error) return false;
  if (!limited) return true;
  const DoubleDouble least =
      to_double_double(limit.exact.units()) * travel.unit / DoubleDouble{static_cast<double>(Count::kRestPerOne), 0};
  return (dot(left, left) - least * least).hi >= -2 * error * (refined + shortest);
}

int ToolPlane::cross_sign(const Travel& first, const Travel& second) const {
  if (first.slack == 0 && second.slack == 0 && tool_.is_whole)
    return dot(exact(tool_.whole()), cross(exact(first.whole()), exact(second.whole()))).sign();
  const Fine normal = cross(fine(first.whole()), fine(second.whole()));
  const double refined = dot(fine_unit(), normal).hi;
  const double lengths = std::sqrt(first.square) * std::sqrt(second.square);
  const double size = std::abs(normal.x.hi) + std::abs(normal.y.hi) + std::abs(normal.z.hi);
  const double slack =
      4 * (first.slack * std::sqrt(second.square) + second.slack * std::sqrt(first.square)) + kFine * lengths;
  return std::abs(refined) <= (fine_error() + kFine) * size + slack ? 0 : sign_of(refined);
}

int ToolPlane::dot_sign(const Travel& first, const Travel& second) const {
  return fast::dot_sign(kinematics_, first, tool_, second, tool_);
}

int dot_sign(const Kinematics& kinematics, const Travel& first, const Direction& first_tool, const Travel& second,
             const Direction& second_tool) {
  const ToolPlane a(kinematics, first_tool);
  const ToolPlane b(kinematics, second_tool);
  const double lengths = std::sqrt(first.square) * std::sqrt(second.square);
  const double estimate = dot(cross(a.unit(), first.value), cross(b.unit(), second.value));
  const bool clean = first.slack == 0 && second.slack == 0;
  if (clean && std::abs(estimate) > (a.square_bound() + b.square_bound()) * lengths) return sign_of(estimate);
  if (is_exact(first, first_tool) && is_exact(second, second_tool))
    return dot(cross(exact(first_tool.whole()), exact(first.whole())),
               cross(exact(second_tool.whole()), exact(second.whole())))
        .sign();
  const Fine first_unit = a.fine_unit();  // by value: refining the other tool takes its place
  const Fine second_unit = b.fine_unit();
  // Either is off by its tool's error over the whole travel, however little of that the tool leaves across itself.
  const Fine across1 = cross(first_unit, fine(first.whole()));
  const Fine across2 = cross(second_unit, fine(second.whole()));
  const double refined = dot(across1, across2).hi;
  const double off1 = (a.fine_error() + kFine) * std::sqrt(first.square);
  const double off2 = (b.fine_error() + kFine) * std::sqrt(second.square);
  const double size1 = std::sqrt(dot(across1, across1).hi);
  const double size2 = std::sqrt(dot(across2, across2).hi);
  const double bound = 6 * (off1 * size2 + off2 * size1 + off1 * off2) + kFine * size1 * size2 +
                       4 * (first.slack * std::sqrt(second.square) + second.slack * std::sqrt(first.square));
  return std::abs(refined) <= bound ? 0 : sign_of(refined);
}

Vector3<DoubleDouble> ToolPlane::fine_left(const Travel& travel) const {
  if (!is_exact(travel, tool_)) return cross(fine_unit(), fine(travel.whole()));
  const Exact tool = exact(tool_.whole());
  const Fine left = fine(cross(tool, exact(travel.whole())));
  const DoubleDouble norm = sqrt(dot(tool, tool).to_double_double());
  return {left.x / norm, left.y / norm, left.z / norm};
}

bool ToolPlane::is_across(const std::array<std::int64_t, 3>& normal) const {
  const unsigned used = static_cast<unsigned>(normal[0] != 0) | static_cast<unsigned>(normal[1] != 0) << 1U |
                        static_cast<unsigned>(normal[2] != 0) << 2U;
  return (used & live(tool_)) == 0;
}

std::optional<std::int64_t> ToolPlane::whole_dot(const Travel& first, const Travel& second) const {
  const std::array<std::int64_t, 3> a = first.small();
  const std::array<std::int64_t, 3> b = second.small();
  const std::int64_t product = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const unsigned tool_axes = live(tool_);
  if (is_axis(tool_)) {
    const std::size_t i = tool_axes == 1 ? 0 : (tool_axes == 2 ? 1 : 2);
    return product - a[i] * b[i];
  }
  const bool across1 = (live(first) & tool_axes) == 0;
  const bool across2 = (live(second) & tool_axes) == 0;
  if (!across1 && !across2) return std::nullopt;
  return product;
}

void ToolPlane::set_fine_turn(const Travel& first, const Travel& second, SpaceTurn& turn) const {
  const FineTurn numbers = fine_turn(first, second);
  turn.cross = cross_sign(first, second);
  turn.dot = dot_sign(first, second);
  turn.left1 = nearest(numbers.left1);
  turn.ahead1 = nearest(numbers.ahead1);
  turn.c = turn.cross == 0 ? 0 : numbers.c.hi;
  turn.k = turn.dot == 0 ? 0 : numbers.k.hi;
  turn.length1 = numbers.length1.hi;
  turn.ill = true;
}

FineTurn ToolPlane::fine_turn(const Travel& first, const Travel& second) const {
  FineTurn turn;
  const Fine v = fine_unit();
  const auto leg = [&](const Travel& travel, Fine& left, Fine& ahead) {
    const Fine w = fine_left(travel);
    const DoubleDouble norm = sqrt(fast::dot(w, w));
    left = {w.x / norm, w.y / norm, w.z / norm};
    ahead = fast::cross(left, v);
    return norm;
  };
  turn.length1 = leg(first, turn.left1, turn.ahead1) / DoubleDouble{first.unit, 0};
  (void)leg(second, turn.left2, turn.ahead2);
  turn.c = fast::dot(v, fast::cross(turn.left1, turn.left2));
  turn.k = fast::dot(turn.left1, turn.left2);
  return turn;
}

SpaceTurn ToolPlane::straight(const Travel& travel) const {
  SpaceTurn result;
  const Vector3<double> v = unit();
  const Vector3<double> w = fast::cross(v, travel.value);
  const double square = fast::dot(w, w);
  if (4 * square >= travel.square && travel.slack == 0) [[likely]] {
    const double norm = std::sqrt(square);
    result.left1 = {w.x / norm, w.y / norm, w.z / norm};
    result.ahead1 = fast::cross(result.left1, v);
    result.length1 = norm / travel.unit;
  } else {
    const FineTurn numbers = fine_turn(travel, travel);
    result.left1 = nearest(numbers.left1);
    result.ahead1 = nearest(numbers.ahead1);
    result.length1 = numbers.length1.hi;
    result.ill = true;
  }
  result.dot = 1;
  return result;
}

int ToolPlane::facing_by_little(std::size_t axis) const {
  if (tool_.is_whole) return sign_of(tool_.unit[static_cast<Eigen::Index>(axis)]);
  const double refined = fine_unit()[axis].hi;
  return std::abs(refined) <= fine_error() ? 0 : sign_of(refined);
}

}  // namespace toolcomp::fast
