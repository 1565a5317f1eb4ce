// SPDX-License-Identifier: Apache-2.0
// Exact angles: sums, comparisons and whole turns. Expected values follow from the degrees in the names of the angles,
// or from the enclosures of the degrees where two angles are apart.
#include <gtest/gtest.h>

#include <vector>

#include "model/kinematics/angle.h"
#include "model/kinematics/coordinate.h"

namespace toolcomp::model {
namespace {

// An angle that is not kept as a rational, although it is one of whole degrees.
Angle hidden(int degrees) { return Angle::of_direction(exact::cos_degrees(degrees), exact::sin_degrees(degrees)); }
Angle turned(const Angle& angle, int turns) { return angle.plus_turns(turns); }

TEST(Angle, DirectionsAlongAxesAndDiagonalsAreRational) {
  const auto is = [](int x, int y, int degrees) {
    const Angle angle = Angle::of_direction(x, y);
    return angle.is_rational() && angle.rational() == degrees;
  };
  EXPECT_TRUE(is(3, 0, 0));
  EXPECT_TRUE(is(-3, 0, 180));
  EXPECT_TRUE(is(0, 2, 90));
  EXPECT_TRUE(is(0, -2, -90));
  EXPECT_TRUE(is(5, 5, 45));
  EXPECT_TRUE(is(-5, 5, 135));
  EXPECT_TRUE(is(-5, -5, -135));
  EXPECT_TRUE(is(5, -5, -45));
  EXPECT_FALSE(Angle::of_direction(1, 2).is_rational());
}

TEST(Angle, RecognisesThousandths) {
  for (const int degrees : {-179, -120, -89, -1, 1, 30, 100, 150, 179}) {
    ASSERT_FALSE(hidden(degrees).is_rational()) << degrees;
    const Angle known = hidden(degrees).recognised();
    ASSERT_TRUE(known.is_rational()) << degrees;
    EXPECT_EQ(known.rational(), degrees);
    EXPECT_EQ(turned(hidden(degrees), 2).degrees().decimal(15), std::to_string(degrees + 720));
  }
  EXPECT_FALSE(Angle::of_direction(4, 3).recognised().is_rational());
  EXPECT_EQ(Angle::of_direction(4, 3).degrees().decimal(15), "36.869897645844021");
  EXPECT_EQ(Angle::of_direction(-4, 3).degrees().decimal(15), "143.130102354155979");
  EXPECT_EQ(Angle::of_direction(-3, -4).degrees().decimal(15), "-126.869897645844021");
}

TEST(Angle, SumsCountTheirTurns) {
  for (int a = -175; a <= 180; a += 35)
    for (int b = -177; b <= 180; b += 21) {
      const Angle sum = turned(hidden(a), 1) + hidden(b);
      EXPECT_TRUE(sum == Angle(a + b + 360)) << a << ' ' << b;
      EXPECT_EQ(sum.recognised().rational(), a + b + 360) << a << ' ' << b;
      const Angle difference = hidden(a) - turned(hidden(b), -1);
      EXPECT_EQ(difference.recognised().rational(), a - b + 360) << a << ' ' << b;
      EXPECT_EQ((hidden(a) + Angle(b)).recognised().rational(), a + b);
    }
}

TEST(Angle, OrderIsThatOfTheDegrees) {
  std::vector<int> values;
  for (int i = -1000; i <= 1000; i += 37) values.push_back(i);
  for (const int i : {-360, -180, -90, 0, 90, 180, 270, 360}) values.push_back(i);
  const auto angle = [](int degrees, int kind) {
    const int principal = 180 - ((180 - degrees) % 360 + 360) % 360;
    if (kind == 0) return Angle(degrees);
    if (kind == 1) return turned(hidden(principal), (degrees - principal) / 360);
    return hidden(100) + Angle(degrees - 100);
  };
  for (const int a : values)
    for (const int b : values)
      for (int kind = 0; kind < 9; ++kind) {
        const Real result = order(angle(a, kind / 3), angle(b, kind % 3));
        ASSERT_EQ(static_cast<int>(result.sign()), (a > b) - (a < b)) << a << ' ' << b << ' ' << kind;
        ASSERT_LE(result.double_enclosure().upper, 1);
        ASSERT_GE(result.double_enclosure().lower, -1);
      }
}

TEST(Angle, WholeAndNearestTurns) {
  for (int degrees = -1080; degrees <= 1080; degrees += 15) {
    const int whole = (degrees + 3600) / 360 - 10;
    const int nearest = (degrees + 3600 + 179) / 360 - 10;
    EXPECT_EQ(Angle(degrees).whole_turns(), whole) << degrees;
    EXPECT_EQ(Angle(degrees).nearest_turns(), nearest) << degrees;
    const Angle other = hidden(77) + Angle(degrees - 77);
    EXPECT_EQ(other.whole_turns(), whole) << degrees;
    EXPECT_EQ(other.nearest_turns(), nearest) << degrees;
  }
  EXPECT_TRUE(turned(hidden(-100), 5).principal() == Angle(-100));
  EXPECT_TRUE((hidden(100) + hidden(100)).principal() == Angle(-160));
}

TEST(Angle, CosineAndSineOfSums) {
  const Angle angle = Angle::of_direction(4, 3) + Angle(Rational(405));
  EXPECT_TRUE(angle.cosine() == (Rational(4, 5) - Rational(3, 5)) * exact::cos_degrees(45));
  EXPECT_TRUE(angle.sine() == (Rational(4, 5) + Rational(3, 5)) * exact::cos_degrees(45));
  EXPECT_TRUE(square(angle.cosine()) + square(angle.sine()) == 1);
}

TEST(Angle, KnownAnglesAskNoSign) {
  // 3, 4, 5 from an arc tangent: no zero of it can be proven.
  const Real degrees = exact::arctangent_degrees(Rational(3, 4));
  const Angle known = Angle::known(exact::cos_real_degrees(degrees), exact::sin_real_degrees(degrees), degrees);
  EXPECT_EQ((known + Angle(720)).degrees().decimal(10), "756.8698976458");
  EXPECT_EQ((-known).sine().decimal(10), "-0.6");
  const Angle none = known - Angle::of_direction(4, 3);
  EXPECT_EQ(none.nearest_turns(), 0);
  EXPECT_EQ((none + Angle(1080)).nearest_turns(), 3);
}

TEST(RotaryCoordinate, KeepsItsRestThroughSumsWithRationals) {
  Coordinate at(Angle::of_direction(4, 3));
  for (int i = 0; i < 100; ++i) at = at + Coordinate(Rational(36));
  EXPECT_EQ(at.value().decimal(12), "3636.869897645844");
  EXPECT_TRUE(at.angle() == Angle::of_direction(4, 3).plus_turns(10));
  EXPECT_TRUE(at == Coordinate(Rational(3600)) + Coordinate(Angle::of_direction(4, 3)));
  EXPECT_FALSE(at == Coordinate(Rational(3600)));
  EXPECT_TRUE((at - Coordinate(Angle::of_direction(4, 3))).is_rational());
}

}  // namespace
}  // namespace toolcomp::model
