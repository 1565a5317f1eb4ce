// SPDX-License-Identifier: Apache-2.0
#include "model/exact/interval.h"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace toolcomp::exact {
namespace {

// Infinite endpoints can meet as inf - inf or 0 * inf; the bound is then unknown.
void repair(Interval& x) {
  if (mpfr_nan_p(x.lower)) mpfr_set_inf(x.lower, -1);
  if (mpfr_nan_p(x.upper)) mpfr_set_inf(x.upper, +1);
}

void set_whole_line(Interval& x) {
  mpfr_set_inf(x.lower, -1);
  mpfr_set_inf(x.upper, +1);
}

enum class Side { positive, negative, both };

// Zero endpoints count to the side of the other endpoint, which is right for products.
Side side(const Interval& x) {
  if (mpfr_sgn(x.lower) >= 0) return Side::positive;
  if (mpfr_sgn(x.upper) <= 0) return Side::negative;
  return Side::both;
}

void multiply_ends(Interval& result, const mpfr_t a, const mpfr_t b, const mpfr_t c, const mpfr_t d) {
  mpfr_mul(result.lower, a, b, MPFR_RNDD);
  mpfr_mul(result.upper, c, d, MPFR_RNDU);
}

// Both operands hold zero inside: the extremes are among two products each.
void multiply_mixed(Interval& result, const Interval& x, const Interval& y) {
  HeapInterval other(result.precision());
  multiply_ends(result, x.lower, y.upper, x.lower, y.lower);
  multiply_ends(other, x.upper, y.lower, x.upper, y.upper);
  if (mpfr_less_p(other.lower, result.lower)) mpfr_set(result.lower, other.lower, MPFR_RNDD);
  if (mpfr_greater_p(other.upper, result.upper)) mpfr_set(result.upper, other.upper, MPFR_RNDU);
}

// A number of two limbs.
struct Digits {
  std::array<mp_limb_t, 2> limbs{};
  mpfr_exp_t exponent = 0;

  void increase() {
    for (mp_limb_t& limb : limbs)
      if (++limb != 0) return;
    limbs[1] = mp_limb_t{1} << (GMP_NUMB_BITS - 1);
    ++exponent;
  }
  void put(mpfr_ptr x, bool negative) const {
    auto* const significand = static_cast<mp_limb_t*>(mpfr_custom_get_significand(x));
    significand[0] = limbs[0];
    significand[1] = limbs[1];
    mpfr_custom_init_set(x, negative ? -MPFR_REGULAR_KIND : MPFR_REGULAR_KIND, exponent, base_precision, significand);
  }
};

// By a quotient of 129 bits or more, cut off behind 128; in a quarter of MPFR's time. Of longer numbers false.
bool set_at_base_precision(Interval& result, mpz_srcptr numerator, mpz_srcptr denominator) {
  constexpr std::size_t most = 16;
  constexpr std::size_t limbs_for_129_bits = 3;
  const std::size_t size = mpz_size(numerator);
  const std::size_t divisor = mpz_size(denominator);
  if (result.precision() != base_precision || size == 0 || size > most || divisor > most) return false;
  const std::size_t wanted = divisor + limbs_for_129_bits;
  const std::size_t added = size < wanted ? wanted - size : 0;
  using Limbs = std::array<mp_limb_t, 2 * most + limbs_for_129_bits>;
  Limbs quotient;  // NOLINT(cppcoreguidelines-pro-type-member-init): what is read of it is written
  bool inexact = false;
  std::size_t last = size + added - divisor;
  if (divisor == 1) {
    inexact = mpn_divrem_1(quotient.data(), static_cast<mp_size_t>(added), mpz_limbs_read(numerator),
                           static_cast<mp_size_t>(size), mpz_getlimbn(denominator, 0)) != 0;
  } else {
    Limbs dividend;  // NOLINT(cppcoreguidelines-pro-type-member-init)
    Limbs rest;      // NOLINT(cppcoreguidelines-pro-type-member-init)
    std::fill_n(dividend.begin(), added, 0);
    std::copy_n(mpz_limbs_read(numerator), size, dividend.begin() + static_cast<std::ptrdiff_t>(added));
    mpn_tdiv_qr(quotient.data(), rest.data(), 0, dividend.data(), static_cast<mp_size_t>(size + added),
                mpz_limbs_read(denominator), static_cast<mp_size_t>(divisor));
    inexact = mpn_zero_p(rest.data(), static_cast<mp_size_t>(divisor)) == 0;
  }
  if (quotient.at(last) == 0) --last;
  const auto zeros = static_cast<unsigned>(std::countl_zero(quotient.at(last)));
  const auto from = [&](std::size_t limb) {
    return zeros == 0 ? quotient.at(limb)
                      : quotient.at(limb) << zeros | quotient.at(limb - 1) >> (GMP_NUMB_BITS - zeros);
  };
  Digits digits{{from(last - 1), from(last)},
                GMP_NUMB_BITS * (static_cast<mpfr_exp_t>(last + 1) - static_cast<mpfr_exp_t>(added)) -
                    static_cast<mpfr_exp_t>(zeros)};
  inexact = inexact || quotient.at(last - 2) << zeros != 0 ||
            (last > 2 && mpn_zero_p(quotient.data(), static_cast<mp_size_t>(last - 2)) == 0);
  const bool negative = mpz_sgn(numerator) < 0;
  digits.put(negative ? result.upper : result.lower, negative);
  if (inexact) digits.increase();
  digits.put(negative ? result.lower : result.upper, negative);
  return true;
}

}  // namespace

