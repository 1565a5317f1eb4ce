// SPDX-License-Identifier: Apache-2.0
// Rationals of one word, and about the limit of it, are computed as GMP does.
#include "model/exact/short_rational.h"

#include <gtest/gtest.h>

#include <random>

#include "model/exact/real.h"
#include "tests/sanitized.h"

namespace toolcomp::exact {
namespace {

constexpr int numbers = toolcomp::test::random_cases(200'000);

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

Rational rational(std::mt19937_64& bits) {
  const Integer denominator = whole(bits);
  const Rational value(whole(bits), denominator.is_zero() ? Integer(1) : denominator);
  return bits() % 2 == 0 ? value : Rational(-value);
}

using Operation = void(mpq_ptr, mpq_srcptr, mpq_srcptr);

void expect_equal(Operation* ours, Operation* of_gmp, const Rational& x, const Rational& y) {
  Rational result = -7;  // what was there before does not matter
  Rational expected;
  ours(result.backend().data(), x.backend().data(), y.backend().data());
  of_gmp(expected.backend().data(), x.backend().data(), y.backend().data());
  // In lowest terms, too: compared by numerator and denominator.
  ASSERT_EQ(numerator(result), numerator(expected)) << x << ' ' << y;
  ASSERT_EQ(denominator(result), denominator(expected)) << x << ' ' << y;
}

TEST(ShortRational, AgreesWithGmp) {
  std::mt19937_64 bits(1);
  for (int i = 0; i < numbers; ++i) {
    const Rational x = rational(bits);
    const Rational y = i % 16 == 0 ? x : i % 16 == 1 ? Rational(-x) : i % 16 == 2 ? Rational(x + 1) : rational(bits);
    expect_equal(add, mpq_add, x, y);
    expect_equal(subtract, mpq_sub, x, y);
    expect_equal(multiply, mpq_mul, x, y);
    if (!y.is_zero()) expect_equal(divide, mpq_div, x, y);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace toolcomp::exact
