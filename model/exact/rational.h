// SPDX-License-Identifier: Apache-2.0
// Integers and rational numbers of any size, over GMP: values, in lowest terms, exact in every operation.
#pragma once

#include <gmp.h>

#include <compare>
#include <concepts>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <string>

namespace toolcomp::exact {

/// The integer types of the language from which a number may be made.
template <class T>
concept Whole = std::integral<T> && !std::same_as<T, bool> && sizeof(T) <= sizeof(std::int64_t);

/// Sets `value` to `number`. What GMP takes is a `long`, which has 32 bits on some platforms.
template <Whole T>
void set_whole(mpz_ptr value, T number) {
  if constexpr (sizeof(T) > sizeof(long)) {
    const bool negative = number < 0;
    const auto bits = static_cast<std::uint64_t>(number);
    const std::uint64_t magnitude = negative ? 0 - bits : bits;
    mpz_import(value, 1, -1, sizeof magnitude, 0, 0, &magnitude);
    if (negative) mpz_neg(value, value);
  } else if constexpr (std::signed_integral<T>) {
    mpz_set_si(value, number);
  } else {
    mpz_set_ui(value, number);
  }
}

/// The number of `value`, which lies within the type.
template <Whole T>
T whole_of(mpz_srcptr value) {
  static_assert(GMP_NUMB_BITS >= 64);
  if constexpr (sizeof(T) > sizeof(long)) {
    const std::uint64_t magnitude = mpz_getlimbn(value, 0);
    return static_cast<T>(mpz_sgn(value) < 0 ? 0 - magnitude : magnitude);
  } else if constexpr (std::signed_integral<T>) {
    return static_cast<T>(mpz_get_si(value));
  } else {
    return static_cast<T>(mpz_get_ui(value));
  }
}

/// An integer. Quotients and remainders are rounded towards zero, as those of the language; std::overflow_error if
/// the divisor is zero.
class Integer {
 public:
  Integer() { mpz_init(value_); }
  template <Whole T>
  Integer(T number) {  // NOLINT(google-explicit-constructor): a number is a number
    mpz_init(value_);
    set_whole(value_, number);
  }
  explicit Integer(const std::string& text);  ///< of decimal digits, with or without sign; std::invalid_argument
  Integer(const Integer& other) { mpz_init_set(value_, other.value_); }
  Integer(Integer&& other) noexcept {
    mpz_init(value_);
    mpz_swap(value_, other.value_);
  }
  Integer& operator=(const Integer& other) {
    mpz_set(value_, other.value_);
    return *this;
  }
  Integer& operator=(Integer&& other) noexcept {
    mpz_swap(value_, other.value_);
    return *this;
  }
  ~Integer() { mpz_clear(value_); }

  [[nodiscard]] mpz_srcptr raw() const { return value_; }
  [[nodiscard]] mpz_ptr raw() { return value_; }
  [[nodiscard]] int sign() const { return mpz_sgn(value_); }
  [[nodiscard]] bool is_zero() const { return sign() == 0; }
  [[nodiscard]] std::string str() const;  ///< decimal
  /// The value, or the nearest limit of the type.
  template <Whole T>
  explicit operator T() const {
    if (*this < Integer(std::numeric_limits<T>::min())) return std::numeric_limits<T>::min();
    if (*this > Integer(std::numeric_limits<T>::max())) return std::numeric_limits<T>::max();
    return whole_of<T>(value_);
  }

  Integer& operator+=(const Integer& x);
  Integer& operator-=(const Integer& x);
  Integer& operator*=(const Integer& x);
  Integer& operator/=(const Integer& x);
  Integer& operator%=(const Integer& x);
  Integer& operator<<=(std::uint64_t bits);
  Integer& operator>>=(std::uint64_t bits);  ///< towards minus infinity
  Integer& operator++() { return *this += 1; }

