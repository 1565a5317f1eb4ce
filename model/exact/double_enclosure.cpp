// SPDX-License-Identifier: Apache-2.0
#include "model/exact/double_enclosure.h"

#include <bit>
#include <cmath>

#include "model/exact/interval.h"

namespace toolcomp::exact {
namespace {

// Whole numbers up to here are numbers of double.
constexpr std::size_t exact_bits = 53;
constexpr int word_bits = 64;
__extension__ typedef unsigned __int128 TwoWords;  // NOLINT(modernize-use-using): the attribute needs a typedef

// 2^exponent, where that is a normal number.
constexpr int greatest_exponent = 1022;
double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + greatest_exponent + 1) << (exact_bits - 1));
}

// The first 64 bits of a number that is not 0, the rest cut off: it lies between word 2^exponent and (word + 1)
// 2^exponent.
struct Leading {
  std::uint64_t word;
  std::int64_t exponent;
};
Leading leading(mpz_srcptr z) {
  const auto size = static_cast<mp_size_t>(mpz_size(z));
  const mp_limb_t top = mpz_getlimbn(z, size - 1);
  const int zeros = std::countl_zero(top);
  std::uint64_t word = top << zeros;
  if (zeros != 0) word |= mpz_getlimbn(z, size - 2) >> (word_bits - zeros);  // limb -1 is 0
  return {word, static_cast<std::int64_t>(size - 1) * word_bits - zeros};
}

// Of a quotient whose numbers are too large for double, in size; none where it is not well inside the range of double.
std::optional<DoubleEnclosure> quotient_of_large(mpz_srcptr numerator, mpz_srcptr denominator) {
  const Leading n = leading(numerator);
  const Leading d = leading(denominator);
  // Between 2^61 and 2^63; by what was cut off, the quotient is less by 2 at most, or more by 3.
  constexpr int shift = word_bits - 2;
  const auto quotient = static_cast<std::uint64_t>((TwoWords{n.word} << shift) / d.word);
  const std::int64_t exponent = n.exponent - d.exponent - shift;
  if (exponent < -greatest_exponent || exponent > greatest_exponent - word_bits) return std::nullopt;
  // A quotient of words below a power of two is that of numbers below it, so that the double above is enough there.
  const int cut = (quotient >> shift != 0 ? shift + 1 : shift) - static_cast<int>(exact_bits);
  const double unit = power_of_two(static_cast<int>(exponent) + cut);
  return DoubleEnclosure{static_cast<double>((quotient - 2) >> cut) * unit,
                         static_cast<double>(((quotient + 3) >> cut) + 1) * unit};
}

// As mpfr_get_d, in a fifth of its time where there are two limbs.
double rounded(mpfr_srcptr x, mpfr_rnd_t direction) {
  constexpr mpfr_exp_t greatest = 900;
  if (mpfr_get_prec(x) != base_precision || mpfr_regular_p(x) == 0 || mpfr_get_exp(x) > greatest ||
      mpfr_get_exp(x) < -greatest)
    return mpfr_get_d(x, direction);
  const bool negative = mpfr_signbit(x) != 0;
  const auto* const limbs = static_cast<const mp_limb_t*>(mpfr_custom_get_significand(x));
  std::uint64_t digits = limbs[1] >> (word_bits - exact_bits);
  const bool cut = limbs[0] != 0 || limbs[1] << exact_bits != 0;
  if (cut && negative == (direction == MPFR_RNDD)) ++digits;
  const double size =
      static_cast<double>(digits) * power_of_two(static_cast<int>(mpfr_get_exp(x)) - static_cast<int>(exact_bits));
  return negative ? -size : size;
}

bool is_exact(mpz_srcptr z) { return mpz_size(z) <= 1 && mpz_getlimbn(z, 0) >> exact_bits == 0; }
// Of a whole number of double.
double exactly(mpz_srcptr z) {
  const auto size = static_cast<double>(mpz_getlimbn(z, 0));
  return mpz_sgn(z) < 0 ? -size : size;
}

}  // namespace

std::optional<Sign> certain_sign(const DoubleEnclosure& x) {
  if (x.lower > 0) return Sign::positive;
  if (x.upper < 0) return Sign::negative;
  if (x.lower == 0 && x.upper == 0) return Sign::zero;
  return std::nullopt;
}

DoubleEnclosure enclosing(mpz_srcptr numerator, mpz_srcptr denominator) {
  if (mpz_sgn(numerator) == 0) return point(0);
  if (is_exact(numerator) && is_exact(denominator)) {
    const double dividend = exactly(numerator);
    const double divisor = exactly(denominator);
    if (divisor == 1) return point(dividend);
    const double quotient = dividend / divisor;
    // The rest of a division is a number of double, and tells on which side the quotient lies.
    const double rest = std::fma(-quotient, divisor, dividend);
    if (rest == 0) return point(quotient);
    return rest > 0 ? DoubleEnclosure{quotient, above(quotient)} : DoubleEnclosure{below(quotient), quotient};
  }
  if (const auto size = quotient_of_large(numerator, denominator))
    return mpz_sgn(numerator) < 0 ? negate(*size) : *size;
  // Rounded towards zero. Of numbers that double cannot hold GMP promises nothing.
  mpq_t value;
  *mpq_numref(value) = *numerator;  // seen, not copied
  *mpq_denref(value) = *denominator;
  const double magnitude = std::fabs(mpq_get_d(value));
  constexpr double least = std::numeric_limits<double>::min();
  if (!std::isfinite(magnitude)) return whole_line;
  const DoubleEnclosure bounds =
      magnitude < least ? DoubleEnclosure{0, least} : DoubleEnclosure{magnitude, above(magnitude)};
  return mpz_sgn(numerator) < 0 ? negate(bounds) : bounds;
}

DoubleEnclosure enclosing(const Interval& x) { return {rounded(x.lower, MPFR_RNDD), rounded(x.upper, MPFR_RNDU)}; }

// The root of a number of double is rounded correctly, as IEEE 754 asks.
DoubleEnclosure root(const DoubleEnclosure& x) {
  return {x.lower > 0 ? below(std::sqrt(x.lower)) : 0, x.upper > 0 ? above(std::sqrt(x.upper)) : 0};
}

}  // namespace toolcomp::exact
