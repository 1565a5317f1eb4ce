// SPDX-License-Identifier: Apache-2.0
// Cutter compensation B in the exact engine, by hand. The worked examples of 14.4 stand in
// corpus/examples/fanuc/cutter_compensation_b.cpp.
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;
using test::Lines;
using test::lines;
using test::run;
using test::Show;

std::string setup(const std::string& offsets, const std::string& parameters = "", const std::string& more = "") {
  return "control = \"fanuc\"\ncutter_compensation = \"B\"\naxes = [\"X\", \"Y\", \"Z\"]\n[parameters]\n" + parameters +
         offsets + more;
}
const std::string kTen = "[offsets.D]\n1 = 10\n2 = 5\n3 = -10\n4 = 0\n";
constexpr const char* kOfh = "\"5001#2\" = 1\n";

Lines heads(const std::string& program, const std::string& parameters = "", const std::string& more = "") {
  return lines(run(setup(kTen, parameters, more), program), Show::point, 14);
}

// V of length 10 across (3, 4)/5: (-8, 6).
TEST(ModelCutterCompensationB, StartUpVectors) {
  // A negative value turns the side round; number 0 and value 0 make vectors of length 0.
  EXPECT_EQ(heads("G41 X30 Y40 D3\n"), (Lines{"1 rapid X38 Y34 Z0 (start-up)"}));
  EXPECT_EQ(heads("G41 X30 Y40 D4\nX0 D1\n"), (Lines{"1 rapid X30 Y40 Z0 (start-up)", "2 rapid X0 Y30 Z0"}));
  EXPECT_EQ(heads("G41 X30 Y40 D0\n"), (Lines{"1 rapid X30 Y40 Z0 (start-up)"}));
  // With OFH an H gives the number too.
  EXPECT_EQ(lines(run(setup("[offsets.H]\n1 = 10\n", kOfh), "G41 X30 Y40 H1\n"), Show::point),
            (Lines{"1 rapid X22 Y46 Z0 (start-up)"}));
}

TEST(ModelCutterCompensationB, CornerArcOnTheRight) {
  const test::Run made = run(setup(kTen), "G01 G42 Y60 D2\nG39 I-40\n");
  EXPECT_EQ(lines(made, Show::point), (Lines{"1 linear X5 Y60 Z0 (start-up)", "2 arc X0 Y65 Z0 (corner)"}));
  EXPECT_EQ(made.events().at(1).arc->direction, spec::ArcDirection::ccw);
  EXPECT_EQ(made.events().at(1).arc->sweep->decimal(3), "90");
  // A negative value turns the sense round.
  const test::Run negative = run(setup(kTen), "G01 G41 Y60 D3\nG39 I-40\n");
  EXPECT_EQ(negative.events().at(1).arc->direction, spec::ArcDirection::ccw);
  EXPECT_EQ(test::text(negative.events().at(1).point, negative.setup.axes, 3), "X0 Y70 Z0");
}

TEST(ModelCutterCompensationB, CornerArcDirections) {
  // The direction by axis words: G91 (30, 40); G90 the same from (40, 0). Nothing moves but the vector.
  const Lines expected{"1 linear X40 Y10 Z0 (start-up)", "2 arc X32 Y6 Z0 (corner)"};
  EXPECT_EQ(heads("G01 G41 X40 D1\nG91 G39 X30 Y40\n"), expected);
  EXPECT_EQ(heads("G01 G41 X40 D1\nG39 X70 Y40\n"), expected);
  // I J before axis words.
  EXPECT_EQ(heads("G01 G41 X40 D1\nG39 X1 I3 J4\n"), expected);
  // The long way round on the inside: 360 less atan(4/3).
  const test::Run inside = run(setup(kTen), "G01 G41 X40 D1\nG39 I3 J4\n");
  EXPECT_EQ(inside.events().at(1).arc->sweep->decimal(12), "306.869897645844");
  // The same direction, and number 0: no arc.
  EXPECT_EQ(heads("G01 G41 X40 D1\nG39 I5\n"), (Lines{"1 linear X40 Y10 Z0 (start-up)"}));
  EXPECT_EQ(heads("G01 G41 X40 D0\nG39 J5\n"), (Lines{"1 linear X40 Y0 Z0 (start-up)"}));
  // The point is one of the system that the block selects: from -60 in G55 towards -50, along +X; in G54 along -X.
  EXPECT_EQ(heads("G01 G41 Y40 D1\nG39 G55 X-50\n", "", "[workpiece.G55]\nX = 60\n").at(1),
            "2 arc X-60 Y50 Z0 (corner)");
  // Under G00 the arc carries F.
  const test::Run rapid = run(setup(kTen), "F100 G41 X40 D1\nG39 J5\n");
  EXPECT_EQ(rapid.events().at(1).feed->decimal(3), "100");
}

