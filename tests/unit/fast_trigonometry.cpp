// SPDX-License-Identifier: Apache-2.0
// Sines and cosines of the fast engine against MPFR with 300 bits.
#include "fast/arithmetic/extended_sine.h"
#include "fast/arithmetic/trigonometry.h"
#include "tests/effort.h"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>
#include <random>

namespace toolcomp::fast {
namespace {

// MPFR numbers of 300 bits.
class Exact {
 public:
  Exact() { mpfr_init2(x_, 300); }
  Exact(const Exact&) = delete;
  Exact& operator=(const Exact&) = delete;
  ~Exact() { mpfr_clear(x_); }
  mpfr_ptr get() { return x_; }
  // |*this - (hi + lo)|
  double error(double hi, double lo) {
    Exact difference;
    mpfr_sub_d(difference.get(), x_, hi, MPFR_RNDN);
    mpfr_sub_d(difference.get(), difference.get(), lo, MPFR_RNDN);
    return std::abs(mpfr_get_d(difference.get(), MPFR_RNDN));
  }
  // The same over |*this|
  double relative_error(double hi, double lo = 0) {
    Exact difference;
    mpfr_sub_d(difference.get(), x_, hi, MPFR_RNDN);
    mpfr_sub_d(difference.get(), difference.get(), lo, MPFR_RNDN);
    mpfr_div(difference.get(), difference.get(), x_, MPFR_RNDN);
    return std::abs(mpfr_get_d(difference.get(), MPFR_RNDN));
  }

