// SPDX-License-Identifier: Apache-2.0
// The rationals of nodes, whatever form they are in, against those of GMP in lowest terms.
#include "model/exact/rational_value.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <random>
#include <utility>

#include "tests/effort.h"

namespace toolcomp::exact {
namespace {

const int numbers = static_cast<int>(toolcomp::test::random_cases(200'000));

mpq_srcptr raw(const Rational& x) { return x.raw(); }

// Of any length up to two words, sometimes with many factors in common with others, or at the limit of one word.
Integer whole(std::mt19937_64& bits) {
  switch (bits() % 8) {
    case 0:
      return (Integer(1) << 63) - 2 + bits() % 4;
    case 1:
      return (Integer(1) << 64) - 2 + bits() % 4;
    case 2:
      return Integer(bits()) << (bits() % 40);
    case 3:
      return Integer(bits() % 100) * 1'000'000'000;
    default:
      return bits() >> (bits() % 64);
  }
}

// A decimal as programs have them, or any quotient.
Rational rational(std::mt19937_64& bits) {
  Integer denominator = whole(bits);
  if (bits() % 2 == 0) denominator = exact::pow(Integer(10), static_cast<unsigned>(bits() % 24));
  const Rational value(whole(bits), denominator.is_zero() ? Integer(1) : denominator);
  return bits() % 2 == 0 ? value : Rational(-value);
}

// A value in both forms.
struct Pair {
  std::unique_ptr<RationalValue> ours = std::make_unique<RationalValue>();
  Rational of_gmp;
};
Pair pair(const Rational& x) {
  Pair result;
  result.ours->set(raw(x));
  result.of_gmp = x;
  return result;
}

void expect_equal(const Pair& x) {
  const Rational value = x.ours->rational();
  // In lowest terms, too: compared by numerator and denominator.
  ASSERT_EQ(numerator(value), numerator(x.of_gmp)) << x.of_gmp;
  ASSERT_EQ(denominator(value), denominator(x.of_gmp)) << x.of_gmp;
  ASSERT_EQ(x.ours->sign(), x.of_gmp.sign());
  ASSERT_EQ(x.ours->is_unit(1), x.of_gmp == 1);
  ASSERT_EQ(x.ours->is_unit(-1), x.of_gmp == -1);
  ASSERT_GT(mpz_sgn(x.ours->denominator()), 0);
  Rational left;  // the same as it is seen
  Rational right = x.of_gmp;
  mpq_set_z(left.raw(), x.ours->numerator());
  mpz_mul(mpq_numref(right.raw()), mpq_numref(raw(right)), x.ours->denominator());
  mpq_canonicalize(right.raw());
  ASSERT_EQ(left, right);
}

Pair operation(int which, const Pair& x, const Pair& y) {
  Pair result = pair(Rational(-7, 3));  // what was there before does not matter
  switch (which) {
    case 0:
      result.ours->add(*x.ours, *y.ours);
      result.of_gmp = x.of_gmp + y.of_gmp;
      break;
    case 1:
      result.ours->subtract(*x.ours, *y.ours);
      result.of_gmp = x.of_gmp - y.of_gmp;
      break;
    case 2:
      result.ours->multiply(*x.ours, *y.ours);
      result.of_gmp = x.of_gmp * y.of_gmp;
      break;
    case 3:
      if (y.of_gmp.is_zero()) return operation(0, x, y);
      result.ours->divide(*x.ours, *y.ours);
      result.of_gmp = x.of_gmp / y.of_gmp;
      break;
    case 4:
      if (x.of_gmp.is_zero()) return operation(0, x, y);
      result.ours->invert(*x.ours);
      result.of_gmp = 1 / x.of_gmp;
      break;
    default:
      result.ours->negate(*x.ours);
      result.of_gmp = -x.of_gmp;
  }
  return result;
}
constexpr int operations = 6;

TEST(RationalValue, AgreesWithGmp) {
  std::mt19937_64 bits(1);
  for (int i = 0; i < numbers; ++i) {
    const Rational first = rational(bits);
    const Pair x = pair(first);
    const Pair y = pair(i % 16 == 0   ? first
                        : i % 16 == 1 ? Rational(-first)
                        : i % 16 == 2 ? Rational(first + 1)
                                      : rational(bits));
    for (int which = 0; which < operations; ++which) expect_equal(operation(which, x, y));
    ASSERT_EQ(x.ours->equals(*y.ours), x.of_gmp == y.of_gmp);
    if (HasFatalFailure()) return;
  }
}

// Numbers made of numbers: with common divisors that are left in, with many decimals, and long ones.
TEST(RationalValue, AgreesWithGmpInChains) {
  std::mt19937_64 bits(2);
  for (int i = 0; i < numbers / 100; ++i) {
    std::array<Pair, 4> values{pair(rational(bits)), pair(rational(bits)), pair(rational(bits)), pair(rational(bits))};
    for (int step = 0; step < 12; ++step) {
      const Pair& x = values.at(bits() % values.size());
      const Pair& y = values.at(bits() % values.size());
      Pair result = operation(static_cast<int>(bits() % operations), x, y);
      expect_equal(result);
      ASSERT_EQ(result.ours->equals(*x.ours), result.of_gmp == x.of_gmp);
      if (HasFatalFailure()) return;
      values.at(bits() % values.size()) = std::move(result);
    }
  }
}

TEST(RationalValue, RootsAreRationalWhereTheyAre) {
  std::mt19937_64 bits(3);
  for (int i = 0; i < numbers / 10; ++i) {
    const Rational x = abs(rational(bits));
    // With a common divisor that is no square, or as decimals of any number.
    const Pair divisor = pair(rational(bits));
    const Pair square = operation(3, operation(2, pair(x * x), divisor), divisor);
    RationalValue root;
    if (!divisor.of_gmp.is_zero()) {
      ASSERT_TRUE(root.root(*square.ours)) << x;
      ASSERT_EQ(root.rational(), x);
    }
    ASSERT_TRUE(root.root(*pair(x * x).ours)) << x;
    ASSERT_EQ(root.rational(), x);
    if (!x.is_zero()) {
      ASSERT_FALSE(root.root(*pair(2 * x * x).ours)) << x;
      ASSERT_FALSE(root.root(*pair(10 * x * x).ours)) << x;
    }
  }
}

// However often a number is multiplied by 1.0, it does not grow.
TEST(RationalValue, DoesNotGrow) {
  for (const Rational& factor : {Rational(1), Rational(3, 7)}) {
    Pair x = pair(Rational(1, 3));
    Pair y = pair(Rational(12345, 1000));
    Pair one = operation(2, pair(Rational(25, 100)), pair(4));
    for (int i = 0; i < 1000; ++i) {
      const Pair a = operation(2, x, pair(factor));
      x = operation(3, a, pair(factor));
      x = operation(2, x, one);
      y = operation(2, y, one);
    }
    EXPECT_EQ(x.ours->rational(), Rational(1, 3));
    EXPECT_EQ(y.ours->rational(), Rational(12345, 1000));
    EXPECT_LT(mpz_size(x.ours->denominator()), 20U);
    EXPECT_LT(mpz_size(y.ours->denominator()), 20U);
  }
}

}  // namespace
}  // namespace toolcomp::exact