TEST(ModelCutterCompensationB, SwitchesSidesInOneMove) {
  EXPECT_EQ(heads("G41 X40 D1\nG42 X80\n"), (Lines{"1 rapid X40 Y10 Z0 (start-up)", "2 rapid X80 Y-10 Z0"}));
  // A lone code waits for the next vector; a new number too.
  EXPECT_EQ(heads("G41 X40 D1\nG42\nD2\nZ1\nX80\n"),
            (Lines{"1 rapid X40 Y10 Z0 (start-up)", "4 rapid X40 Y10 Z1", "5 rapid X80 Y-5 Z1"}));
}

TEST(ModelCutterCompensationB, KeepsTheVectorWithoutADirection) {
  EXPECT_EQ(heads("G41 X40 D1\nX40 D2\nX50 I0 J0\nG91 Y0\nX0 J1\n"),
            (Lines{"1 rapid X40 Y10 Z0 (start-up)", "2 rapid X40 Y10 Z0", "3 rapid X50 Y10 Z0", "4 rapid X50 Y10 Z0",
                   "5 rapid X45 Y0 Z0"}));
  // Before the first direction there is no vector.
  EXPECT_EQ(heads("G41 Z5 D1\nX0\nY10\n"),
            (Lines{"1 rapid X0 Y0 Z5", "2 rapid X0 Y0 Z5", "3 rapid X-10 Y10 Z5 (start-up)"}));
}

// Not a tangent join: old head (40, 10), centre (40, 20), new head at (60 - 10, 20): radii 10 and 10. From (40, 0) with
// the vector of X40, G03 about (40, 20) to (60, 20).
TEST(ModelCutterCompensationB, Arcs) {
  const test::Run tangent = run(setup(kTen), "G01 G41 X40 D1\nG03 X60 Y20 J20\n");
  EXPECT_EQ(lines(tangent, Show::point).at(1), "2 arc X50 Y20 Z0");
  EXPECT_EQ(tangent.events().at(1).arc->sweep->decimal(3), "90");
  EXPECT_FALSE(tangent.events().at(1).arc->radius);
  // From (40, 0), head (40, 10), G02 about (50, 0) to (60, 0): the new vector points away from the centre, head (70,
  // 0). Radii |(-10, 10)| = 10√2 and 20, clockwise from 135° to 0°.
  const test::Run spiral = run(setup(kTen), "G01 G41 X40 D1\nG02 X60 I10\n");
  EXPECT_EQ(lines(spiral, Show::point).at(1), "2 arc X70 Y0 Z0");
  EXPECT_EQ(spiral.events().at(1).arc->sweep->decimal(3), "135");
  EXPECT_EQ(spiral.events().at(1).arc->radius->first.decimal(12), "14.142135623731");
  EXPECT_EQ(spiral.events().at(1).arc->radius->second.decimal(12), "20");
  // A full circle from a radial vector is a whole turn.
  const test::Run whole = run(setup(kTen), "G01 G41 X40 D1\nG03 J20\n");
  EXPECT_EQ(whole.events().at(1).arc->sweep->decimal(3), "360");
  // Inside with the radius of the arc: the head lies in the centre.
  const test::Run point = run(setup(kTen), "G01 G41 X40 D1\nG03 X50 Y10 J10\n");
  EXPECT_EQ(lines(point, Show::point).at(1), "2 arc X40 Y10 Z0");
  EXPECT_FALSE(point.events().at(1).arc->sweep);
  // An arc that ends in its centre.
  EXPECT_EQ(heads("G01 G41 X40 D1\nG03 X50 I10\n").back(), "2 PS0038");
}

