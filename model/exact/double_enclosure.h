// SPDX-License-Identifier: Apache-2.0
// Enclosures with ends in double. They are wider than those of MPFR, and take a twentieth of the time. Most signs are
// certain with them. Each operation is rounded to nearest, and its ends are moved outwards by one number, so that they
// contain every value that the operation takes on points of its operands.
#pragma once

#include <gmp.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>

#include "model/exact/real.h"

namespace toolcomp::exact {

struct Interval;

// Ends may be infinite, never NaN.
inline constexpr DoubleEnclosure whole_line{-std::numeric_limits<double>::infinity(),
                                            std::numeric_limits<double>::infinity()};

/// The double before x. NaN, of which nothing is known, becomes the lowest value.
constexpr double below(double x) {
  if (!(x > whole_line.lower)) return whole_line.lower;
  if (x == 0) return -std::numeric_limits<double>::denorm_min();
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(x) + (x > 0 ? -1 : 1));
}
/// The double after x; NaN becomes the greatest value.
constexpr double above(double x) { return -below(-x); }

constexpr DoubleEnclosure point(double x) { return {x, x}; }
constexpr bool is_finite(const DoubleEnclosure& x) { return x.lower > whole_line.lower && x.upper < whole_line.upper; }

/// The enclosure of four numbers that were rounded to nearest.
constexpr DoubleEnclosure around(double a, double b, double c, double d) {
  // NOLINTNEXTLINE(modernize-min-max-use-initializer-list): a list is walked in memory
  return {below(std::min(std::min(a, b), std::min(c, d))), above(std::max(std::max(a, b), std::max(c, d)))};
}

/// As in interval.h.
std::optional<Sign> certain_sign(const DoubleEnclosure& x);

/// numerator / denominator, which may have a common divisor; the second is positive.
DoubleEnclosure enclosing(mpz_srcptr numerator, mpz_srcptr denominator);
DoubleEnclosure enclosing(const Interval& x);
/// The common part of two enclosures of one value.
constexpr DoubleEnclosure intersection(const DoubleEnclosure& x, const DoubleEnclosure& y) {
  return {std::max(x.lower, y.lower), std::min(x.upper, y.upper)};
}

constexpr DoubleEnclosure negate(const DoubleEnclosure& x) { return {-x.upper, -x.lower}; }
constexpr DoubleEnclosure add(const DoubleEnclosure& x, const DoubleEnclosure& y) {
  return {below(x.lower + y.lower), above(x.upper + y.upper)};
}
constexpr DoubleEnclosure subtract(const DoubleEnclosure& x, const DoubleEnclosure& y) { return add(x, negate(y)); }
constexpr DoubleEnclosure multiply(const DoubleEnclosure& x, const DoubleEnclosure& y) {
  if (!is_finite(x) || !is_finite(y)) return whole_line;
  return around(x.lower * y.lower, x.lower * y.upper, x.upper * y.lower, x.upper * y.upper);
}
constexpr DoubleEnclosure square(const DoubleEnclosure& x) {
  const DoubleEnclosure product = multiply(x, x);
  if (x.lower > 0 || x.upper < 0) return {std::max(product.lower, 0.0), product.upper};
  return {0, product.upper};
}
/// The divisor is not zero, though its enclosure may contain zero. Then the result contains every real number.
constexpr DoubleEnclosure divide(const DoubleEnclosure& x, const DoubleEnclosure& y) {
  if (!is_finite(x) || !is_finite(y) || (y.lower <= 0 && y.upper >= 0)) return whole_line;
  return around(x.lower / y.lower, x.lower / y.upper, x.upper / y.lower, x.upper / y.upper);
}
/// The argument is not negative. Its enclosure may reach below zero, and is clamped at zero.
DoubleEnclosure root(const DoubleEnclosure& x);

// Angles are in degrees.
DoubleEnclosure sine(const DoubleEnclosure& angle);
DoubleEnclosure cosine(const DoubleEnclosure& angle);
DoubleEnclosure arctangent(const DoubleEnclosure& tangent);

/// The number pi, between two neighbours.
// NOLINTNEXTLINE(modernize-use-std-numbers): which side of pi that constant lies on is not said
inline constexpr DoubleEnclosure pi_in_double{0x1.921fb54442d18p+1, 0x1.921fb54442d19p+1};

}  // namespace toolcomp::exact
