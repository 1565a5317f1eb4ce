// SPDX-License-Identifier: Apache-2.0
// Enclosures: closed intervals with MPFR endpoints. Every operation rounds outwards, so the result contains every value
// the operation takes on points of its operands. There are no comparison operators, only signs that are certain.
#pragma once

#include <gmp.h>
#include <mpfr.h>

#include <array>
#include <optional>

#include "model/exact/real.h"

namespace toolcomp::exact {

/// Precision of the enclosure every node carries, in bits.
inline constexpr mpfr_prec_t base_precision = 128;

/// The endpoints; who owns their limbs is said by the derived types. Endpoints may be infinite, never NaN.
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

/// The sign that all points share; none if the interval holds zero and other points.
std::optional<Sign> certain_sign(const Interval& x);

// Each sets `result`, which must be another object than the operands, at its own precision.
/// numerator / denominator, the only way in for a rational; they may have a common divisor, the second is positive.
void set(Interval& result, mpz_srcptr numerator, mpz_srcptr denominator);
void set(Interval& result, const mpz_t value);
void set(Interval& result, const Interval& x);
/// Keeps of `result` what is also in `x`; both must enclose one value.
void intersect(Interval& result, const Interval& x);
void negate(Interval& result, const Interval& x);
void add(Interval& result, const Interval& x, const Interval& y);
void subtract(Interval& result, const Interval& x, const Interval& y);
void multiply(Interval& result, const Interval& x, const Interval& y);
void square(Interval& result, const Interval& x);
/// The divisor is not zero, though its enclosure may hold zero; then every real number is in the result.
void divide(Interval& result, const Interval& x, const Interval& y);
/// The argument is not negative, though its enclosure may reach below zero: it is clamped there.
void root(Interval& result, const Interval& x);

}  // namespace toolcomp::exact
