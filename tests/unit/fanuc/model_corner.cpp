// SPDX-License-Identifier: Apache-2.0
// The geometry of a corner by itself: classes, vectors, meeting points, groups, and what is left of a block between two
// groups. Expected values: the worked examples of 14.6.1 to 14.6.5, by hand; where a comment says so, derived here.
#include "model/fanuc/corner/corner.h"

#include <gtest/gtest.h>

#include <string>

#include "model/basis/event.h"
#include "model/fanuc/corner/interference.h"
#include "model/fanuc/cutter_compensation_c/rules.h"
#include "spec/language/setup_format.h"

namespace {

using namespace toolcomp;
using namespace toolcomp::model;

spec::Setup setup(const std::string& parameters = "") {
  return spec::read_setup_toml("control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[parameters]\n" + parameters,
                               "setup.toml");
}

// A line through a corner in this direction, with this offset to the left.
PathEnd line(int x, int y, const Rational& offset = 10) {
  PathEnd end;
  end.heading = heading({x, y});
  end.offset = offset;
  return end;
}
// An arc about a centre seen from the corner.
PathEnd arc(int center_x, int center_y, int turn, const Rational& offset = 10) {
  PathEnd end;
  end.heading = heading(Real(turn) * left(PlanePoint{-center_x, -center_y}));
  end.turn = turn;
  end.offset = offset;
  return end;
}

std::string text(const PlanePoint& vector, int digits = 13) {
  return '(' + vector[0].decimal(digits) + ", " + vector[1].decimal(digits) + ')';
}
std::string text(const VectorGroup& group, int digits = 13) {
  std::string line;
  for (const CornerVector& vector : group) line += text(vector.vector, digits);
  return line;
}
// The group in the plane X Y.
std::string text(const SpaceGroup& group) {
  std::string line;
  for (const SpaceVector& vector : group) line += text(in_plane_of(spec::Plane::xy, vector.vector));
  return line;
}

class ModelCorner : public ::testing::Test {
 protected:
  Recorder recorder{true};
  CutterRules rules{setup(), recorder};
  CutterRules type_b{setup("\"5003#0\" = 1"), recorder};
  PathEnd a = line(40, 0);

