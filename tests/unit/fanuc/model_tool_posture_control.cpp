// SPDX-License-Identifier: Apache-2.0
// Tool posture control of single blocks, beside the worked examples (golden/fanuc/corpus_examples_tool_posture.cpp).
// Positions stand as "tool-side work-side" in degrees.
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/fanuc/posture_run.h"
#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;
using model::Angle;
using model::Direction;
using model::Pose;
using model::PosturePlan;
using model::Rational;
using model::Real;
using test::kHC;
using test::kN45;
using test::kTAC;
using test::polar;
using test::pose_at;
using test::PostureMachine;
using test::text;

// 35.2643896827547 degrees: cosine 2, sine sqrt(2).
Angle pyramid() { return Angle::of_direction(2, sqrt(Real(2))); }

TEST(ModelToolPosture, BranchOfTypeOne) {
  const PostureMachine hc(kHC);
  EXPECT_FALSE(hc.to(Pose{20, 0}, Pose{40, 90}).branch_differs);
  // A swing of 200 degrees, a turn more, the other branch: the plane cannot be followed to what is commanded.
  EXPECT_TRUE(hc.to(Pose{20, 0}, Pose{20, 200}).branch_differs);
  EXPECT_TRUE(hc.to(Pose{20, 0}, Pose{40, 450}).branch_differs);
  EXPECT_TRUE(hc.to(Pose{20, 0}, Pose{-40, 90}).branch_differs);
  EXPECT_TRUE(hc.to(Pose{20, 0}, Pose{400, 90}).branch_differs);
  // Across the pole with C standing.
  EXPECT_FALSE(hc.to(Pose{20, 0}, Pose{-40, 0}).branch_differs);
  EXPECT_EQ(pose_at(hc.to(Pose{20, 0}, Pose{-40, 0}), Rational(1, 3)), "0 0");
}

// Found by a campaign. The tool, commanded in the plane X Y, leans there along a line and along an arc: both ends are
// at right angles to the work-side axis Z, so they stand 90 degrees of tilt, 85 of A beside 19698, and no further proof
// is asked for.
TEST(ModelToolPosture, LeansInThePlaneAcrossTheWorkSideAxis) {
  const auto done = test::run(R"(control = "fanuc"
axes = ["X", "Y", "Z", "A", "C"]
increment = "IS-A"
parameters = {"19604#0" = 1, 19680 = 21, 19681 = 4, 19682 = 1, 19686 = 5, 19687 = 3, 19689 = 1, 19698 = 5, 19700 = 155, 19701 = 259, 19702 = "-280.05", 19709 = 32, 19710 = "44.02", 19738 = 10, 19739 = 90}
offsets = {H = {1 = 0, 2 = "129.9"}}
)",
                              R"(G43.5 H2 P1
I3123.77 J-168.58 K8438.82 X-2490.04 Y-1008.28 Z-2394.82
X-2176.49 Y945.07 Z-2332.57 J-1. K1.
G91 X66.19 Y19.15 Z-29.61
G43.4 H1 P1 X5 Z25
G01 G43.5 H2 P1 Q2.
I966.39 J683.13 K8921.85
X45. Y-70. Z-70. I-911.82 J-436.03 K8943.07
I1823.64 J872.06 K17886.14
X-14.98 Y68.36 Z1.8
G03 X77.11 Y9.32 R403.11 I40104.63 J-5306.26 G1
G03 X-26.69 Y-41.67 R-35.
)");
  const model::Event& last = done.events().back();
  EXPECT_EQ(last.line, 12U);
  ASSERT_EQ(last.kind, spec::EventKind::move);
  EXPECT_EQ(last.axes[3].decimal(9), "85");
  ASSERT_TRUE(last.tool_axis);
  EXPECT_EQ((*last.tool_axis)[2].decimal(9), "0");
}

TEST(ModelToolPosture, WithoutALimitNobodyLooks) {
  EXPECT_FALSE(PostureMachine(kHC + "19739 = 5\n\"19696#3\" = 1\n").to({10, 0}, polar(12, 176)).changed);
}

