// Tool posture control of single blocks: the worked examples 3 to 8. Positions stand as "tool-side
// work-side" in degrees.
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/fanuc/posture_run.h"

namespace {

using namespace toolcomp;
using model::Angle;
using model::Direction;
using model::Pose;
using model::PosturePlan;
using model::Rational;
using model::Real;
using test::kHC;
using test::kMBC;
using test::kN45;
using test::kTAC;
using test::polar;
using test::pose_at;
using test::PostureMachine;
using test::text;

// 35.2643896827547 degrees: cosine 2, sine sqrt(2).
Angle pyramid() { return Angle::of_direction(2, sqrt(Real(2))); }
Direction edge(int i, int j) { return Direction::of({i, j, 2}); }

// Example 3: an edge of the pyramid.
TEST(ModelToolPosture, Ex3OnAHead) {
  const PostureMachine hc(kHC);
  const PosturePlan plan = hc.to({pyramid(), 135}, edge(-1, -1));
  EXPECT_EQ(text(plan.end), "35.2643896827547 225");
  EXPECT_EQ(pose_at(plan, Rational(1, 4), 12), "28.98724661424 154.488330009362");
  EXPECT_EQ(pose_at(plan, Rational(1, 2), 12), "26.565051177078 180");
  EXPECT_EQ(pose_at(plan, Rational(3, 4), 12), "28.98724661424 205.511669990638");
  EXPECT_EQ(text(plan.motion->at(Rational(1, 4)).tool), "-0.437363799276446 0.208721190616481 0.874727598552893");
  EXPECT_EQ(text(plan.motion->at(Rational(1, 2)).tool), "-0.447213595499958 0 0.894427190999916");
  EXPECT_EQ(text(plan.motion->at(Rational(3, 4)).tool), "-0.437363799276446 -0.208721190616481 0.874727598552893");
}

// The conventional block: C runs evenly, B stands.
TEST(ModelToolPosture, Ex3Conventional) {
  const PostureMachine hc(kHC);
  const Pose start{pyramid(), 135};
  const PosturePlan plan = hc.posture.conventional(hc.frame, {start, hc.direction(start), edge(-1, -1), {}, {}});
  EXPECT_EQ(text(plan.end), "35.2643896827547 225");
  EXPECT_EQ(text(plan.motion->at(Rational(1, 4)).tool), "-0.533402096794177 0.220942382690395 0.816496580927726");
  EXPECT_EQ(text(plan.motion->at(Rational(1, 2)).tool), "-0.577350269189626 0 0.816496580927726");
}

TEST(ModelToolPosture, Ex3OnOtherMachines) {
  const PostureMachine tac(kTAC);
  const PosturePlan table = tac.to({pyramid(), 225}, edge(-1, -1));
  EXPECT_EQ(text(table.end), "35.2643896827547 315");
  EXPECT_EQ(pose_at(table, Rational(1, 4), 12), "28.98724661424 244.488330009362");
  EXPECT_EQ(pose_at(table, Rational(1, 2), 12), "26.565051177078 270");
  EXPECT_EQ(pose_at(table, Rational(3, 4), 12), "28.98724661424 295.511669990638");
  const PostureMachine mbc(kMBC);
  const PosturePlan mixed = mbc.to({pyramid(), 135}, edge(-1, -1));
  EXPECT_EQ(pose_at(mixed, Rational(1, 4), 12), "28.98724661424 154.488330009362");
  EXPECT_EQ(text(mixed.end), "35.2643896827547 225");
}

TEST(ModelToolPosture, Ex3OnANutatingHead) {
  const PostureMachine n45(kN45);
  // The pair of (-1, 1, 2) with B 50.7…: C 116.4….
  model::Recorder recorder;
  const model::Solutions pairs = inverse(n45.machine, recorder, edge(-1, 1));
  const Pose start = pairs.at[0].pose.tool > Angle(0) ? pairs.at[0].pose : pairs.at[1].pose;
  EXPECT_EQ(text(start, 12), "50.728700549047 116.467819046821");
  const PosturePlan plan = n45.to(start, edge(-1, -1));
  EXPECT_EQ(pose_at(plan, Rational(1, 4), 12), "41.456792600235 139.507322177772");
  EXPECT_EQ(pose_at(plan, Rational(1, 2), 12), "37.921419763845 166.345415254024");
  EXPECT_EQ(pose_at(plan, Rational(3, 4), 12), "41.456792600235 190.530662159048");
  EXPECT_EQ(text(plan.end, 12), "50.728700549047 206.467819046821");
}

// Example 4: type 1.
TEST(ModelToolPosture, Ex4TypeOne) {
  const PostureMachine hc(kHC);
  const PosturePlan plan = hc.to(Pose{20, 0}, Pose{40, 90});
  EXPECT_FALSE(plan.branch_differs);
  EXPECT_EQ(text(plan.motion->at(Rational(1, 4)).tool), "0.268133688322374 0.176528861603656 0.947070159073528");
  EXPECT_EQ(text(plan.motion->at(Rational(1, 2)).tool), "0.184413141980199 0.346583337389474 0.919712880908474");
  EXPECT_EQ(text(plan.motion->at(Rational(3, 4)).tool, 14), "0.09392904535954 0.50392649660129 0.85862414388427");
  EXPECT_EQ(pose_at(plan, Rational(1, 4)), "18.7250240410852 33.3593629436283");
  EXPECT_EQ(pose_at(plan, Rational(1, 2)), "23.1158568832211 61.9830533459686");
  EXPECT_EQ(pose_at(plan, Rational(3, 4)), "30.8375489371282 79.441555265135");
  // A swing of 200 degrees, a turn more, the other branch: the plane cannot be followed to what is commanded.
  EXPECT_TRUE(hc.to(Pose{20, 0}, Pose{20, 200}).branch_differs);
  EXPECT_TRUE(hc.to(Pose{20, 0}, Pose{40, 450}).branch_differs);
  EXPECT_TRUE(hc.to(Pose{20, 0}, Pose{-40, 90}).branch_differs);
  EXPECT_TRUE(hc.to(Pose{20, 0}, Pose{400, 90}).branch_differs);
  // Across the pole with C standing.
  EXPECT_FALSE(hc.to(Pose{20, 0}, Pose{-40, 0}).branch_differs);
  EXPECT_EQ(pose_at(hc.to(Pose{20, 0}, Pose{-40, 0}), Rational(1, 3)), "0 0");
}

// Example 5: near the pole of a head.
TEST(ModelToolPosture, Ex5Unchanged) {
  const std::string near = kHC + "19738 = 1\n19739 = 3\n";
  const PostureMachine hc(near);
  const Direction end = polar(12, 176);
  const PosturePlan plan = hc.to({10, 0}, end);
  EXPECT_FALSE(plan.changed);
  EXPECT_EQ(text(plan.end), "12 176");
  EXPECT_EQ(pose_at(plan, Rational(1, 10), 14), "7.80345595842618 0.62716053289532");
  EXPECT_EQ(plan.motion->at(Rational(1, 10)).pose.work.degrees().decimal(15), "0.627160532895321");
  EXPECT_EQ(pose_at(plan, Rational(3, 10), 14), "3.41845337728643 4.27970316883873");
  EXPECT_EQ(pose_at(plan, Rational(4, 10), 13), "1.2584903950637 15.6447476915161");
  EXPECT_EQ(pose_at(plan, Rational(5, 10), 12), "1.072282522858 156.749981593727");
  EXPECT_EQ(pose_at(plan, Rational(6, 10), 12), "3.222390215892 170.951321299778");
  EXPECT_EQ(PostureMachine(near + "\"19696#3\" = 1\n").alarm({10, 0}, end), "PS5421");
  // Without a limit nobody looks.
  EXPECT_FALSE(PostureMachine(kHC + "19739 = 5\n\"19696#3\" = 1\n").to({10, 0}, end).changed);
}

TEST(ModelToolPosture, Ex5Changed) {
  const PostureMachine hc(kHC + "19738 = 1\n19739 = 5\n");
  const PosturePlan plan = hc.to({10, 0}, polar(12, 176));
  EXPECT_TRUE(plan.changed);
  EXPECT_EQ(text(plan.end), "-12 0");
  EXPECT_EQ(text(plan.tool.unit), "-0.207911690817759 0 0.978147600733806");
  EXPECT_EQ(pose_at(plan, Rational(1, 4)), "4.5 0");
  EXPECT_EQ(pose_at(plan, Rational(5, 11)), "0 0");
  EXPECT_EQ(text(plan.motion->at(Rational(1, 4)).tool), "0.078459095727845 0 0.996917333733128");
  EXPECT_EQ(text(plan.motion->at(Rational(1, 2)).tool), "-0.017452406437284 0 0.999847695156391");
  // The next block starts from the changed pair.
  const PosturePlan next = hc.to(plan.end, polar(30, 200));
  EXPECT_EQ(text(next.end), "-30 20");
  EXPECT_EQ(pose_at(next, Rational(1, 2)), "-20.7582829496743 14.1611368115305");
}

TEST(ModelToolPosture, Ex5OnATableAndAroundTheOtherPole) {
  const std::string near = "19738 = 1\n19739 = 5\n";
  const PostureMachine tac(kTAC + near);
  const PosturePlan table = tac.to({10, 0}, tac.direction({12, 176}));
  EXPECT_EQ(text(table.end), "-12 0");
  EXPECT_EQ(text(table.motion->at(Rational(1, 2)).tool), "0 0.017452406437284 0.999847695156391");
  const PostureMachine hc(kHC + near);
  const PosturePlan below = hc.to({172, 0}, polar(170, 177));
  EXPECT_TRUE(below.changed);
  EXPECT_EQ(text(below.end), "190 0");
}

// Example 7: delta is 5.71059313749964.
TEST(ModelToolPosture, Ex7RationalNearTest) {
  const auto changed = [](const std::string& limit, const std::string& veto) {
    const PostureMachine hc(kHC + "19738 = " + limit + "\n19739 = " + veto + "\n");
    return hc.to({Angle::of_direction(5, 1), 0}, Direction::of({-1, Rational(1, 10), 5})).changed;
  };
  EXPECT_TRUE(changed("1", "5.7105931375"));
  EXPECT_FALSE(changed("1", "5.7105931374"));
  // d = 0.572223911907299.
  EXPECT_TRUE(changed("0.5722239119073", "6"));
  EXPECT_FALSE(changed("0.572223911907", "6"));
}

TEST(ModelToolPosture, Ex7ExactCrossing) {
  const PostureMachine hc(kHC + "19738 = 90\n19739 = 180\n");
  const PosturePlan plan = hc.to({Angle::of_direction(2, 1), 0}, Direction::of({-2, 0, 3}));
  EXPECT_FALSE(plan.changed);
  EXPECT_EQ(text(plan.start), "26.565051177078 0");
  EXPECT_EQ(text(plan.end), "-33.6900675259798 0");
}

// Example 8, the first block: from the pole.
TEST(ModelToolPosture, Ex8FromThePole) {
  const PostureMachine hc(kHC);
  const PostureMachine tac(kTAC);
  const PostureMachine mbc(kMBC);
  const PosturePlan head = hc.to({0, 0}, edge(-1, 1));
  EXPECT_TRUE(head.pre_turn);
  EXPECT_EQ(text(head.start), "0 -45");
  EXPECT_EQ(text(head.end), "-35.2643896827547 -45");
  EXPECT_EQ(text(head.motion->at(Rational(1, 4)).tool), "-0.108373643161723 0.108373643161723 0.988185360615968");
  EXPECT_EQ(text(head.motion->at(Rational(1, 2)).tool), "-0.214186495298066 0.214186495298066 0.953020613871423");
  EXPECT_EQ(text(head.motion->at(Rational(3, 4)).tool), "-0.314938275028657 0.314938275028657 0.895336677369998");
  EXPECT_EQ(text(tac.to({0, 0}, edge(-1, 1)).end), "-35.2643896827547 45");
  EXPECT_EQ(text(mbc.to({0, 0}, edge(-1, 1)).end), "-35.2643896827547 -45");
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

// No plane: the rules of choice; the same direction again stands.
TEST(ModelToolPosture, EqualAndOpposite) {
  const PostureMachine hc(kHC);
  const PosturePlan same = hc.to({30, 60}, hc.direction({30, 60}));
  EXPECT_EQ(text(same.end), "30 60");
  // Type 1, example 11: t = 1/4 (45, 60), t = 1/2 (90, 90).
  const PosturePlan opposite = hc.to(Pose{30, 0}, Pose{150, 180});
  EXPECT_EQ(pose_at(opposite, Rational(1, 4)), "60 45");
  EXPECT_EQ(text(opposite.motion->at(Rational(1, 4)).tool), "0.612372435695795 0.612372435695795 0.5");
  EXPECT_EQ(text(opposite.motion->at(Rational(1, 2)).tool), "0 1 0");
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
