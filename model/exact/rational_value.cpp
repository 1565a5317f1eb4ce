// SPDX-License-Identifier: Apache-2.0
#include "model/exact/rational_value.h"

#include <algorithm>
#include <array>
#include <bit>

namespace toolcomp::exact {
namespace {

static_assert(GMP_NUMB_BITS == 64);
using Word = std::uint64_t;
__extension__ typedef unsigned __int128 TwoWords;  // NOLINT(modernize-use-using): the attribute needs a typedef

constexpr std::int32_t kMostDecimals = 128;
// Both operands of an operation whose result is not brought to lowest terms.
constexpr std::size_t kShortLimbs = 16;

constexpr std::size_t kWordPowers = 20;  // of ten, in one word; of five there are more
constexpr std::size_t kWordFives = 28;
template <std::size_t Size>
constexpr std::array<Word, Size> powers(Word base) {
  std::array<Word, Size> result{1};
  for (std::size_t i = 1; i < Size; ++i) result.at(i) = result.at(i - 1) * base;
  return result;
}
constexpr auto kTens = powers<kWordPowers>(10);
constexpr auto kFives = powers<kWordFives>(5);

mpz_srcptr power_of_ten(std::int32_t exponent) {
  struct Power {
    mpz_t z;
  };
  // They live as long as any number.
  static const auto* const powers = [] {
    auto* const made = new std::array<Power, kMostDecimals + 1>;
    for (std::size_t i = 0; i < made->size(); ++i) {
      mpz_init(made->at(i).z);
      mpz_ui_pow_ui(made->at(i).z, 10, i);
    }
    return made;
  }();
  return powers->at(static_cast<std::size_t>(exponent)).z;
}

bool is_word(mpz_srcptr z) { return mpz_size(z) <= 1; }
Word word(mpz_srcptr z) { return mpz_getlimbn(z, 0); }

void put(mpz_ptr z, bool negative, TwoWords magnitude) {
  mp_limb_t* const limbs = z->_mp_alloc >= 2 ? z->_mp_d : mpz_limbs_write(z, 2);
  limbs[0] = static_cast<Word>(magnitude);
  limbs[1] = static_cast<Word>(magnitude >> 64U);
  const int size = limbs[1] != 0 ? 2 : limbs[0] != 0 ? 1 : 0;
  z->_mp_size = negative ? -size : size;
}

void put_product(mpz_ptr result, mpz_srcptr x, mpz_srcptr y) {
  if (is_word(x) && is_word(y))
    put(result, (mpz_sgn(x) < 0) != (mpz_sgn(y) < 0), TwoWords{word(x)} * word(y));
  else
    mpz_mul(result, x, y);
}

// x + y, or x - y.
void put_sum(mpz_ptr result, mpz_srcptr x, mpz_srcptr y, bool negative) {
  if (!is_word(x) || !is_word(y)) {
    (negative ? mpz_sub : mpz_add)(result, x, y);
    return;
  }
  const Word a = word(x);
  const Word b = word(y);
  const bool sign_of_x = mpz_sgn(x) < 0;
  const bool sign_of_y = (mpz_sgn(y) < 0) != negative;
  if (sign_of_x == sign_of_y)
    put(result, sign_of_x, TwoWords{a} + b);
  else if (a >= b)
    put(result, sign_of_x, a - b);
  else
    put(result, sign_of_y, b - a);
}

// The exponent of a power of five; of another number none is below kWordFives.
std::size_t exponent_of_five(Word odd) {
  // Each has another width, of 2.32 bits times its exponent.
  std::size_t exponent = static_cast<std::size_t>(std::bit_width(odd) - 1) * 431 / 1000;
  for (; exponent < kWordFives && kFives.at(exponent) < odd; ++exponent) {
  }
  return exponent < kWordFives && kFives.at(exponent) == odd ? exponent : kWordFives;
}

// digits / 10^decimals, of digits that are not 0, in lowest terms.
void reduce(mpq_ptr result, mpz_srcptr digits, std::int32_t decimals) {
  mpz_ptr numerator = mpq_numref(result);
  mpz_ptr denominator = mpq_denref(result);
  const auto twos =
      static_cast<std::int32_t>(std::min<mp_bitcnt_t>(mpz_scan1(digits, 0), static_cast<mp_bitcnt_t>(decimals)));
  std::int32_t fives = 0;
  mpz_tdiv_q_2exp(numerator, digits, static_cast<mp_bitcnt_t>(twos));
  for (; fives < decimals && mpz_divisible_ui_p(numerator, 5) != 0; ++fives) mpz_divexact_ui(numerator, numerator, 5);
  mpz_srcptr const power = power_of_ten(decimals - fives);
  if (fives >= twos)
    mpz_mul_2exp(denominator, power, static_cast<mp_bitcnt_t>(fives - twos));
  else
    mpz_tdiv_q_2exp(denominator, power, static_cast<mp_bitcnt_t>(twos - fives));
}

}  // namespace

// An operand in lowest terms.
class RationalValue::LowestTerms {
 public:
  explicit LowestTerms(const RationalValue& x) : terms_(x.value_) {
    if (x.decimals_ == kLowestTerms) return;
    made_ = x.rational();
    terms_ = made_.raw();
  }
  [[nodiscard]] mpq_srcptr get() const { return terms_; }

