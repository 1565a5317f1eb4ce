// SPDX-License-Identifier: Apache-2.0
// Double-double numbers: an unevaluated sum hi + lo with |lo| <= ulp(hi) / 2, about 106 bits.
// Error bounds (Joldes, Muller, Popescu, "Tight and rigorous error bounds for basic building blocks of double-word
// arithmetic", 2017), u = 2^-53: sum 3u^2 (relative to the operands' magnitudes here, which is what cancellation
// leaves), product 5u^2, both relative. Rounding must be to nearest and products must not be contracted.
#pragma once

#include <cmath>

#include "fast/arithmetic/int128.h"

namespace toolcomp::fast {

// -1, 0 or 1.
inline int sign_of(double value) { return static_cast<int>(value > 0) - static_cast<int>(value < 0); }

struct DoubleDouble {
  double hi = 0;
  double lo = 0;
};

// a + b = hi + lo exactly.
constexpr DoubleDouble two_sum(double a, double b) {
  const double s = a + b;
  const double t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

// The same where |a| >= |b| or a = 0.
constexpr DoubleDouble quick_two_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

// a * b = hi + lo exactly (Dekker), for |a|, |b| below 2^996 and products that do not underflow.
constexpr DoubleDouble two_product(double a, double b) {
  constexpr double kSplit = 134217729.0;  // 2^27 + 1
  const double p = a * b;
  const double ca = kSplit * a;
  const double ah = ca - (ca - a);
  const double al = a - ah;
  const double cb = kSplit * b;
  const double bh = cb - (cb - b);
  const double bl = b - bh;
  return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

constexpr DoubleDouble operator-(const DoubleDouble& a) { return {-a.hi, -a.lo}; }

constexpr DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble s = two_sum(a.hi, b.hi);
  const DoubleDouble t = two_sum(a.lo, b.lo);
  const DoubleDouble v = quick_two_sum(s.hi, s.lo + t.hi);
  return quick_two_sum(v.hi, v.lo + t.lo);
}

constexpr DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }

constexpr DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble p = two_product(a.hi, b.hi);
  return quick_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

constexpr DoubleDouble operator*(const DoubleDouble& a, double b) {
  const DoubleDouble p = two_product(a.hi, b);
  return quick_two_sum(p.hi, p.lo + a.lo * b);
}

constexpr DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double q1 = a.hi / b.hi;
  const DoubleDouble r = a - b * q1;
  const double q2 = r.hi / b.hi;
  const DoubleDouble s = r - b * q2;
  const DoubleDouble q = quick_two_sum(q1, q2);
  return q + DoubleDouble{s.hi / b.hi, 0};
}

// For a >= 0.
inline DoubleDouble sqrt(const DoubleDouble& a) {
  if (a.hi <= 0) return {};
  const double root = std::sqrt(a.hi);
  const DoubleDouble r = a - two_product(root, root);
  const DoubleDouble first = quick_two_sum(root, r.hi / (2 * root));
  const DoubleDouble rest = a - first * first;
  return first + DoubleDouble{rest.hi / (2 * root), 0};
}

// A whole number as a double-double; relative error at most 2^-106 (exact below 2^106).
constexpr DoubleDouble to_double_double(Int128 value) {
  const auto hi = static_cast<double>(value);
  // |value| <= 2^126, so hi fits back into 128 bits and the difference is exact before it is rounded.
  return quick_two_sum(hi, static_cast<double>(value - static_cast<Int128>(hi)));
}

constexpr double to_double(const DoubleDouble& a) { return a.hi + a.lo; }

}  // namespace toolcomp::fast