TEST(ModelCutterCompensationB, Cancel) {
  EXPECT_EQ(heads("G41 X40 D1\nG40 X80\nX90\n"),
            (Lines{"1 rapid X40 Y10 Z0 (start-up)", "2 rapid X80 Y0 Z0 (cancel)", "3 rapid X90 Y0 Z0"}));
  EXPECT_EQ(heads("G41 X40 D1\nG01 G40\nG40\n"),
            (Lines{"1 rapid X40 Y10 Z0 (start-up)", "2 linear X40 Y0 Z0 (cancel)"}));
  EXPECT_EQ(heads("G41 X40 D1\nG40 Z5 I1\n"), (Lines{"1 rapid X40 Y10 Z0 (start-up)", "2 rapid X40 Y0 Z5 (cancel)"}));
  // Nothing started, nothing cancelled; a zero vector does not move.
  EXPECT_EQ(heads("G41 D1\nG40 X5\n"), (Lines{"2 rapid X5 Y0 Z0"}));
  EXPECT_EQ(heads("G41 X40 D0\nG40\n"), (Lines{"1 rapid X40 Y0 Z0 (start-up)"}));
  EXPECT_EQ(heads("G41 X40 D0\nG40 G02 X60 R10\n").back(), "2 arc X60 Y0 Z0 (cancel)");
  // D0 does not cancel.
  EXPECT_EQ(heads("G41 X40 D1\nX50 D0\nX60 D1\n"),
            (Lines{"1 rapid X40 Y10 Z0 (start-up)", "2 rapid X50 Y0 Z0", "3 rapid X60 Y10 Z0"}));
}

// A length that changes with a lone G40 or with G39 goes in the same move.
TEST(ModelCutterCompensationB, LengthOffsetInTheSameMove) {
  const std::string h = "[offsets.H]\n1 = 7\n";
  EXPECT_EQ(lines(run(setup(kTen, "", h), "G43 G41 X40 D1\nG40 H1\n")),
            (Lines{"1 rapid X40 Y10 Z0 (start-up)", "2 rapid X40 Y0 Z7 (cancel)"}));
  EXPECT_EQ(lines(run(setup(kTen, "", h), "G43 G41 X40 D0\nG40 H1\n")).at(1), "2 rapid X40 Y0 Z7");
  EXPECT_EQ(lines(run(setup(kTen, "", h), "G43 G41 X40 D1\nG39 J1 H1\n")).at(1), "2 arc X30 Y0 Z7 (corner)");
  EXPECT_EQ(lines(run(setup(kTen, "", h), "G43 G41 X40 D1\nG39 I1 H1\n")).at(1), "2 rapid X40 Y10 Z7");
}

TEST(ModelCutterCompensationB, Planes) {
  // G18: Z is the first axis, X the second: left of +Z is +X. G19: left of +Y is +Z.
  EXPECT_EQ(heads("G18 G41 Z40 D1\n"), (Lines{"1 rapid X10 Y0 Z40 (start-up)"}));
  EXPECT_EQ(heads("G19 G41 Y40 D1\nX5 Z1 K-1\n"), (Lines{"1 rapid X0 Y40 Z10 (start-up)", "2 rapid X5 Y50 Z1"}));
  EXPECT_EQ(heads("G41 X40 D1\nG18 X50\n").back(), "2 PS0037");
  EXPECT_EQ(heads("G41 X40 D1\nG18 G40 X50\n").back(), "2 PS0037");
  EXPECT_EQ(lines(run("control = \"fanuc\"\ncutter_compensation = \"B\"\naxes = [\"X\", \"Y\"]\n", "G18 G41 X1\n")),
            (Lines{"1 PS0028"}));
}

