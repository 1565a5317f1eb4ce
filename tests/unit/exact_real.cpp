// SPDX-License-Identifier: Apache-2.0
// Real as a number: folding to rationals, errors, comparisons, copies, the pool.
#include "model/exact/alike.h"
#include "model/exact/real.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace toolcomp::exact {
namespace {

const Rational tenth(1, 10);

TEST(Real, FieldOperationsOnRationalsStayRational) {
  const Real a = Rational(3, 10);
  const Real b = Rational(-7, 4);
  EXPECT_EQ((a + b).rational(), Rational(-29, 20));
  EXPECT_EQ((a - b).rational(), Rational(41, 20));
  EXPECT_EQ((a * b).rational(), Rational(-21, 40));
  EXPECT_EQ((a / b).rational(), Rational(-6, 35));
  EXPECT_EQ((-a).rational(), Rational(-3, 10));
  EXPECT_EQ((Real(tenth) + Real(Rational(2, 10)) - a).rational(), 0);
  EXPECT_EQ(Real().rational(), 0);
  EXPECT_EQ(Real(0).sign(), Sign::zero);
}

TEST(Real, PerfectSquaresHaveRationalRoots) {
  EXPECT_EQ(sqrt(Real(Rational(49, 16))).rational(), Rational(7, 4));
  EXPECT_EQ(sqrt(Real(0)).rational(), 0);
  EXPECT_FALSE(sqrt(Real(Rational(49, 17))).is_rational());
  EXPECT_EQ(square(sqrt(Real(2))).rational(), 2);
}

TEST(Real, SinesAndCosinesAreRationalWhereTheyCanBe) {
  const std::vector<std::pair<int, Rational>> sines = {
      {0, 0},    {30, Rational(1, 2)},   {90, 1},   {150, Rational(1, 2)},  {180, 0}, {210, Rational(-1, 2)},
      {270, -1}, {330, Rational(-1, 2)}, {-90, -1}, {-30, Rational(-1, 2)}, {360, 0}, {-36000000, 0}};
  for (const auto& [degrees, value] : sines) {
    ASSERT_TRUE(sin_degrees(degrees).is_rational()) << degrees;
    EXPECT_EQ(sin_degrees(degrees).rational(), value) << degrees;
    EXPECT_EQ(cos_degrees(90 - Rational(degrees)).rational(), value) << degrees;
  }
}

// Signs of the quadrants, and the same values a full turn away, by the exact proof.
TEST(Real, SinesAndCosinesInEveryQuadrant) {
  const Rational d(1234567, 100000);
  const Real s = sin_degrees(d);
  const Real c = cos_degrees(d);
  for (const int turn : {-720, 0, 360}) {
    EXPECT_EQ(sin_degrees(d + turn), s);
    EXPECT_EQ(cos_degrees(d + turn), c);
    EXPECT_EQ(sin_degrees(d + turn + 90), c);
    EXPECT_EQ(cos_degrees(d + turn + 90), -s);
    EXPECT_EQ(sin_degrees(d + turn + 180), -s);
    EXPECT_EQ(cos_degrees(d + turn + 180), -c);
    EXPECT_EQ(sin_degrees(d + turn + 270), -c);
    EXPECT_EQ(cos_degrees(d + turn + 270), s);
    EXPECT_EQ(sin_degrees(-d - turn), -s);
    EXPECT_EQ(cos_degrees(-d - turn), c);
  }
}

TEST(Real, FoldsWhatIsTheSameNode) {
  const Real x = sin_degrees(1) + sqrt(Real(2));
  EXPECT_TRUE((x - x).is_rational());
  EXPECT_TRUE((x + -x).is_rational());
  EXPECT_TRUE((-x + x).is_rational());
  EXPECT_TRUE((0 * x).is_rational());
  EXPECT_EQ((x / x).rational(), 1);
  EXPECT_TRUE((sqrt(x * x) - x).is_rational());
  EXPECT_TRUE((sqrt(-x * -x) - x).sign() == Sign::zero);
}

// What positions have in common goes out of their difference.
TEST(Real, FoldsWhatSumsHaveInCommon) {
  const Real x = sin_degrees(1) * sqrt(Real(2)) + cos_degrees(1);
  const Real y = sqrt(Real(3));
  EXPECT_TRUE(((x + 5) - (x + 3)).is_rational());
  EXPECT_EQ(((x + 5) - (x + 3)).rational(), 2);
  EXPECT_TRUE(((x + 5) - (3 - -x)).is_rational());
  EXPECT_TRUE(alike((x + 5) - ((x + 3) + y), 2 - y));
  EXPECT_TRUE(alike(7 - (3 + y), 4 - y));
  EXPECT_TRUE(alike(7 - (3 - y), 4 + y));
}

TEST(Real, AlikeIsEqual) {
  const auto made = [](const Rational& r) { return arctangent_degrees(sqrt(Real(r)) / pi()) + sin_degrees(r); };
  EXPECT_TRUE(alike(made(2), made(2)));
  EXPECT_FALSE(alike(made(2), made(3)));
  EXPECT_TRUE(alike(Real(), Real(0)));
  EXPECT_FALSE(alike(Real(), made(2)));
  EXPECT_FALSE(alike(sin_degrees(1), cos_degrees(1)));
}

TEST(Real, ConstantsAroundAnExpressionAreGathered) {
  const Real x = sin_degrees(1);
  const std::size_t before = live_nodes();
  Real y = x;
  for (int i = 0; i < 1000; ++i) y = y + Real(tenth);
  // The sum node and its one constant.
  EXPECT_EQ(live_nodes(), before + 2);
  EXPECT_EQ((y - x - 100).sign(), Sign::zero);
}

TEST(Real, ErrorsOfArguments) {
  EXPECT_THROW(Real(1) / Real(0), std::domain_error);
  EXPECT_THROW(sqrt(Real(-1)), std::domain_error);
  // Zeros and signs that need a proof.
  const Real zero = sin_degrees(tenth) * sin_degrees(tenth) + cos_degrees(tenth) * cos_degrees(tenth) - 1;
  EXPECT_THROW(sqrt(Real(2)) / zero, std::domain_error);
  EXPECT_EQ(sqrt(zero).sign(), Sign::zero);
  EXPECT_THROW(sqrt(zero - Rational(1, 1'000'000'000)), std::domain_error);
}

TEST(Real, Comparisons) {
  const Real two = sqrt(Real(2)) * sqrt(Real(3)) * sqrt(Real(2)) / sqrt(Real(3));
  EXPECT_TRUE(two == 2);
  EXPECT_TRUE(two >= 2 && two <= 2);
  EXPECT_FALSE(two < 2 || two > 2 || two != 2);
  EXPECT_TRUE(sin_degrees(44) < cos_degrees(45));
  EXPECT_EQ(compare(sqrt(Real(3)), sqrt(Real(2))), Sign::positive);
  EXPECT_EQ(-Sign::positive, Sign::negative);
}

TEST(Real, AProvenZeroIsARationalFromThenOn) {
  const Real zero = sqrt(Real(6)) - sqrt(Real(2)) * sqrt(Real(3));
  EXPECT_FALSE(zero.is_rational());
  EXPECT_EQ(zero.sign(), Sign::zero);
  EXPECT_TRUE(zero.is_rational());
  EXPECT_EQ(zero.rational(), 0);
  EXPECT_TRUE((zero * sin_degrees(1)).is_rational());
}

TEST(Real, CopiesAndMoves) {
  Real a = sin_degrees(1);
  Real b = a;
  Real c = std::move(a);
  a = b;
  const Real& self = a;
  a = self;
  b = std::move(c);
  EXPECT_EQ((a - b).sign(), Sign::zero);
  b = Real(5);
  EXPECT_EQ((a - sin_degrees(1)).sign(), Sign::zero);
}

TEST(Real, EnclosuresHoldTheValueAndAreNarrow) {
  const Real x = sqrt(Real(2)) - Rational(14142135623, 10000000000);
  for (const int bits : {10, 100, 500, 3000}) {
    const Enclosure bounds = x.enclosure(bits);
    // sqrt(2) between them: by squares.
    const Rational low = bounds.lower + Rational(14142135623, 10000000000);
    const Rational high = bounds.upper + Rational(14142135623, 10000000000);
    EXPECT_LE(low * low, 2);
    EXPECT_GE(high * high, 2);
    EXPECT_LE((bounds.upper - bounds.lower) * Rational(Integer(1) << static_cast<unsigned>(bits)), bounds.lower);
  }
  const Enclosure exact = Real(tenth).enclosure();
  EXPECT_EQ(exact.lower, tenth);
  EXPECT_EQ(exact.upper, tenth);
}

TEST(Real, DoubleEnclosuresAreNeighbours) {
  const DoubleEnclosure third = Real(Rational(1, 3)).double_enclosure();
  EXPECT_EQ(std::nextafter(third.lower, 1.0), third.upper);
  EXPECT_EQ(third.lower, 1.0 / 3);  // which rounds down
  const DoubleEnclosure half = Real(Rational(-1, 2)).double_enclosure();
  EXPECT_EQ(half.lower, -0.5);
  EXPECT_EQ(half.upper, -0.5);
  const DoubleEnclosure root = sqrt(Real(2)).double_enclosure();
  EXPECT_EQ(std::nextafter(root.lower, 2.0), root.upper);
  const DoubleEnclosure zero = (sqrt(Real(8)) - 2 * sqrt(Real(2))).double_enclosure();
  EXPECT_EQ(zero.lower, 0);
  EXPECT_EQ(zero.upper, 0);
  // Cancellation to 1e-40: still neighbours.
  const Real near = sqrt(Real(1) + Rational(1) / Rational("10000000000000000000000000000000000000000")) - 1;
  const DoubleEnclosure narrow = near.double_enclosure();
  EXPECT_EQ(std::nextafter(narrow.lower, 1.0), narrow.upper);
  EXPECT_NEAR(narrow.lower, 5e-41, 1e-50);
}

TEST(Real, EveryNodeReturnsToThePool) {
  const std::size_t before = live_nodes();
  {
    std::vector<Real> values;
    for (int i = 1; i < 100; ++i)
      values.push_back(sqrt(square(sin_degrees(i)) + Rational(i, 7)) / (2 + cos_degrees(Rational(i, 10))));
    Real zero = square(values[3]) * values[5] - values[3] * values[5] * values[3];
    EXPECT_EQ(zero.sign(), Sign::zero);
    EXPECT_GT(live_nodes(), before + 100);
  }
  EXPECT_EQ(live_nodes(), before);
}

TEST(Real, ErrorsLeaveNothingBehind) {
  const std::size_t before = live_nodes();
  EXPECT_THROW(sin_degrees(1) / (sin_degrees(2) - 2 * sin_degrees(1) * cos_degrees(1)), std::domain_error);
  EXPECT_THROW(sqrt(-sqrt(Real(2))), std::domain_error);
  EXPECT_EQ(live_nodes(), before);
}

TEST(Real, ThreadsHaveTheirOwnPools) {
  const std::size_t before = live_nodes();
  const Real mine = sin_degrees(1);
  std::size_t theirs = 1;
  std::thread([&] {
    const Real x = sin_degrees(1) + sqrt(Real(2));
    theirs = live_nodes();
  }).join();
  EXPECT_EQ(theirs, 4U);
  EXPECT_EQ(live_nodes(), before + 1);
}

}  // namespace
}  // namespace toolcomp::exact
