// SPDX-License-Identifier: Apache-2.0
#include "fast/heidenhain/program/tool_vector.h"

#include <bit>
#include <cmath>
#include <utility>

#include "fast/arithmetic/trigonometry.h"

namespace toolcomp::fast::klartext {
namespace {

// Ry(b) Rx(a) of an axis. Each component is one product: none cancels.
template <class Number>
Vector3<Number> tilted(std::size_t axis, const SineCosine<Number>& a, const SineCosine<Number>& b, const Number& one) {
  Vector3<Number> v;
  switch (axis) {
    case 0:
      v.x = one;
      break;
    case 1:
      v.y = a.cosine;
      v.z = a.sine;
      break;
    default:
      v.y = -a.sine;
      v.z = a.cosine;
  }
  return {b.cosine * v.x + b.sine * v.z, v.y, b.cosine * v.z - b.sine * v.x};
}

// Rz(c) Ry(b) Rx(a) of an axis.
template <class Number>
Vector3<Number> turned(std::size_t axis, const SineCosine<Number>& a, const SineCosine<Number>& b,
                       const SineCosine<Number>& c, const Number& one) {
  const Vector3<Number> v = tilted(axis, a, b, one);
  return {c.cosine * v.x - c.sine * v.y, c.sine * v.x + c.cosine * v.y, v.z};
}

// Whether a sum of tilted and turned components is exactly 0. Terms that are not 0 cancel only where the tool lies in
// XY, B being an odd multiple of 90 degrees: their sum is then a sine of C + A or C - A and a quarter turn, of decimals
// 0 or well above the bound. Elsewhere no angles of rational degrees make them opposite.
bool is_zero_sum(const DoubleDouble& a, const DoubleDouble& b, bool lies) {
  if (a.hi == 0 || b.hi == 0) return a.hi == b.hi;
  return lies && std::abs((a + b).hi) <= 0x1p-90;
}

Int128 nearest_units(const DoubleDouble& value) {
  const double whole = std::nearbyint(value.hi);
  return static_cast<Int128>(whole) + static_cast<Int128>(std::nearbyint((value.hi - whole) + value.lo));
}

bool is_quarter(const SineCosine<double>& turn) { return turn.sine == 0 || turn.cosine == 0; }

}  // namespace

void ToolVector::turn(std::size_t axis, const std::array<Count, 3>& degrees) {
  std::array<SineCosine<double>, 3> turn;
  turn[0] = degrees[0].is_zero() ? SineCosine<double>{0, 1} : sine_cosine(degrees[0]);
  const std::array<SineCosine<double>, 2> last = sine_cosine(degrees[1], degrees[2]);
  turn[1] = last[0];
  turn[2] = last[1];
  unit_ = Vector(turned<double>(axis, turn[0], turn[1], turn[2], 1));
  whole_ = is_quarter(turn[0]) && is_quarter(turn[1]) && is_quarter(turn[2]);
  if (whole_) {
    vector_.narrow = true;
    for (std::size_t i = 0; i < 3; ++i) vector_.small[i] = static_cast<std::int64_t>(unit_[i]) * WholeVector::kOne;
    return;
  }
  axis_ = axis;
  degrees_ = degrees;
}

FineVector3 ToolVector::fine() const {
  if (whole_) return vector_.fine();
  return turned<DoubleDouble>(axis_, fine_sine_cosine(degrees_[0]), fine_sine_cosine(degrees_[1]),
                              fine_sine_cosine(degrees_[2]), {1, 0});
}

unsigned ToolVector::components() const {
  std::array<bool, 3> none{};
  if (whole_) {
    for (std::size_t i = 0; i < 3; ++i) none[i] = vector_.narrow ? vector_.small[i] == 0 : vector_.wide[i] == 0;
  } else {
    const SineCosine<DoubleDouble> b = fine_sine_cosine(degrees_[1]);
    const SineCosine<DoubleDouble> c = fine_sine_cosine(degrees_[2]);
    const FineVector3 v = tilted<DoubleDouble>(axis_, fine_sine_cosine(degrees_[0]), b, {1, 0});
    const bool lies = b.cosine.hi == 0;
    none = {is_zero_sum(c.cosine * v.x, -(c.sine * v.y), lies), is_zero_sum(c.sine * v.x, c.cosine * v.y, lies),
            v.z.hi == 0};
  }
  return (none[0] ? 0U : 1U) | (none[1] ? 0U : 2U) | (none[2] ? 0U : 4U);
}

double ToolVector::way(const Count& length, std::array<Count, 3>& xyz) const {
  xyz = {};
  if (length.is_zero()) return 0;
  const unsigned along = components();
  if (std::has_single_bit(along)) {
    const auto axis = static_cast<std::size_t>(std::countr_zero(along));
    xyz[axis] = unit_[axis] < 0 ? -length : length;
    return 0;
  }
  const FineVector3 t = fine();
  const DoubleDouble size = whole_ ? sqrt(dot(t, t)) : DoubleDouble{1, 0};
  const DoubleDouble units = to_double_double(length.units());
  for (std::size_t i = 0; i < 3; ++i)
    if ((along >> i & 1U) != 0) xyz[i] = Count::of_units(nearest_units(units * t[i] / size));
  // Half a unit of rounding, and what the direction is off by.
  return 1 + 4 * kFineError * std::abs(units.hi);
}

}  // namespace toolcomp::fast::klartext
