// SPDX-License-Identifier: Apache-2.0
// Near ties: the other outcome of a decision inside its band is permitted, outside it is a difference. The wrong
// answers are the model's own, with the decision forced: a controller whose arithmetic errs would give just these.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <initializer_list>
#include <random>
#include <string>

#include "fuzz/gen/encode.h"
#include "judge/oracle/compare.h"
#include "judge/oracle/number.h"
#include "judge/oracle/policy.h"
#include "judge/oracle/verdict.h"
#include "tests/harness/liar.h"

namespace toolcomp::judge {
namespace {

using exact::Sign;
using spec::Clause;

// A tool leaning by I : K towards a movement along X, offset 10, no fluctuation range.
spec::Case leaning(const std::string& i, const std::string& range = "0") {
  spec::Case c;
  c.section = "fanuc/leading-edge-offset";
  c.setup.d[1].geometry = spec::decimal(10);
  c.setup.parameters[{19631, -1}] = *spec::parse_decimal(range);
  c.program = "G91 G01 F100 G43.5 H0 I" + i + " K1.\nG41.3 D1\nX100.\nX50.\nG40\n";
  return c;
}

// Every decision of `clause` takes the opposite outcome.
Forced opposite(const ModelRun& run, Clause clause) {
  Forced forced;
  const auto& decisions = run.recorder.decisions();
  for (std::size_t i = 0; i < decisions.size(); ++i)
    if (decisions[i].clause == clause) forced[i] = -decisions[i].outcome;
  return forced;
}

TEST(NearTies, InsideTheBandTheOtherOutcomeIsPermittedAndCounted) {
  // The lean is 1e-13 of a right angle's: |VM·VT| / (|VM| |VT|) = 1e-13 < 2^-40 = 9.1e-13.
  const spec::Case c = leaning("0.0000000000001");
  const ModelRun run = run_model(c);
  const std::vector<fast::Event> other = test::in_doubles(run_model(c, opposite(run, Clause::fanuc_leading_edge_sign)));
  ASSERT_NE(other[1].point.value[0], test::in_doubles(run)[1].point.value[0]);  // -10 and +10
  const Verdict v = judge::judge(c, run, other);
  EXPECT_EQ(v.outcome, Outcome::agrees) << (v.difference ? explain(*v.difference) : v.undecided);
  EXPECT_GE(v.ties, 1U);
  EXPECT_GE(v.near_ties, v.ties);
  // The exact answer is right as well, and no tie was needed.
  EXPECT_EQ(judge::judge(c, run, test::in_doubles(run)).outcome, Outcome::agrees);
  EXPECT_EQ(judge::judge(c, run, test::in_doubles(run)).ties, 0U);
}

TEST(NearTies, OutsideTheBandTheOtherOutcomeIsADifference) {
  // 1e-11 > 2^-40.
  const spec::Case c = leaning("0.00000000001");
  const ModelRun run = run_model(c);
  const Verdict v =
      judge::judge(c, run, test::in_doubles(run_model(c, opposite(run, Clause::fanuc_leading_edge_sign))));
  ASSERT_EQ(v.outcome, Outcome::differs);
  EXPECT_EQ(v.difference->field, "point.X");
  EXPECT_NEAR(v.difference->deviation_um, 20'000, 1);
}

TEST(NearTies, OneWrongEventInAnOtherwisePermittedListIsADifference) {
  const spec::Case c = leaning("0.0000000000001");
  const ModelRun run = run_model(c);
  std::vector<fast::Event> other = test::in_doubles(run_model(c, opposite(run, Clause::fanuc_leading_edge_sign)));
  other[2].point.value[2] += 0.001;
  EXPECT_EQ(judge::judge(c, run, other).outcome, Outcome::differs);
  // Neither outcome: the vector of a run is one of the two, not something between.
  other = test::in_doubles(run);
  other[1].point.value[0] = 0;
  EXPECT_EQ(judge::judge(c, run, other).outcome, Outcome::differs);
}

// An exact tie has no finite vector on its other side: a tool along the movement, classified as not along.
TEST(NearTies, AnOutcomeWithoutFiniteVectorsIsNotPermitted) {
  spec::Case c = leaning("0");
  c.program = "G91 G01 F100 G43.5 H0 K1.\nG41.3 D1\nX100. Z10.\nZ50.\nX10.\nG40\n";
  const ModelRun run = run_model(c);
  bool tried = false;
  const auto& decisions = run.recorder.decisions();
  for (std::size_t i = 0; i < decisions.size(); ++i) {
    if (decisions[i].clause != Clause::fanuc_leading_edge_near_0 || margin(decisions[i]) != 0) continue;
    tried = true;
    EXPECT_THROW(run_model(c, {{i, Sign::negative}}), std::exception);
  }
  EXPECT_TRUE(tried);
  std::vector<fast::Event> wrong = test::in_doubles(run);
  wrong[2].point.value[0] += 3;
  EXPECT_EQ(judge::judge(c, run, wrong).outcome, Outcome::differs);
}

// A great circle through the pole of a tool side inclined by 45 degrees, X10 with I-1 K4 to X20 with I1 K4; beside the
// pole the work-side axis has turned by 90 degrees in the middle, where exactly through it it stands.
TEST(NearTies, ASampleInThePoleOfAGreatCircle) {
  spec::Case c;
  c.section = "fanuc/tool-posture-control";
  c.setup.axes = spec::Axes("XYZBC");
  for (const auto& [number, value] : std::vector<std::pair<std::uint32_t, std::int64_t>>{
           {19680, 2}, {19681, 5}, {19682, 3}, {19686, 4}, {19687, 5}, {19688, 45}})
    c.setup.parameters[{number, -1}] = spec::decimal(value);
  c.program = "G90 G01 F1000\nG43.5 H1 P1\nX10. I-1 K4\nX20. I1 K4\n";
  c.samples = 2;
  const ModelRun run = run_model(c);
  const auto middle = [](const ModelRun& of) { return test::in_doubles(of).at(of.events.size() - 2); };
  ASSERT_EQ(middle(run).kind, spec::EventKind::sample);
  const auto& decisions = run.recorder.decisions();
  int tried = 0;
  for (std::size_t i = 0; i < decisions.size(); ++i) {
    if (decisions[i].clause != Clause::fanuc_tool_posture_crossing || decisions[i].line != 4) continue;
    if (decisions[i].outcome != Sign::zero) continue;
    for (const Sign side : {Sign::positive, Sign::negative}) {
      const ModelRun beside = run_model(c, {{i, side}});
      EXPECT_DOUBLE_EQ(std::fabs(middle(beside).axes[4] - middle(run).axes[4]), 90);
      EXPECT_DOUBLE_EQ(middle(beside).axes[3], middle(run).axes[3]);
      const Verdict v = judge::judge(c, run, test::in_doubles(beside));
      EXPECT_EQ(v.outcome, Outcome::agrees) << (v.difference ? explain(*v.difference) : v.undecided);
      EXPECT_EQ(v.ties, 1U);
      ++tried;
    }
  }
  EXPECT_EQ(tried, 2);
}

// Axes A and C, a head (2), tables (12) or both (21); P1 with 19738 = 2 and 19739 as given.
spec::Case hardly_upright(int type, int veto, std::string_view program) {
  spec::Case c;
  c.section = "fanuc/tool-posture-control";
  c.setup.axes = spec::Axes("XYZAC");
  c.setup.h[1].geometry = spec::decimal(60);
  c.setup.h[2].geometry = spec::decimal(20);
  const auto set = [&](std::uint32_t number, std::int64_t value) {
    c.setup.parameters[{number, -1}] = spec::decimal(value);
  };
  const bool head = type == 2;
  set(19680, type);
  set(19681, head ? 5 : 4);
  set(19682, head ? 3 : 1);
  set(19684, 1);
  set(19686, head ? 4 : 5);
  set(19687, head ? 1 : 3);
  set(19689, 1);
  set(19738, 2);
  set(19739, veto);
  c.program = program;
  c.samples = 4;
  return c;
}

// Out of upright by 1e-19 (a position near 360 cannot tell), 1e-17 and 1e-13. The fast engine turned the table by half
// a turn, took one side of the pole for the other, or left an end as it was.
TEST(NearTies, HardlyOutOfASingularPosture) {
  struct Posture {
    int type;
    int veto;
    std::string_view program;
  };
  constexpr Posture kPostures[] = {
      {12, 90, "G01 F3100 A360. C-1350.\nG43.5 H1 P1\nX10. J.0000000000001 K984808\n"},
      {12, 90,
       "G01 F3100 A-360. C-90.\nG43.5 H1 P1\nI16. Y70.\nX10. J.0000000000001 K984808\nZ1. G43.5 H1 P1\n"
       "X10. J.0000000000001 K984808\nG43.5 H1 P1\nG90 X5.\n"},
      // The circle from 2e-19 beside one singular posture to 1e-19 beside the other passes the other one.
      {12, 90,
       "G91 G01 F3700 A-360. C-90.\nG43.5 H1 P1\nI16. Y70.\nX10. J.0000000000001 K984808\nZ1. G43.5 H2\n"
       "X20. I-1. K4\nX10. J.0000000000001 K984808\nZ1. G43.5 H2\nX10. J.0000000000001 K-984808\n"},
      {12, 1,
       "G91 G01 F3700 A-360. C45.\nG43.5 H1 P1\nX-4. J-.0000000000001 K984808\nG43.5\n"
       "X1. I-.0000000000001 J.0000000000005 K984808\n"},
      // 3e-17 beside the one, the root of 5 beside the other, which is nearer.
      {2, 180,
       "G91 G01 F3700 A0 C45.\nG43.5 H1 P1\nX-14. I-.0000000000003 K9848\n"
       "X-10. I-.0000000000001 J.0000000000002 K-9848\n"},
      // Near at its end, where the circle turns back to within 1e-26.
      {2, 180,
       "G91 G01 F3700 A0 C17.\nG43.5 H1 P1\nX-19. I-.0000000000003 J-.0000000000001 K1\nX11. I-.0000000000003 K1\n"},
      // Nearly opposite directions; the oracle granted their circle nothing.
      {21, 0,
       "G91 G01 F3700 A30. C45.\nG43.5 H1 P1\nX13. J-.0000000000001 K98\nX1. J.0000000000002 K98\nZ1. G43.5 H2\n"
       "X-1. I-.0000000000001 J.0000000000002 K-98\n"},
      // Positions that the end of the mode leaves, of a work-side position that doubles hardly know.
      {12, 1,
       "G91 G01 F3700 A0 C17.\nG43.5 H1 P1\nX13. I.0000000000001 J.0000000000005 K98\nG43.5\n"
       "X19. I.0000000000002 J-.0000000000001 K98\nG43.5\nX-14. I-.0000000000001 K98\n"},
  };
  for (const Posture& posture : kPostures) {
    SCOPED_TRACE(posture.program);
    const spec::Case c = hardly_upright(posture.type, posture.veto, posture.program);
    const Verdict v = judge::judge(c, run_fast(c));
    EXPECT_EQ(v.outcome, Outcome::agrees) << (v.difference ? explain(*v.difference) : v.undecided);
  }
}

// A program of directions 1e-13, 1e-15 or 1e-17 beside either singular posture, some far away, and new modes.
std::string among_singular_postures(std::mt19937_64& random) {
  const auto any = [&](std::initializer_list<int> of) { return of.begin()[random() % of.size()]; };
  const auto word = [&](char letter, int tenths) {
    return tenths == 0 ? std::string()
                       : fmt::format("{}{}.000000000000{} ", letter, tenths < 0 ? "-" : "", std::abs(tenths));
  };
  const int height = any({1, 98, 9848});
  std::string program =
      fmt::format("G91 G01 F3700 A{}. C{}.\nG43.5 H1 P1\n", any({0, 0, 360, -360, 30}), any({0, -90, 45, 17}));
  for (int blocks = any({2, 3, 4, 5, 6}); blocks > 0; --blocks) {
    std::string lean = word('I', any({0, 1, -1, 2, -3})) + word('J', any({0, 1, -1, 2, 5}));
    if (lean.empty()) lean = "I0 ";
    program += fmt::format("X{}. ", any({-20, -7, 0, 3, 18}));
    if (any({0, 0, 0, 1}) == 1)
      program += any({0, 1}) == 0 ? "I16. K5\n" : "I1. J1. K-1\n";
    else
      program += fmt::format("{}K{}\n", lean, any({1, 1, 1, -1}) * height);
    if (any({0, 0, 0, 1}) == 1) program += any({0, 1}) == 0 ? "G43.5\n" : "Z1. G43.5 H2\n";
  }
  return program;
}

// Which of two poles is nearer may be an exact tie that rounded positions cannot see: then nothing is said of the fast
// engine. Hardly ever.
TEST(NearTies, ProgramsAmongSingularPostures) {
  std::mt19937_64 random(1);
  constexpr int kPrograms = 300;
  int undecided = 0;
  for (int i = 0; i < kPrograms; ++i) {
    const int type = std::array{2, 12, 21}.at(random() % 3);
    const int veto = std::array{0, 1, 90, 180}.at(random() % 4);
    const spec::Case c = hardly_upright(type, veto, among_singular_postures(random));
    const Verdict v = judge::judge(c, run_fast(c));
    EXPECT_NE(v.outcome, Outcome::differs) << type << " " << veto << "\n" << c.program << explain(*v.difference);
    if (v.outcome == Outcome::undecided) ++undecided;
  }
  EXPECT_LE(undecided, kPrograms / 100);
}

// A controller of resolution 0.001 cannot know the lean of 1e-7 over a movement of 100 (its band is some 1e-4); one in
// double can.
TEST(NearTies, ACoarserControllerHasAWiderBand) {
  const spec::Case c = leaning("0.0000001");
  const ModelRun run = run_model(c);
  const std::vector<fast::Event> other = test::in_doubles(run_model(c, opposite(run, Clause::fanuc_leading_edge_sign)));
  EXPECT_EQ(judge::judge(c, run, other).outcome, Outcome::differs);
  EXPECT_EQ(judge::judge(c, run, other, {{}, {.mm = 0.001, .degrees = 0.001}}).outcome, Outcome::agrees);
  // A lean of 1e-2 it knows as well: what it moves is long.
  const spec::Case clear = leaning("0.01");
  const ModelRun sure = run_model(clear);
  const std::vector<fast::Event> wrong =
      test::in_doubles(run_model(clear, opposite(sure, Clause::fanuc_leading_edge_sign)));
  EXPECT_EQ(judge::judge(clear, sure, wrong, {{}, {.mm = 0.001, .degrees = 0.001}}).outcome, Outcome::differs);
  EXPECT_GT(policy::controller_band(0.001, 0.001, 100), 1e-5);
  EXPECT_LT(policy::controller_band(0.001, 0.001, 100), 1e-3);
}

// Many independent near ties in one program: each event is explained by its own decision, so a chain of forks finds the
// one list among 2^n.
TEST(NearTies, AChainOfTiesIsFollowed) {
  spec::Case c = leaning("0.0000000000001");
  c.program = "G91 G01 F100 G43.5 H0 I0.0000000000001 K1.\nG41.3 D1\n";
  for (int i = 0; i < 6; ++i) c.program += i % 2 == 0 ? "X100.\n" : "X-50.\n";
  c.program += "G40\n";
  const ModelRun run = run_model(c);
  const Verdict v =
      judge::judge(c, run, test::in_doubles(run_model(c, opposite(run, Clause::fanuc_leading_edge_sign))));
  EXPECT_EQ(v.outcome, Outcome::agrees) << (v.difference ? explain(*v.difference) : v.undecided);
  EXPECT_GT(v.ties, 3U);
}

// Found by a controller that decides near ties otherwise. Two ties of one corner: one takes a vector away before it,
// the other makes none behind it. Alone the one leaves the event as it is, and the other moves it in X while Z, where
// the first difference is, stays: that is another event.
TEST(NearTies, AForkThatMovesTheEventInAnotherFieldIsFollowed) {
  const spec::Case c = fuzz::decode(
      "fanuc/tool-side-compensation",
      "u inch\na ZYXCB\np 5003#1 1\np 5008#0 0\np 19680 12\np 19681 4\np 19682 3\np 19684 1\np 19686 5\n"
      "p 19687 2\np 19689 1\np 19697 2\nd 2 4.00000\nf B 180\nf C -170\nf Y -210.00000\nf Z -280.00000\n%%\n"
      "N10 G01 F3900. C90. B90 X0 Y-35. Z-30.\nN20 G41.2 D2\nN30 G01 X-4.35655 Y-47.27587\n"
      "N40 Z-110 C87.05819 B180.\nN50 C-180 B37.70711\nN60 Y-75.18876 Z-110.00001\n"
      "N70 C180 B165. Y-47.27587 Z-110.\nN80 C180.03603 B30 X-729.2209 Y2940.7447 Z2265.99753\nN90 G40\n"
      "X-726.76247 Y2920.74856 Z2257.95370 C45.25125 B31.94732\nN110 M02\n");
  const ModelRun run = run_model(c);
  const auto decision = [](const ModelRun& of, Clause clause, std::uint64_t line) {
    const auto& all = of.recorder.decisions();
    std::size_t i = 0;
    while (i < all.size() && (all[i].clause != clause || all[i].line != line)) ++i;
    return i;
  };
  Forced forced = {{decision(run, Clause::fanuc_tool_side_along_the_tool, 7), Sign::negative}};
  const ModelRun one = run_model(c, forced);
  forced[decision(one, Clause::fanuc_cutter_c_interference_direction, 6)] = Sign::negative;
  const ModelRun both = run_model(c, forced);
  const auto last = [](const ModelRun& of) { return test::in_doubles(of).at(5).point; };
  ASSERT_GT(std::fabs(last(both)[2] - last(run)[2]), 0.5);
  const Verdict v = judge::judge(c, run, test::in_doubles(both));
  EXPECT_EQ(v.outcome, Outcome::agrees) << (v.difference ? explain(*v.difference) : v.undecided);
  EXPECT_EQ(v.ties, 2U);
}

// Every near tie of `clause` takes the opposite outcome.
Forced opposite_near_ties(const ModelRun& run, Clause clause) {
  Forced forced;
  const auto& decisions = run.recorder.decisions();
  for (std::size_t i = 0; i < decisions.size(); ++i)
    if (decisions[i].clause == clause && margin(decisions[i]) <= policy::kDoubleBand) forced[i] = -decisions[i].outcome;
  return forced;
}

// The opposite outcome of the first decision of `clause`.
Forced opposite_at_first(const ModelRun& run, Clause clause) {
  const auto& decisions = run.recorder.decisions();
  for (std::size_t i = 0; i < decisions.size(); ++i)
    if (decisions[i].clause == clause) return {{i, -decisions[i].outcome}};
  return {};
}

// The first decision of `clause` takes `outcome`.
Forced forced_to(const ModelRun& run, Clause clause, Sign outcome) {
  Forced forced = opposite_at_first(run, clause);
  if (!forced.empty()) forced.begin()->second = outcome;
  return forced;
}

// The opposite outcome of the last decision of `clause`.
Forced opposite_at_last(const ModelRun& run, Clause clause) {
  Forced forced;
  const auto& decisions = run.recorder.decisions();
  for (std::size_t i = 0; i < decisions.size(); ++i)
    if (decisions[i].clause == clause) forced = {{i, -decisions[i].outcome}};
  return forced;
}

// A contour of lines under G41 with the offset 10.
spec::Case contour(const std::string& blocks) {
  spec::Case c;
  c.section = "fanuc/cutter-compensation-c";
  c.setup.d[1].geometry = spec::decimal(10);
  c.program = "G90 G01 F100 G41 X40. D1\n" + blocks;
  return c;
}

// 90 degrees but for 1e-13: one head or two of them, a hair apart.
TEST(NearTies, ACornerOfAlmostRightAnglesMayHaveTheVectorsOfEither) {
  const spec::Case c = contour("X80.\nX80.00000000001 Y-100.\nY-200.\nG40 X0\n");
  const ModelRun run = run_model(c);
  const ModelRun other = run_model(c, opposite_at_first(run, Clause::fanuc_cutter_c_obtuse_or_acute));
  ASSERT_EQ(other.events.size(), run.events.size() + 1);
  const Verdict v = judge::judge(c, run, test::in_doubles(other));
  EXPECT_EQ(v.outcome, Outcome::agrees) << (v.difference ? explain(*v.difference) : v.undecided);
  EXPECT_GE(v.ties, 1U);
  // A degree less is no tie.
  const spec::Case clear = contour("X80.\nX80.01 Y-100.\nY-200.\nG40 X0\n");
  const ModelRun sharp = run_model(clear);
  EXPECT_EQ(
      judge::judge(clear, sharp,
                   test::in_doubles(run_model(clear, opposite_at_first(sharp, Clause::fanuc_cutter_c_obtuse_or_acute))))
          .outcome,
      Outcome::differs);
}

// A groove 1e-12 narrower than the tool: PS0041, or not.
TEST(NearTies, InterferenceByAHairMayBeSeenOrNot) {
  const spec::Case c = contour("X80.\nY19.999999999999\nX40.\nG40 Y40.\n");
  const ModelRun run = run_model(c);
  ASSERT_EQ(run.events.back().number.view(), "PS0041");
  const ModelRun other = run_model(c, opposite_near_ties(run, Clause::fanuc_cutter_c_interference_direction));
  ASSERT_EQ(other.events.back().kind, spec::EventKind::move);
  const Verdict v = judge::judge(c, run, test::in_doubles(other));
  EXPECT_EQ(v.outcome, Outcome::agrees) << (v.difference ? explain(*v.difference) : v.undecided);
  // A micrometre narrower there is nothing to permit.
  const spec::Case narrow = contour("X80.\nY19.999\nX40.\nG40 Y40.\n");
  const ModelRun alarm = run_model(narrow);
  EXPECT_EQ(judge::judge(narrow, alarm,
                         test::in_doubles(
                             run_model(narrow, opposite_at_last(alarm, Clause::fanuc_cutter_c_interference_direction))))
                .outcome,
            Outcome::differs);
}

// Half the chord of the arc is the offset: both its heads lie on Y30, where that meets the tool's circle of 0.02, in
// one point. Exactly that is a whole turn, over 180 degrees more than programmed: PS0041. Heads a rounding apart make
// an arc of almost nothing instead, as programmed.
TEST(NearTies, HeadsOfAnArcInOnePointMayBeAWholeTurnOrNone) {
  const spec::Case c = contour("X120.\nY40.\nX0\nG03 Y20. R10.02\nG01 X60.\nG40 X80.\n");
  const ModelRun run = run_model(c);
  ASSERT_EQ(run.events.back().number.view(), "PS0041");
  Forced forced;
  const auto& decisions = run.recorder.decisions();
  for (std::size_t i = 0; i < decisions.size(); ++i)
    if (decisions[i].clause == Clause::fanuc_cutter_c_arc_sweep) forced[i] = Sign::positive;
  ASSERT_EQ(forced.size(), 1U);
  const std::vector<fast::Event> other = test::in_doubles(run_model(c, forced));
  const auto arc = std::ranges::find_if(other, [](const fast::Event& event) { return event.arc.has_value(); });
  ASSERT_NE(arc, other.end());
  const auto judged = [&](double sweep) {
    std::vector<fast::Event> answer = other;
    answer[static_cast<std::size_t>(arc - other.begin())].arc->sweep = sweep;
    return judge::judge(c, run, answer);
  };
  // Degrees of an ulp of 40 at 0.02 from the centre: 2e-11.
  const Verdict v = judged(2e-11);
  EXPECT_EQ(v.outcome, Outcome::agrees) << (v.difference ? explain(*v.difference) : v.undecided);
  EXPECT_EQ(v.ties, 1U);
  EXPECT_EQ(judged(2e-6).outcome, Outcome::differs);
  EXPECT_EQ(judged(180).outcome, Outcome::differs);
  EXPECT_EQ(judged(360).outcome, Outcome::differs);
}

// The two heads of this corner lie 12 apart in X and in Y (10·(sin a1 - sin a2 - cos a1 - cos a2) with a1 of -3 : 4 and
// a2 of 4 : -3, and the like), 1e-13 over the limit of 5010. Dropping the second takes both decisions, and nothing
// shows after one.
TEST(NearTies, BothAxesOfASmallCornerMovementMayGoTheOtherWay) {
  spec::Case c = contour("X-20. Y80.\nX60. Y20.\nG40 X140. Y-40.\n");
  c.setup.parameters[{5010, -1}] = *spec::parse_decimal("11.9999999999999");
  const ModelRun run = run_model(c);
  const auto small = Clause::fanuc_cutter_c_small_corner_movement;
  Forced forced = opposite_near_ties(run, small);
  ASSERT_EQ(forced.size(), 1U);
  EXPECT_EQ(run_model(c, forced).events.size(), run.events.size());
  const std::size_t x = forced.begin()->first;
  Forced next = opposite_near_ties(run_model(c, forced), small);
  next.erase(x);
  ASSERT_EQ(next.size(), 1U);
  forced.merge(next);
  const ModelRun other = run_model(c, forced);
  ASSERT_EQ(other.events.size() + 1, run.events.size());
  const Verdict v = judge::judge(c, run, test::in_doubles(other));
  EXPECT_EQ(v.outcome, Outcome::agrees) << (v.difference ? explain(*v.difference) : v.undecided);
  EXPECT_EQ(v.ties, 2U);
}

// Down to 200 with the signal at the end of the zone 200 ± `half`.
spec::Case measured(const std::string& signal, const std::string& half) {
  spec::Case c;
  c.section = "fanuc/tool-length-measurement";
  c.setup.h[1].geometry = spec::decimal(15);
  c.setup.position['Z'] = spec::decimal(760);
  c.setup.measurement['Z'] = *spec::parse_decimal(signal);
  c.setup.parameters[{6254, -1}] = *spec::parse_decimal(half);
  c.program = "H1\nG90 G00 Z700.\nG37 Z200.\n";
  return c;
}

// Both ends of G37's zone belong to it. Sums of decimals are compared without rounding, so leaving one out is a
// difference; a controller with a resolution of its own may round first.
TEST(NearTies, AnExactTieOfDecimalsGoesAsTheClauseSays) {
  for (const auto& [signal, clause] : {std::pair("205.005", Clause::fanuc_length_measurement_too_early),
                                       std::pair("194.995", Clause::fanuc_length_measurement_too_late)}) {
    const spec::Case c = measured(signal, "5.005");
    const ModelRun run = run_model(c);
    const ModelRun other = run_model(c, forced_to(run, clause, Sign::negative));
    ASSERT_EQ(run.events.back().kind, spec::EventKind::setting);
    ASSERT_EQ(other.events.back().number.view(), "PS0080");
    EXPECT_EQ(judge::judge(c, run, test::in_doubles(run)).near_ties, 0U);
    EXPECT_EQ(judge::judge(c, run, test::in_doubles(other)).outcome, Outcome::differs);
    EXPECT_EQ(judge::judge(c, run, test::in_doubles(other), {{}, {.mm = 0.001, .degrees = 0.001}}).outcome,
              Outcome::agrees);
  }
}

// Behind G43.5 the tool stands at 5·√2 = 7.07106781186547…, 7·10^-14 before the signal. Where the signal is taken to be
// on from the start, the run cannot be decided (no value of a memory is irrational): such a fork agrees with nothing.
TEST(NearTies, AForkThatEndsUndecidedNeverAgrees) {
  spec::Case c = measured("7.0710678118654", "5");
  c.setup.position['Z'] = spec::decimal(0);
  c.setup.h[1].geometry = spec::decimal(10);
  c.program = "G90 G01 F100 G43.5 H1 I1. K1. Z0\nG49\nH1\nG37 Z5.\n";
  const ModelRun run = run_model(c);
  ASSERT_EQ(run.events.back().kind, spec::EventKind::setting);
  const ModelRun fork =
      run_model(c, forced_to(run, Clause::fanuc_length_measurement_signal_from_the_start, Sign::negative));
  ASSERT_EQ(fork.events.back().kind, spec::EventKind::undecided);
  ASSERT_GE(judge::judge(c, run, test::in_doubles(run)).near_ties, 1U);
  EXPECT_EQ(judge::judge(c, run, test::in_doubles(run)).outcome, Outcome::agrees);
  // Right up to where the fork ends, wrong there: neither run has it.
  std::vector<fast::Event> wrong = test::in_doubles(run);
  wrong.back().value += 1;
  EXPECT_EQ(judge::judge(c, run, wrong).outcome, Outcome::differs);
  wrong = test::in_doubles(run);
  wrong[fork.events.size() - 1].point.value[2] += 1;
  EXPECT_EQ(judge::judge(c, run, wrong).outcome, Outcome::differs);
}

// A head of B on C with B at 10^-9 degrees: C is off by 1/sin B = 6·10^10 ulps, 1/20 of a radian. No decision is a near
// tie for that beyond 2^-12.
TEST(NearTies, TheBandOfAPositionHasItsCap) {
  spec::Setup setup;
  setup.axes = spec::Axes("XYZBC");
  for (const auto& [parameter, value] : {std::pair(19680U, 2), {19681U, 5}, {19682U, 3}, {19686U, 4}, {19687U, 2}})
    setup.parameters[{parameter, -1}] = spec::decimal(value);
  model::Event event;
  event.line = 2;
  event.tool_axis = {model::Real(0), model::Real(0), model::Real(1)};
  for (std::size_t i = 0; i < 5; ++i) event.axes.set(i, 0);
  event.axes.set(3, exact::Rational(1, 1'000'000'000));
  event.machine = event.axes;
  PositionErrors positions(setup);
  positions.follow(event);
  ASSERT_GT(policy::kDoubleBand * positions.at(2), 100 * policy::kWidestBand);
  const Rules rules(setup, "fanuc/tool-center-point-control", {});
  const auto near = [&](Clause clause, double quantity) {
    return rules.is_near_tie({clause, 2, model::Real(exact::Rational(quantity)), 1, Sign::positive},
                             policy::kDoubleBand, positions);
  };
  const Clause range = Clause::fanuc_tool_center_point_range;
  EXPECT_TRUE(near(range, policy::kWidestBand * 0.999));
  EXPECT_FALSE(near(range, policy::kWidestBand * 1.001));
  // A clause that does not compare positions has the band of doubles.
  const Clause corner = Clause::fanuc_cutter_c_obtuse_or_acute;
  EXPECT_TRUE(near(corner, policy::kDoubleBand * 0.999));
  EXPECT_FALSE(near(corner, policy::kDoubleBand * 1.001));
}

// In an inch setup the zone of 5 mm is no decimal: its end, named in millimetres, is rounded before it is compared.
TEST(NearTies, AnExactTieOfConvertedLengthsMayGoTheOtherWay) {
  spec::Case c = measured("0", "0");
  c.setup.units = spec::Units::inch;
  c.setup.parameters.clear();
  c.setup.measurement.clear();
  c.setup.position.clear();
  c.program = "G21 H1\nG00 Z220.\nG90 G37 Z200.\n";
  const ModelRun run = run_model(c);
  const Clause rapid = Clause::fanuc_length_measurement_rapid_part;
  EXPECT_EQ(judge::judge(c, run, test::in_doubles(run)).near_ties, 1U);
  EXPECT_EQ(judge::judge(c, run, test::in_doubles(run_model(c, forced_to(run, rapid, Sign::positive)))).outcome,
            Outcome::agrees);
  // The same in millimetres is exact.
  c.setup.units = spec::Units::mm;
  const ModelRun plain = run_model(c);
  EXPECT_EQ(judge::judge(c, plain, test::in_doubles(plain)).near_ties, 0U);
  EXPECT_EQ(judge::judge(c, plain, test::in_doubles(run_model(c, forced_to(plain, rapid, Sign::positive)))).outcome,
            Outcome::differs);
}

// A table of deviations is read at the contact angle: 60 degrees between (1, 1, 0) and (1, 0, 1), where R2 + dR2 is
// 1 - 1 = 0. No control knows that angle exactly.
TEST(NearTies, ATieAtAContactAngleMayGoTheOtherWay) {
  spec::Case c;
  c.section = "heidenhain/face-milling";
  c.dialect = "klartext";
  c.setup.control = spec::Control::heidenhain;
  spec::ToolRow& ball = c.setup.tools.emplace_back();
  ball.number = 10;
  ball.r = ball.r2 = spec::decimal(1);
  ball.dr2_table = "deviations";
  c.setup.dr2_tables["deviations"] = {{spec::decimal(30), spec::decimal(0)}, {spec::decimal(90), spec::decimal(-2)}};
  c.program = "TOOL CALL 1 Z\nM128\nLN X0 Y0 Z0 NX1 NY1 NZ0 TX1 TY0 TZ1\n";
  const ModelRun run = run_model(c);
  const Clause corner = Clause::heidenhain_tool_effective_corner_radius;
  ASSERT_EQ(run.events.back().kind, spec::EventKind::move);
  const ModelRun below = run_model(c, forced_to(run, corner, Sign::negative));
  ASSERT_EQ(below.events.back().number.view(), "E_R2_NEG");
  EXPECT_EQ(judge::judge(c, run, test::in_doubles(below)).outcome, Outcome::agrees);
}

// A change of side on a straight line: paths that are parallel have no intersection, whatever is forced.
TEST(NearTies, AnIntersectionOfParallelLinesIsNotPermitted) {
  const spec::Case c = contour("X80.\nG42 X120.\nX160.\nG40 Y40.\n");
  const ModelRun run = run_model(c);
  bool tried = false;
  const auto& decisions = run.recorder.decisions();
  for (std::size_t i = 0; i < decisions.size(); ++i) {
    if (decisions[i].clause != Clause::fanuc_cutter_c_direction_change_parallel) continue;
    ASSERT_EQ(margin(decisions[i]), 0);
    tried = true;
    for (const Sign outcome : {Sign::negative, Sign::positive})
      EXPECT_THROW(run_model(c, {{i, outcome}}), std::exception);
  }
  EXPECT_TRUE(tried);
  std::vector<fast::Event> wrong = test::in_doubles(run);
  wrong[1].point.value[0] += 1;
  EXPECT_EQ(judge::judge(c, run, wrong).outcome, Outcome::differs);
}

// Lines beside a tool that leans by I J K, offset 10.
spec::Case flank(const std::string& blocks) {
  spec::Case c;
  c.section = "fanuc/tool-side-compensation";
  c.setup.d[1].geometry = spec::decimal(10);
  c.program = blocks;
  return c;
}

// In the plane of the tool (3, 0, 4) the second line turns by 90 degrees and 1e-13: one head, or two a hair apart.
TEST(NearTies, ASideCornerOfAlmostRightAnglesMayHaveTheVectorsOfEither) {
  const std::string start = "G90 G01 F100 G43.5 H0 I3. K4.\nG41.6 Y50. D1\nY100.\n";
  const spec::Case c = flank(start + "X80. Y99.99999999999 Z-60.\nX160. Z-120.\nG40 X0\n");
  const ModelRun run = run_model(c);
  const ModelRun other = run_model(c, opposite_at_last(run, Clause::fanuc_tool_side_obtuse_or_acute));
  ASSERT_EQ(other.events.size() + 1, run.events.size());
  const Verdict v = judge::judge(c, run, test::in_doubles(other));
  EXPECT_EQ(v.outcome, Outcome::agrees) << (v.difference ? explain(*v.difference) : v.undecided);
  EXPECT_GE(v.ties, 1U);
  // A degree less is no tie.
  const spec::Case clear = flank(start + "X80. Y99.99 Z-60.\nX160. Z-120.\nG40 X0\n");
  const ModelRun sharp = run_model(clear);
  EXPECT_EQ(
      judge::judge(clear, sharp,
                   test::in_doubles(run_model(clear, opposite_at_last(sharp, Clause::fanuc_tool_side_obtuse_or_acute))))
          .outcome,
      Outcome::differs);
}

// The tool turns by 45 degrees less 5e-14 while the path goes back under it: PS0041, or not.
TEST(NearTies, AChangeOfThePlaneByAHairLessThanTheLimitMayBeSeenOrNot) {
  const auto turning = [](const std::string& k) {
    return flank("G90 G01 F100 G43.5 H0 K1.\nG41.6 X50. D1\nX100.\nX200.\nX150. Z-100. I1. K" + k +
                 "\nX100. Z-200.\nG40 Z0\n");
  };
  const spec::Case c = turning("1.0000000000001");
  const ModelRun run = run_model(c);
  ASSERT_EQ(run.events.back().kind, spec::EventKind::move);
  const ModelRun other = run_model(c, opposite_near_ties(run, Clause::fanuc_tool_side_plane_change_angle));
  ASSERT_EQ(other.events.back().number.view(), "PS0041");
  const Verdict v = judge::judge(c, run, test::in_doubles(other));
  EXPECT_EQ(v.outcome, Outcome::agrees) << (v.difference ? explain(*v.difference) : v.undecided);
  // A thousandth of a degree is no hair.
  const spec::Case clear = turning("1.00004");
  const ModelRun apart = run_model(clear);
  Forced forced;
  for (std::size_t i = 0; i < apart.recorder.decisions().size(); ++i) {
    const model::Decision& d = apart.recorder.decisions()[i];
    if (d.clause == Clause::fanuc_tool_side_plane_change_angle) forced[i] = Sign::positive;
  }
  EXPECT_EQ(judge::judge(clear, apart, test::in_doubles(run_model(clear, forced))).outcome, Outcome::differs);
}

// A line along the tool has no direction in the plane, whatever is forced.
TEST(NearTies, AMovementAlongTheToolIsNotOneInThePlane) {
  const spec::Case c =
      flank("G90 G01 F100 G43.5 H0 I3. K4.\nG41.6 Y50. D1\nY100.\nX30. Z40.\nX80. Y120.\nX160.\nG40 X0\n");
  const ModelRun run = run_model(c);
  bool tried = false;
  const auto& decisions = run.recorder.decisions();
  for (std::size_t i = 0; i < decisions.size(); ++i) {
    if (decisions[i].clause != Clause::fanuc_tool_side_along_the_tool || margin(decisions[i]) != 0) continue;
    tried = true;
    EXPECT_THROW(run_model(c, {{i, Sign::positive}}), std::exception);
  }
  EXPECT_TRUE(tried);
}

}  // namespace
}  // namespace toolcomp::judge