TEST(ModelCutterCompensationB, MachinePositions) {
  const std::string reference = "[reference.1]\nX = 7\n";
  EXPECT_EQ(heads("G41 X40 D1\nG53 X60\nX70\n"),
            (Lines{"1 rapid X40 Y10 Z0 (start-up)", "2 rapid X60 Y0 Z0", "3 rapid X70 Y10 Z0 (start-up)"}));
  EXPECT_EQ(heads("G41 X40 D1\nG53 Z5\nX70\n"),
            (Lines{"1 rapid X40 Y10 Z0 (start-up)", "2 rapid X40 Y10 Z5", "3 rapid X70 Y10 Z5"}));
  EXPECT_EQ(heads("G41 X40 D1\nG28 X60\n", "", reference),
            (Lines{"1 rapid X40 Y10 Z0 (start-up)", "2 rapid X60 Y0 Z0 (reference)", "2 rapid X7 Y0 Z0 (reference)"}));
  EXPECT_EQ(heads("G41 X40 D1\nG40 G53 Z5\n").back(), "2 rapid X40 Y0 Z5");
  // G53 under G91 does nothing: a lone G40.
  EXPECT_EQ(heads("G41 X40 D1\nG91 G40 G53 X5\n").back(), "2 rapid X40 Y0 Z0 (cancel)");
  // G92 and G54 to G59 leave the tool where it is.
  EXPECT_EQ(heads("G41 X40 D1\nG92 X0\nX10\n").back(), "3 rapid X10 Y10 Z0");
  // The move that removes the vector is written after the renaming, that of the length offset alone before it.
  constexpr const char* kLength = "[offsets.H]\n9 = 50\n";
  EXPECT_EQ(heads("G43 H9\nG41 X40 D1\nG40 G92 H0 X1\n", "", kLength).back(), "3 rapid X1 Y0 Z0 (cancel)");
  EXPECT_EQ(heads("G43 H9\nG41 X40 D1\nG92 H0 X1\n", "", kLength).back(), "3 rapid X40 Y10 Z0");
}

TEST(ModelCutterCompensationB, EditedValues) {
  const char* const program = "G41 X40 D1\nG10 L11 P1 R2\nX50\nX60 D1\n";
  EXPECT_EQ(heads(program),
            (Lines{"1 rapid X40 Y10 Z0 (start-up)", "2 H1=2", "3 rapid X50 Y10 Z0", "4 rapid X60 Y2 Z0"}));
  EXPECT_EQ(heads(program, "\"5001#4\" = 1\n").at(2), "3 rapid X50 Y2 Z0");
}

TEST(ModelCutterCompensationB, Alarms) {
  const std::string on = "G01 G41 X40 D1\n";
  EXPECT_EQ(heads("G02 G41 X20 R10 D1\n").back(), "1 PS0034");
  EXPECT_EQ(heads("G41 D1\nG02 X20 R10\n").back(), "2 PS0034");
  EXPECT_EQ(heads(on + "G02 G41 X60 R10\n").back(), "2 PS0034");
  EXPECT_EQ(heads(on + "G02 G42 X60 R10\n").back(), "2 PS0034");
  EXPECT_EQ(heads(on + "G02 X60 R10 D2\n").back(), "2 PS0034");
  EXPECT_EQ(heads(on + "G02 X60 R10 D1\n").size(), 2U);  // the number in force is no other number
  EXPECT_EQ(heads(on + "G02 G40 X60 R10\n").back(), "2 PS0034");
  EXPECT_EQ(heads(on + "G53 X0\nG02 X60 R30\n").back(), "3 PS0034");
  EXPECT_EQ(heads("G39 I1\n"), (Lines{"1 PS0035"}));
  EXPECT_EQ(heads("G41 D1\nG39 I1\n"), (Lines{"2 PS0035"}));
  for (const char* const g39 : {"G39", "G39 I0", "G39 K1", "G39 Z5 I1", "G39 G40 I1", "G39 G41 I1", "G39 I1 D2"})
    EXPECT_EQ(heads(on + g39 + "\n").back(), "2 PS0035") << g39;
  EXPECT_EQ(heads(on + "G45 X1\n").back(), "2 PS0042");
  EXPECT_EQ(heads(on + "G41.3\n").back(), "2 FORBIDDEN_IN_CUTTER_COMPENSATION");
  EXPECT_EQ(heads(on + "G43.5 I1\n").back(), "2 FORBIDDEN_IN_CUTTER_COMPENSATION");
}

}  // namespace
