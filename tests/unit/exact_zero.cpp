// SPDX-License-Identifier: Apache-2.0
// Identities that must be proven zero, most of them textbook: the source of the identity stands with each.
#include <gtest/gtest.h>

#include "model/exact/vector.h"

namespace toolcomp::exact {
namespace {

Real root(int n) { return sqrt(Real(n)); }
Real sine(const Rational& degrees) { return sin_degrees(degrees); }
Real cosine(const Rational& degrees) { return cos_degrees(degrees); }

TEST(Zero, AngleAdditionAtEveryNumberOfDecimals) {
  Rational unit = 1;
  for (int decimals = 0; decimals <= 15; ++decimals, unit /= 10) {
    for (int i = 1; i < 40; ++i) {
      const Rational a = Rational(1234567891L * i) * unit + 7;
      const Rational b = Rational(-987654321L * i) * unit;
      EXPECT_EQ(sine(a + b), sine(a) * cosine(b) + cosine(a) * sine(b));
      EXPECT_EQ(cosine(a + b), cosine(a) * cosine(b) - sine(a) * sine(b));
    }
  }
}

// Also where a factor or an addend became zero before the sign of the whole was asked.
TEST(Zero, AZeroIsKnownAsARationalFromThenOn) {
  const Real zero = sine(18) - (root(5) - 1) / 4;
  const Real product = zero * root(7);
  const Real quotient = product / root(3);
  const Real sum = zero + product;
  for (const Real& x : {zero, product, quotient, sum}) {
    EXPECT_FALSE(x.is_rational());
    EXPECT_EQ(x.sign(), Sign::zero);
    EXPECT_TRUE(x.is_rational());
  }
}

// Ptolemy's and Gauss's values.
TEST(Zero, SinesThatAreRoots) {
  EXPECT_EQ(cosine(45), root(2) / 2);
  EXPECT_EQ(cosine(30), root(3) / 2);
  EXPECT_EQ(cosine(15), (root(6) + root(2)) / 4);
  EXPECT_EQ(sine(18), (root(5) - 1) / 4);
  EXPECT_EQ(cosine(36), (root(5) + 1) / 4);
  EXPECT_EQ(cosine(Rational(45, 2)), sqrt(2 + root(2)) / 2);
  EXPECT_EQ(cosine(Rational(45, 4)), sqrt(2 + sqrt(2 + root(2))) / 2);
  EXPECT_EQ(cosine(Rational(45, 8)), sqrt(2 + sqrt(2 + sqrt(2 + root(2)))) / 2);
  EXPECT_EQ(sine(3), (2 * (1 - root(3)) * sqrt(5 + root(5)) + root(2) * (root(5) - 1) * (root(3) + 1)) / 16);
  EXPECT_EQ(sine(72), sqrt(10 + 2 * root(5)) / 4);
}

// Degrees whose denominators have other primes than 2 and 5.
TEST(Zero, DegreesThatAreNoDecimals) {
  const Rational seventh(360, 7);
  EXPECT_EQ(cosine(seventh) + cosine(2 * seventh) + cosine(3 * seventh), Rational(-1, 2));
  EXPECT_EQ(sine(seventh / 2) * sine(seventh) * sine(3 * seventh / 2), root(7) / 8);
  EXPECT_EQ(cosine(20) * cosine(40) * cosine(80), Rational(1, 8));
  EXPECT_EQ(cosine(Rational(20, 3)) * 4 * square(cosine(Rational(20, 3))) - 3 * cosine(Rational(20, 3)), cosine(20));
  // The side of the regular polygon of 17 sides (Gauss, Disquisitiones 365).
  const Real inner = sqrt(34 - 2 * root(17));
  const Real outer = sqrt(34 + 2 * root(17));
  EXPECT_EQ(16 * cosine(Rational(360, 17)), -1 + root(17) + inner + 2 * sqrt(17 + 3 * root(17) - inner - 2 * outer));
}

TEST(Zero, MorriesAndMultipleAngles) {
  const Rational a(12345678, 1000000);
  EXPECT_EQ(4 * sine(a) * sine(60 - a) * sine(60 + a), sine(3 * a));
  EXPECT_EQ(16 * sine(a) * sine(36 - a) * sine(36 + a) * sine(72 - a) * sine(72 + a), sine(5 * a));
  Real product = sine(a);
  Rational angle = a;
  for (int i = 0; i < 6; ++i, angle *= 2) product *= 2 * cosine(angle);
  EXPECT_EQ(product, sine(64 * a));
  EXPECT_EQ(sine(a) + sine(a + 120) + sine(a + 240), 0);
  EXPECT_EQ(cosine(a) + cosine(a + 72) + cosine(a + 144) + cosine(a + 216) + cosine(a + 288), 0);
}

TEST(Zero, RootOfASquare) {
  for (int i = 1; i < 60; ++i) {
    const Rational d(i * 6131, 1000);
    const Real y = sine(d) - Rational(i % 11, 10) * cosine(3 * d);
    const Real squared = sine(d) * sine(d) - Rational(i % 11, 5) * sine(d) * cosine(3 * d) +
                         Rational((i % 11) * (i % 11), 100) * square(cosine(3 * d));
    EXPECT_EQ(sqrt(squared), y.sign() == Sign::negative ? -y : y) << i;
    EXPECT_NE(sqrt(squared), y.sign() == Sign::negative ? y : -y) << i;
  }
}

TEST(Zero, ProductsAndQuotientsOfRoots) {
  for (int i = 1; i < 60; ++i) {
    const Real a = 2 + sine(Rational(i * 31, 7 + i % 4));
    const Real b = 1 + Rational(1, 3) * cosine(i);
    EXPECT_EQ(sqrt(a) * sqrt(b), sqrt(a * b));
    EXPECT_EQ(sqrt(a) / sqrt(b), sqrt(a / b));
    EXPECT_EQ(1 / (sqrt(a) + sqrt(b)), (sqrt(a) - sqrt(b)) / (a - b));
  }
}

TEST(Zero, NestedRadicals) {
  EXPECT_EQ(sqrt(5 + 2 * root(6)), root(2) + root(3));
  EXPECT_EQ(sqrt(5 - 2 * root(6)), root(3) - root(2));
  EXPECT_EQ(sqrt(16 - 2 * root(29) + 2 * sqrt(55 - 10 * root(29))),
            sqrt(22 + 2 * root(5)) - sqrt(11 + 2 * root(29)) + root(5));
  EXPECT_EQ(sqrt(10 + root(24) + root(40) + root(60)), root(2) + root(3) + root(5));
  // Four independent roots and their sum squared.
  const Real sum = root(2) + root(3) + root(5) + root(7);
  EXPECT_EQ(sqrt(sum * (root(7) + root(5) + root(3) + root(2))), sum);
}

TEST(Zero, SumsInsideRootsInsideDivisors) {
  const Real zero = sqrt(Real(Rational(1, 2))) - 1 / root(2);
  const Real x = sine(Rational(1, 10));
  EXPECT_EQ(sqrt(zero + x) / sqrt(x + zero * x), 1);
  EXPECT_EQ((x / (1 + zero * x) - x) * root(11), 0);
}

// Signs of divisors under a root: sqrt(a / b^2) = sqrt(a) / |b| with b negative.
TEST(Zero, NegativeDivisorsUnderRoots) {
  const Real b = cosine(100) - sqrt(Real(Rational(1, 10)));
  const Real a = 3 + sine(1);
  EXPECT_EQ(sqrt(a / (b * b)), -(sqrt(a) / b));
  EXPECT_EQ(sqrt((1 / b) / b), -1 / b);
  EXPECT_EQ(sqrt(a / b / b / b / b), sqrt(a) / b / b);
  EXPECT_NE(sqrt(a / (b * b)), sqrt(a) / b);
}

Vector3 rotated_about_z(const Vector3& v, const Rational& degrees) {
  const Real c = cosine(degrees);
  const Real s = sine(degrees);
  return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}
Vector3 rotated_about_y(const Vector3& v, const Rational& degrees) {
  const Real c = cosine(degrees);
  const Real s = sine(degrees);
  return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

// Rotation keeps lengths and angles, and turns about one axis add up.
TEST(Zero, RotationsOfVectors) {
  const Vector3 u{Rational(123456, 1000), Rational(-7, 10), 5};
  const Vector3 v{-2, Rational(31, 100), Rational(999, 1000)};
  for (int i = 1; i < 20; ++i) {
    const Rational b(i * 7001, 1000);
    const Rational c(i * -12347, 1000);
    const auto turn = [&](const Vector3& w) { return rotated_about_z(rotated_about_y(w, b), c); };
    EXPECT_EQ(dot(turn(u), turn(v)), dot(u, v));
    EXPECT_TRUE(cross(turn(u), turn(v)) == turn(cross(u, v)));
    EXPECT_TRUE(rotated_about_z(rotated_about_z(u, b), c) == rotated_about_z(u, b + c));
    EXPECT_TRUE(turn(rotated_about_z(rotated_about_y(turn(u), 0), 0)) == turn(turn(u)));
  }
}

// Straight on: the second move is a multiple of the first, in workpiece coordinates turned by the tool's angles.
TEST(Zero, StraightOnCorners) {
  for (int i = 1; i < 20; ++i) {
    const Rational b(i * 4567, 1000);
    const Rational c(i * 89101, 10000);
    const Vector3 first = rotated_about_z(rotated_about_y({1, Rational(i, 10), -3}, b), c);
    const Vector3 second = rotated_about_z(rotated_about_y({Rational(7, 3), Rational(7 * i, 30), -7}, b), c);
    EXPECT_TRUE(is_zero(cross(first, second)));
    EXPECT_EQ(dot(first, second).sign(), Sign::positive);
    // As unit vectors, each with its own root.
    const Vector3 n = first / sqrt(squared_norm(first));
    const Vector3 m = second / sqrt(squared_norm(second));
    EXPECT_TRUE(n == m);
    EXPECT_EQ(dot(n, m), 1);
    EXPECT_EQ(dot(n, -m), -1);
  }
}

// Coplanar: a corner whose moves lie in the plane of the tool; and the leading-edge vector VC is in span(VT, VM),
// perpendicular to VT and of length R.
TEST(Zero, CoplanarCornersAndTheLeadingEdge) {
  for (int i = 1; i < 20; ++i) {
    const Rational b(i * 4567, 1000);
    const Rational c(i * 89101, 1000);
    const Vector3 tool = rotated_about_z(rotated_about_y({0, 0, 1}, b), c);
    const Vector3 move{Rational(3 * i, 7), -2, Rational(11, 10)};
    const Vector3 in_plane = Real(Rational(17, 10)) * tool - Real(Rational(i, 3)) * move;
    EXPECT_EQ(dot(cross(tool, move), in_plane), 0);

    const Real radius = Rational(79, 10);
    const Vector3 direction = cross(cross(tool, move), tool);
    const Vector3 edge = radius / sqrt(squared_norm(direction)) * direction;
    EXPECT_EQ(dot(edge, tool), 0);
    EXPECT_EQ(dot(cross(tool, move), edge), 0);
    EXPECT_EQ(squared_norm(edge), square(radius));
    EXPECT_EQ(sqrt(squared_norm(edge)), radius);
  }
}

// Two offset lines meet on the bisector: with unit normals n and m, (n + m) R / (1 + n.m) is at distance R along both.
TEST(Zero, CornerOfTwoOffsets) {
  for (int i = 1; i < 10; ++i) {
    const Rational d(i * 13579, 1000);
    const Vector3 u{cosine(d), sine(d), 0};
    const Vector3 v{Rational(i, 10), 1, 0};
    const Vector3 axis{0, 0, 1};
    const Vector3 n = cross(axis, u) / sqrt(squared_norm(u));
    const Vector3 m = cross(axis, v) / sqrt(squared_norm(v));
    const Vector3 corner = (n + m) * (Real(Rational(5, 2)) / (1 + dot(n, m)));
    EXPECT_EQ(dot(corner, n), Rational(5, 2));
    EXPECT_EQ(dot(corner, m), Rational(5, 2));
    EXPECT_EQ(dot(corner, u) + dot(corner, v) / sqrt(squared_norm(v)), 0);
  }
}

// Twelve nested roots over sines whose angles share no circle of few degrees: far beyond what is multiplied out.
Real nested(bool turned) {
  Real x = 2;
  for (int i = 1; i <= 12; ++i) {
    const Real a = sine(Rational(100'003 * i, 100'000)) * x;
    const Real b = x * cosine(Rational(70'001 * i, 100'000));
    x = sqrt(turned ? square(b) + (a * b + 1) : (1 + b * a) + square(b));
  }
  return x;
}

// What is made alike is equal, in whatever order sums and products have their operands, and however deep it is.
TEST(Zero, NumbersMadeAlikeAreEqual) {
  EXPECT_EQ(nested(false), nested(false));
  const Real x = nested(true);
  const Real y = nested(true);
  EXPECT_EQ(x * y, square(x));
  EXPECT_EQ(x * root(2) - root(2) * y, 0);
  EXPECT_EQ(x + root(2), root(2) + y);
  // A zero inside what is proven by other means.
  EXPECT_EQ((x - y) * root(3) + root(8), 2 * root(2));
  EXPECT_NE(x + Rational(1, 1'000'000'000), y);
  EXPECT_NE(x - root(3), root(3) - y);
  // The order of a difference and of a quotient counts.
  const auto a = [] { return sine(Rational(11'338, 1000)); };
  EXPECT_EQ((a() - root(2)) * root(3) + (root(2) - a()) * root(3), 0);
  EXPECT_EQ(a() / root(2) * (root(2) / a()), 1);
}

// (a / p)(n p) = n a for a polynomial p, also where the numerator is -p.
TEST(Zero, ADivisorGoesOutWithItsMultiple) {
  const auto polynomial = [] {
    return sine(Rational(11'338, 1000)) * root(3) + cosine(Rational(89'574, 1000)) - Rational(7, 5) * root(7);
  };
  const Real p = polynomial();
  EXPECT_EQ(root(2) / p * (3 * polynomial()), 3 * root(2));
  EXPECT_EQ(root(2) / p * (Rational(-5, 7) * polynomial()), Rational(-5, 7) * root(2));
  EXPECT_EQ(polynomial() * (root(2) / square(p)), root(2) / polynomial());
  EXPECT_EQ(sqrt(square(p) * root(2)) / polynomial(), -sqrt(root(2)));  // p < 0
}

}  // namespace
}  // namespace toolcomp::exact
