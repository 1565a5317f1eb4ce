// SPDX-License-Identifier: Apache-2.0
// Enclosures contain what they must: against every pair of points of small intervals, in exact rational arithmetic.
#include "model/exact/interval.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "model/exact/trigonometry.h"
#include "tests/effort.h"

namespace toolcomp::exact {
namespace {

const std::vector<int> points = {-3, -2, -1, 0, 1, 2, 3};

void set_ends(Interval& x, int lower, int upper) {
  mpfr_set_si(x.lower, lower, MPFR_RNDD);
  mpfr_set_si(x.upper, upper, MPFR_RNDU);
}

bool contains(const Interval& x, const Rational& value) {
  return mpfr_cmp_q(x.lower, value.raw()) <= 0 && mpfr_cmp_q(x.upper, value.raw()) >= 0;
}

// The ends are attained at the ends of the operands, so no interval is wider than it need be.
bool is_hull(const Interval& x, const std::vector<Rational>& values) {
  Rational low = values.front();
  Rational high = values.front();
  for (const Rational& value : values) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  InlineInterval of_low;
  InlineInterval of_high;
  set(of_low, mpq_numref(low.raw()), mpq_denref(low.raw()));
  set(of_high, mpq_numref(high.raw()), mpq_denref(high.raw()));
  return mpfr_equal_p(x.lower, of_low.lower) && mpfr_equal_p(x.upper, of_high.upper);
}

template <class Test>
void for_all_pairs(Test test) {
  for (const int a : points)
    for (const int b : points)
      for (const int c : points)
        for (const int d : points)
          if (a <= b && c <= d) test(a, b, c, d);
}

TEST(Interval, ArithmeticGivesTheHullOfTheValues) {
  for_all_pairs([](int a, int b, int c, int d) {
    InlineInterval x;
    InlineInterval y;
    InlineInterval result;
    set_ends(x, a, b);
    set_ends(y, c, d);
    add(result, x, y);
    EXPECT_TRUE(is_hull(result, {a + c, b + d}));
    subtract(result, x, y);
    EXPECT_TRUE(is_hull(result, {a - d, b - c}));
    multiply(result, x, y);
    EXPECT_TRUE(is_hull(result, {a * c, a * d, b * c, b * d})) << a << b << c << d;
    if (c > 0 || d < 0) {
      divide(result, x, y);
      EXPECT_TRUE(is_hull(result, {Rational(a) / c, Rational(a) / d, Rational(b) / c, Rational(b) / d}))
          << a << b << c << d;
    }
  });
}

TEST(Interval, DivisionByAnEnclosureOfZeroGivesEveryNumber) {
  InlineInterval x;
  InlineInterval y;
  InlineInterval result;
  set_ends(x, 1, 2);
  set_ends(y, -1, 0);
  divide(result, x, y);
  EXPECT_TRUE(mpfr_inf_p(result.lower));
  EXPECT_TRUE(mpfr_inf_p(result.upper));
  EXPECT_EQ(certain_sign(result), std::nullopt);
  // And what is computed on from there is never NaN.
  InlineInterval next;
  set_ends(x, 0, 0);
  multiply(next, result, x);
  EXPECT_TRUE(contains(next, 7));
  subtract(next, result, result);
  EXPECT_TRUE(contains(next, 7));
}

TEST(Interval, SquareAndRoot) {
  for (const int a : points)
    for (const int b : points) {
      if (a > b) continue;
      InlineInterval x;
      InlineInterval result;
      set_ends(x, a, b);
      square(result, x);
      EXPECT_TRUE(is_hull(
          result, a <= 0 && b >= 0 ? std::vector<Rational>{a * a, b * b, 0} : std::vector<Rational>{a * a, b * b}));
      if (b < 0) continue;
      InlineInterval root_of_square;
      set_ends(x, a < 0 ? a : a * a, b * b);
      root(root_of_square, x);
      EXPECT_TRUE(is_hull(root_of_square, {a < 0 ? 0 : a, b}));
    }
}

TEST(Interval, RationalsAreContainedAndOneUnitWide) {
  for (int denominator = 1; denominator < 200; ++denominator) {
    const Rational value(-7919, denominator);
    InlineInterval x;
    set(x, mpq_numref(value.raw()), mpq_denref(value.raw()));
    EXPECT_TRUE(contains(x, value));
    mpfr_nextabove(x.lower);
    EXPECT_GE(mpfr_cmp(x.lower, x.upper), 0);
  }
}

// Of any length: with and without a common divisor, exact, and where the last bit carries through all of them.
TEST(Interval, RationalsAreRoundedAsByMpfr) {
  std::mt19937_64 bits(1);
  const auto whole = [&bits] {
    Integer result = 0;
    for (std::uint64_t i = 0, words = 1 + bits() % (bits() % 16 == 0 ? 20 : 5); i < words; ++i)
      result = (result << 64) + (bits() % 4 == 0 ? ~std::uint64_t{0} : bits() % 4 == 0 ? 0 : bits());
    return Integer(result >> (bits() % 64));
  };
  const int numbers = static_cast<int>(toolcomp::test::random_cases(200'000));
  for (int i = 0; i < numbers; ++i) {
    const Integer divisor = i % 4 == 0 ? Integer(Integer(1) << (bits() % 300)) : Integer(whole() + 1);
    const Integer common = i % 3 == 0 ? Integer(bits() % 1000 + 1) : Integer(1);
    const Integer numerator = (i % 2 == 0 ? whole() : Integer(-whole())) * common;
    const Integer denominator = divisor * common;
    const Rational value(numerator, denominator);
    InlineInterval x;
    set(x, numerator.raw(), denominator.raw());
    InlineInterval by_mpfr;
    mpfr_set_q(by_mpfr.lower, value.raw(), MPFR_RNDD);
    mpfr_set_q(by_mpfr.upper, value.raw(), MPFR_RNDU);
    ASSERT_TRUE(mpfr_equal_p(x.lower, by_mpfr.lower)) << value;
    ASSERT_TRUE(mpfr_equal_p(x.upper, by_mpfr.upper)) << value;
    ASSERT_EQ(mpfr_cmp(x.lower, x.upper) == 0, contains(x, value) && mpfr_cmp_q(x.lower, value.raw()) == 0);
  }
}

TEST(Interval, SignsAreCertainOrNone) {
  InlineInterval x;
  EXPECT_EQ(certain_sign(x), Sign::zero);
  set_ends(x, 1, 2);
  EXPECT_EQ(certain_sign(x), Sign::positive);
  set_ends(x, -2, -1);
  EXPECT_EQ(certain_sign(x), Sign::negative);
  set_ends(x, 0, 2);
  EXPECT_EQ(certain_sign(x), std::nullopt);
  set_ends(x, -2, 0);
  EXPECT_EQ(certain_sign(x), std::nullopt);
}

// sin^2 + cos^2 = 1 and sin 30 = 1/2 at several precisions; the widths shrink with the precision.
TEST(Interval, SinesAndCosinesAreEnclosed) {
  for (const mpfr_prec_t precision : {128, 256, 1024}) {
    for (const Rational& degrees :
         {Rational(30), Rational(123457, 10000), Rational(89999999, 1000000), Rational(1, 7)}) {
      HeapInterval sine(precision);
      HeapInterval cosine(precision);
      HeapInterval a(precision);
      HeapInterval b(precision);
      HeapInterval one(precision);
      sine_and_cosine(&sine, &cosine, degrees.raw());
      square(a, sine);
      square(b, cosine);
      add(one, a, b);
      EXPECT_TRUE(contains(one, 1));
      mpfr_sub(one.upper, one.upper, one.lower, MPFR_RNDU);
      EXPECT_LT(mpfr_get_exp(one.upper), -precision + 8);
      EXPECT_EQ(contains(sine, Rational(1, 2)), degrees == 30);
    }
  }
}

}  // namespace
}  // namespace toolcomp::exact