  friend Integer operator-(Integer x) {
    mpz_neg(x.value_, x.value_);
    return x;
  }
  friend Integer operator+(Integer x, const Integer& y) { return x += y; }
  friend Integer operator-(Integer x, const Integer& y) { return x -= y; }
  friend Integer operator*(Integer x, const Integer& y) { return x *= y; }
  friend Integer operator/(Integer x, const Integer& y) { return x /= y; }
  friend Integer operator%(Integer x, const Integer& y) { return x %= y; }
  friend Integer operator<<(Integer x, std::uint64_t bits) { return x <<= bits; }
  friend Integer operator>>(Integer x, std::uint64_t bits) { return x >>= bits; }
  friend bool operator==(const Integer& x, const Integer& y) { return mpz_cmp(x.value_, y.value_) == 0; }
  friend std::strong_ordering operator<=>(const Integer& x, const Integer& y) {
    return mpz_cmp(x.value_, y.value_) <=> 0;
  }

 private:
  mpz_t value_;
};

Integer abs(Integer x);
Integer gcd(const Integer& x, const Integer& y);  ///< not negative
Integer lcm(const Integer& x, const Integer& y);  ///< not negative
Integer pow(const Integer& base, unsigned exponent);
Integer power_of_ten(unsigned exponent);
Integer sqrt(const Integer& x);  ///< rounded down; x is not negative

/// A rational number. std::overflow_error if a denominator or divisor is zero.
class Rational {
 public:
  Rational() { mpq_init(value_); }
  template <Whole T>
  Rational(T number) {  // NOLINT(google-explicit-constructor): a number is a number
    mpq_init(value_);
    set_whole(mpq_numref(value_), number);
  }
  Rational(const Integer& number) {  // NOLINT(google-explicit-constructor): a number is a number
    mpq_init(value_);
    mpz_set(mpq_numref(value_), number.raw());
  }
  Rational(const Integer& numerator, const Integer& denominator);
  explicit Rational(double number);            ///< exactly; finite
  explicit Rational(const std::string& text);  ///< "p" or "p/q"; std::invalid_argument
  Rational(const Rational& other) {
    mpq_init(value_);
    mpq_set(value_, other.value_);
  }
  Rational(Rational&& other) noexcept {
    mpq_init(value_);
    mpq_swap(value_, other.value_);
  }
  Rational& operator=(const Rational& other) {
    mpq_set(value_, other.value_);
    return *this;
  }
  Rational& operator=(Rational&& other) noexcept {
    mpq_swap(value_, other.value_);
    return *this;
  }
  ~Rational() { mpq_clear(value_); }

  [[nodiscard]] mpq_srcptr raw() const { return value_; }
  [[nodiscard]] mpq_ptr raw() { return value_; }  ///< after a change through it the number may not be in lowest terms
  [[nodiscard]] int sign() const { return mpq_sgn(value_); }
  [[nodiscard]] bool is_zero() const { return sign() == 0; }
  [[nodiscard]] double to_double() const;  ///< the nearest normal double
  [[nodiscard]] std::string str() const;   ///< "p" or "p/q"

  Rational& operator+=(const Rational& x);
  Rational& operator-=(const Rational& x);
  Rational& operator*=(const Rational& x);
  Rational& operator/=(const Rational& x);

  friend Rational operator-(Rational x) {
    mpq_neg(x.value_, x.value_);
    return x;
  }
  friend Rational operator+(Rational x, const Rational& y) { return x += y; }
  friend Rational operator-(Rational x, const Rational& y) { return x -= y; }
  friend Rational operator*(Rational x, const Rational& y) { return x *= y; }
  friend Rational operator/(Rational x, const Rational& y) { return x /= y; }
  friend bool operator==(const Rational& x, const Rational& y) { return mpq_equal(x.value_, y.value_) != 0; }
  friend std::strong_ordering operator<=>(const Rational& x, const Rational& y) {
    return mpq_cmp(x.value_, y.value_) <=> 0;
  }

 private:
  mpq_t value_;
};

Integer numerator(const Rational& x);
Integer denominator(const Rational& x);  ///< positive
Rational abs(Rational x);
Integer floor(const Rational& x);  ///< the greatest integer that is not greater than x

std::ostream& operator<<(std::ostream& out, const Integer& x);
std::ostream& operator<<(std::ostream& out, const Rational& x);

}  // namespace toolcomp::exact
