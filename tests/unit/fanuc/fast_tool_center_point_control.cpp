// Tool center point control in the fast engine: control points, the program O0010, samples. Expected values: the worked
// examples 3, 4, 5, 8, 9 and 11 of the posture fact sheet, typed in, and hand derivations where a comment says so.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tests/unit/fanuc/fast_run.h"
#include "tests/unit/fanuc/fast_tip_control.h"

namespace toolcomp::fast {
namespace {

using tip_control::expect_axes;
using tip_control::expect_axis;
using tip_control::expect_direction;
using tip_control::expect_point;
using tip_control::machine_b_c_mixed;
using tip_control::machine_head;
using tip_control::machine_nutating_head;
using tip_control::machine_table;
using tip_control::move_at;
using tip_control::sample_at;

// Example 3: the edge of the pyramid, the tool between two faces.
TEST(FastToolCenterPointControl, EdgeOfThePyramidUnderPostureControl) {
  const ProgramRun run(machine_head("", "X=20\nY=-20\nC=135\n"), "G43.5 H1 P1 I-1 J1 K2\nG01 Y20 I-1 J-1 K2 F100\n", 4);
  ASSERT_EQ(run.alarm(), "");
  const std::size_t start = move_at(run, 1);
  expect_axes(run, start, "BC", {35.2643896827547, 135});
  expect_axes(run, start, "XYZ", {-20.8248290463863, 20.8248290463863, 81.6496580927726});
  const std::array<std::array<double, 2>, 3> pose{
      {{154.488330009362, 28.9872466142404}, {180, 26.565051177078}, {205.511669990638, 28.9872466142404}}};
  const std::array<std::array<double, 3>, 3> control{{{-23.7363799276446, 10.8721190616481, 87.4727598552893},
                                                      {-24.7213595499958, 0, 89.4427190999916},
                                                      {-23.7363799276446, -10.8721190616481, 87.4727598552893}}};
  for (unsigned k = 1; k <= 3; ++k) {
    const std::size_t i = sample_at(run, 2, k, 4);
    expect_axes(run, i, "CB", {pose[k - 1][0], pose[k - 1][1]});
    expect_axes(run, i, "XYZ", {control[k - 1][0], control[k - 1][1], control[k - 1][2]});
    expect_point(run, i, {20, -20 + 10.0 * k, 0});
  }
  expect_direction(run, sample_at(run, 2, 1, 4), {-0.437363799276446, 0.208721190616481, 0.874727598552893});
  expect_direction(run, sample_at(run, 2, 2, 4), {-0.447213595499958, 0, 0.894427190999916});
  expect_axes(run, move_at(run, 2), "CB", {225, 35.2643896827547});
  expect_axes(run, move_at(run, 2), "XYZ", {-20.8248290463863, -20.8248290463863, 81.6496580927726});
}

TEST(FastToolCenterPointControl, EdgeOfThePyramidConventionally) {
  const ProgramRun run(machine_head("", "X=20\nY=-20\nC=135\n"), "G43.5 H1 P0 I-1 J1 K2\nG01 Y20 I-1 J-1 K2 F100\n", 4);
  ASSERT_EQ(run.alarm(), "");
  expect_axes(run, sample_at(run, 2, 1, 4), "CB", {157.5, 35.2643896827547});
  expect_direction(run, sample_at(run, 2, 1, 4), {-0.533402096794177, 0.220942382690395, 0.816496580927726});
  expect_direction(run, sample_at(run, 2, 2, 4), {-0.577350269189626, 0, 0.816496580927726});
  expect_axes(run, sample_at(run, 2, 2, 4), "XYZ", {-37.7350269189626, 0, 81.6496580927726});
}

// The same arc on other machines, by commanded rotary positions.
TEST(FastToolCenterPointControl, EdgeOfThePyramidOnOtherMachines) {
  const auto check = [](const std::string& machine, char tool, double tool_end, const std::string& first,
                        const std::string& second, const std::array<double, 3>& tool_side,
                        const std::array<double, 3>& work_side) {
    const ProgramRun run(machine, "G43.4 H1 P1\nG01 X20 Y-20 F100 " + first + "\nY20 " + second + "\n", 4);
    ASSERT_EQ(run.alarm(), "") << first;
    for (unsigned k = 1; k <= 3; ++k) {
      const std::size_t i = sample_at(run, 3, k, 4);
      expect_axis(run, i, tool, tool_side[k - 1], 1e-11);
      expect_axis(run, i, 'C', work_side[k - 1], 1e-11);
    }
    expect_axis(run, move_at(run, 3), tool, tool_end, 0);
    for (const Event& event : run.events) EXPECT_NE(event.kind, spec::EventKind::warning) << first;
  };
  const std::array<double, 3> polar{28.9872466142404, 26.565051177078, 28.9872466142404};
  check(machine_table("", ""), 'A', 35.2643896827547, "A35.2643896827547 C225", "A35.2643896827547 C315", polar,
        {244.488330009362, 270, 295.511669990638});
  check(machine_b_c_mixed("", ""), 'B', 35.2643896827547, "B35.2643896827547 C135", "B35.2643896827547 C225", polar,
        {154.488330009362, 180, 205.511669990638});
  check(machine_nutating_head("", ""), 'B', 50.7287005490466, "B50.7287005490466 C116.467819046821",
        "B50.7287005490466 C206.467819046821", {41.4567926002351, 37.921419763845, 41.4567926002351},
        {139.507322177772, 166.345415254024, 190.530662159048});
}

// Example 4: type 1.
TEST(FastToolCenterPointControl, CommandedRotaryPositions) {
  const ProgramRun run(machine_head("", "B=20\n"), "G43.4 H2 P1\nG01 B40 C90 F100\n", 4);
  ASSERT_EQ(run.alarm(), "");
  expect_direction(run, sample_at(run, 2, 1, 4), {0.268133688322374, 0.176528861603656, 0.947070159073528});
  expect_axes(run, sample_at(run, 2, 1, 4), "CB", {33.3593629436283, 18.7250240410852});
  expect_direction(run, sample_at(run, 2, 2, 4), {0.184413141980199, 0.346583337389474, 0.919712880908474});
  expect_axes(run, sample_at(run, 2, 2, 4), "CB", {61.9830533459686, 23.1158568832211});
  expect_axes(run, sample_at(run, 2, 2, 4), "XYZ", {27.6619712970299, 51.9875006084212, 137.956932136271});
  expect_direction(run, sample_at(run, 2, 3, 4), {0.0939290453595435, 0.503926496601286, 0.858624143884272});
  expect_axes(run, sample_at(run, 2, 3, 4), "CB", {79.441555265135, 30.8375489371282});
  expect_axes(run, move_at(run, 2), "CB", {90, 40}, 0);

  const ProgramRun conventional(machine_head("", "B=20\n"), "G43.4 H2 P0\nG01 B40 C90 F100\n", 2);
  expect_axes(conventional, sample_at(conventional, 2, 1, 2), "CB", {45, 30}, 0);
  expect_axes(conventional, sample_at(conventional, 2, 1, 2), "XYZ",
              {53.0330085889911, 53.0330085889911, 129.903810567666});
}

// A swing of 200 degrees is not the continuous one: conventional, with a warning before the move.
// R of a dwell is no radius, so the table that has turned bars nothing; X without a centre is an arc that cannot be.
TEST(FastToolCenterPointControl, ADwellIsNoArc) {
  const ProgramRun run(machine_b_c_mixed("\"19696#5\"=1\n", ""), "G43.4\nC1\nR0 G04 G02\nX0\n");
  EXPECT_EQ(run.alarm(), "PS0023@4");
}

TEST(FastToolCenterPointControl, OtherBranchIsConventional) {
  const ProgramRun run(machine_head("", "B=20\n"), "G43.4 H2 P1\nG01 B20 C200 F100\n", 2);
  ASSERT_EQ(run.alarm(), "");
  ASSERT_EQ(run.events.size(), 4U);
  EXPECT_EQ(run.events[1].kind, spec::EventKind::warning);
  EXPECT_EQ(run.events[1].number.view(), "posture-branch");
  EXPECT_EQ(run.events[1].line, 2U);
  expect_axes(run, 2, "CB", {100, 20}, 0);
  expect_axes(run, 3, "CB", {200, 20}, 0);
}

// Example 5: near the singular posture. Ve has the polar angle 12 and the azimuth 176, to twelve places.
const std::string kNearSingular = "G01 X50 I-0.207405228389 J0.014503186402 K0.978147600734 F100\n";

TEST(FastToolCenterPointControl, NearSingularPostureUnchanged) {
  const std::string parameters = "19738=1\n19739=3\n";
  const ProgramRun run(machine_head(parameters, "B=10\n"), "G43.5 H3 P1\n" + kNearSingular, 10);
  ASSERT_EQ(run.alarm(), "");
  const auto pose = [&](unsigned k, unsigned n, double c, double b) {
    expect_axes(run, sample_at(run, 2, k, n), "CB", {c, b}, 2e-9);
  };
  pose(1, 10, 0.627160532895321, 7.80345595842618);
  pose(3, 10, 4.27970316883873, 3.41845337728643);
  pose(2, 5, 15.6447476915161, 1.25849039506375);
  pose(1, 2, 156.749981593727, 1.07228252285797);
  pose(3, 5, 170.951321299778, 3.2223902158916);
  expect_axes(run, move_at(run, 2), "CB", {176, 12}, 1e-9);

  const ProgramRun refused(machine_head(parameters + "\"19696#3\"=1\n", "B=10\n"), "G43.5 H3 P1\n" + kNearSingular);
  EXPECT_EQ(refused.alarm(), "PS5421@2");
}

TEST(FastToolCenterPointControl, NearSingularPostureChanged) {
  const ProgramRun run(machine_head("19738=1\n19739=5\n", "B=10\n"),
                       "G43.5 H3 P1\n" + kNearSingular + "X60 I-0.4698463104 J-0.1710100717 K0.8660254038\n", 4);
  ASSERT_EQ(run.alarm(), "");
  expect_axes(run, sample_at(run, 2, 1, 4), "CB", {0, 4.5}, 1e-9);
  expect_direction(run, sample_at(run, 2, 1, 4), {0.0784590957278449, 0, 0.996917333733128}, 1e-11);
  expect_axes(run, sample_at(run, 2, 1, 4), "XYZ", {18.7767276582276, 0, 79.7533866986502}, 1e-9);
  expect_axes(run, sample_at(run, 2, 1, 2), "XYZ", {23.6038074850173, 0, 79.9878156125113}, 1e-9);
  expect_axes(run, sample_at(run, 2, 3, 4), "XYZ", {28.4437428985675, 0, 79.485748454127}, 1e-9);
  expect_axes(run, move_at(run, 2), "CB", {0, -12}, 1e-9);
  expect_direction(run, move_at(run, 2), {-0.207911690817759, 0, 0.978147600733806}, 1e-11);
  expect_axes(run, move_at(run, 2), "XYZ", {33.3670647345793, 0, 78.2518080587045}, 1e-9);
  // The next block starts from the actual pair. Polar 30, azimuth 200.
  expect_axes(run, sample_at(run, 3, 1, 2), "CB", {14.1611368115305, -20.7582829496743}, 1e-8);
  expect_axes(run, move_at(run, 3), "CB", {20, -30}, 1e-8);
}

// Example 8: the program O0010 of the manual.
const std::string kPyramid =
    "N10 G90 G00 X30.0 Y-30.0 Z0.0\nN20 G43.5 H1 P1\nN30 G42.6 D2\nN40 G01 X20.0 Y-20.0 I-1 J1 K2 F500\n"
    "N50 Y20 I-1 J-1 K2\nN60 X-20 I1 J-1 K2\nN70 Y-20 I1 J1 K2\nN80 X20 I-1 J1 K2\n";

void check_pyramid(const std::string& machine, const std::string& letters,
                   const std::array<std::array<double, 2>, 5>& ends) {
  const ProgramRun run(machine, kPyramid, 4);
  ASSERT_EQ(run.alarm(), "");
  for (unsigned k = 0; k < 5; ++k) expect_axes(run, move_at(run, 4 + k), letters, {ends[k][0], ends[k][1]}, 2e-13);
  const double third = 3.72677996249965;
  expect_point(run, move_at(run, 4), {24.4721359549996, -20, 2.23606797749979});
  expect_point(run, move_at(run, 5), {20 + third, 20 + third, third});
  expect_point(run, move_at(run, 6), {-20 - third, 20 + third, third});
  expect_point(run, move_at(run, 7), {-20 - third, -20 - third, third});
  expect_point(run, sample_at(run, 5, 1, 2), {24.0994579587496, 1.86338998124982, 2.98142396999972});
  expect_direction(run, sample_at(run, 5, 1, 2), {-1 / std::sqrt(5.0), 0, 2 / std::sqrt(5.0)});
  expect_direction(run, sample_at(run, 4, 1, 4), {-0.108373643161723, 0.108373643161723, 0.988185360615968});
  expect_direction(run, sample_at(run, 4, 3, 4), {-0.314938275028657, 0.314938275028657, 0.895336677369998});
  // The face 2x + z = 40 from the tip: 5 at every moment of N50.
  for (unsigned k = 1; k < 4; ++k) {
    const std::size_t i = sample_at(run, 5, k, 4);
    EXPECT_NEAR((2 * run.point(i, 'X') + run.point(i, 'Z') - 40) / std::sqrt(5.0), 5, 1e-13);
  }
}

TEST(FastToolCenterPointControl, PyramidOfTheManual) {
  const double b = 35.2643896827547;
  check_pyramid(machine_head("", ""), "CB", {{{-45, -b}, {45, -b}, {135, -b}, {225, -b}, {315, -b}}});
  check_pyramid(machine_table("", ""), "AC", {{{-b, 45}, {-b, 135}, {-b, 225}, {-b, 315}, {-b, 405}}});
  check_pyramid(machine_b_c_mixed("", ""), "BC", {{{-b, -45}, {-b, 45}, {-b, 135}, {-b, 225}, {-b, 315}}});

  const ProgramRun run(machine_head("", ""), kPyramid, 4);
  expect_axes(run, move_at(run, 4), "XYZ", {-16.3526930913867, 20.8248290463863, 83.8857260702724});
  expect_axes(run, move_at(run, 5), "XYZ", {-17.0980490838867, -17.0980490838867, 85.3764380552723});
  expect_axes(run, move_at(run, 6), "XYZ", {17.0980490838867, -17.0980490838867, 85.3764380552723});
  expect_axes(run, move_at(run, 7), "XYZ", {17.0980490838867, 17.0980490838867, 85.3764380552723});
  expect_axes(run, sample_at(run, 5, 1, 2), "XYZ", {-20.6219015912462, 1.86338998124982, 92.4241430699913});
  // The start is a singular posture: C goes to where the great circle leads first, with the tip and the tool standing.
  const std::size_t turn = tip_control::first_event(run, 4);
  EXPECT_EQ(run.events[turn].cause, spec::Cause::pre_turn);
  expect_axes(run, turn, "CB", {-45, 0}, 2e-14);
  expect_point(run, turn, {30, -30, 0});
  expect_axes(run, turn, "XYZ", {30, -30, 100}, 0);
}

// Example 9: a table with offsets.
TEST(FastToolCenterPointControl, TableWithOffsets) {
  const std::string offsets = "19702=-100\n19704=30\n19705=50\n";
  const std::string origin = "[workpiece.G54]\nX=5\nY=10\nZ=20\n";
  const ProgramRun run(machine_table(offsets, "X=30\nY=-30\n", origin),
                       "G43.5 H1 P1\nG01 X20 Y-20 I-1 J1 K2 F100\nY20 I-1 J-1 K2\n", 4);
  ASSERT_EQ(run.alarm(), "");
  const auto machine = [&](std::size_t i, double x, double y, double z) {
    EXPECT_NEAR(run.machine(i, 'X'), x, 5e-13);
    EXPECT_NEAR(run.machine(i, 'Y'), y, 5e-13);
    EXPECT_NEAR(run.machine(i, 'Z'), z, 5e-13);
  };
  machine(move_at(run, 1), 35, -20, 120);
  expect_axes(run, move_at(run, 1), "XYZ", {30, -30, 100});
  machine(move_at(run, 2), -10.6066017177982, -82.314902372249, 88.7639589068648);
  expect_axes(run, move_at(run, 2), "AC", {-35.2643896827547, 45});
  const auto sample = [&](unsigned k, unsigned n, double a, double c, double x, double y, double z) {
    const std::size_t i = sample_at(run, 3, k, n);
    expect_axes(run, i, "AC", {a, c});
    expect_axes(run, i, "XYZ", {x - 5, y - 10, z - 20}, 5e-13);
  };
  sample(1, 4, -28.9872466142404, 64.488330009362, -16.3075542211557, -62.950174050187, 102.31002896252);
  sample(1, 2, -26.565051177078, 90, -20, -49.1934955049954, 109.56733089749);
  sample(3, 4, -28.9872466142404, 115.511669990638, -19.7923489480995, -47.8805445089336, 110.658876587179);
  machine(move_at(run, 3), -17.6776695296637, -59.220891604664, 105.093890525419);

  const ProgramRun turned(machine_table(offsets, "A=20\nC=45\n", origin), "G43.4 H1\nG01 X20 Y-20 Z5 A-35 C10 F100\n");
  ASSERT_EQ(turned.alarm(), "");
  EXPECT_NEAR(turned.machine(1, 'X'), 67.5977865158401, 5e-13);
  EXPECT_NEAR(turned.machine(1, 'Y'), -84.213831437203, 5e-13);
  EXPECT_NEAR(turned.machine(1, 'Z'), 80.2516544957449, 5e-13);
  expect_direction(turned, 1, {0.328989928337166, 0.72167761037298, 0.609054228898422});
}

// Example 11.
TEST(FastToolCenterPointControl, LeanInTheDirectionOfTravel) {
  const ProgramRun upright(machine_head("", ""), "G43.5 H1 P0 Q2\nG01 X10 I0 J0 K1 F100\n");
  ASSERT_EQ(upright.alarm(), "");
  expect_direction(upright, 1, {0.034899496702501, 0, 0.999390827019096});
  const ProgramRun inclined(machine_head("", "C=130\n"), "G43.5 H1 P0 Q3\nG01 Y10 I-1 J1 K2 F100\n");
  ASSERT_EQ(inclined.alarm(), "");
  expect_direction(inclined, 1, {-0.398133605769323, 0.45546477337505, 0.796267211538646});
  expect_axes(inclined, 1, "CB", {131.157551336705, 37.2248886695106}, 5e-13);
}

TEST(FastToolCenterPointControl, HeadWithOffsets) {
  const ProgramRun run(machine_head("19666=30\n19711=40\n19712=25\n19714=60\n", ""),
                       "G43.5 H1 P0\nG01 X20 Y-20 I-1 J1 K2 F100\n");
  ASSERT_EQ(run.alarm(), "");
  expect_axes(run, 1, "CB", {-45, -35.2643896827547});
  expect_axes(run, 1, "XYZ", {-31.724539849193, 31.724539849193, 198.804418757713}, 5e-13);
}

TEST(FastToolCenterPointControl, OppositeVectorsAreConventional) {
  const ProgramRun run(machine_head("", "B=30\n"), "G43.4 H1 P1\nG01 B150 C180 F100\n", 4);
  ASSERT_EQ(run.alarm(), "");
  expect_axes(run, sample_at(run, 2, 1, 4), "CB", {45, 60}, 0);
  expect_direction(run, sample_at(run, 2, 1, 4), {0.612372435695795, 0.612372435695795, 0.5});
  expect_direction(run, sample_at(run, 2, 1, 2), {0, 1, 0});
}

}  // namespace
}  // namespace toolcomp::fast
