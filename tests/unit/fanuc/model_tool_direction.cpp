// SPDX-License-Identifier: Apache-2.0
// Tool directions: of rotary axes by both sets of parameters, and of I J K under G43.5. Expected directions are the
// closed forms of each machine by hand, and the inverse kinematics of worked example 1, read backwards.
#include <gtest/gtest.h>

#include <string>

#include "spec/language/input_error.h"
#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;
using test::Lines;
using test::run;

// Axes X1 Y2 Z3 A4 B5 C6.
std::string setup(const std::string& parameters) {
  return "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"A\", \"B\", \"C\"]\n[parameters]\n" + parameters +
         "[offsets.H]\n1 = 50\n2 = 10\n[offsets.D]\n1 = 10\n";
}
// Parameters of 19680 for two axes by number and direction code.
std::string machine(int type, int first, int first_code, int second, int second_code, const std::string& more = "") {
  return setup("19680 = " + std::to_string(type) + "\n19681 = " + std::to_string(first) +
               "\n19682 = " + std::to_string(first_code) + "\n19686 = " + std::to_string(second) +
               "\n19687 = " + std::to_string(second_code) + "\n" + more);
}
constexpr const char* kTable = "19684 = 1\n19689 = 1\n";  // the usual senses of table axes

// The tool axis after the last move.
std::string axis(const std::string& setup_text, const std::string& program, int digits = 15) {
  const test::Run done = run(setup_text, program);
  const model::Event& event = done.events().back();
  if (event.kind != spec::EventKind::move) return std::string(event.number.view());
  if (!event.tool_axis) return "none";
  std::string text;
  for (const exact::Real& component : *event.tool_axis) text += (text.empty() ? "" : " ") + component.decimal(digits);
  return text;
}

// sin, cos of 30: 0.5, 0.866025403784438647; of 60 the other way round.
TEST(ModelToolDirection, OrthogonalHeads) {
  // B carried by C: (sB cC, sB sC, cB).
  EXPECT_EQ(axis(machine(2, 6, 3, 5, 2), "B30. C60.\n"), "0.25 0.433012701892219 0.866025403784439");
  // A carried by C: (sA sC, -sA cC, cA).
  EXPECT_EQ(axis(machine(2, 6, 3, 4, 1), "A30. C60.\n"), "0.433012701892219 -0.25 0.866025403784439");
  // A carried by B: (sB cA, -sA, cB cA).
  EXPECT_EQ(axis(machine(2, 5, 2, 4, 1), "A30. B60.\n"), "0.75 -0.5 0.433012701892219");
  // B carried by A: (sB, -sA cB, cA cB).
  EXPECT_EQ(axis(machine(2, 4, 1, 5, 2), "A30. B60.\n"), "0.866025403784439 -0.25 0.433012701892219");
}

// G43.5 without I J K in the first block: nothing has moved yet, the direction is that of the start pose.
TEST(ModelToolDirection, TheStartPoseIsInForceFirst) {
  EXPECT_EQ(axis(machine(2, 6, 3, 5, 2), "G43.5\n"), "0 0 1");
  EXPECT_EQ(axis(machine(2, 6, 3, 5, 2, "19697 = 1\n"), "G43.5\n"), "1 0 0");
  EXPECT_EQ(axis(machine(2, 6, 3, 5, 2) + "[position]\nB = 90\n", "G43.5\n"), "1 0 0");
}

// B at 30 degrees of G54 is called 0 in a G55 that lies 30 degrees further, or by G92: VT stays (sin 30, 0, cos 30).
TEST(ModelToolDirection, AChangeOfCoordinatesTurnsNothing) {
  const std::string leaning = "0.5 0 0.866025403784439";
  const std::string work = machine(2, 6, 3, 5, 2) + "[workpiece.G55]\nB = 30\n";
  EXPECT_EQ(axis(work, "B30.\nG55\nX1.\n"), leaning);
  EXPECT_EQ(axis(work, "B30.\nG55\nG43.5\n"), leaning);
  EXPECT_EQ(axis(work, "B30.\nG92 B0\nX1.\n"), leaning);
  EXPECT_EQ(axis(work, "G55\nB0\n"), leaning);
  EXPECT_EQ(axis(work, "G55\nG53 B30.\n"), leaning);
  EXPECT_EQ(axis(work, "G55\nB-30.\n"), "0 0 1");
  EXPECT_EQ(axis(machine(2, 6, 3, 5, 2) + "[workpiece.G54]\nB = 30\n", "X1.\n"), leaning);
}

