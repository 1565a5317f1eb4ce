// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/leading_edge_offset/compensation_vector.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "fast/arithmetic/trigonometry.h"
#include "fast/arithmetic/wide.h"

namespace toolcomp::fast {
namespace {

constexpr double u = 0x1p-53;
constexpr std::size_t kX = 0, kY = 1, kZ = 2;

template <class Vector>
auto dot(const Vector& a, const Vector& b) {
  return a[kX] * b[kX] + a[kY] * b[kY] + a[kZ] * b[kZ];
}
template <class Vector>
Vector cross(const Vector& a, const Vector& b) {
  return {a[kY] * b[kZ] - a[kZ] * b[kY], a[kZ] * b[kX] - a[kX] * b[kZ], a[kX] * b[kY] - a[kY] * b[kX]};
}

double largest(const Vector3<double>& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

using WideVector = std::array<Wide, 3>;
WideVector wide(const std::array<Int128, 3>& v) { return {Wide(v[kX]), Wide(v[kY]), Wide(v[kZ])}; }
FineVector fine(const std::array<Int128, 3>& v) {
  return {to_double_double(v[kX]), to_double_double(v[kY]), to_double_double(v[kZ])};
}

bool is_exact(const Displacement& m, const Direction& v) { return v.is_whole && m.slack == 0; }

// How far M.V or a component of M x V in double-double may be from the truth.
double fine_bound(const Displacement& m, const Direction& v) {
  return 3 * v.refined_error() * m.value.norm() + 4 * m.slack;
}

}  // namespace

CompensationVector::CompensationVector(const spec::Decimal& limit) {
  const bool none = limit.negative || limit.is_zero();
  const Count angle = none ? Count() : Count::of(limit);
  const auto degrees = [](int whole) { return Count::of(spec::decimal(whole)); };
  const auto t = fine_sine_cosine(angle);
  sine_.fine = t.sine * t.sine;
  cosine_.fine = t.cosine * t.cosine;
  sine_.value = sine_.fine.hi;
  cosine_.value = cosine_.fine.hi;
  wide_ = degrees(45) < angle;
  constexpr struct {
    int angle, sine, cosine;
  } kRational[] = {{0, 0, 4}, {30, 1, 3}, {45, 2, 2}, {60, 3, 1}, {90, 4, 0}};
  for (const auto& rational : kRational)
    if (angle == degrees(rational.angle)) {
      sine_.quarters = rational.sine;
      cosine_.quarters = rational.cosine;
    }
}

int CompensationVector::dot_sign(const Kinematics& kinematics, const Displacement& m, const Direction& v) {
  const double d = m.value.dot(v.unit);
  if (m.slack == 0) {
    // Every product is exactly zero: the tool stands on an axis and the movement does not use it, and the like.
    unsigned live = 0;
    for (std::size_t i = 0; i < 3; ++i) live |= static_cast<unsigned>(m.value[static_cast<Eigen::Index>(i)] != 0) << i;
    if ((live & ~static_cast<unsigned>(v.zero) & 7U) == 0) return 0;
    const double bound = (2 * v.error + 6 * u) * m.value.norm();
    if (d > bound) return 1;
    if (d < -bound) return -1;
  }
  if (is_exact(m, v)) return dot(wide(m.whole()), wide(v.whole())).sign();
  const double refined = dot(fine(m.whole()), kinematics.refine(v)).hi;
  if (std::abs(refined) <= fine_bound(m, v)) return 0;
  return refined > 0 ? 1 : -1;
}

int CompensationVector::compare(const Kinematics& kinematics, const Displacement& m, const Direction& v, Side side,
                                const Square& limit) {
  const double square = m.value.squaredNorm();
  const double d = m.value.dot(v.unit);
  const double left = side == Side::dot ? d * d : m.value.cross(v.unit).squaredNorm();
  const double estimate = left - limit.value * square;
  const double bound = square_bound(v) * square;
  if (m.slack == 0) {
    if (estimate > bound) return 1;
    if (estimate < -bound) return -1;
  }
  if (is_exact(m, v) && limit.quarters >= 0) {
    const WideVector movement = wide(m.whole());
    const WideVector tool = wide(v.whole());
    Wide squared;
    if (side == Side::dot) {
      const Wide product = dot(movement, tool);
      squared = product * product;
    } else {
      const WideVector c = cross(movement, tool);
      squared = dot(c, c);
    }
    return (squared * Wide(4) - dot(movement, movement) * dot(tool, tool) * Wide(limit.quarters)).sign();
  }
  const FineVector movement = fine(m.whole());
  const FineVector tool = kinematics.refine(v);
  DoubleDouble squared;
  if (side == Side::dot) {
    const DoubleDouble product = dot(movement, tool);
    squared = product * product;
  } else {
    const FineVector c = cross(movement, tool);
    squared = dot(c, c);
  }
  const double refined = (squared - limit.fine * dot(movement, movement)).hi;
  const double error = 2 * fine_bound(m, v);
  const double refined_bound = error * (2 * std::sqrt(left) + error) + 0x1p-98 * limit.value * square;
  if (std::abs(refined) <= refined_bound) return 0;
  return refined > 0 ? 1 : -1;
}

AngleClass CompensationVector::classify(const Kinematics& kinematics, const Displacement& m, const Direction& v) const {
  // A squared sine tells small angles apart, a squared cosine large ones: use the one that is at most 1/2.
  const int parallel =
      wide_ ? -compare(kinematics, m, v, Side::dot, cosine_) : compare(kinematics, m, v, Side::cross, sine_);
  const bool is_parallel = parallel <= 0;
  const int sign = dot_sign(kinematics, m, v);
  if (is_parallel && sign > 0) return AngleClass::near_0;
  if (is_parallel && sign < 0) return AngleClass::near_180;
  if (sign == 0) return AngleClass::near_90;
  const int square =
      wide_ ? -compare(kinematics, m, v, Side::cross, cosine_) : compare(kinematics, m, v, Side::dot, sine_);
  if (square <= 0) return AngleClass::near_90;
  return sign > 0 ? AngleClass::below_90 : AngleClass::above_90;
}

Vector3<double> CompensationVector::fine_backward(const Kinematics& kinematics, const Displacement& m,
                                                  const Direction& v, double sine) {
  // Products of few digits are whole doubles, and so are their differences: nothing is lost where they cancel. The
  // second product is of vectors at right angles.
  if (is_exact(m, v) && m.narrow && v.narrow) {
    const Vector3<double> way{m.value[0], m.value[1], m.value[2]};
    const auto of_whole = [&](std::size_t i) { return static_cast<double>(v.small[i]); };
    const Vector3<double> tool{of_whole(kX), of_whole(kY), of_whole(kZ)};
    constexpr double kMost = 0x1p52;
    if (largest(way) * largest(tool) <= kMost) [[likely]]
      return cross(cross(way, tool), tool);
  }
  // Of rotary axes: what the extended direction lacks is below 2^-56 of a product with such a sine, less than its
  // rounding.
  constexpr double kLeastSine = 0x1p-7;
  const FineVector* const extended = m.narrow && sine >= kLeastSine ? kinematics.extended(v) : nullptr;
  if (extended != nullptr) [[likely]] {
    const auto component = [&](std::size_t i, std::size_t k) {
      return ((*extended)[k] * m.value[static_cast<Eigen::Index>(i)] -
              (*extended)[i] * m.value[static_cast<Eigen::Index>(k)])
          .hi;
    };
    return cross(Vector3<double>{component(kY, kZ), component(kZ, kX), component(kX, kY)},
                 Vector3<double>{v.unit[0], v.unit[1], v.unit[2]});
  }
  // Double-double loses as many of its 98 bits as the sine has leading zeros: enough down to 2^-30 for a double. Below
  // that whole numbers are exact; a direction from rotary axes has no better numbers, nor could it use them.
  if (is_exact(m, v) && sine < 0x1p-30) {
    const WideVector tool = wide(v.whole());
    const WideVector exact = cross(cross(wide(m.whole()), tool), tool);
    return {exact[kX].to_double(), exact[kY].to_double(), exact[kZ].to_double()};
  }
  const FineVector tool = v.is_whole ? fine(v.whole()) : kinematics.refine(v);
  const FineVector refined = cross(cross(fine(m.whole()), tool), tool);
  return {refined[kX].hi, refined[kY].hi, refined[kZ].hi};
}

}  // namespace toolcomp::fast
