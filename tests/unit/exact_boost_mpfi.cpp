// SPDX-License-Identifier: Apache-2.0
// Why enclosures are a small type of ours and not Boost.Multiprecision's interval number: three facts, each followed by
// what ours does. Seen with Boost 1.74 and 1.81; should one of them fail, Boost has been mended and the question is
// open.
#include <gtest/gtest.h>

#include <boost/multiprecision/gmp.hpp>
#include <boost/multiprecision/mpfi.hpp>
#include <cstdlib>

#include "model/exact/interval.h"

namespace toolcomp::exact {
namespace {

using BoostInterval = boost::multiprecision::number<boost::multiprecision::mpfi_float_backend<50>>;

BoostInterval between(double lower, double upper) {
  BoostInterval result;
  mpfi_interv_d(result.backend().data(), lower, upper);
  return result;
}

TEST(BoostMpfi, ConvertsRationalsToAPointBesideThem) {
  const Rational tenth(1, 10);
  const BoostInterval boost_tenth{boost::multiprecision::mpq_rational(1, 10)};
  const auto* const ends = boost_tenth.backend().data();
  EXPECT_TRUE(mpfr_equal_p(&ends->left, &ends->right));
  EXPECT_NE(mpfr_cmp_q(&ends->left, tenth.raw()), 0);

  InlineInterval ours;
  set(ours, mpq_numref(tenth.raw()), mpq_denref(tenth.raw()));
  EXPECT_LT(mpfr_cmp_q(ours.lower, tenth.raw()), 0);
  EXPECT_GT(mpfr_cmp_q(ours.upper, tenth.raw()), 0);
}

TEST(BoostMpfiDeathTest, EndsTheProgramWhenOverlappingIntervalsAreCompared) {
  const BoostInterval a = between(0, 2);
  const BoostInterval b = between(1, 3);
  // It throws where it must not, so that the exception cannot be caught.
  EXPECT_DEATH(
      {
        try {
          [[maybe_unused]] const bool less = a < b;
        } catch (...) {
        }
        std::exit(0);
      },
      "Ambiguous comparison");

  InlineInterval x;
  InlineInterval y;
  InlineInterval difference;
  mpfr_set_si(x.upper, 2, MPFR_RNDU);
  mpfr_set_si(y.lower, 1, MPFR_RNDD);
  mpfr_set_si(y.upper, 3, MPFR_RNDU);
  subtract(difference, x, y);
  EXPECT_EQ(certain_sign(difference), std::nullopt);
}

TEST(BoostMpfi, HasNoRootOfAnIntervalThatReachesBelowZero) {
  const BoostInterval boost_root = sqrt(between(-1e-30, 4));
  EXPECT_TRUE(mpfi_nan_p(boost_root.backend().data()));

  InlineInterval x;
  InlineInterval ours;
  mpfr_set_d(x.lower, -1e-30, MPFR_RNDD);
  mpfr_set_si(x.upper, 4, MPFR_RNDU);
  root(ours, x);
  EXPECT_TRUE(mpfr_zero_p(ours.lower));
  EXPECT_EQ(mpfr_cmp_si(ours.upper, 2), 0);
}

}  // namespace
}  // namespace toolcomp::exact