// The other reading: VT follows the programmed coordinate.
TEST(ModelToolDirection, FollowsTheProgrammedCoordinateWhereTheSetupSaysSo) {
  const std::string work = "rotary_angles = \"programmed\"\n" + machine(2, 6, 3, 5, 2) + "[workpiece.G55]\nB = 30\n";
  EXPECT_EQ(axis(work, "B30.\nG55\nX1.\n"), "0 0 1");
  EXPECT_EQ(axis(work, "B30.\nG55\nG43.5\n"), "0 0 1");
  EXPECT_EQ(axis(work, "B30.\nG92 B0\nX1.\n"), "0 0 1");
  EXPECT_EQ(axis(work, "G55\nG53 B30.\n"), "0 0 1");
}

// Linear axis 3 of a rotary axis may be left out where nothing depends on it, but not contradict the other two.
TEST(ModelToolDirection, LinearAxisThreeIsTheRemainingOne) {
  const std::string group = "19610 = 6\n19611 = 1\n19612 = 2\n";
  EXPECT_EQ(axis(setup(group), "C10.\n"), "0 0 1");
  EXPECT_EQ(axis(setup(group + "19613 = 3\n"), "C10.\n"), "0 0 1");
  EXPECT_THROW(axis(setup(group + "19613 = 1\n"), "C10.\n"), spec::InputError);
  EXPECT_THROW(axis(setup(group + "19613 = 4\n"), "C10.\n"), spec::InputError);
}

// Quarter turns are exact.
TEST(ModelToolDirection, QuarterTurns) {
  EXPECT_EQ(axis(machine(2, 6, 3, 5, 2), "B90. C180.\n"), "-1 0 0");
  EXPECT_EQ(axis(machine(2, 6, 3, 5, 2), "B-450. C90.\n"), "0 -1 0");
}

// (1, 2, 3) / sqrt(14) = (0.267261241912, 0.534522483825, 0.801783725737).
TEST(ModelToolDirection, TablesAndMixedMachines) {
  const std::string direction = "0.267261241912 0.534522483825 0.801783725737";
  EXPECT_EQ(axis(machine(12, 4, 1, 6, 3, kTable), "A36.6992252004899 C153.434948822922\n", 12), direction);
  EXPECT_EQ(axis(machine(12, 5, 2, 6, 3, kTable), "B36.6992252004899 C63.434948822922\n", 12), direction);
  EXPECT_EQ(axis(machine(21, 5, 2, 6, 3, "19689 = 1\n"), "B36.6992252004899 C63.434948822922\n", 12), direction);
  EXPECT_EQ(axis(machine(21, 4, 1, 6, 3, "19689 = 1\n"), "A36.6992252004899 C153.434948822922\n", 12), direction);
  // The other sense of every axis: all angles negative.
  EXPECT_EQ(axis(machine(12, 4, 1, 6, 3), "A-36.6992252004899 C-153.434948822922\n", 12), direction);
  EXPECT_EQ(axis(machine(2, 6, 3, 5, 2, "19684 = 1\n19689 = 1\n"), "B-30. C-60.\n"),
            "0.25 0.433012701892219 0.866025403784439");
}

// The slave about (0,1,1)/sqrt(2): code 5, inclination 45.
TEST(ModelToolDirection, InclinedAxes) {
  EXPECT_EQ(axis(machine(2, 6, 3, 5, 5, "19688 = 45\n"), "C13.8260478038529 B81.1005711201888\n", 12),
            "0.57735026919 0.57735026919 0.57735026919");
  EXPECT_EQ(
      axis(machine(12, 5, 5, 6, 3, std::string("19683 = 45\n") + kTable), "B52.8741729167231 C44.0642169567833\n", 12),
      "0.267261241912 0.534522483825 0.801783725737");
  // Half a turn takes Z to 2(u·Z)u - Z: for (cos 30, sin 30, 0) to -Z, for (sin 30, 0, cos 30) to (sin 60, 0, cos 60).
  EXPECT_EQ(axis(machine(2, 6, 3, 5, 4, "19688 = 30\n"), "B180.\n"), "0 0 -1");
  EXPECT_EQ(axis(machine(2, 6, 3, 5, 6, "19688 = 30\n"), "B180.\n"), "0.866025403784439 0 0.5");
}

