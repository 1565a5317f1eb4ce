// SPDX-License-Identifier: Apache-2.0
#include "model/exact/double_enclosure.h"

#include <cmath>

#include "model/exact/interval.h"

namespace toolcomp::exact {
namespace {

// Whole numbers up to here are numbers of double.
constexpr std::size_t exact_bits = 53;

bool is_exact(const mpz_t value) { return mpz_sizeinbase(value, 2) <= exact_bits; }

}  // namespace

std::optional<Sign> certain_sign(const DoubleEnclosure& x) {
  if (x.lower > 0) return Sign::positive;
  if (x.upper < 0) return Sign::negative;
  if (x.lower == 0 && x.upper == 0) return Sign::zero;
  return std::nullopt;
}

DoubleEnclosure enclosing(const mpq_t value) {
  if (is_exact(mpq_numref(value)) && is_exact(mpq_denref(value))) {
    const double numerator = mpz_get_d(mpq_numref(value));
    const double denominator = mpz_get_d(mpq_denref(value));
    if (denominator == 1) return point(numerator);
    const double quotient = numerator / denominator;
    return {below(quotient), above(quotient)};
  }
  // Rounded towards zero. Of numbers that double cannot hold GMP promises nothing.
  const double magnitude = std::fabs(mpq_get_d(value));
  constexpr double least = std::numeric_limits<double>::min();
  if (!std::isfinite(magnitude)) return whole_line;
  const DoubleEnclosure bounds =
      magnitude < least ? DoubleEnclosure{0, least} : DoubleEnclosure{magnitude, above(magnitude)};
  return mpq_sgn(value) < 0 ? negate(bounds) : bounds;
}

DoubleEnclosure enclosing(const Interval& x) {
  return {mpfr_get_d(x.lower, MPFR_RNDD), mpfr_get_d(x.upper, MPFR_RNDU)};
}

// The root of a number of double is rounded correctly, as IEEE 754 asks.
DoubleEnclosure root(const DoubleEnclosure& x) {
  return {x.lower > 0 ? below(std::sqrt(x.lower)) : 0, x.upper > 0 ? above(std::sqrt(x.upper)) : 0};
}

}  // namespace toolcomp::exact
