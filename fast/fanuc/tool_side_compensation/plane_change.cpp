// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_side_compensation/plane_change.h"

#include <cmath>
#include <cstdlib>

#include "fast/arithmetic/trigonometry.h"
#include "fast/arithmetic/wide.h"
#include "spec/language/input_error.h"

namespace toolcomp::fast {

PlaneChangeLimit::PlaneChangeLimit(const spec::Setup& setup) {
  const auto degrees = [](int whole) { return Count::of(spec::decimal(whole)); };
  Count angle = degrees(45);
  if (const auto value = setup.parameter(6261); value && !value->is_zero()) {
    if (!fits_count(*value) || value->negative || degrees(180) < Count::of(*value))
      throw spec::InputError("setup", 0, 0, "parameters.\"6261\": must be from 0 to 180 degrees");
    angle = Count::of(*value);
  }
  cosine_ = fine_sine_cosine(angle).cosine;
  constexpr struct {
    int angle, quarters;
  } kRational[] = {{30, 3}, {45, 2}, {60, 1}, {90, 0}, {120, -1}, {135, -2}, {150, -3}, {180, -4}};
  for (const auto& rational : kRational)
    if (angle == degrees(rational.angle)) {
      rational_ = true;
      quarters_ = rational.quarters;
    }
}

bool PlaneChangeLimit::reached(const Kinematics& kinematics, const Direction& first, const Direction& second) const {
  const double product = first.unit.dot(second.unit);
  const double over = product - cosine_.hi;
  const double bound = 2 * (first.error + second.error) + 6 * 0x1p-53;
  if (std::abs(over) > bound) [[likely]]
    return over < 0;
  if (first.is_whole && second.is_whole && rational_) {
    const std::array<Int128, 3> a = first.whole();
    const std::array<Int128, 3> b = second.whole();
    Wide dot;
    Wide square1;
    Wide square2;
    for (std::size_t i = 0; i < 3; ++i) {
      dot = dot + Wide(a[i]) * Wide(b[i]);
      square1 = square1 + Wide(a[i]) * Wide(a[i]);
      square2 = square2 + Wide(b[i]) * Wide(b[i]);
    }
    // The signs of the cosines are those of dot and of the limit; within them the squares compare.
    const int sign = dot.sign();
    const int limit_sign = quarters_ > 0 ? 1 : (quarters_ < 0 ? -1 : 0);
    if (sign != limit_sign) return sign < limit_sign;
    const int larger = (dot * dot * Wide(4) - square1 * square2 * Wide(std::abs(quarters_))).sign();
    return sign * larger <= 0;  // the cosine is not above that of the limit
  }
  const FineVector a = kinematics.refine(first);  // by value: refining the other one takes its place
  const FineVector& b = kinematics.refine(second);
  DoubleDouble refined = -cosine_;
  for (std::size_t i = 0; i < 3; ++i) refined = refined + a[i] * b[i];
  const double tie = 4 * (first.refined_error() + second.refined_error()) + 0x1p-96;
  return refined.hi <= tie;
}

}  // namespace toolcomp::fast
