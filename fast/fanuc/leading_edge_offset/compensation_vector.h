// SPDX-License-Identifier: Apache-2.0
// The compensation vector of leading edge offset: which way it points (fanuc.leading-edge.vector, sign) and how it is
// classified (near-0, near-90, near-180).
#pragma once

#include <cmath>
#include <cstdint>

#include "fast/arithmetic/double_double.h"
#include "fast/geometry/displacement.h"
#include "fast/geometry/vector3.h"
#include "fast/kinematics/kinematics.h"
#include "spec/language/decimal.h"

namespace toolcomp::fast {

// The angle between movement and tool direction, by the ranges of parameter 19631.
enum class AngleClass : std::uint8_t { near_0, near_180, near_90, below_90, above_90 };

// How a movement stands to the tool.
struct Lean {
  AngleClass angle = AngleClass::near_90;
  Vector3<double> backward;  // along (VM x VT) x VT; not set near 0 and 180 degrees
  double norm = 1;           // of `backward`
};

// Decisions go through three levels, each used only where the one before cannot tell:
//  1. doubles with the bounds below;
//  2. whole numbers of 512 bits, where movement and tool direction are whole and the limit is 0, 30, 45, 60 or 90
//     degrees, the only rational ones whose sine squared is rational (Niven);
//  3. double-double, relative 2^-98. What it cannot tell is taken for an exact tie: decimals of 15 digits reach such
//     closeness only when they are made for it, and then they lie inside the band in which both outcomes are right.
//
// Level 1, u = 2^-53, m the rounded movement (|m_i - M_i| <= u |M_i|), v the rounded direction (|v_i - V_i| <= e):
//   d = m.v: |d - M.V| <= (sqrt 3 e + u + 3u + slack) |m|;
//   c = m x v: each component (e + 4u)(|m_j| + |m_k|), so |c - M x V| <= sqrt 6 (e + 4u) |m|;
//   d^2, |c|^2 are at most |m|^2, so their errors are at most 2 sqrt 6 (e + 4u) |m|^2 < 5 (e + 4u) |m|^2,
//   plus 8u |m|^2 for squares, sums and the product with the limit.
class CompensationVector {
 public:
  // `limit`: 19631 in degrees, at most 90; 0 or less classifies exact 0, 90 and 180 only.
  explicit CompensationVector(const spec::Decimal& limit);

  [[nodiscard]] Lean lean(const Kinematics& kinematics, const Displacement& m, const Direction& v) const;
  // The sign of M.V.
  [[nodiscard]] static int dot_sign(const Kinematics& kinematics, const Displacement& m, const Direction& v);

 private:
  // A squared sine or cosine.
  struct Square {
    double value = 0;
    DoubleDouble fine;
    int quarters = -1;  // 4 times the value, where that is whole
  };
  enum class Side : std::uint8_t { dot, cross };
  // The sign of (M.V)^2 or |M x V|^2 minus limit * |M|^2 |V|^2.
  static int compare(const Kinematics& kinematics, const Displacement& m, const Direction& v, Side side,
                     const Square& limit);

  [[nodiscard]] AngleClass classify(const Kinematics& kinematics, const Displacement& m, const Direction& v) const;
  // (M x V) x V without the cancellation that doubles suffer near 0 and 180 degrees.
  // `sine` is about |M x V| / |M||V|.
  [[nodiscard]] static Vector3<double> fine_backward(const Kinematics& kinematics, const Displacement& m,
                                                     const Direction& v, double sine);

  Square sine_;
  Square cosine_;
  bool wide_ = false;  // the limit is above 45 degrees
};

// How far the square of d or |c| in doubles may be from the truth, over |m|^2.
inline double square_bound(const Direction& v) {
  constexpr double kRounding = 0x1p-53;
  return 5 * (v.error + 4 * kRounding) + 8 * kRounding;
}

// Every block: level 1 is here, for the usual angles.
[[gnu::always_inline]] inline Lean CompensationVector::lean(const Kinematics& kinematics, const Displacement& m,
                                                            const Direction& v) const {
  const Vector3<double> way{m.value[0], m.value[1], m.value[2]};
  const Vector3<double> tool{v.unit[0], v.unit[1], v.unit[2]};
  const double square = dot(way, way);
  const double d = dot(way, tool);
  const double d2 = d * d;
  const Vector3<double> c = cross(way, tool);
  const double c2 = dot(c, c);
  Lean lean;
  const double bound = square_bound(v) * square;
  const double off_axis = wide_ ? cosine_.value * square - d2 : c2 - sine_.value * square;
  const double off_right = wide_ ? cosine_.value * square - c2 : d2 - sine_.value * square;
  const bool apart = off_axis > bound && m.slack == 0;
  if (apart && off_right > bound && d2 > bound) [[likely]]
    // Away from 0 and 180 and from the limits about 90, and d^2 exceeds its error: the sign of d is certain.
    lean.angle = d > 0 ? AngleClass::below_90 : AngleClass::above_90;
  else if (apart && off_right < -bound)
    // Between the limits about 90 degrees, whatever the sign.
    lean.angle = AngleClass::near_90;
  else
    lean.angle = classify(kinematics, m, v);
  if (lean.angle == AngleClass::near_0 || lean.angle == AngleClass::near_180) [[unlikely]]
    return lean;
  // Cancellation in the product grows as the movement nears the tool direction: beyond 30 degrees it costs at most a
  // factor 2, nearer the product is made without it.
  if (4 * c2 >= square) [[likely]]
    lean.backward = cross(c, tool);
  else
    lean.backward = fine_backward(kinematics, m, v, std::sqrt(c2 / square));
  lean.norm = std::sqrt(dot(lean.backward, lean.backward));
  return lean;
}

}  // namespace toolcomp::fast
