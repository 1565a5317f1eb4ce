// SPDX-License-Identifier: Apache-2.0
// Where two offset paths meet: the formulas, over double or DoubleDouble.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "fast/arithmetic/double_double.h"
#include "fast/arithmetic/trigonometry.h"
#include "fast/geometry/heading.h"
#include "fast/geometry/vector2.h"

namespace toolcomp::fast {

// One derivation serves lines and arcs of every combination. With p the signed curvature (+1/R counterclockwise, 0 for
// a line), c = t1 x t2, k = t1 . t2 and
//   e = rho (p1 + p2 - rho p1 p2), that is 1 - e = (1 - rho p1)(1 - rho p2), the product of the radii of the offset
//       circles over the radii,
// the offset paths meet where 1 + k - 2 e >= 0, and the vector X to the nearer point is
//   X = [rho (p1 - p2)(a N1 - b t1) + sign(c) S (a t1 + b N1)] / (a^2 + b^2),   a = p1 k - p2, b = p1 c,
//   S = sqrt(1 - k)(sqrt(1 + k) - sqrt(1 + k - 2 e)) = 2 e sqrt(1 - k) / (sqrt(1 + k) + sqrt(1 + k - 2 e)).
// a^2 + b^2 is the squared distance of the centres over (R1 R2)^2, S is free of cancellation, and the two brackets are
// perpendicular. A latter path offset to the other side is the same path run backward: c, k and p2 change their signs.
template <class T>
struct OffsetMeeting {
  Vector2<T> t1;
  Vector2<T> t2;
  T c{};
  T k{};
  T plus{};   // 1 + k
  T minus{};  // 1 - k
  T p1{};
  T p2{};
  T rho{};
  T rho2{};
  T r{};
  int turned = 0;  // the sign of c
};

// Two quotients, two roots: in doubles side by side, which takes as long as one.
inline std::array<double, 2> quotients(double a, double b, double c, double d) {
  const DoublePair both = DoublePair{a, c} / DoublePair{b, d};
  return {both[0], both[1]};
}
inline std::array<DoubleDouble, 2> quotients(const DoubleDouble& a, const DoubleDouble& b, const DoubleDouble& c,
                                             const DoubleDouble& d) {
  return {a / b, c / d};
}

// 1 + k and 1 - k free of cancellation.
template <class T>
void complete(OffsetMeeting<T>& n) {
  if (leading(n.k) >= 0) {
    n.plus = number<T>(1) + n.k;
    n.minus = n.c * n.c / n.plus;
  } else {
    n.minus = number<T>(1) - n.k;
    n.plus = n.c * n.c / n.minus;
  }
}

// c, k and what follows from them, as complete() does, without a quotient of a quotient.
inline void set_turn(OffsetMeeting<double>& n, const Turn& turn) {
  const auto [c, k] = quotients(turn.c, turn.norms, turn.k, turn.norms);
  n.c = c;
  n.k = k;
  const double square = turn.c * turn.c;
  if (turn.k >= 0) {
    n.plus = 1 + n.k;
    n.minus = square / (turn.norms * (turn.norms + turn.k));
  } else {
    n.minus = 1 - n.k;
    n.plus = square / (turn.norms * (turn.norms - turn.k));
  }
  n.turned = sign_of(turn.c);
}

template <class T>
T curvature_term(const OffsetMeeting<T>& n) {
  return n.rho * (n.p1 + n.p2 - n.rho * n.p1 * n.p2);
}

// What errors of 1 + k - 2 e are relative to.
template <class T>
double discriminant_scale(const OffsetMeeting<T>& n) {
  const double first = std::abs(leading(n.rho) * leading(n.p1));
  const double second = std::abs(leading(n.rho) * leading(n.p2));
  return leading(n.plus) + 2 * (first + second + first * second);
}

// Down to which (a^2 + b^2) / (p1^2 + p2^2) doubles make the vector of paths_meet well. The error of a curvature moves
// it along the path only, by rho p b / (a^2 + b^2) times as much, which is little where the paths hardly turn; the
// error of a turn that is not exact by rho p / sqrt(a^2 + b^2).
inline double least_spread(double turn_error, double c) {
  return std::clamp(std::max(std::abs(c) / 4, 0x1p-6 * turn_error * turn_error), 0x1p-20, 0x1p-6);
}

// Far from tangent contact and from equal circles: doubles make the vector of paths_meet well. `discriminant`: 1 + k -
// 2 e; `turn_error`: Turn::error.
inline bool doubles_suffice(const OffsetMeeting<double>& n, double discriminant, double turn_error) {
  const double difference = n.p1 - n.p2;
  const double spread = difference * difference + 2 * n.p1 * n.p2 * n.minus;
  return discriminant >= 0x1p-6 * discriminant_scale(n) &&
         spread >= least_spread(turn_error, n.c) * (n.p1 * n.p1 + n.p2 * n.p2);
}

// `discriminant`: 1 + k - 2 e, not negative.
template <class T>
Vector2<T> paths_meet(const OffsetMeeting<T>& n, const T& e, const T& discriminant) {
  const T sum = root(n.plus) + root(discriminant);
  const T difference = n.p1 - n.p2;
  const T a = leading(n.k) >= 0 ? difference - n.p1 * n.minus : n.p1 * n.plus - (n.p1 + n.p2);
  const T b = n.p1 * n.c;
  const Vector2<T> n1 = left_of(n.t1);
  const Vector2<T> across = n1 * a - n.t1 * b;
  const Vector2<T> along = n.t1 * a + n1 * b;
  const T square = a * a + b * b;
  auto [s, q] = quotients(number<T>(2) * e * root(n.minus), sum * square, n.rho * difference, square);
  if (n.turned < 0) s = -s;
  return {across.x * q + along.x * s, across.y * q + along.y * s};
}

}  // namespace toolcomp::fast