TEST(ModelToolDirection, ReferenceDirections) {
  const auto at_zero = [](const std::string& more) { return axis(machine(2, 6, 3, 5, 2, more), "X1\n"); };
  EXPECT_EQ(at_zero(""), "0 0 1");
  EXPECT_EQ(at_zero("19697 = 1\n"), "1 0 0");
  EXPECT_EQ(at_zero("19697 = 2\n"), "0 1 0");
  EXPECT_EQ(at_zero("19697 = 3\n"), "0 0 1");
  // v0 = (cos RA sin RB, -sin RA, cos RA cos RB).
  EXPECT_EQ(at_zero("19699 = 90\n"), "1 0 0");
  EXPECT_EQ(at_zero("19698 = 30\n19699 = 60\n"), "0.75 -0.5 0.433012701892219");
  // With +X as the third axis the triple is (Y, Z, X).
  EXPECT_EQ(at_zero("19697 = 1\n19698 = 30\n19699 = 60\n"), "0.433012701892219 0.75 -0.5");
}

TEST(ModelToolDirection, HypotheticalAxes) {
  EXPECT_EQ(axis(machine(12, 0, 1, 6, 3, std::string("19685 = 30\n\"19696#0\" = 1\n") + kTable), "C90.\n"),
            "0.5 0 0.866025403784439");
  EXPECT_EQ(axis(machine(21, 5, 2, 0, 3, "19689 = 1\n19690 = 60\n\"19696#1\" = 1\n"), "B30.\n"),
            "0.25 0.433012701892219 0.866025403784439");
}

// B turns axis 3 (Z) toward axis 1 (X), C axis 1 toward axis 2; the first group first.
std::string older(const std::string& more = "") {
  return setup("19610 = 5\n19611 = 3\n19612 = 1\n19615 = 6\n19616 = 1\n19617 = 2\n" + more);
}

TEST(ModelToolDirection, OlderParameters) {
  EXPECT_EQ(axis(older(), "B30. C60.\n"), "0.25 0.433012701892219 0.866025403784439");
  EXPECT_EQ(axis(older("19620 = 10\n19621 = -30\n"), "B40. C30.\n"), "0.25 0.433012701892219 0.866025403784439");
  EXPECT_EQ(axis(older("19622 = 30\n19623 = 60\n"), "X1\n"), "0.75 -0.5 0.433012701892219");
  EXPECT_EQ(axis(older("19623 = 90\n"), "X1\n"), "1 0 0");
  // One group; X toward Z is left-handed about Y.
  EXPECT_EQ(axis(setup("19610 = 5\n19611 = 1\n19612 = 3\n"), "B-30.\n"), "0.5 0 0.866025403784439");
  // Inclined: sin(45) Z + cos(45) Y, the nutating axis N45 of the worked examples.
  EXPECT_EQ(axis(setup("19610 = 5\n19611 = 3\n19612 = 1\n19613 = 2\n19614 = 45\n19615 = 6\n19616 = 1\n19617 = 2\n"),
                 "C13.8260478038529 B81.1005711201888\n", 12),
            "0.57735026919 0.57735026919 0.57735026919");
  // 19680 counts before 19610.
  EXPECT_EQ(axis(machine(2, 6, 3, 4, 1, "19610 = 5\n19611 = 3\n19612 = 1\n"), "A30. B77. C60.\n"),
            "0.433012701892219 -0.25 0.866025403784439");
}

