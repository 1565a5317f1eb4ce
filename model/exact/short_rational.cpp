// SPDX-License-Identifier: Apache-2.0
#include "model/exact/short_rational.h"

#include <cstdint>
#include <numeric>
#include <utility>

namespace toolcomp::exact {
namespace {

static_assert(GMP_NUMB_BITS == 64);
using Word = std::uint64_t;
__extension__ typedef unsigned __int128 TwoWords;  // NOLINT(modernize-use-using): the attribute needs a typedef

// Below 2^63, so that a product of two is below 2^126, and a sum of two products fits.
bool is_short(mpz_srcptr x) { return mpz_size(x) <= 1 && mpz_getlimbn(x, 0) >> 63 == 0; }
bool is_short(mpq_srcptr x) { return is_short(mpq_numref(x)) && is_short(mpq_denref(x)); }

struct Short {
  explicit Short(mpq_srcptr x)
      : numerator(mpz_getlimbn(mpq_numref(x), 0)),
        denominator(mpz_getlimbn(mpq_denref(x), 0)),
        negative(mpq_sgn(x) < 0) {}
  Word numerator;
  Word denominator;
  bool negative;
};

Word divisor(Word a, Word b) { return a == 1 || b == 1 ? 1 : std::gcd(a, b); }
// Of a number of two words with b > 0.
Word divisor(TwoWords a, Word b) { return b == 1 ? 1 : std::gcd(static_cast<Word>(a % b), b); }

TwoWords product(Word a, Word b) { return TwoWords{a} * b; }

void set(mpz_ptr z, bool negative, TwoWords magnitude) {
  mp_limb_t* const limbs = mpz_limbs_write(z, 2);
  limbs[0] = static_cast<Word>(magnitude);
  limbs[1] = static_cast<Word>(magnitude >> 64);
  mpz_limbs_finish(z, negative ? -2 : 2);
}

void set(mpq_ptr result, bool negative, TwoWords numerator, TwoWords denominator) {
  set(mpq_numref(result), negative, numerator);
  set(mpq_denref(result), false, denominator);
}

void product_of(mpq_ptr result, const Short& x, const Short& y) {
  const Word a = divisor(x.numerator, y.denominator);
  const Word b = divisor(y.numerator, x.denominator);
  set(result, x.negative != y.negative, product(x.numerator / a, y.numerator / b),
      product(x.denominator / b, y.denominator / a));
}

// With d the common divisor of the denominators, of numerator and denominator only what divides d can go out
// (Knuth, The Art of Computer Programming, 4.5.1).
void sum_of(mpq_ptr result, const Short& x, const Short& y) {
  const Word common = x.denominator == y.denominator ? x.denominator : divisor(x.denominator, y.denominator);
  TwoWords a = product(x.numerator, y.denominator / common);
  TwoWords b = product(y.numerator, x.denominator / common);
  bool negative = x.negative;
  if (x.negative != y.negative) {
    if (a < b) {
      std::swap(a, b);
      negative = y.negative;
    }
    a -= b;
  } else {
    a += b;
  }
  const Word reducible = divisor(a, common);
  set(result, negative, reducible == 1 ? a : a / reducible, product(x.denominator / common, y.denominator / reducible));
}

}  // namespace

void add(mpq_ptr result, mpq_srcptr x, mpq_srcptr y) {
  if (is_short(x) && is_short(y))
    sum_of(result, Short(x), Short(y));
  else
    mpq_add(result, x, y);
}

void subtract(mpq_ptr result, mpq_srcptr x, mpq_srcptr y) {
  if (!is_short(x) || !is_short(y)) {
    mpq_sub(result, x, y);
    return;
  }
  Short negated(y);
  negated.negative = !negated.negative;
  sum_of(result, Short(x), negated);
}

void multiply(mpq_ptr result, mpq_srcptr x, mpq_srcptr y) {
  if (is_short(x) && is_short(y))
    product_of(result, Short(x), Short(y));
  else
    mpq_mul(result, x, y);
}

void divide(mpq_ptr result, mpq_srcptr x, mpq_srcptr y) {
  if (!is_short(x) || !is_short(y)) {
    mpq_div(result, x, y);
    return;
  }
  Short inverse(y);
  std::swap(inverse.numerator, inverse.denominator);
  product_of(result, Short(x), inverse);
}

}  // namespace toolcomp::exact