  std::string mode(const PathEnd& former, const PathEnd& latter) {
    const auto group = offset_mode(recorder, former, latter);
    return group ? text(*group) : "none";
  }
};

TEST_F(ModelCorner, Classes) {
  EXPECT_EQ(classify(recorder, a, line(0, 30)), CornerClass::inner);
  EXPECT_EQ(classify(recorder, a, line(7, 0)), CornerClass::straight);
  EXPECT_EQ(classify(recorder, a, line(40, -30)), CornerClass::obtuse);
  EXPECT_EQ(classify(recorder, a, line(0, -30)), CornerClass::obtuse);  // 90° exactly
  EXPECT_EQ(classify(recorder, a, line(-1, -1000)), CornerClass::acute);
  EXPECT_EQ(classify(recorder, a, line(-40, 0)), CornerClass::acute);  // reversal
  // The other side of the same corners.
  const PathEnd right = line(40, 0, -10);
  EXPECT_EQ(classify(recorder, right, line(0, 30, -10)), CornerClass::obtuse);
  EXPECT_EQ(classify(recorder, right, line(40, -30, -10)), CornerClass::inner);
  EXPECT_EQ(classify(recorder, right, line(-40, 0, -10)), CornerClass::acute);
  // Of arcs the tangent counts, here irrational: a tie is proven.
  EXPECT_EQ(classify(recorder, arc(1, 1, -1), arc(-3, -3, 1)), CornerClass::straight);
  EXPECT_EQ(classify(recorder, arc(1, 1, -1), arc(3, 3, 1)), CornerClass::acute);
}

TEST_F(ModelCorner, UnderOneDegree) {
  EXPECT_TRUE(is_under_one_degree(recorder, line(100, 0), line(-100, -1)));
  EXPECT_FALSE(is_under_one_degree(recorder, line(100, 0), line(-100, -2)));
  // Around tan 1° = 0.01745506492821758576…, an opposite over 10^9.
  EXPECT_TRUE(is_under_one_degree(recorder, line(1, 0), line(-1000000000, -17455064)));
  EXPECT_FALSE(is_under_one_degree(recorder, line(1, 0), line(-1000000000, -17455065)));
}

TEST_F(ModelCorner, Vectors) {
  EXPECT_EQ(text(perpendicular(line(3, 4))), "(-8, 6)");
  EXPECT_EQ(text(perpendicular(arc(10, -40, -1))), text(perpendicular(line(40, 10))));
  EXPECT_EQ(text(tangents_meet(tangent(a), tangent(line(24, 32)))), "(-5, 10)");
  EXPECT_EQ(text(tangents_meet(tangent(a), tangent(line(30, 30)))), "(-4.142135623731, 10)");
  EXPECT_EQ(text(prolonged(tangent(a))), "(10, 10)");
  EXPECT_EQ(text(begun_before(tangent(line(-30, -40)))), "(14, 2)");
  // On the right of the path both are prolonged too.
  EXPECT_EQ(text(prolonged(tangent(line(40, 0, -10)))), "(10, -10)");
  EXPECT_EQ(text(begun_before(tangent(line(-30, 40, -10)))), "(14, -2)");
}

TEST_F(ModelCorner, OffsetMode) {
  EXPECT_EQ(mode(a, line(40, 0)), "(0, 10)");
  EXPECT_EQ(mode(a, line(24, 32)), "(-5, 10)");
  EXPECT_EQ(mode(a, line(0, -30)), "(10, 10)");
  EXPECT_EQ(mode(a, line(-30, -40)), "(10, 10)(14, 2)");
  EXPECT_EQ(mode(a, line(-40, 0)), "(10, 10)(10, -10)");
  EXPECT_EQ(mode(a, arc(-40, 30, 1)), "(-5.3589838486225, 10)");
  EXPECT_EQ(mode(a, arc(-30, -40, -1)), "(3.3333333333333, 10)(6, 8)");
  EXPECT_EQ(mode(a, arc(-40, 30, -1)), "(10, 10)(14, 2)(8, -6)");
  EXPECT_EQ(mode(arc(-30, -40, 1, -10), line(-40, 0, -10)), "(6, 8)(3.3333333333333, 10)");
  EXPECT_EQ(mode(arc(0, -30, -1), arc(-30, 0, -1)), "(0, 10)(10, 10)(10, 0)");
  // Two arcs of radius 50 about (-40, -30) and (40, -30) meet above: offset to the inside of both, R' = 40, at height
  // -30 over a half distance of 40: the circles touch at (0, -30). Derived.
  EXPECT_EQ(mode(arc(-40, -30, 1), arc(40, -30, 1)), "(0, -30)");
  EXPECT_EQ(mode(arc(-40, -30, 1, 11), arc(40, -30, 1, 11)), "none");
  // The same with the line Y = 10 above the circle of R' = 40 about (-40, -30).
  EXPECT_EQ(mode(a, arc(-40, -30, 1)), "(-40, 10)");
  EXPECT_EQ(mode(line(40, 0, 11), arc(-40, -30, 1, 11)), "none");
}

TEST_F(ModelCorner, OffsetLargerThanTheRadius) {
  // R = 5 < 10: P1 of the former, at an inner corner only.
  EXPECT_EQ(mode(a, arc(-3, 4, 1)), "(0, 10)");
  EXPECT_EQ(mode(arc(3, 4, 1), line(0, 30)), text(perpendicular(arc(3, 4, 1))));
  // R = 10: the circle is the centre, on the offset line or not.
  EXPECT_EQ(mode(a, arc(-6, 8, 1)), "none");
  // Tangent joins do not ask.
  EXPECT_EQ(mode(a, arc(0, 8, 1)), "(0, 10)");
}

TEST_F(ModelCorner, StartUpAndCancel) {
  EXPECT_EQ(text(rules.start_or_cancel(a, line(40, -30), false)), "(6, 8)");
  EXPECT_EQ(text(type_b.start_or_cancel(a, line(40, -30), false)), "(0, 10)(3.3333333333333, 10)");
  EXPECT_EQ(text(type_b.start_or_cancel(a, line(0, 30), false)), "(-10, 0)");
  EXPECT_EQ(text(type_b.start_or_cancel(a, arc(-40, 30, -1), false)), "(0, 10)(10, 10)(14, 2)(8, -6)");
  EXPECT_EQ(text(type_b.start_or_cancel(a, line(-30, -40), true)), "(10, 10)(14, 2)(8, -6)");
  EXPECT_EQ(text(type_b.start_or_cancel(arc(-30, -40, 1, -10), line(-40, 0, -10), true)),
            "(6, 8)(3.3333333333333, 10)(0, 10)");
  EXPECT_EQ(text(rules.start_or_cancel(a, line(-30, -40), true)), "(0, 10)");
  // Under 1° there is no detour between lines; an arc has one.
  EXPECT_EQ(text(type_b.start_or_cancel(a, line(-40, 0), false)), "(0, -10)");
  EXPECT_EQ(text(type_b.start_or_cancel(a, line(-40, 0), true)), "(0, 10)");
  EXPECT_EQ(text(type_b.start_or_cancel(a, arc(0, 30, -1), false)), "(0, 10)(10, 10)(10, -10)(0, -10)");
}

TEST_F(ModelCorner, CancelAlongADirection) {
  EXPECT_EQ(text(rules.cancel_along(a, {0, -7})), "(10, 10)");
  EXPECT_EQ(text(rules.cancel_along(a, {0, 7})), "(-10, 10)");
  EXPECT_EQ(text(rules.cancel_along(a, {5, 0})), "(0, 10)");
  EXPECT_EQ(text(rules.cancel_along(a, {-5, 0})), "(0, 10)");
  EXPECT_EQ(text(rules.cancel_along(arc(0, -60, -1), {-10, -10})), "(20.937502231726, 6.7953666079951)");
  // R' < 0.
  EXPECT_EQ(text(rules.cancel_along(arc(0, 6, 1), {-10, -10})), "(0, 10)");
}

TEST_F(ModelCorner, ChangeOfDirection) {
  const auto change = [this](const PathEnd& latter) { return text(direction_change(recorder, a, latter)); };
  EXPECT_EQ(change(line(0, 30, -10)), "(10, 10)");
  EXPECT_EQ(change(line(-40, 0, -10)), "(0, 10)");
  EXPECT_EQ(change(line(40, 0, -10)), "(0, -10)");
  EXPECT_EQ(change(arc(-40, 30, 1, -10)), "(16.5685424949238, 10)");
  EXPECT_EQ(change(arc(0, 30, 1, -10)), "(0, -10)");    // tangent
  EXPECT_EQ(change(arc(0, 30, -1, -10)), "(0, 10)");    // straight back
  EXPECT_EQ(change(arc(-3, -4, -1, -10)), "(-6, -8)");  // R' < 0
}

TEST_F(ModelCorner, SmallMovements) {
  const OffsetPath next = line_path({-20, -99}, 10, 10);
  VectorGroup group = offset_mode(recorder, a, next.start).value();
  ASSERT_EQ(group.size(), 2U);
  CutterRules(setup("5010 = 2"), recorder).drop_small_movements(group, next);
  EXPECT_EQ(group.size(), 2U);
  CutterRules(setup("5010 = \"2.2\""), recorder).drop_small_movements(group, next);
  EXPECT_EQ(text(group), "(10, 10)");
  // The limit itself is small: the acute corner straight back differs by (0, -20).
  const OffsetPath back = line_path({-40, 0}, 10, 10);
  group = offset_mode(recorder, a, back.start).value();
  CutterRules(setup("5010 = 20"), recorder).drop_small_movements(group, back);
  EXPECT_EQ(text(group), "(10, 10)");
  group = offset_mode(recorder, a, back.start).value();
  CutterRules(setup("5010 = \"-1\""), recorder).drop_small_movements(group, back);
  EXPECT_EQ(group.size(), 2U);
}

TEST_F(ModelCorner, Interference) {
  const auto check = [this](const PlanePoint& travel, const VectorGroup& start, const VectorGroup& end) {
    const OffsetPath path = line_path(travel, 10, 10);
    const spec::Plane plane = spec::Plane::xy;
    SpaceGroup at_start = in_space(plane, start);
    SpaceGroup at_end = in_space(plane, end);
    const CheckedPath checked = between_vectors(plane, path);
    const Passage passage = check_interference(recorder, nullptr, checked, at_start, at_end, nullptr).passage;
    const char* const name = passage == Passage::free        ? "free "
                             : passage == Passage::shortened ? "shortened "
                                                             : "blocked ";
    return name + text(at_start) + " to " + text(at_end);
  };
  const VectorGroup inner{{{-10, 10}, Seat::on, Seat::on}};
  EXPECT_EQ(check({0, 20}, inner, {{{-10, -10}, Seat::on, Seat::on}}), "free (-10, 10) to (-10, -10)");
  EXPECT_EQ(check({0, 15}, inner, {{{-10, -10}, Seat::on, Seat::on}}).substr(0, 7), "blocked");
  // Pairs (V2, W1) and (V1, W1) of an acute corner before an inner one.
  const VectorGroup acute{{{10, 10}, Seat::off, Seat::off}, {{14, 2}, Seat::off, Seat::off}};
  EXPECT_EQ(check({-3, -4}, acute, {{{20, 10}, Seat::on, Seat::on}}).substr(0, 7), "blocked");
  // Derived: the first pair goes against the travel, the next one with it; the last ones stay.
  EXPECT_EQ(check({4, 0}, {{{0, 10}, {}, {}}, {{6, 10}, {}, {}}}, {{{0, 10}, {}, {}}}), "shortened (0, 10) to (0, 10)");
}

TEST_F(ModelCorner, ForcedOutcomesWithoutAFiniteVector) {
  // Straight back forced to be an inner corner.
  Recorder forced(true);
  forced.force(0, Sign::positive);
  EXPECT_THROW((void)offset_mode(forced, a, line(-40, 0)), NotFinite);
}

}  // namespace