// Worked example 7 at the last digit of its limits: delta is 5.71059313749964.
TEST(ModelToolPosture, RationalNearTest) {
  const auto changed = [](const std::string& limit, const std::string& veto) {
    const PostureMachine hc(kHC + "19738 = " + limit + "\n19739 = " + veto + "\n");
    return hc.to({Angle::of_direction(5, 1), 0}, Direction::of({-1, Rational(1, 10), 5})).changed;
  };
  EXPECT_TRUE(changed("1", "5.71059313749965"));
  EXPECT_FALSE(changed("1", "5.71059313749963"));
  // d = 0.572223911907299.
  EXPECT_TRUE(changed("0.5722239119073", "6"));
  EXPECT_FALSE(changed("0.572223911907", "6"));
}

// Type 1 at the pole: C commanded is reached by a turn before, or behind, the block.
TEST(ModelToolPosture, TurnsAtThePole) {
  const PostureMachine hc(kHC);
  const PosturePlan away = hc.to(Pose{0, 0}, Pose{30, 60});
  EXPECT_TRUE(away.pre_turn);
  EXPECT_EQ(text(away.start), "0 60");
  EXPECT_EQ(pose_at(away, Rational(1, 2)), "15 60");
  const PosturePlan back = hc.to(Pose{30, 60}, Pose{0, 0});
  EXPECT_FALSE(back.pre_turn);
  EXPECT_EQ(text(back.end), "0 60");
  ASSERT_TRUE(back.post_turn);
  EXPECT_EQ(text(*back.post_turn), "0 0");
  // No turn where C stands there already; the other multiple of B is no end of the plane.
  EXPECT_FALSE(hc.to(Pose{0, 60}, Pose{30, 60}).pre_turn);
  EXPECT_FALSE(hc.to(Pose{30, 60}, Pose{0, 60}).post_turn);
  EXPECT_TRUE(hc.to(Pose{30, 60}, Pose{360, 60}).branch_differs);
  EXPECT_TRUE(hc.to(Pose{360, 60}, Pose{30, 60}).branch_differs);
  // Type 2: C stays where it is.
  const PosturePlan directed = hc.to(Pose{30, 60}, Direction::of({0, 0, 5}));
  EXPECT_EQ(text(directed.end), "0 60");
}

// On the nutating head the work-side axis moves along a great circle to the pole, and comes from where it then is.
TEST(ModelToolPosture, ThePoleOfANutatingHead) {
  const PostureMachine n45(kN45);
  const Pose start{60, 20};
  const PosturePlan down = n45.to(start, Direction::of({0, 0, 1}));
  EXPECT_EQ(down.end.tool.degrees().decimal(12), "0");
  EXPECT_EQ(down.motion->at(Rational(999999, 1000000)).pose.work.degrees().decimal(3),
            down.end.work.degrees().decimal(3));
  // Followed back the same way.
  const PosturePlan up = n45.to({0, 0}, n45.direction(start));
  EXPECT_EQ(up.end.tool.principal().degrees().decimal(9), up.end.tool.degrees().decimal(9));
  const PosturePlan mid = n45.to(up.start, up.tool);
  EXPECT_FALSE(mid.pre_turn);
  EXPECT_EQ(up.motion->at(Rational(1, 1000000)).pose.work.degrees().decimal(3), up.start.work.degrees().decimal(3));
  // Through the pole, exactly: at t = 1/2 of equal ends it is there, also where only algebra can tell.
  const PosturePlan through = n45.to(
      start, Direction::of({-n45.direction(start).unit.x, -n45.direction(start).unit.y, n45.direction(start).unit.z}));
  const model::Posture pole = through.motion->at(Rational(1, 2));
  EXPECT_EQ(text(pole.tool), "0 0 1");
  EXPECT_EQ(text(pole.pose), text(down.end));
  EXPECT_EQ(text(through.motion->at(Rational(1, 4)).pose, 9), text(down.motion->at(Rational(1, 2)).pose, 9));
  EXPECT_EQ(text(through.end, 4), text(through.motion->at(Rational(99999999, 100000000)).pose, 4));
}