TEST(ModelToolDirection, ParametersThatMakeNoSense) {
  const auto refused = [](const std::string& setup_text) {
    try {
      run(setup_text, "X1\n");
    } catch (const spec::InputError& error) {
      return error.message().substr(0, error.message().find(':'));
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refused(setup("19680 = 3\n")), "parameters.19680");
  EXPECT_EQ(refused(machine(2, 7, 3, 5, 2)), "parameters.19681");
  EXPECT_EQ(refused(machine(2, 0, 3, 5, 2)), "parameters.19681");
  EXPECT_EQ(refused(machine(2, 1, 3, 5, 2)), "parameters.19681");  // X
  EXPECT_EQ(refused(machine(2, 6, 0, 5, 2)), "parameters.19682");
  EXPECT_EQ(refused(machine(2, 6, 3, 6, 2)), "parameters.19686");
  EXPECT_EQ(refused(machine(2, 6, 3, 5, 7)), "parameters.19687");
  EXPECT_EQ(refused(machine(2, 6, 3, 5, 2, "19684 = 2\n")), "parameters.19684");
  EXPECT_EQ(refused(machine(2, 6, 3, 5, 2, "19697 = 4\n")), "parameters.19697");
  EXPECT_EQ(refused(machine(12, 4, 1, 6, 3, "\"19696#1\" = 1\n")), "parameters.19686");
  EXPECT_EQ(refused(setup("19610 = 5\n19611 = 3\n19612 = 3\n")), "parameters.19612");
  EXPECT_EQ(refused(setup("19610 = 5\n19611 = 4\n19612 = 3\n")), "parameters.19611");
  EXPECT_EQ(refused(setup("19610 = 3\n19611 = 1\n19612 = 2\n")), "parameters.19610");
  EXPECT_EQ(refused(setup("19610 = 5\n19611 = 1\n19612 = 3\n19613 = 2\n19614 = 45\n")), "parameters.19613");
  EXPECT_EQ(refused(setup("19610 = 5\n19611 = 3\n19612 = 1\n19615 = 5\n19616 = 3\n19617 = 1\n")), "parameters.19615");
}

// I J K: any length; a missing one is 0; none keeps the direction, at first that of the axes.
TEST(ModelToolDirection, Words) {
  const std::string head = machine(2, 6, 3, 5, 2);
  EXPECT_EQ(axis(setup(""), "X1\n"), "none");
  EXPECT_EQ(axis(setup(""), "G43.5\n"), "0 0 1");
  EXPECT_EQ(axis(setup(""), "G43.5 I30 K40\n"), "0.6 0 0.8");
  EXPECT_EQ(axis(setup(""), "G43.5 I30 K40\nJ-7\n"), "0 -1 0");
  EXPECT_EQ(axis(setup(""), "G43.5 I30 K40\nX1\n"), "0.6 0 0.8");
  EXPECT_EQ(axis(head, "B30.\nG43.5\n"), "0.5 0 0.866025403784439");
  EXPECT_EQ(axis(head, "B30.\nG43.5 K1\nG49\nX1\n"), "0 0 1");  // the head has turned
  EXPECT_EQ(axis(setup(""), "G43.5 K1\nG49\nX1\n"), "none");
}

// X Y Z go to the programmed point plus the length along the tool.
TEST(ModelToolDirection, LengthAlongTheTool) {
  EXPECT_EQ(test::lines(run(setup(""), "X10\nG43.5 I3 K4 H1\nX20\nI0 J1\nH2\nH2\nY5 H0\nG49\nX0\n")),
            (Lines{"1 rapid X10 Y0 Z0 A0 B0 C0", "2 rapid X40 Y0 Z40 A0 B0 C0", "3 rapid X50 Y0 Z40 A0 B0 C0",
                   "4 rapid X20 Y50 Z0 A0 B0 C0", "5 rapid X20 Y10 Z0 A0 B0 C0", "7 rapid X20 Y5 Z0 A0 B0 C0",
                   "9 rapid X0 Y5 Z0 A0 B0 C0"}));
  // G43.5 alone makes a move even where nothing changes, the repeated one too.
  EXPECT_EQ(run(setup(""), "G43.5\nG43.5\n").events().size(), 2U);
  // The H rules of G43: with OFH a lone H is ignored, the first code without H takes H0.
  EXPECT_EQ(test::lines(run(setup("\"5001#2\" = 1\n"), "H1\nG43.5 I1\nG43.5 H1\nH2\nG43.5\n")),
            (Lines{"2 rapid X0 Y0 Z0 A0 B0 C0", "3 rapid X50 Y0 Z0 A0 B0 C0", "5 rapid X50 Y0 Z0 A0 B0 C0"}));
  // EVO: an edited value in the next block.
  EXPECT_EQ(test::lines(run(setup("\"5001#6\" = 1\n"), "G43.5 I1 H1\nG10 L11 P1 R60\nY1\n")).back(),
            "3 rapid X60 Y1 Z0 A0 B0 C0");
}

// G49 makes no move: the programmed position becomes that of the axes, irrational where the direction is.
// 50 / sqrt(2) = 35.355339059327376.
TEST(ModelToolDirection, End) {
  const auto done = run(setup(""), "G43.5 I1 K1 H1\nG49\nG91 Y1\nG90 X2\nG49 Z3\n");
  EXPECT_EQ(test::lines(done, test::Show::point),
            (Lines{"1 rapid X0 Y0 Z0", "3 rapid X35.355339059327376 Y1 Z35.355339059327376",
                   "4 rapid X2 Y1 Z35.355339059327376", "5 rapid X2 Y1 Z3"}));
  // Words in the block with G49 count from there.
  EXPECT_EQ(test::lines(run(setup(""), "G43.5 I1 H1\nG91 G49 X1\n")).back(), "2 rapid X51 Y0 Z0 A0 B0 C0");
  // The machine shifted by such a rest comes back exactly: G92 calls X 35.35… 0, and G53 X0 is -35.35… from there.
  EXPECT_EQ(test::lines(run(setup(""), "G43.5 I1 K1 H1\nG49\nG92 X0\nG53 X0\n")).back(),
            "4 rapid X-35.355339059327376 Y0 Z35.355339059327376 A0 B0 C0");
}

TEST(ModelToolDirection, MachineCoordinates) {
  const auto done = run(setup("") + "[workpiece.G54]\nX = 100\n", "G43.5 I1 H1\nG49\nX0\n");
  EXPECT_EQ(test::lines(done, test::Show::machine), (Lines{"1 rapid X150 Y0 Z0 A0 B0 C0", "3 rapid "}));
}

TEST(ModelToolDirection, Alarms) {
  const std::string head = machine(2, 6, 3, 5, 2);
  const auto last = [](const std::string& setup_text, const std::string& program) {
    return test::lines(run(setup_text, program)).back();
  };
  for (const char* block : {"G28 X0", "G29 X0", "G30 X0", "G30.1 X0", "G53 X0", "G92 X0", "G54", "G59"})
    EXPECT_EQ(last(head, std::string("G43.5\n") + block + "\n"), "2 FORBIDDEN_UNDER_TOOL_DIRECTION") << block;
  EXPECT_EQ(last(head, "G43.5\nG04 P1\nG10 L11 P1 R1\nX1\n"), "4 rapid X1 Y0 Z0 A0 B0 C0");
  EXPECT_EQ(last(head, "G43.5\nG49 G28 X0\n"), "2 rapid X0 Y0 Z0 A0 B0 C0 (reference)");
  EXPECT_EQ(last(head, "G43.5\nG43 H1\n"), "2 LENGTH_OFFSET_EXCLUSION");
  EXPECT_EQ(last(head, "G43 H1\nG43.5\n"), "2 LENGTH_OFFSET_EXCLUSION");
  EXPECT_EQ(last(head, "G43 H1\nH0\nG43.5\n"), "3 rapid X0 Y0 Z0 A0 B0 C0");
  EXPECT_EQ(last(setup("19666 = 1\n"), "G43.5\n"), "1 rapid X0 Y0 Z1 A0 B0 C0");
  EXPECT_EQ(last(head, "G02 G43.5\n"), "1 TOOL_DIRECTION_FORMAT");
  EXPECT_EQ(last(head, "G43.5\nG02 X1 I5\n"), "2 PS5421");
  EXPECT_EQ(last(head, "G43.5\nG02 X1 R5\n"), "2 arc X1 Y0 Z0 A0 B0 C0");
  EXPECT_EQ(last(head, "G41.3 D1\nX100\nG43.5\n"), "3 TOOL_DIRECTION_FORMAT");
  EXPECT_EQ(last(head, "G43.5\nG41.3 D1\nX100\nG49\n"), "4 TOOL_DIRECTION_FORMAT");
  EXPECT_EQ(last(head, "G41.3 G43.5 D1\nX100\n"), "1 TOOL_DIRECTION_FORMAT");
  EXPECT_EQ(last(head, "G43.5\nB30.\n"), "2 PS5421");
  EXPECT_EQ(last(head, "G43.5 B30.\n"), "1 PS5421");
  EXPECT_EQ(last(head, "G43.5 I0 J0\n"), "1 PS5421");
  EXPECT_EQ(last(setup(""), "G43.4 H1\n"), "1 PS5459");
  EXPECT_EQ(last(setup(""), "G43.5 H3\n"), "1 rapid X0 Y0 Z0 A0 B0 C0");
}

}  // namespace
