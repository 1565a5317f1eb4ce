// SPDX-License-Identifier: Apache-2.0
#include "fast/heidenhain/program/tool_vector.h"

#include <utility>

#include "fast/arithmetic/trigonometry.h"
#include "fast/basis/fault.h"

namespace toolcomp::fast::klartext {
namespace {

// Rz(c) Ry(b) Rx(a) of an axis.
template <class Number>
Vector3<Number> turned(std::size_t axis, const SineCosine<Number>& a, const SineCosine<Number>& b,
                       const SineCosine<Number>& c, const Number& one) {
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
  v = {b.cosine * v.x + b.sine * v.z, v.y, b.cosine * v.z - b.sine * v.x};
  return {c.cosine * v.x - c.sine * v.y, c.sine * v.x + c.cosine * v.y, v.z};
}

bool is_quarter(const SineCosine<double>& turn) { return turn.sine == 0 || turn.cosine == 0; }

}  // namespace

void ToolVector::turn(std::size_t axis, const std::array<Count, 3>& degrees) {
  std::array<SineCosine<double>, 3> turn;
  turn[0] = degrees[0].is_zero() ? SineCosine<double>{0, 1} : sine_cosine(degrees[0]);
  const std::array<SineCosine<double>, 2> last = sine_cosine(degrees[1], degrees[2]);
  turn[1] = last[0];
  turn[2] = last[1];
  if (fault(Fault::klartext_rotary_order)) std::swap(turn[0], turn[2]);
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

}  // namespace toolcomp::fast::klartext