// No plane: the same direction again stands.
TEST(ModelToolPosture, EqualDirections) {
  const PostureMachine hc(kHC);
  const PosturePlan same = hc.to({30, 60}, hc.direction({30, 60}));
  EXPECT_EQ(text(same.end), "30 60");
}

TEST(ModelToolPosture, ReachAndRange) {
  // A head that cannot come nearer than 5 degrees to the pole: ends are reached, the way between is not.
  const PostureMachine tilted(kHC + "19698 = 5\n");
  EXPECT_EQ(tilted.alarm({10, 0}, tilted.direction({10, 175})), "PS5459");
  EXPECT_EQ(tilted.alarm(Pose{10, 0}, Pose{10, 175}), "PS5459");
  EXPECT_EQ(tilted.alarm({10, 0}, Direction::of({0, 0, 1})), "PS5459");
  EXPECT_EQ(tilted.alarm({10, 0}, tilted.direction({10, 20})), "none");
  const PostureMachine limited(kHC + "19741 = 170\n19742 = -170\n19743 = 90\n19744 = -90\n");
  EXPECT_EQ(limited.alarm({20, 100}, polar(20, 180)), "PS5459");
  EXPECT_EQ(limited.alarm({20, 100}, polar(20, 170)), "none");
}

// A about (1, 1, 0) carries B, the reference leans 45 degrees: -u_w is singular at B -90, the edge of reach is across
// u_w. B goes on through the pole, 0 to -90 to -270; a half turn the other way would jump.
TEST(ModelToolPosture, TheEdgeOfReachBehindAPole) {
  const PostureMachine below("19680 = 2\n19681 = 4\n19682 = 4\n19683 = 45\n19686 = 5\n19687 = 2\n19698 = 45\n");
  const PosturePlan plan = below.to({0, 0}, Direction::of({-1, 1, -2}));
  EXPECT_EQ(text(plan.end), "-270 125.2643896827547");
  EXPECT_EQ(text(plan.motion->at(Rational(999999, 1000000)).pose, 0), "-270 125");
  // Up to +u_w of the nutating head and on: B 60 to 0 to -180.
  const PostureMachine n45(kN45);
  const Direction start = n45.direction({60, 0});
  const PosturePlan above = n45.to({60, 0}, Direction::of({-start.unit.x, -start.unit.y, 0}));
  EXPECT_EQ(above.end.tool.degrees().decimal(12), "-180");
}

// From the edge of reach, along Y, to upright. The pair chosen has B half a turn up, 0 or 360 alike near to 0, so the
// greater; by hand the azimuth of the tilted direction goes from 90 to 180 on that way, so C to -90. A table sees the
// pole, from its frame at B 180, along Y.
TEST(ModelToolPosture, FromTheEdgeOfReachToAPole) {
  const std::string nutating_table =
      "19680 = 12\n19681 = 5\n19682 = 5\n19683 = 45\n19684 = 1\n19686 = 6\n19687 = 3\n19689 = 1\n";
  const std::string nutating_mixed = "19680 = 21\n19681 = 5\n19682 = 5\n19683 = 45\n19686 = 6\n19687 = 3\n19689 = 1\n";
  for (const auto& [from, to] : {std::pair{180, "360 -90"}, std::pair{-180, "0 -90"}, std::pair{540, "720 -90"}}) {
    const PostureMachine n45(kN45);
    const PosturePlan plan = n45.to({from, 0}, Direction::of({0, 0, 1}));
    EXPECT_EQ(text(plan.end), to);
    // (1 + cos B)/2 = cos 45 in the middle, from an independent computation.
    EXPECT_EQ((plan.motion->at(Rational(1, 2)).pose.tool - Angle(from)).degrees().decimal(12), "114.469800520702");
    EXPECT_EQ(plan.motion->at(Rational(1, 2)).pose.work.degrees().decimal(12), "-65.530199479298");
    EXPECT_EQ(text(PostureMachine(nutating_mixed).to({from, 0}, Direction::of({0, 0, 1})).end), to);
    EXPECT_EQ(text(PostureMachine(nutating_table, {from, 0}).to({from, 0}, Direction::of({0, 1, 0})).end), to);
  }
  // Type 1: toward the pair commanded.
  const PostureMachine n45(kN45);
  EXPECT_FALSE(n45.to({180, 0}, Pose{360, -90}).branch_differs);
  EXPECT_FALSE(n45.to({180, 0}, Pose{0, 90}).branch_differs);
  const PosturePlan turned = n45.to({180, 0}, Pose{360, 10});
  EXPECT_FALSE(turned.branch_differs);
  EXPECT_EQ(text(turned.end), "360 -90");
  ASSERT_TRUE(turned.post_turn);
  EXPECT_EQ(text(*turned.post_turn), "360 10");
  EXPECT_TRUE(n45.to({180, 0}, Pose{720, -90}).branch_differs);
}

