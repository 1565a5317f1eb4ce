// SPDX-License-Identifier: Apache-2.0
#include "model/exact/rational.h"

#include <mpfr.h>

#include <limits>
#include <ostream>
#include <stdexcept>

namespace toolcomp::exact {
namespace {

void require_nonzero(int sign) {
  if (sign == 0) throw std::overflow_error("division by zero");
}

// What GMP reads but no text of ours means (blanks within, other bases) is refused.
void require_digits(const std::string& text, const char* further) {
  if (text.empty() || text.find_first_not_of(further) != std::string::npos)
    throw std::invalid_argument("not a number: " + text);
}

}  // namespace

Integer::Integer(const std::string& text) {
  require_digits(text, "-0123456789");
  if (mpz_init_set_str(value_, text.c_str(), 10) == 0) return;
  mpz_clear(value_);
  throw std::invalid_argument("not a number: " + text);
}

std::string Integer::str() const {
  std::string text(mpz_sizeinbase(value_, 10) + 2, '\0');
  mpz_get_str(text.data(), 10, value_);
  text.resize(text.find('\0'));
  return text;
}

Integer& Integer::operator+=(const Integer& x) {
  mpz_add(value_, value_, x.value_);
  return *this;
}

Integer& Integer::operator-=(const Integer& x) {
  mpz_sub(value_, value_, x.value_);
  return *this;
}

Integer& Integer::operator*=(const Integer& x) {
  mpz_mul(value_, value_, x.value_);
  return *this;
}

Integer& Integer::operator/=(const Integer& x) {
  require_nonzero(x.sign());
  mpz_tdiv_q(value_, value_, x.value_);
  return *this;
}

Integer& Integer::operator%=(const Integer& x) {
  require_nonzero(x.sign());
  mpz_tdiv_r(value_, value_, x.value_);
  return *this;
}

Integer& Integer::operator<<=(std::uint64_t bits) {
  mpz_mul_2exp(value_, value_, static_cast<mp_bitcnt_t>(bits));
  return *this;
}

Integer& Integer::operator>>=(std::uint64_t bits) {
  mpz_fdiv_q_2exp(value_, value_, static_cast<mp_bitcnt_t>(bits));
  return *this;
}

Integer abs(Integer x) {
  mpz_abs(x.raw(), x.raw());
  return x;
}

Integer gcd(const Integer& x, const Integer& y) {
  Integer result;
  mpz_gcd(result.raw(), x.raw(), y.raw());
  return result;
}

Integer lcm(const Integer& x, const Integer& y) {
  Integer result;
  mpz_lcm(result.raw(), x.raw(), y.raw());
  return result;
}

Integer pow(const Integer& base, unsigned exponent) {
  Integer result;
  mpz_pow_ui(result.raw(), base.raw(), exponent);
  return result;
}

Integer power_of_ten(unsigned exponent) { return pow(10, exponent); }

Integer sqrt(const Integer& x) {
  Integer result;
  mpz_sqrt(result.raw(), x.raw());
  return result;
}

Rational::Rational(const Integer& numerator, const Integer& denominator) {
  require_nonzero(denominator.sign());
  mpq_init(value_);
  mpz_set(mpq_numref(value_), numerator.raw());
  mpz_set(mpq_denref(value_), denominator.raw());
  mpq_canonicalize(value_);
}

Rational::Rational(double number) {
  mpq_init(value_);
  mpq_set_d(value_, number);
}

Rational::Rational(const std::string& text) {
  require_digits(text, "-/0123456789");
  mpq_init(value_);
  if (mpq_set_str(value_, text.c_str(), 10) == 0 && mpz_sgn(mpq_denref(value_)) > 0) {
    mpq_canonicalize(value_);
    return;
  }
  mpq_clear(value_);
  throw std::invalid_argument("not a number: " + text);
}

std::string Rational::str() const {
  const Integer below = denominator(*this);
  return numerator(*this).str() + (below == 1 ? "" : "/" + below.str());
}

double Rational::to_double() const {
  mpfr_t rounded;
  mpfr_init2(rounded, std::numeric_limits<double>::digits);
  mpfr_set_q(rounded, value_, MPFR_RNDN);
  const double result = mpfr_get_d(rounded, MPFR_RNDN);
  mpfr_clear(rounded);
  return result;
}

Rational& Rational::operator+=(const Rational& x) {
  mpq_add(value_, value_, x.value_);
  return *this;
}

Rational& Rational::operator-=(const Rational& x) {
  mpq_sub(value_, value_, x.value_);
  return *this;
}

Rational& Rational::operator*=(const Rational& x) {
  mpq_mul(value_, value_, x.value_);
  return *this;
}

Rational& Rational::operator/=(const Rational& x) {
  require_nonzero(x.sign());
  mpq_div(value_, value_, x.value_);
  return *this;
}

Integer numerator(const Rational& x) {
  Integer result;
  mpz_set(result.raw(), mpq_numref(x.raw()));
  return result;
}

Integer denominator(const Rational& x) {
  Integer result;
  mpz_set(result.raw(), mpq_denref(x.raw()));
  return result;
}

Rational abs(Rational x) {
  mpq_abs(x.raw(), x.raw());
  return x;
}

Integer floor(const Rational& x) {
  Integer result;
  mpz_fdiv_q(result.raw(), mpq_numref(x.raw()), mpq_denref(x.raw()));
  return result;
}

std::ostream& operator<<(std::ostream& out, const Integer& x) { return out << x.str(); }
std::ostream& operator<<(std::ostream& out, const Rational& x) { return out << x.str(); }

}  // namespace toolcomp::exact
