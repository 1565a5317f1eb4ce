// SPDX-License-Identifier: Apache-2.0
#include "fast/kinematics/kinematics.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "fast/arithmetic/extended_sine.h"
#include "spec/language/input_error.h"

namespace toolcomp::fast {
namespace {

[[noreturn]] void refuse(std::uint32_t number, const std::string& why) {
  throw spec::InputError("setup", 0, 0, "parameters.\"" + std::to_string(number) + "\": " + why);
}

// The parameter as a whole number in [low, high]; absent is 0.
int whole_parameter(const spec::Setup& setup, std::uint32_t number, int low, int high) {
  const auto value = setup.parameter(number);
  if (!value) return 0;
  std::uint64_t digits = value->digits;
  unsigned decimals = value->decimals;
  while (decimals > 0 && digits % 10 == 0) {
    digits /= 10;
    --decimals;
  }
  if (decimals > 0) refuse(number, "must be a whole number");
  if (digits > 1000) refuse(number, "is out of range");
  const int whole = value->negative ? -static_cast<int>(digits) : static_cast<int>(digits);
  if (whole < low || whole > high)
    refuse(number, "must be from " + std::to_string(low) + " to " + std::to_string(high));
  return whole;
}

// An angle in degrees; absent is 0.
Count angle_parameter(const spec::Setup& setup, std::uint32_t number) {
  const auto value = setup.parameter(number);
  if (!value) return {};
  if (!fits_count(*value)) refuse(number, "is too large");
  return Count::of(*value);
}

// The index of the controlled axis a parameter names, which must be rotary.
std::size_t rotary_parameter(const spec::Setup& setup, std::uint32_t number) {
  const int axis = whole_parameter(setup, number, 0, static_cast<int>(setup.axes.size()));
  if (axis == 0) refuse(number, "must name a rotary axis");
  const auto index = static_cast<std::size_t>(axis - 1);
  if (!spec::is_rotary_axis(setup.axes.letter(index))) refuse(number, "names an axis that is not rotary");
  return index;
}

// 0, 1, 2 for X, Y, Z: the linear axis a parameter names; -1 for 0.
int linear_parameter(const spec::Setup& setup, std::uint32_t number) {
  const int axis = whole_parameter(setup, number, 0, static_cast<int>(setup.axes.size()));
  if (axis == 0) return -1;
  const char letter = setup.axes.letter(static_cast<std::size_t>(axis - 1));
  if (letter < 'X' || letter > 'Z') refuse(number, "must name X, Y or Z");
  return letter - 'X';
}

FineVector cross(const FineVector& a, const FineVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
DoubleDouble dot(const FineVector& a, const FineVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
FineVector operator*(const FineVector& a, const DoubleDouble& b) { return {a[0] * b, a[1] * b, a[2] * b}; }
FineVector operator-(const FineVector& a, const FineVector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

FineVector operator+(const FineVector& a, const FineVector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

FineVector unit_vector(int axis) {
  FineVector e{};
  e[static_cast<std::size_t>(axis)] = {1, 0};
  return e;
}

// v0 = cosRA sinRB e1 - sinRA e2 + cosRA cosRB e3 for the cyclic triple that ends with axis `third`.
FineVector tilted(const Count& ra, const Count& rb, int third) {
  const auto a = fine_sine_cosine(ra);
  const auto b = fine_sine_cosine(rb);
  FineVector v{};
  v[static_cast<std::size_t>((third + 1) % 3)] = a.cosine * b.sine;
  v[static_cast<std::size_t>((third + 2) % 3)] = -a.sine;
  v[static_cast<std::size_t>(third)] = a.cosine * b.cosine;
  return v;
}

// The direction codes of 19682 and 19687: 1 X, 2 Y, 3 Z, 4 to 6 inclined by 19683 or 19688.
FineVector axis_direction(const spec::Setup& setup, std::uint32_t number) {
  const int code = whole_parameter(setup, number, 1, 6);
  if (code == 0) refuse(number, "must be from 1 to 6");
  if (code <= 3) return unit_vector(code - 1);
  const auto a = fine_sine_cosine(angle_parameter(setup, number + 1));
  if (code == 4) return {a.cosine, a.sine, DoubleDouble{}};
  if (code == 5) return {DoubleDouble{}, a.cosine, a.sine};
  return {a.sine, DoubleDouble{}, a.cosine};
}

}  // namespace

Kinematics::Kinematics(const spec::Setup& setup) {
  const int type = whole_parameter(setup, 19680, 0, 21);
  if (type != 0) {
    if (type != 2 && type != 12 && type != 21) refuse(19680, "must be 0, 2, 12 or 21");
    from_unit_type(setup, type);
  } else if (whole_parameter(setup, 19610, 0, static_cast<int>(setup.axes.size())) != 0) {
    from_axis_groups(setup);
  }
  reference_ = {inner_.reference, outer_.reference};
}

void Kinematics::set_zeros(const std::array<Count, spec::kMaxAxes>& zero) {
  if (inner_.index != RotaryAxis::kNone) inner_.reference = reference_[0] - zero[inner_.index];
  if (outer_.index != RotaryAxis::kNone) outer_.reference = reference_[1] - zero[outer_.index];
}

void Kinematics::from_unit_type(const spec::Setup& setup, int type) {
  defined_ = true;
  type_ = type;
  std::array<RotaryAxis, 2> axis;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::uint32_t base = i == 0 ? 19681 : 19686;
    if (setup.bit(19696, static_cast<int>(i))) {
      if (whole_parameter(setup, base, 0, 0) != 0) refuse(base, "must be 0 for a hypothetical axis");
      axis[i].reference = -angle_parameter(setup, base + 4);
    } else {
      axis[i].index = rotary_parameter(setup, base);
    }
    axis[i].axis = axis_direction(setup, base + 1);
    axis[i].reversed = whole_parameter(setup, base + 3, 0, 1) == 1;
  }
  if (axis[0].index != RotaryAxis::kNone && axis[0].index == axis[1].index)
    refuse(19686, "names the same axis as 19681");
  // A table turns the work, so the direction seen from the work turns the other way.
  if (type == 12) axis[0].reversed = !axis[0].reversed;
  if (type != 2) axis[1].reversed = !axis[1].reversed;
  inner_ = type == 2 ? axis[1] : axis[0];
  outer_ = type == 2 ? axis[0] : axis[1];
  const int vertical = setup.parameter(19697) ? whole_parameter(setup, 19697, 1, 3) : 3;
  const bool turns_with_table = setup.bit(19746, 4) && !setup.bit(19696, 5);
  table_may_stand_ = type != 2 && setup.series == spec::Series::series_30i && !turns_with_table;
  expand(tilted(angle_parameter(setup, 19698), angle_parameter(setup, 19699), vertical - 1));
}

void Kinematics::from_axis_groups(const spec::Setup& setup) {
  defined_ = true;
  const auto group = [&](std::uint32_t base, std::uint32_t reference) {
    RotaryAxis rotary;
    rotary.index = rotary_parameter(setup, base);
    rotary.reference = angle_parameter(setup, reference);
    const int first = linear_parameter(setup, base + 1);
    const int second = linear_parameter(setup, base + 2);
    const int third = linear_parameter(setup, base + 3);
    if (first < 0) refuse(base + 1, "must name a linear axis");
    if (second < 0 || second == first) refuse(base + 2, "must name another linear axis");
    const FineVector normal = cross(unit_vector(first), unit_vector(second));
    const Count inclination = angle_parameter(setup, base + 4);
    if (inclination.is_zero()) {
      if (third == first || third == second) refuse(base + 3, "must name the third linear axis");
      rotary.axis = normal;
      return rotary;
    }
    if (third < 0 || dot(normal, unit_vector(third)).hi <= 0)
      refuse(base + 3, "linear axes 1, 2, 3 of an inclined rotary axis must be right-handed");
    const auto a = fine_sine_cosine(inclination);
    rotary.axis = {};
    rotary.axis[static_cast<std::size_t>(first)] = a.sine;
    rotary.axis[static_cast<std::size_t>(third)] = a.cosine;
    return rotary;
  };
  inner_ = group(19610, 19620);
  if (whole_parameter(setup, 19615, 0, static_cast<int>(setup.axes.size())) != 0)
    outer_ = group(19615, 19621);
  else
    outer_.axis = unit_vector(2);
  if (inner_.index == outer_.index) refuse(19615, "names the same axis as 19610");
  expand(tilted(angle_parameter(setup, 19622), angle_parameter(setup, 19623), 2));
}

void Kinematics::set_frame(const std::array<FineVector, 3>& rows, double fine_error) {
  frame_ = Frame{};
  frame_.fine_error = fine_error;
  refined_.valid = false;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const double entry = rows[i][j].hi;
      frame_.fine[i][j] = rows[i][j];
      frame_.rough[i][j] = entry;
      if (entry != (i == j ? 1 : 0)) frame_.turned = true;
      if (entry != 0 && std::abs(entry) != 1) frame_.along_axes = false;
    }
}

void Kinematics::expand(const FineVector& v0) {
  zero_direction_ = v0;
  // R(a, t) x = (a.x) a + cos t (x - (a.x) a) + sin t (a x x)
  const auto parts = [](const FineVector& a, const FineVector& x) {
    const FineVector along = a * dot(a, x);
    return std::array<FineVector, 3>{along, x - along, cross(a, x)};
  };
  const auto inner = parts(inner_.axis, v0);
  std::array<double, 3> magnitude{};
  std::array<int, 3> count{};
  whole_terms_ = true;
  for (std::uint8_t i = 0; i < 3; ++i) {
    const auto outer = parts(outer_.axis, inner[i]);
    for (std::uint8_t j = 0; j < 3; ++j)
      for (std::uint8_t k = 0; k < 3; ++k) {
        const DoubleDouble& c = outer[j][k];
        if (c.hi == 0) continue;
        terms_.push_back({c.hi, k, i, j, c});
        magnitude[k] += std::abs(c.hi);
        ++count[k];
        if (c.lo != 0 || std::abs(c.hi) != 1) whole_terms_ = false;
        term_[k] = {c.hi, i, j};
      }
  }
  one_term_ = count[0] <= 1 && count[1] <= 1 && count[2] <= 1;
  // Each term: coefficient u, two trigonometric values, two products 2u; each further term of a component one addition.
  constexpr double u = 0x1p-53;
  for (std::size_t k = 0; k < 3; ++k) {
    error_ = std::max(error_, (2 * kTrigonometryError + (3 + std::max(0, count[k] - 1)) * u) * magnitude[k] * 1.001);
    fine_error_ = std::max(fine_error_, magnitude[k] * 0x1p-98);
  }
}

Count Kinematics::angle(const RotaryAxis& axis, const std::array<Count, spec::kMaxAxes>& position) {
  if (axis.stands) return {};
  const Count turned = axis.index == RotaryAxis::kNone ? -axis.reference : position[axis.index] - axis.reference;
  return axis.reversed ? -turned : turned;
}

// The usual angle in place: a count that is put together elsewhere would have to be waited for.
std::int64_t Kinematics::set_angle(const RotaryAxis& axis, const std::array<Count, spec::kMaxAxes>& position,
                                   Count& turned) {
  if (axis.stands) [[unlikely]] {
    turned.set_small(0);
    return 0;
  }
  if (axis.index != RotaryAxis::kNone && position[axis.index].is_small() && axis.reference.is_small()) [[likely]] {
    std::int64_t small = position[axis.index].small() - axis.reference.small();
    if (axis.reversed) small = -small;
    if (Count::is_small(small)) [[likely]] {
      turned.set_small(small);
      return small;
    }
  }
  turned = angle(axis, position);
  return Count::kNotSmall;
}

void Kinematics::set_trigonometry(std::size_t i, double sine, double cosine) {
  trigonometry_[i][1] = cosine;
  trigonometry_[i][2] = sine;
  quarters_[i] = sine * cosine == 0;
}

void Kinematics::direct(const std::array<Count, spec::kMaxAxes>& position, Direction& direction) {
  const std::int64_t first = set_angle(inner_, position, direction.angle[0]);
  const std::int64_t second = set_angle(outer_, position, direction.angle[1]);
  if (first != Count::kNotSmall && second != Count::kNotSmall) [[likely]] {
    if (first != last_[0] || second != last_[1]) {
      const SineCosine<DoublePair> t = sine_cosine(first, second);
      set_trigonometry(0, t.sine[0], t.cosine[0]);
      set_trigonometry(1, t.sine[1], t.cosine[1]);
    }
  } else {
    for (std::size_t i = 0; i < 2; ++i) {
      const SineCosine<double> t = sine_cosine(direction.angle[i]);
      set_trigonometry(i, t.sine, t.cosine);
    }
  }
  last_ = {first, second};
  const std::array<double, 3>& inner = trigonometry_[0];
  const std::array<double, 3>& outer = trigonometry_[1];
  direction.error = error_;
  direction.fine_error = fine_error_;
  direction.is_fine = false;
  direction.framed = false;
  direction.is_whole = false;
  if (one_term_) [[likely]] {
    const auto value = [&](const OneTerm& term) { return term.coefficient * inner[term.inner] * outer[term.outer]; };
    const double x = value(term_[0]);
    const double y = value(term_[1]);
    const double z = value(term_[2]);
    direction.unit[0] = x;
    direction.unit[1] = y;
    direction.unit[2] = z;
    direction.zero = static_cast<std::uint8_t>(static_cast<unsigned>(x == 0) | static_cast<unsigned>(y == 0) << 1U |
                                               static_cast<unsigned>(z == 0) << 2U);
  } else {
    std::array<double, 3> sum{};
    unsigned nonzero = 0;
    for (const Term& term : terms_) {
      const double value = term.coefficient * inner[term.inner] * outer[term.outer];
      sum[term.component] += value;
      nonzero |= static_cast<unsigned>(value != 0) << term.component;
    }
    for (std::size_t k = 0; k < 3; ++k) direction.unit[static_cast<Eigen::Index>(k)] = sum[k];
    direction.zero = static_cast<std::uint8_t>(~nonzero & 7U);
  }
  // With whole coefficients and angles that are multiples of 90 the direction is an axis.
  if (!whole_terms_ || !quarters_[0] || !quarters_[1]) [[likely]]
    return;
  direction.is_whole = true;
  direction.error = 0;
  direction.narrow = true;
  for (std::size_t k = 0; k < 3; ++k) {
    direction.small[k] = static_cast<std::int64_t>(direction.unit[static_cast<Eigen::Index>(k)]);
    if (direction.small[k] == 0) direction.zero = static_cast<std::uint8_t>(direction.zero | 1U << k);
  }
}

const FineVector& Kinematics::refine(const Direction& direction) const {
  if (direction.is_fine) return direction.fine;
  if (refined_.valid && refined_.is_whole == direction.is_whole && refined_.framed == direction.framed &&
      (direction.is_whole ? refined_.whole == direction.whole() : refined_.angle == direction.angle))
    return refined_.unit;
  refined_.valid = true;
  refined_.is_whole = direction.is_whole;
  refined_.framed = direction.framed;
  refined_.whole = direction.is_whole ? direction.whole() : std::array<Int128, 3>{};
  refined_.angle = direction.angle;
  FineVector& unit = refined_.unit;
  if (direction.is_whole) {
    FineVector v;
    for (std::size_t k = 0; k < 3; ++k) v[k] = to_double_double(refined_.whole[k]);
    const DoubleDouble norm = sqrt(dot(v, v));
    for (std::size_t k = 0; k < 3; ++k) unit[k] = v[k] / norm;
    return unit;
  }
  const FineVector on_table = refine_on_table(direction);
  if (!direction.framed || !frame_.turned)
    unit = on_table;
  else
    for (std::size_t k = 0; k < 3; ++k) unit[k] = dot(frame_.fine[k], on_table);
  return unit;
}

FineVector Kinematics::refine_on_table(const Direction& direction) const {
  if (direction.is_whole || direction.is_fine) {
    const FineVector unit = refine(direction);
    if (!frame_.turned) return unit;
    FineVector back{};
    for (std::size_t k = 0; k < 3; ++k) back = back + frame_.fine[k] * unit[k];
    return back;
  }
  return sum_of_terms(fine_sine_cosine(direction.angle[0]), fine_sine_cosine(direction.angle[1]));
}

FineVector Kinematics::sum_of_terms(const SineCosine<DoubleDouble>& inner,
                                    const SineCosine<DoubleDouble>& outer) const {
  const std::array<DoubleDouble, 3> i{DoubleDouble{1, 0}, inner.cosine, inner.sine};
  const std::array<DoubleDouble, 3> o{DoubleDouble{1, 0}, outer.cosine, outer.sine};
  FineVector unit{};
  for (const Term& term : terms_) {
    const DoubleDouble turned = term.inner == 0   ? o[term.outer]
                                : term.outer == 0 ? i[term.inner]
                                                  : i[term.inner] * o[term.outer];
    unit[term.component] = unit[term.component] + (whole_terms_ ? turned * term.coefficient : term.fine * turned);
  }
  return unit;
}

// A component has nine terms at most, with coefficients of at most 1 and two sines each.
const FineVector* Kinematics::extended(const Direction& direction) const {
  static_assert(9 * 2 * kExtendedSineError <= 0x1p-65);
  const auto usual = [](const Count& angle) {
    return angle.is_small() && angle.small() <= kMostExtendedAngle && angle.small() >= -kMostExtendedAngle;
  };
  const Count& inner = direction.angle[0];
  const Count& outer = direction.angle[1];
  if (direction.is_whole || direction.is_fine || (direction.framed && frame_.turned) || !usual(inner) || !usual(outer))
    return nullptr;
  Extended& last = extended_;
  if (last.angle[0] != inner.small() || last.angle[1] != outer.small()) {
    last.angle = {inner.small(), outer.small()};
    last.unit = sum_of_terms(extended_sine_cosine(inner.small()), extended_sine_cosine(outer.small()));
  }
  return &last.unit;
}

}  // namespace toolcomp::fast