InlineInterval::InlineInterval() {
  mpfr_custom_init_set(lower, MPFR_ZERO_KIND, 0, base_precision, lower_limbs_.data());
  mpfr_custom_init_set(upper, MPFR_ZERO_KIND, 0, base_precision, upper_limbs_.data());
}

HeapInterval::HeapInterval(mpfr_prec_t precision) {
  mpfr_inits2(precision, lower, upper, static_cast<mpfr_ptr>(nullptr));
}
HeapInterval::~HeapInterval() { mpfr_clears(lower, upper, static_cast<mpfr_ptr>(nullptr)); }

std::optional<Sign> certain_sign(const Interval& x) {
  if (mpfr_sgn(x.lower) > 0) return Sign::positive;
  if (mpfr_sgn(x.upper) < 0) return Sign::negative;
  if (mpfr_zero_p(x.lower) && mpfr_zero_p(x.upper)) return Sign::zero;
  return std::nullopt;
}

void set(Interval& result, mpz_srcptr numerator, mpz_srcptr denominator) {
  if (set_at_base_precision(result, numerator, denominator)) return;
  mpq_t value;
  *mpq_numref(value) = *numerator;  // seen, not copied
  *mpq_denref(value) = *denominator;
  const int inexact = mpfr_set_q(result.lower, value, MPFR_RNDD);
  mpfr_set(result.upper, result.lower, MPFR_RNDU);
  // Rounded down, the value lies strictly between this number and the next.
  if (inexact != 0) mpfr_nextabove(result.upper);
}

void set(Interval& result, const mpz_t value) {
  mpfr_set_z(result.lower, value, MPFR_RNDD);
  mpfr_set_z(result.upper, value, MPFR_RNDU);
}

void set(Interval& result, const Interval& x) {
  mpfr_set(result.lower, x.lower, MPFR_RNDD);
  mpfr_set(result.upper, x.upper, MPFR_RNDU);
}

void intersect(Interval& result, const Interval& x) {
  if (mpfr_greater_p(x.lower, result.lower)) mpfr_set(result.lower, x.lower, MPFR_RNDD);
  if (mpfr_less_p(x.upper, result.upper)) mpfr_set(result.upper, x.upper, MPFR_RNDU);
}

void negate(Interval& result, const Interval& x) {
  mpfr_neg(result.lower, x.upper, MPFR_RNDD);
  mpfr_neg(result.upper, x.lower, MPFR_RNDU);
}

void add(Interval& result, const Interval& x, const Interval& y) {
  mpfr_add(result.lower, x.lower, y.lower, MPFR_RNDD);
  mpfr_add(result.upper, x.upper, y.upper, MPFR_RNDU);
  repair(result);
}

void subtract(Interval& result, const Interval& x, const Interval& y) {
  mpfr_sub(result.lower, x.lower, y.upper, MPFR_RNDD);
  mpfr_sub(result.upper, x.upper, y.lower, MPFR_RNDU);
  repair(result);
}

void multiply(Interval& result, const Interval& x, const Interval& y) {
  const Side of_x = side(x);
  const Side of_y = side(y);
  if (of_x == Side::both && of_y == Side::both) {
    multiply_mixed(result, x, y);
  } else {
    // The end of one operand that gives a bound is told by the side of the other.
    const auto* low_x = of_y == Side::positive || (of_y == Side::both && of_x == Side::negative) ? x.lower : x.upper;
    const auto* low_y = of_x == Side::positive || (of_x == Side::both && of_y == Side::negative) ? y.lower : y.upper;
    const auto* high_x = of_y == Side::negative || (of_y == Side::both && of_x == Side::negative) ? x.lower : x.upper;
    const auto* high_y = of_x == Side::negative || (of_x == Side::both && of_y == Side::negative) ? y.lower : y.upper;
    multiply_ends(result, low_x, low_y, high_x, high_y);
  }
  repair(result);
}

void square(Interval& result, const Interval& x) {
  switch (side(x)) {
    case Side::positive:
      mpfr_sqr(result.lower, x.lower, MPFR_RNDD);
      mpfr_sqr(result.upper, x.upper, MPFR_RNDU);
      break;
    case Side::negative:
      mpfr_sqr(result.lower, x.upper, MPFR_RNDD);
      mpfr_sqr(result.upper, x.lower, MPFR_RNDU);
      break;
    case Side::both:
      mpfr_set_zero(result.lower, +1);
      mpfr_sqr(result.upper, mpfr_cmpabs(x.lower, x.upper) > 0 ? x.lower : x.upper, MPFR_RNDU);
      break;
  }
}

void divide(Interval& result, const Interval& x, const Interval& y) {
  if (mpfr_sgn(y.lower) <= 0 && mpfr_sgn(y.upper) >= 0) {
    set_whole_line(result);
    return;
  }
  const bool positive = mpfr_sgn(y.lower) > 0;
  const auto* low_x = positive ? x.lower : x.upper;
  const auto* high_x = positive ? x.upper : x.lower;
  // The end of the divisor that gives a bound is told by the sign of the dividend's end alone.
  mpfr_div(result.lower, low_x, mpfr_sgn(low_x) >= 0 ? y.upper : y.lower, MPFR_RNDD);
  mpfr_div(result.upper, high_x, mpfr_sgn(high_x) >= 0 ? y.lower : y.upper, MPFR_RNDU);
  repair(result);
}

void root(Interval& result, const Interval& x) {
  if (mpfr_sgn(x.lower) > 0)
    mpfr_sqrt(result.lower, x.lower, MPFR_RNDD);
  else
    mpfr_set_zero(result.lower, +1);
  if (mpfr_sgn(x.upper) > 0)
    mpfr_sqrt(result.upper, x.upper, MPFR_RNDU);
  else
    mpfr_set_zero(result.upper, +1);
}

}  // namespace toolcomp::exact
