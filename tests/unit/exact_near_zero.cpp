// SPDX-License-Identifier: Apache-2.0
// What is nearly zero and must not be called zero; expressions made to break the arithmetic; and honest surrender.
#include <gtest/gtest.h>

#include <vector>

#include "model/exact/vector.h"

namespace toolcomp::exact {
namespace {

Rational power_of_ten(int exponent) {
  Rational result = 1;
  for (int i = 0; i < exponent; ++i) result *= 10;
  for (int i = 0; i > exponent; --i) result /= 10;
  return result;
}

Real angle_addition(const Rational& a, const Rational& b) {
  return sin_degrees(a + b) - sin_degrees(a) * cos_degrees(b) - cos_degrees(a) * sin_degrees(b);
}

TEST(NearZero, AnIdentityOffByATinyAmount) {
  for (const int exponent : {-10, -30, -37, -38, -39, -40, -60, -76, -77, -78, -100, -153, -154, -155, -200, -300}) {
    const Real tiny = power_of_ten(exponent);
    EXPECT_EQ((angle_addition(Rational(1234, 100), Rational(777, 10)) + tiny).sign(), Sign::positive) << exponent;
    EXPECT_EQ((angle_addition(Rational(1234, 100), Rational(777, 10)) - tiny).sign(), Sign::negative) << exponent;
    EXPECT_EQ((sqrt(5 + 2 * sqrt(Real(6))) - sqrt(Real(2)) - sqrt(Real(3)) - tiny).sign(), Sign::negative) << exponent;
  }
}

// The tiny amount under a root and in an angle: the difference is about tiny / 2 and tiny * pi / 180.
TEST(NearZero, TinyAmountsInsideFunctions) {
  for (const int exponent : {-15, -40, -80, -160, -300}) {
    const Rational tiny = power_of_ten(exponent);
    EXPECT_EQ((sqrt(2 + Real(tiny)) - sqrt(Real(2))).sign(), Sign::positive);
    EXPECT_EQ((sqrt(2 - Real(tiny)) - sqrt(Real(2))).sign(), Sign::negative);
    EXPECT_EQ((sin_degrees(30 + tiny) - Rational(1, 2)).sign(), Sign::positive);
    EXPECT_EQ((cos_degrees(60 + tiny) - Rational(1, 2)).sign(), Sign::negative);
    EXPECT_EQ((cos_degrees(tiny) - 1).sign(), Sign::negative);
    EXPECT_EQ(sin_degrees(180 - tiny).sign(), Sign::positive);
    EXPECT_EQ(sin_degrees(180 + tiny).sign(), Sign::negative);
  }
}

// Sums of roots that agree to many digits by accident (Graham's and others), and Ramanujan-like near misses.
TEST(NearZero, AccidentsOfNature) {
  const auto root = [](int n) { return sqrt(Real(n)); };
  // Differ by about 1e-8.
  EXPECT_EQ(compare(root(10) + root(11), root(5) + root(18)),
            compare(Rational(3162277660 + 3316624790, 1000000000), Rational(2236067977 + 4242640687, 1000000000)));
  // Conjugates: (sqrt 2 - 1)^n = |a - b sqrt 2| falls below any epsilon, never to zero.
  Real power = 1;
  for (int n = 1; n <= 400; ++n) {
    power *= root(2) - 1;
    ASSERT_EQ(power.sign(), Sign::positive);
  }
  // The same as a difference of whole numbers and roots: p - q sqrt 2 with p^2 - 2 q^2 = 1.
  Integer p = 3;
  Integer q = 2;
  for (int n = 0; n < 9; ++n) {
    const Integer next = p * p + 2 * q * q;
    q = 2 * p * q;
    p = next;
    const Real difference = Real(Rational(p)) - Real(Rational(q)) * root(2);
    EXPECT_EQ(difference.sign(), Sign::positive) << n;
    EXPECT_EQ((difference * (Real(Rational(p)) + Real(Rational(q)) * root(2)) - 1).sign(), Sign::zero);
  }
}

TEST(NearZero, CornersJustOffStraightAndJustOffCoplanar) {
  const Rational b(4567, 1000);
  const Vector3 u{cos_degrees(b), sin_degrees(b), Rational(1, 3)};
  // Angles of up to 15 decimals; the proof does not reach further.
  for (const int exponent : {-6, -9, -12, -15}) {
    const Rational tiny = power_of_ten(exponent);
    const Vector3 v{cos_degrees(b + tiny), sin_degrees(b + tiny), Rational(1, 3)};
    const Vector3 turn = cross(u, v);
    EXPECT_EQ(turn.z.sign(), Sign::positive);
    EXPECT_EQ(cross(v, u).z.sign(), Sign::negative);
    const Vector3 out_of_plane = u + v + Vector3{0, 0, tiny};
    EXPECT_EQ(dot(turn, out_of_plane).sign(), Sign::positive);
    EXPECT_EQ(dot(turn, u + v).sign(), Sign::zero);
  }
}

TEST(Adversarial, HugeAndTinyMagnitudes) {
  const Real x = sin_degrees(1);
  for (const int exponent : {300, 3000}) {
    const Real huge = power_of_ten(exponent);
    EXPECT_EQ((x * huge / huge - x).sign(), Sign::zero);
    EXPECT_EQ((x + huge - huge - x).sign(), Sign::zero);
    EXPECT_EQ((x + huge).sign(), Sign::positive);
    EXPECT_EQ((sqrt(x) * huge - sqrt(x * huge * huge)).sign(), Sign::zero);
    EXPECT_EQ((x / huge).sign(), Sign::positive);
    // The root of huge^2 + 1 is above huge by 1 / (2 huge).
    EXPECT_EQ((sqrt(huge * huge + 1) - huge).sign(), Sign::positive);
  }
}

// Beyond MPFR's exponents the bounds are infinite or zero; nothing is claimed then that is not so.
TEST(Adversarial, ExponentOverflow) {
  Real big = 1 + sqrt(Real(2));
  for (int i = 0; i < 40; ++i) big *= big;
  EXPECT_EQ(big.sign(), Sign::positive);
  EXPECT_EQ((1 / big).sign(), Sign::positive);
  EXPECT_EQ((1 / big).decimal(3), "0");
  EXPECT_THROW((void)(big - big * 2 + big).sign(), Undecided);
}

TEST(Adversarial, CatastrophicCancellationInSteps) {
  // e_n = e_(n-1) * 3 - 2 * x starting from x stays x; in intervals the width triples each time.
  const Real x = sqrt(Real(2)) + sin_degrees(Rational(1, 10));
  Real e = x;
  for (int i = 0; i < 100; ++i) e = e * 3 - 2 * x;
  EXPECT_EQ(e.decimal(20), x.decimal(20));
  EXPECT_EQ((e - x + Rational(1, 1000000000)).sign(), Sign::positive);
}

TEST(Adversarial, ChainsOfOneHundredThousandOperations) {
  const std::size_t before = live_nodes();
  {
    const Real s = sin_degrees(Rational(1, 10));
    Real x = s;
    for (int i = 0; i < 100'000; ++i) x = i % 3 == 0 ? x + s : i % 3 == 1 ? x * Rational(1, 2) - s : -(s * x);
    EXPECT_NE(x.sign(), Sign::zero);
    Real roots = 2 + s;
    for (int i = 0; i < 100'000; ++i) roots = sqrt(roots);
    EXPECT_EQ(roots.sign(), Sign::positive);
    EXPECT_EQ(compare(roots, Rational(3, 2)), Sign::negative);
    // Asked for a proof it may surrender, but it comes back.
    EXPECT_THROW((void)((roots - 1) * (roots + 1) - (square(roots) - 1)).sign(), Undecided);
    EXPECT_GT(live_nodes(), before + 200'000);
  }
  EXPECT_EQ(live_nodes(), before);
}

// Zero, but with sixty independent roots: far beyond the work allowed. It must say so, each time.
TEST(Adversarial, AHopelessProofEndsUndecided) {
  Real a = 0;
  Real b = 0;
  for (int i = 1; i <= 60; ++i) {
    const Real root = sqrt(Real(i * i + 1) + sin_degrees(i));
    a += root;
    b = root * (1 + Real(i)) - Real(i) * root + b;
  }
  const Real zero = square(a) * a - b * b * b;
  EXPECT_THROW((void)zero.sign(), Undecided);
  EXPECT_THROW((void)zero.sign(), Undecided);
  // Its bounds still hold zero and are narrow.
  const Enclosure bounds = zero.enclosure();
  EXPECT_LE(bounds.lower, 0);
  EXPECT_GE(bounds.upper, 0);
  EXPECT_LT(bounds.upper - bounds.lower, power_of_ten(-50));
}

}  // namespace
}  // namespace toolcomp::exact