// The whole arc lies on the edge of reach of the nutating head: B stands at 180, V turns with C, evenly.
TEST(ModelToolPosture, AlongTheEdgeOfReach) {
  const PostureMachine n45(kN45);
  const PosturePlan plan = n45.to({180, -90}, Direction::of({0, 1, 0}));
  EXPECT_EQ(text(plan.end), "180 0");
  EXPECT_EQ(pose_at(plan, Rational(1, 4)), "180 -67.5");
  EXPECT_EQ(pose_at(plan, Rational(2, 3)), "180 -30");
}

// Type 1 in a frame that stands at angles of I J K: the frame does not enter. By hand: C stands, so does the plane; B
// turns evenly. With C turning too the plane misses the pole by as much as in the frame at 0.
TEST(ModelToolPosture, Type1InAFrameAtAnyPose) {
  const Pose any{pyramid(), Angle::of_direction(3, sqrt(Real(7)))};
  const PostureMachine tac(kTAC, any);
  const PosturePlan plain = tac.to(any, Pose{Angle(-40), any.work});
  EXPECT_FALSE(plain.branch_differs);
  EXPECT_EQ(text(plain.end), text(Pose{Angle(-40), any.work}));
  const PostureMachine inclined(
      "19680 = 12\n19681 = 4\n19682 = 1\n19684 = 1\n19686 = 6\n19687 = 5\n19688 = 60\n19689 = 1\n", any);
  const PostureMachine at_zero(
      "19680 = 12\n19681 = 4\n19682 = 1\n19684 = 1\n19686 = 6\n19687 = 5\n19688 = 60\n19689 = 1\n");
  const Pose from{20, 30};
  const Pose to{50, 40};
  const PosturePlan turned = inclined.to(from, to);
  const PosturePlan straight = at_zero.to(from, to);
  EXPECT_EQ(turned.branch_differs, straight.branch_differs);
  EXPECT_EQ(pose_at(turned, Rational(1, 3)), pose_at(straight, Rational(1, 3)));
}

// Conventional, to the direction there is: nothing moves, though both axes stand at angles of I J K.
TEST(ModelToolPosture, TheSameDirectionStands) {
  const PostureMachine tac(kTAC, {pyramid(), Angle::of_direction(3, sqrt(Real(7)))});
  const PosturePlan first =
      tac.posture.conventional(tac.frame, {Pose{0, 0}, tac.direction({0, 0}), Direction::of({1, 2, 3}), {}, {}});
  const PosturePlan again =
      tac.posture.conventional(tac.frame, {first.end, Direction::of({1, 2, 3}), Direction::of({2, 4, 6}), {}, {}});
  EXPECT_TRUE(again.end == first.end);
}

}  // namespace
