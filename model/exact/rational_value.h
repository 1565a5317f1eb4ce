// SPDX-License-Identifier: Apache-2.0
// The rational number of a node.
#pragma once

#include <gmp.h>

#include <cstddef>
#include <cstdint>

#include "model/exact/real.h"

namespace toolcomp::exact {

/// Removing common divisors costs more than everything else, so they stay in while numbers are short. Numbers of
/// programs are decimals, and so are their sums and products: digits over a power of ten. Long numbers are in lowest
/// terms.
class RationalValue {
 public:
  RationalValue() { mpq_init(value_); }
  ~RationalValue() { mpq_clear(value_); }
  RationalValue(const RationalValue&) = delete;
  RationalValue& operator=(const RationalValue&) = delete;
  RationalValue(RationalValue&&) = delete;
  RationalValue& operator=(RationalValue&&) = delete;

  [[nodiscard]] int sign() const { return mpz_sgn(mpq_numref(value_)); }
  /// Whether it is this number, 1 or -1.
  [[nodiscard]] bool is_unit(int value) const;
  [[nodiscard]] bool equals(const RationalValue& other) const;
  /// The value is numerator() / denominator(), which may have a common divisor; the denominator is positive.
  [[nodiscard]] mpz_srcptr numerator() const { return mpq_numref(value_); }
  [[nodiscard]] mpz_srcptr denominator() const;
  [[nodiscard]] Rational rational() const;

  void set(std::int64_t value);
  void set(mpq_srcptr value);  ///< in lowest terms

  // Each sets this object to the result. It must not be one of the operands.
  void negate(const RationalValue& x);
  void invert(const RationalValue& x);  ///< x is not 0
  void add(const RationalValue& x, const RationalValue& y) { add(x, y, false); }
  void subtract(const RationalValue& x, const RationalValue& y) { add(x, y, true); }
  void multiply(const RationalValue& x, const RationalValue& y);
  void divide(const RationalValue& x, const RationalValue& y);  ///< y is not 0
  /// Returns false, and the value of this object is lost, if the root is irrational; x is not negative.
  bool root(const RationalValue& x);

  /// Releases limbs beyond this number; the value may be lost.
  void trim(int kept_limbs);

 private:
  class LowestTerms;

  [[nodiscard]] bool is_decimal() const { return decimals_ >= 0; }
  [[nodiscard]] std::size_t limbs() const { return mpz_size(numerator()) + mpz_size(denominator()); }
  void add(const RationalValue& x, const RationalValue& y, bool negative);
  void add_decimals(const RationalValue& x, const RationalValue& y, bool negative);
  void settle();  // of a value in lowest terms: checks whether it is a decimal

  // Special values in place of a number of decimals.
  static constexpr std::int32_t kLowestTerms = -1;
  static constexpr std::int32_t kQuotient = -2;  // that may have a common divisor

  mpq_t value_;                // of a decimal only the numerator is used
  std::int32_t decimals_ = 0;  // the denominator is this power of ten
};

}  // namespace toolcomp::exact