 private:
  mpfr_t x_;
};

void sine_cosine_of(const Count& degrees, Exact& sine, Exact& cosine) {
  const Int128 turn = 360 * Count::kRestPerOne;
  const Int128 units = degrees.units() % turn;
  Exact angle;
  Exact scale;
  // Two exact halves of the whole number.
  mpfr_set_si(angle.get(), static_cast<long>(units >> 40), MPFR_RNDN);
  mpfr_mul_2ui(angle.get(), angle.get(), 40, MPFR_RNDN);
  mpfr_add_si(angle.get(), angle.get(), static_cast<long>(units & ((Int128{1} << 40) - 1)), MPFR_RNDN);
  mpfr_const_pi(scale.get(), MPFR_RNDN);
  mpfr_mul(angle.get(), angle.get(), scale.get(), MPFR_RNDN);
  mpfr_set_str(scale.get(), "22860000000000000000000", 10, MPFR_RNDN);  // 180 * 127e18
  mpfr_div(angle.get(), angle.get(), scale.get(), MPFR_RNDN);
  mpfr_sin_cos(sine.get(), cosine.get(), angle.get(), MPFR_RNDN);
}

Count random_angle(std::mt19937_64& random) {
  spec::Decimal value;
  value.digits = random() % 1'000'000'000'000'000;
  value.decimals = static_cast<std::uint8_t>(random() % 16);
  value.negative = random() % 2 == 0;
  if (random() % 2 == 0) value.digits /= 1'000'000;
  return Count::of(value);
}

TEST(Trigonometry, WithinTheStatedErrors) {
  std::mt19937_64 random(1);
  double worst = 0;
  double worst_fine = 0;
  Exact sine;
  Exact cosine;
  for (std::uint64_t i = 0; i < test::random_cases(100'000); ++i) {
    const Count angle = random_angle(random);
    sine_cosine_of(angle, sine, cosine);
    if (mpfr_cmpabs_ui(sine.get(), 0) == 0) continue;
    const auto t = sine_cosine(angle);
    const auto f = fine_sine_cosine(angle);
    if (t.sine != 0) worst = std::max(worst, sine.relative_error(t.sine));
    if (t.cosine != 0) worst = std::max(worst, cosine.relative_error(t.cosine));
    if (f.sine.hi != 0) worst_fine = std::max(worst_fine, sine.relative_error(f.sine.hi, f.sine.lo));
    if (f.cosine.hi != 0) worst_fine = std::max(worst_fine, cosine.relative_error(f.cosine.hi, f.cosine.lo));
  }
  RecordProperty("worst_ulp_double", std::to_string(worst * 0x1p53));
  RecordProperty("worst_log2_fine", std::to_string(std::log2(worst_fine)));
  EXPECT_LE(worst, kTrigonometryError);
  EXPECT_LE(worst_fine, kFineTrigonometryError);
}

TEST(Trigonometry, ExtendedSinesWithinTheirError) {
  std::mt19937_64 random(5);
  Exact sine;
  Exact cosine;
  double worst = 0;
  for (std::uint64_t i = 0; i < test::random_cases(100'000); ++i) {
    // Any angle, one of a few turns, one beside a multiple of 45 degrees and half a degree beside a whole one.
    const std::int64_t most = i % 4 == 0 ? kMostExtendedAngle : 1'000'000'000;
    std::int64_t small = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * most + 1)) - most;
    if (i % 4 == 2) small = small / 45'000'000 * 45'000'000 + static_cast<std::int64_t>(random() % 5) - 2;
    if (i % 4 == 3) small = small / 1'000'000 * 1'000'000 + 499'999 + static_cast<std::int64_t>(random() % 3);
    Count angle;
    angle.set_small(small);
    sine_cosine_of(angle, sine, cosine);
    const auto t = extended_sine_cosine(small);
    worst = std::max({worst, sine.error(t.sine.hi, t.sine.lo), cosine.error(t.cosine.hi, t.cosine.lo)});
  }
  RecordProperty("worst_log2", std::to_string(std::log2(worst)));
  EXPECT_LE(worst, kExtendedSineError);
}

TEST(Trigonometry, MultiplesOfNinetyAreExact) {
  for (int quarter = -9; quarter <= 9; ++quarter)
    for (const Count& turn : {Count(), Count::of({360'000'000, 0, false, false})}) {
      const Count angle = Count::of(spec::decimal(90 * quarter)) + turn;
      const int q = ((quarter % 4) + 4) % 4;
      const double sine = q == 1 ? 1 : (q == 3 ? -1 : 0);
      const double cosine = q == 0 ? 1 : (q == 2 ? -1 : 0);
      EXPECT_EQ(sine_cosine(angle).sine, sine) << quarter;
      EXPECT_EQ(sine_cosine(angle).cosine, cosine) << quarter;
      EXPECT_EQ(fine_sine_cosine(angle).sine.hi, sine) << quarter;
      EXPECT_EQ(fine_sine_cosine(angle).cosine.hi, cosine) << quarter;
      EXPECT_EQ(fine_sine_cosine(angle).sine.lo, 0) << quarter;
      EXPECT_EQ(fine_sine_cosine(angle).cosine.lo, 0) << quarter;
    }
}

TEST(Trigonometry, ArctangentWithinItsError) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  Exact exact;
  Exact x;
  Exact y;
  double worst = 0;
  double worst_fine = 0;
  for (std::uint64_t i = 0; i < test::random_cases(100'000); ++i) {
    const double sine = std::ldexp(number(random), i % 3 == 0 ? -static_cast<int>(random() % 60) : 0);
    const double cosine = std::ldexp(number(random), i % 3 == 1 ? -static_cast<int>(random() % 60) : 0);
    mpfr_set_d(y.get(), sine, MPFR_RNDN);
    mpfr_set_d(x.get(), cosine, MPFR_RNDN);
    mpfr_atan2(exact.get(), y.get(), x.get(), MPFR_RNDN);
    mpfr_mul_ui(exact.get(), exact.get(), 180, MPFR_RNDN);
    mpfr_const_pi(x.get(), MPFR_RNDN);
    mpfr_div(exact.get(), exact.get(), x.get(), MPFR_RNDN);
    worst = std::max(worst, exact.relative_error(arctangent(sine, cosine)));
    // The count in units of 1 / (127 10^18): two halves that are doubles.
    const Int128 units = fine_arctangent({sine, 0}, {cosine, 0}).units();
    const auto high = static_cast<double>(units);
    const auto low = static_cast<double>(units - static_cast<Int128>(high));
    mpfr_mul_d(exact.get(), exact.get(), static_cast<double>(Count::kRestPerOne), MPFR_RNDN);
    mpfr_sub_d(x.get(), exact.get(), high, MPFR_RNDN);
    mpfr_sub_d(x.get(), x.get(), low, MPFR_RNDN);
    worst_fine = std::max(worst_fine, std::abs(mpfr_get_d(x.get(), MPFR_RNDN)));
  }
  RecordProperty("worst_ulp_double", std::to_string(worst * 0x1p53));
  EXPECT_LE(worst, kArctangentError);
  EXPECT_LE(worst_fine, 2);
  EXPECT_EQ(arctangent(1, 0), 90);
  EXPECT_EQ(arctangent(-1, 0), -90);
  EXPECT_EQ(arctangent(0, -3), 180);
  EXPECT_EQ(arctangent(-0.0, -3), 180);
  EXPECT_EQ(arctangent(0, 2), 0);
  EXPECT_EQ(arctangent(5, 5), 45);
}

TEST(Trigonometry, AnglesInDouble) {
  std::mt19937_64 random(4);
  for (std::uint64_t i = 0; i < test::random_cases(20'000); ++i) {
    const Count angle = Count::of({random() % 10'000'000'000, 6, random() % 2 == 0, true});
    // The double is the count rounded: half an ulp of 10^4 degrees, in radians.
    const auto exact = sine_cosine(angle);
    const auto rounded = sine_cosine(angle.nearest());
    ASSERT_NEAR(rounded.sine, exact.sine, 0x1p-40 / 57 + 2e-15);
    ASSERT_NEAR(rounded.cosine, exact.cosine, 0x1p-40 / 57 + 2e-15);
  }
  for (int quarter = -9; quarter <= 9; ++quarter) {
    EXPECT_EQ(sine_cosine(90.0 * quarter).sine, sine_cosine(Count::of(spec::decimal(90 * quarter))).sine);
    EXPECT_EQ(sine_cosine(90.0 * quarter).cosine, sine_cosine(Count::of(spec::decimal(90 * quarter))).cosine);
  }
}

// Two side by side are what each is alone.
TEST(Trigonometry, PairsAreAsTheirParts) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto next = [&] {
    const bool zero = random() % 8 == 0;
    return zero ? 0.0 : number(random);
  };
  for (std::uint64_t i = 0; i < test::random_cases(50'000); ++i) {
    DoublePair sine{};
    DoublePair cosine{};
    for (int lane = 0; lane < 2; ++lane) {
      sine[lane] = next();
      cosine[lane] = next();
    }
    const DoublePair angle = arctangent(sine, cosine);
    const DoublePair degrees = angle * 3.0;
    const auto turns = apart(sine_cosine(degrees));
    for (int lane = 0; lane < 2; ++lane) {
      ASSERT_EQ(angle[lane], arctangent(sine[lane], cosine[lane])) << sine[lane] << ' ' << cosine[lane];
      const auto alone = sine_cosine(degrees[lane]);
      ASSERT_EQ(turns[static_cast<std::size_t>(lane)].sine, alone.sine) << degrees[lane];
      ASSERT_EQ(turns[static_cast<std::size_t>(lane)].cosine, alone.cosine) << degrees[lane];
    }
  }
}

// Plain counts, and beside the ties where a quarter ends: within 1 ulp, and never past 1.
TEST(Trigonometry, PlainCountsAreWithinOneUlp) {
  std::mt19937_64 random(2);
  Exact sine;
  Exact cosine;
  double worst = 0;
  for (std::uint64_t i = 0; i < test::random_cases(200'000); ++i) {
    const auto turns = static_cast<std::int64_t>(random() % 41) - 20;
    const auto size = std::int64_t{1} << random() % 27;
    const auto part = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(size)) - size / 2;
    const std::int64_t small = turns * 45'000'000 + part;
    Count angle;
    angle.set_small(small);
    sine_cosine_of(angle, sine, cosine);
    const auto t = sine_cosine(small);
    const auto check = [&](Exact& exact, double value) {
      if (value == 0) return;
      EXPECT_LE(std::abs(value), 1);
      const double ulp = std::nextafter(std::abs(value), 2) - std::abs(value);
      worst = std::max(worst, exact.relative_error(value) * std::abs(value) / ulp);
    };
    check(sine, t.sine);
    check(cosine, t.cosine);
  }
  RecordProperty("worst_ulp", std::to_string(worst));
  EXPECT_LE(worst, 1);
}

}  // namespace
}  // namespace toolcomp::fast
