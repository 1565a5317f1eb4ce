// SPDX-License-Identifier: Apache-2.0
// Exact positions against GMP rationals, and their nearest doubles against MPFR.
#include "fast/arithmetic/count.h"

#include <gmp.h>
#include <gtest/gtest.h>
#include <mpfr.h>

#include <boost/multiprecision/gmp.hpp>
#include <random>

#include "fast/arithmetic/wide.h"
#include "tests/effort.h"

namespace toolcomp::fast {
namespace {

using boost::multiprecision::mpq_rational;
using boost::multiprecision::mpz_int;

mpz_int whole(Int128 value) {
  const UInt128 magnitude = value < 0 ? -static_cast<UInt128>(value) : static_cast<UInt128>(value);
  const mpz_int result =
      (mpz_int(static_cast<std::uint64_t>(magnitude >> 64)) << 64) + static_cast<std::uint64_t>(magnitude);
  return value < 0 ? mpz_int(-result) : result;
}
mpq_rational rational(const Count& count) { return mpq_rational(whole(count.units()), whole(Count::kRestPerOne)); }
mpq_rational rational(const spec::Decimal& value) {
  const mpq_rational magnitude(mpz_int(value.digits), boost::multiprecision::pow(mpz_int(10), value.decimals));
  return value.negative ? mpq_rational(-magnitude) : magnitude;
}
// The double nearest to a rational number, by MPFR.
double nearest(const mpq_rational& value) {
  mpfr_t x;
  mpfr_init2(x, 53);
  mpfr_set_q(x, value.backend().data(), MPFR_RNDN);
  const double result = mpfr_get_d(x, MPFR_RNDN);
  mpfr_clear(x);
  return result;
}

// Decimals as programs have them: up to `digits` digits, any number of places up to 15.
spec::Decimal random_decimal(std::mt19937_64& random, unsigned digits) {
  spec::Decimal value;
  const unsigned n = 1 + static_cast<unsigned>(random() % digits);
  for (unsigned i = 0; i < n; ++i) value.digits = value.digits * 10 + random() % 10;
  value.decimals = static_cast<std::uint8_t>(random() % 16);
  value.negative = random() % 2 == 0;
  return value;
}

TEST(Count, WordsAndFactorsAreExact) {
  std::mt19937_64 random(1);
  for (std::uint64_t i = 0; i < test::random_cases(100'000); ++i) {
    const spec::Decimal value = random_decimal(random, 15);
    const mpq_rational exact = rational(value);
    ASSERT_EQ(rational(Count::of(value)), exact);
    ASSERT_EQ(rational(Count::of(value, Factor::inch_to_mm)), exact * mpq_rational(127, 5));
    ASSERT_EQ(rational(Count::of(value, Factor::mm_to_inch)), exact * mpq_rational(5, 127));
    spec::Decimal counts = value;
    counts.decimals = 0;
    ASSERT_EQ(rational(Count::of(counts, Factor::inch_to_mm, 5)), rational(counts) / 100'000 * mpq_rational(127, 5));
  }
}

TEST(Count, SetupValuesOfEighteenPlaces) {
  const spec::Decimal value{123'456'789'012'345'678, 18, true, true};
  EXPECT_EQ(rational(Count::of(value)), rational(value));
  EXPECT_TRUE(fits_count({99'999'999'999'999'999, 0, false, false}));
  EXPECT_FALSE(fits_count({100'000'000'000'000'000, 0, false, false}));
}

TEST(Count, SumsAreExactAndRoundOnce) {
  std::mt19937_64 random(2);
  Count sum;
  mpq_rational exact = 0;
  for (std::uint64_t i = 0; i < test::random_cases(100'000); ++i) {
    const auto value =
        Count::of(random_decimal(random, 1 + static_cast<unsigned>(i) % 15), static_cast<Factor>(random() % 3));
    const mpq_rational single = rational(value);
    ASSERT_EQ(value.nearest(), nearest(single));
    if (random() % 2 == 0) {
      sum += value;
      exact += single;
    } else {
      sum -= value;
      exact -= single;
    }
    ASSERT_EQ(rational(sum), exact);
    ASSERT_EQ(sum.nearest(), nearest(exact));
    ASSERT_EQ(Count::nearest_sum(sum, value), nearest(exact + single));
    if (i % 500 == 0) {
      sum = Count();
      exact = 0;
    }
  }
}

TEST(Count, TiesRoundToEven) {
  // 2^53 + 1 lies midway between two doubles; so does it over 2.
  const Count odd = Count::of({9'007'199'254'740'993, 0, false, false});
  EXPECT_EQ(odd.nearest(), 9'007'199'254'740'992.0);
  EXPECT_EQ((-odd).nearest(), -9'007'199'254'740'992.0);
  EXPECT_EQ((odd + Count::of({1, 15, false, true})).nearest(), 9'007'199'254'740'994.0);
}

TEST(Count, RangeIsTold) {
  Count sum;
  const Count step = Count::of({999'999'999'999'999, 0, false, false}, Factor::inch_to_mm);
  int steps = 0;
  while (sum.in_range()) {
    sum += step;
    ++steps;
  }
  // 2^125 / (127 * 10^18) = 3.349e17 over 2.54e16: 13 whole steps fit.
  EXPECT_EQ(steps, 14);
}

TEST(Wide, AgreesWithGmp) {
  std::mt19937_64 random(3);
  const auto any = [&random] {
    const auto bits = static_cast<int>(random() % 120);
    const Int128 magnitude =
        static_cast<Int128>((static_cast<UInt128>(random()) << 64 | random()) >> (127 - bits)) >> 1;
    return random() % 2 == 0 ? magnitude : -magnitude;
  };
  for (std::uint64_t i = 0; i < test::random_cases(100'000); ++i) {
    const Int128 a = any(), b = any(), c = any(), d = any();
    const Wide product = (Wide(a) * Wide(b) - Wide(c) * Wide(d)) * Wide(a) * Wide(c);
    const mpz_int exact = (whole(a) * whole(b) - whole(c) * whole(d)) * whole(a) * whole(c);
    ASSERT_EQ(product.sign(), exact.sign());
    const DoubleDouble rounded = product.to_double_double();
    const mpz_int difference = exact - mpz_int(rounded.hi) - mpz_int(rounded.lo);
    ASSERT_LE(boost::multiprecision::abs(difference) << 104, boost::multiprecision::abs(exact));
  }
}

}  // namespace
}  // namespace toolcomp::fast