 private:
  Rational made_;
  mpq_srcptr terms_;
};

bool RationalValue::is_unit(int value) const {
  if (sign() != value) return false;
  if (is_decimal() && is_word(numerator()))
    return decimals_ < static_cast<std::int32_t>(kWordPowers) &&
           word(numerator()) == kTens.at(static_cast<std::size_t>(decimals_));
  return mpz_cmpabs(numerator(), denominator()) == 0;
}

bool RationalValue::equals(const RationalValue& other) const {
  if (is_decimal() && decimals_ == other.decimals_) return mpz_cmp(numerator(), other.numerator()) == 0;
  return rational() == other.rational();
}

mpz_srcptr RationalValue::denominator() const { return is_decimal() ? power_of_ten(decimals_) : mpq_denref(value_); }

Rational RationalValue::rational() const {
  Rational result;
  if (sign() == 0) return result;
  if (is_decimal()) {
    reduce(result.raw(), numerator(), decimals_);
  } else {
    mpq_set(result.raw(), value_);
    if (decimals_ == kQuotient) mpq_canonicalize(result.raw());
  }
  return result;
}

void RationalValue::set(std::int64_t value) {
  set_whole(mpq_numref(value_), value);
  decimals_ = 0;
}

void RationalValue::set(mpq_srcptr value) {
  mpq_set(value_, value);
  settle();
}

void RationalValue::settle() {
  decimals_ = kLowestTerms;
  mpz_srcptr const divisor = mpq_denref(value_);
  if (!is_word(divisor)) return;
  const auto twos = static_cast<std::size_t>(std::countr_zero(word(divisor)));
  const std::size_t decimals = std::max(twos, exponent_of_five(word(divisor) >> twos));
  if (decimals >= kWordPowers) return;
  if (decimals != 0) {
    const mp_limb_t factor = kTens.at(decimals) / word(divisor);
    mpz_t whole;
    mpz_mul(mpq_numref(value_), mpq_numref(value_), mpz_roinit_n(whole, &factor, 1));
  }
  decimals_ = static_cast<std::int32_t>(decimals);
}

void RationalValue::negate(const RationalValue& x) {
  mpz_neg(mpq_numref(value_), x.numerator());
  if (!x.is_decimal()) mpz_set(mpq_denref(value_), x.denominator());
  decimals_ = x.decimals_;
}

void RationalValue::invert(const RationalValue& x) {
  const bool negative = x.sign() < 0;
  (negative ? mpz_neg : mpz_set)(mpq_numref(value_), x.denominator());
  mpz_abs(mpq_denref(value_), x.numerator());
  decimals_ = x.decimals_ == kLowestTerms ? kLowestTerms : kQuotient;
}

void RationalValue::add(const RationalValue& x, const RationalValue& y, bool negative) {
  if (x.is_decimal() && y.is_decimal()) {
    add_decimals(x, y, negative);
    return;
  }
  if (x.limbs() + y.limbs() > kShortLimbs) {
    (negative ? mpq_sub : mpq_add)(value_, LowestTerms(x).get(), LowestTerms(y).get());
    settle();
    return;
  }
  auto* const numerator = mpq_numref(value_);
  auto* const denominator = mpq_denref(value_);
  decimals_ = kQuotient;
  if (mpz_cmp(x.denominator(), y.denominator()) == 0) {
    put_sum(numerator, x.numerator(), y.numerator(), negative);
    mpz_set(denominator, x.denominator());
    return;
  }
  put_product(numerator, x.numerator(), y.denominator());
  (negative ? mpz_submul : mpz_addmul)(numerator, y.numerator(), x.denominator());
  put_product(denominator, x.denominator(), y.denominator());
}

void RationalValue::add_decimals(const RationalValue& x, const RationalValue& y, bool negative) {
  auto* const digits = mpq_numref(value_);
  decimals_ = std::max(x.decimals_, y.decimals_);
  if (x.decimals_ == y.decimals_) {
    put_sum(digits, x.numerator(), y.numerator(), negative);
  } else if (x.decimals_ < y.decimals_) {
    put_product(digits, x.numerator(), power_of_ten(y.decimals_ - x.decimals_));
    put_sum(digits, digits, y.numerator(), negative);
  } else {
    put_product(digits, y.numerator(), power_of_ten(x.decimals_ - y.decimals_));
    if (negative) mpz_neg(digits, digits);
    put_sum(digits, digits, x.numerator(), false);
  }
}

void RationalValue::multiply(const RationalValue& x, const RationalValue& y) {
  const bool decimal = x.is_decimal() && y.is_decimal();
  if (decimal && x.decimals_ + y.decimals_ <= kMostDecimals) {
    put_product(mpq_numref(value_), x.numerator(), y.numerator());
    decimals_ = x.decimals_ + y.decimals_;
  } else if (!decimal && x.limbs() + y.limbs() <= kShortLimbs) {
    put_product(mpq_numref(value_), x.numerator(), y.numerator());
    put_product(mpq_denref(value_), x.denominator(), y.denominator());
    decimals_ = kQuotient;
  } else {
    mpq_mul(value_, LowestTerms(x).get(), LowestTerms(y).get());
    settle();
  }
}

void RationalValue::divide(const RationalValue& x, const RationalValue& y) {
  auto* const numerator = mpq_numref(value_);
  auto* const denominator = mpq_denref(value_);
  if (x.limbs() + y.limbs() > kShortLimbs) {
    mpq_div(value_, LowestTerms(x).get(), LowestTerms(y).get());
    settle();
    return;
  }
  if (x.is_decimal() && x.decimals_ == y.decimals_) {
    mpz_set(numerator, x.numerator());
    mpz_set(denominator, y.numerator());
  } else {
    put_product(numerator, x.numerator(), y.denominator());
    put_product(denominator, x.denominator(), y.numerator());
  }
  if (mpz_sgn(denominator) < 0) {
    mpz_neg(numerator, numerator);
    mpz_neg(denominator, denominator);
  }
  decimals_ = kQuotient;
}

// Where it is rational it is that of numerator times denominator, a whole number, over the denominator.
bool RationalValue::root(const RationalValue& x) {
  auto* const numerator = mpq_numref(value_);
  // Of an even power of ten the root is known.
  const std::int32_t odd = x.decimals_ % 2;
  put_product(numerator, x.numerator(), x.is_decimal() ? power_of_ten(odd) : x.denominator());
  if (mpz_perfect_square_p(numerator) == 0) return false;
  mpz_sqrt(numerator, numerator);
  if (x.is_decimal()) {
    decimals_ = (x.decimals_ + odd) / 2;
  } else {
    mpz_set(mpq_denref(value_), x.denominator());
    decimals_ = kQuotient;
  }
  return true;
}

void RationalValue::trim(int kept_limbs) {
  for (mpz_ptr z : {mpq_numref(value_), mpq_denref(value_)}) {
    if (z->_mp_alloc <= kept_limbs) continue;
    mpz_set_ui(z, 1);
    mpz_realloc2(z, GMP_NUMB_BITS);
  }
}

}  // namespace toolcomp::exact
