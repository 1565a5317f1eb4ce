// SPDX-License-Identifier: Apache-2.0
// Enclosures: closed intervals with MPFR endpoints. Every operation rounds outwards, so that the result contains every
// value that the operation takes on points of its operands. There are no comparison operators, only signs that are
// certain.
#pragma once

#include <gmp.h>
#include <mpfr.h>

#include <array>
#include <optional>

#include "model/exact/real.h"

namespace toolcomp::exact {

/// Precision of the enclosure every node carries, in bits.
inline constexpr mpfr_prec_t base_precision = 128;

/// The endpoints. The derived types own their limbs. Endpoints may be infinite, never NaN.
struct Interval {
  mpfr_t lower;
  mpfr_t upper;

  [[nodiscard]] mpfr_prec_t precision() const { return mpfr_get_prec(lower); }

  Interval(const Interval&) = delete;
  Interval& operator=(const Interval&) = delete;
  Interval(Interval&&) = delete;
  Interval& operator=(Interval&&) = delete;

 protected:
  Interval() = default;  // NOLINT(cppcoreguidelines-pro-type-member-init): the derived types initialize the endpoints
  ~Interval() = default;
};

/// An interval of base_precision with its limbs inside: no allocation. It cannot be moved.
struct InlineInterval : Interval {
  InlineInterval();

 private:
  static constexpr std::size_t limbs = (base_precision + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS;
  std::array<mp_limb_t, limbs> lower_limbs_{};
  std::array<mp_limb_t, limbs> upper_limbs_{};
};

/// An interval of any precision with its limbs on the heap.
struct HeapInterval : Interval {
  explicit HeapInterval(mpfr_prec_t precision);
  ~HeapInterval();
  HeapInterval(const HeapInterval&) = delete;
  HeapInterval& operator=(const HeapInterval&) = delete;
  HeapInterval(HeapInterval&&) = delete;
  HeapInterval& operator=(HeapInterval&&) = delete;
};

/// The sign that all points have; std::nullopt if the interval contains zero and other points.
std::optional<Sign> certain_sign(const Interval& x);

// Each sets `result`, at the precision of `result`. It must not be one of the operands.
/// numerator / denominator, the only way to set a rational. They may have a common divisor; the denominator is
/// positive.
void set(Interval& result, mpz_srcptr numerator, mpz_srcptr denominator);
void set(Interval& result, const mpz_t value);
void set(Interval& result, const Interval& x);
/// Keeps the part of `result` that is also in `x`. Both must enclose the same value.
void intersect(Interval& result, const Interval& x);
void negate(Interval& result, const Interval& x);
void add(Interval& result, const Interval& x, const Interval& y);
void subtract(Interval& result, const Interval& x, const Interval& y);
void multiply(Interval& result, const Interval& x, const Interval& y);
void square(Interval& result, const Interval& x);
/// The divisor is not zero, though its enclosure may contain zero. Then the result contains every real number.
void divide(Interval& result, const Interval& x, const Interval& y);
/// The argument is not negative. Its enclosure may reach below zero, and is clamped at zero.
void root(Interval& result, const Interval& x);

}  // namespace toolcomp::exact
