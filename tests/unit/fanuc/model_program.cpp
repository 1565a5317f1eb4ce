// SPDX-License-Identifier: Apache-2.0
// Interpretation common to the sections: units, arcs, workpiece and machine coordinates, offset memory and G10, alarms.
// Expected values are derived by hand in the comments or stand for themselves.
#include <gtest/gtest.h>

#include <string>

#include "spec/language/input_error.h"
#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;
using test::Lines;
using test::run;
using test::Show;

std::string setup(const std::string& keys = "") {
  return "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"C\"]\n" + keys;
}
Lines moves(const std::string& program, const std::string& keys = "") { return test::lines(run(setup(keys), program)); }
Lines machine(const std::string& program, const std::string& keys) {
  return test::lines(run(setup(keys), program), Show::machine);
}

// "XY ccw X0 Y0 sweep 90 radius 10 20" of the last move, or its type if it is no arc.
std::string arc(const std::string& program, int digits = 15) {
  const test::Run done = run(setup(), program);
  const model::Event& event = done.events().back();
  if (event.kind != spec::EventKind::move) return std::string(event.number.view());
  if (!event.arc) return std::string(spec::name(event.type));
  std::string text = std::string(spec::name(event.arc->plane)) + ' ' + std::string(spec::name(event.arc->direction)) +
                     ' ' + test::text(event.arc->center, done.setup.axes, digits);
  if (event.arc->sweep) text += " sweep " + event.arc->sweep->decimal(digits);
  if (event.arc->radius)
    text += " radius " + event.arc->radius->first.decimal(digits) + ' ' + event.arc->radius->second.decimal(digits);
  return text;
}

TEST(ModelProgram, AbsoluteAndIncremental) {
  EXPECT_EQ(moves("X1 Y2\nG91 X1 C90\nG90 Y5\nG91\nX-0\n"),
            (Lines{"1 rapid X1 Y2 Z0 C0", "2 rapid X2 Y2 Z0 C90", "3 rapid X2 Y5 Z0 C90", "5 rapid X2 Y5 Z0 C90"}));
}

TEST(ModelProgram, Units) {
  // Inch words in a program of a mm setup; G20 counts for its own block; rotary words are degrees.
  EXPECT_EQ(moves("G20 X1 C1\nG21 X1\n"), (Lines{"1 rapid X25.4 Y0 Z0 C1", "2 rapid X1 Y0 Z0 C1"}));
  const auto inch = run(setup("units = \"inch\"\n"), "G21 G01 X50.8 F254\n");
  EXPECT_EQ(test::lines(inch), (Lines{"1 linear X2 Y0 Z0 C0"}));
  EXPECT_EQ(inch.events()[0].feed->decimal(3), "10");
}

TEST(ModelProgram, LeastIncrements) {
  const std::string counted = "[parameters]\n\"3401#0\" = 0\n";
  EXPECT_EQ(moves("X1 Y1. C1\n", counted), (Lines{"1 rapid X0.001 Y1 Z0 C0.001"}));
  EXPECT_EQ(moves("X1 C1\n", "increment = \"IS-A\"\n" + counted), (Lines{"1 rapid X0.01 Y0 Z0 C0.01"}));
  EXPECT_EQ(moves("X1 C1\n", "increment = \"IS-C\"\n" + counted), (Lines{"1 rapid X0.0001 Y0 Z0 C0.0001"}));
  // A ten-thousandth of an inch is 0.00254 mm; degrees as ever.
  EXPECT_EQ(moves("G20 X1 C1\n", counted), (Lines{"1 rapid X0.00254 Y0 Z0 C0.001"}));
  // F never counts increments, R of G10 does.
  const auto done = run(setup(counted), "G01 X1 F100\nG10 L11 P1 R500\n");
  EXPECT_EQ(done.events()[0].feed->decimal(3), "100");
  EXPECT_EQ(done.events()[1].value.decimal(3), "0.5");
}

TEST(ModelProgram, FeedIsModalAndNotOfRapidMoves) {
  const auto done = run(setup("[parameters]\n1411 = 7\n"), "G01 X1\nX2 F100\nX3\nG00 X4 F50\nG01 X5\n");
  ASSERT_EQ(done.events().size(), 5U);
  EXPECT_EQ(done.events()[0].feed->decimal(0), "7");  // at power-on
  EXPECT_EQ(done.events()[1].feed->decimal(0), "100");
  EXPECT_EQ(done.events()[2].feed->decimal(0), "100");
  EXPECT_FALSE(done.events()[3].feed);
  EXPECT_EQ(done.events()[4].feed->decimal(0), "50");
}

// Quarter circles about the origin.
TEST(ModelProgram, ArcsByCenter) {
  EXPECT_EQ(arc("X10\nG03 X0 Y10 I-10\n"), "XY ccw X0 Y0 sweep 90");
  EXPECT_EQ(arc("X10\nG02 X0 Y10 I-10\n"), "XY cw X0 Y0 sweep 270");
  EXPECT_EQ(arc("G18 Z10\nG03 X10 Z0 K-10\n"), "ZX ccw X0 Z0 sweep 90");
  EXPECT_EQ(arc("G19 Y10\nG03 Y0 Z10 J-10\n"), "YZ ccw Y0 Z0 sweep 90");
  EXPECT_EQ(arc("X10\nG03 X-10 I-10\n"), "XY ccw X0 Y0 sweep 180");
  EXPECT_EQ(arc("X10\nG91 G03 X0 Z5 I-10\n"), "XY ccw X0 Y0 sweep 360");  // a helix of one turn
  EXPECT_EQ(arc("X10\nG02 I-10\n"), "XY cw X0 Y0 sweep 360");
  EXPECT_EQ(arc("X10\nG03 X0 Y10 I-10 K5\n"), "XY ccw X0 Y0 sweep 90");  // K is no letter of the plane
  // 3-4-5: atan(4/3) = 53.130102354155979 degrees.
  EXPECT_EQ(arc("X10\nG03 X6 Y8 I-10\n"), "XY ccw X0 Y0 sweep 53.130102354155979");
  EXPECT_EQ(arc("X10\nG02 X6 Y8 I-10\n"), "XY cw X0 Y0 sweep 306.869897645844021");
  EXPECT_EQ(arc("X10\nG03 X-6 Y8 I-10\n"), "XY ccw X0 Y0 sweep 126.869897645844021");
  EXPECT_EQ(arc("X10\nG03 X-6 Y-8 I-10\n"), "XY ccw X0 Y0 sweep 233.130102354155979");
}

TEST(ModelProgram, Spirals) {
  EXPECT_EQ(arc("X10\nG03 X0 Y20 I-10\n"), "XY ccw X0 Y0 sweep 90 radius 10 20");
  EXPECT_EQ(arc("X10\nG03 X0 Y5 I-10\n"), "XY ccw X0 Y0 sweep 90 radius 10 5");
  EXPECT_EQ(arc("X10\nG03 X20 I-10\n"), "XY ccw X0 Y0 sweep 360 radius 10 20");
  EXPECT_EQ(arc("X10\nG03 X0 Y0 I-10\n"), "XY ccw X0 Y0 radius 10 0");
}

TEST(ModelProgram, ArcsByRadius) {
  EXPECT_EQ(arc("X10\nG03 X0 Y10 R10\n"), "XY ccw X0 Y0 sweep 90");
  EXPECT_EQ(arc("X10\nG03 X0 Y10 R-10\n"), "XY ccw X10 Y10 sweep 270");
  EXPECT_EQ(arc("X10\nG02 X0 Y10 R10\n"), "XY cw X10 Y10 sweep 90");
  EXPECT_EQ(arc("X10\nG02 X0 Y10 R-10 I7\n"), "XY cw X0 Y0 sweep 270");  // R wins
  EXPECT_EQ(arc("X10\nG03 X-10 R10\n"), "XY ccw X0 Y0 sweep 180");
  EXPECT_EQ(arc("X10\nG03 X-10 R-10\n"), "XY ccw X0 Y0 sweep 180");
  // The chord is the radius: 60 degrees; the centre at height 10·sqrt(3)/2 on the left of -X.
  EXPECT_EQ(arc("X10\nG03 X0 R10\n"), "XY ccw X5 Y-8.660254037844386 sweep 60");
}

TEST(ModelProgram, ArcsThatCannotBe) {
  for (const char* block : {"G03 X-10 R9.999", "G03 X0 R0"})
    EXPECT_EQ(arc(std::string("X10\n") + block + "\n"), "PS0020") << block;
  for (const char* block : {"G03 X0 Y10", "G03 X0 Y10 I0", "G03 X0 K5", "G03 K5"})
    EXPECT_EQ(arc(std::string("X10\n") + block + "\n"), "PS0022") << block;
  // R with the end in the start: an arc of 0 degrees, which is no move without an axis word.
  for (const char* block : {"G03 X10 R10", "G03 Z5 R5", "G03 X10 R0"})
    EXPECT_EQ(arc(std::string("X10\n") + block + "\n"), "linear") << block;
  EXPECT_EQ(arc("X10\nG03 R10\n"), "rapid");
  EXPECT_EQ(arc("X10\nG03 Z5\n"), "linear");
  EXPECT_EQ(arc("X10\nG03 C90\n"), "linear");
}

// Machine = workpiece + origin; the machine stays when the system changes.
TEST(ModelProgram, WorkpieceSystems) {
  const std::string keys = "[workpiece.G54]\nX = 100\n[workpiece.G55]\nX = 150\nC = 10\n[position]\nX = 5\n";
  EXPECT_EQ(moves("Y0\nG55\nY1\nG91 G54 X1\nG59 G90 X0\n", keys),
            (Lines{"1 rapid X5 Y0 Z0 C0", "3 rapid X-45 Y1 Z0 C-10", "4 rapid X6 Y1 Z0 C0", "5 rapid X0 Y1 Z0 C0"}));
  // G92: 5 is called 20 from here on, in every system: machine X 0 is workpiece 20 - 105 = -85.
  EXPECT_EQ(moves("G92 X20\nY0\nG55 Y0\nG53 X0\n", keys),
            (Lines{"2 rapid X20 Y0 Z0 C0", "3 rapid X-30 Y0 Z0 C-10", "4 rapid X-135 Y0 Z0 C-10"}));
  EXPECT_EQ(machine("G92 X20\nG53 X0\n", keys), (Lines{"2 rapid X0 Y0 Z0 C0"}));
}

TEST(ModelProgram, ReferenceReturns) {
  const std::string keys =
      "[workpiece.G54]\nX = 100\n[reference.1]\nX = 7\n[reference.2]\nX = 8\n[reference.4]\nX = 9\nC = 30\n"
      "[reference.floating]\nX = 10\n";
  EXPECT_EQ(moves("G28 X5\nX0\nG91 G28 X5 Y2\nG90 G28\n", keys),
            (Lines{"1 rapid X5 Y0 Z0 C0 (reference)", "1 rapid X-93 Y0 Z0 C0 (reference)", "2 rapid X0 Y0 Z0 C0",
                   "3 rapid X5 Y2 Z0 C0 (reference)", "3 rapid X-93 Y0 Z0 C0 (reference)"}));
  EXPECT_EQ(machine("G30 X0\nG30 P4 X0 C0\nG30.1 X0\nG30 P3 X0\n", keys),
            (Lines{"1 rapid X100 Y0 Z0 C0 (reference)", "1 rapid X8 Y0 Z0 C0 (reference)",
                   "2 rapid X100 Y0 Z0 C0 (reference)", "2 rapid X9 Y0 Z0 C30 (reference)",
                   "3 rapid X100 Y0 Z0 C30 (reference)", "3 rapid X10 Y0 Z0 C30 (reference)",
                   "4 rapid X100 Y0 Z0 C30 (reference)", "4 rapid X0 Y0 Z0 C30 (reference)"}));
  // P is a number, however it is written.
  EXPECT_EQ(machine("G30 P2.0 X0\n", keys), machine("G30 P2 X0\n", keys));
  EXPECT_EQ(machine("G30 P02. X0\n", keys), machine("G30 P2 X0\n", keys));
  for (const char* block : {"G30 P1 X0", "G30 P5 X0", "G30 P2.5 X0"})
    EXPECT_EQ(moves(std::string(block) + "\n").back(), "1 PS0046");
}

TEST(ModelProgram, ReturnFromReference) {
  EXPECT_EQ(moves("X1\nG28 X5 Y6\nG01 G29 X20\nG91 G29 X1 Y1\nG29 Z3\n"),
            (Lines{"1 rapid X1 Y0 Z0 C0", "2 rapid X5 Y6 Z0 C0 (reference)", "2 rapid X0 Y0 Z0 C0 (reference)",
                   "3 rapid X5 Y0 Z0 C0", "3 rapid X20 Y0 Z0 C0", "4 rapid X5 Y6 Z0 C0", "4 rapid X6 Y7 Z0 C0",
                   "5 rapid X6 Y7 Z0 C0", "5 rapid X6 Y7 Z3 C0"}));
}

// The worked examples of 14.8.
TEST(ModelProgram, OffsetMemory) {
  const std::string c = "[offsets]\nmemory = \"C\"\n[offsets.H]\n5 = { geometry = \"100.5\", wear = \"-0.25\" }\n";
  EXPECT_EQ(moves("G43 Z0 H5\nG91 G10 L11 P5 R0.05\nG43 H5\n", c),
            (Lines{"1 rapid X0 Y0 Z100.25 C0", "2 H5.wear=-0.2", "3 rapid X0 Y0 Z100.3 C0"}));
  EXPECT_EQ(moves("G10 L10 P5 R1\nG10 L12 P5 R2\nG10 L13 P5 R3\nG10 L1 P5 R4\nG43 H5\n", c),
            (Lines{"1 H5.geometry=1", "2 D5.geometry=2", "3 D5.wear=3", "4 H5.wear=4", "5 rapid X0 Y0 Z5 C0"}));
  EXPECT_EQ(moves("G10 L11 P5 R100\n", c), (Lines{"1 PS0032"}));
  // Memory A: one value for H and D.
  EXPECT_EQ(moves("G10 L11 P3 R12\nG43 Z0 H3\nG49\nG41.3 D3\nX100\n"),
            (Lines{"1 H3=12", "2 rapid X0 Y0 Z12 C0", "3 rapid X0 Y0 Z0 C0", "4 rapid X-12 Y0 Z0 C0 (start-up)",
                   "5 rapid X88 Y0 Z0 C0"}));
  EXPECT_EQ(moves("G10 L11 P1000 R1\n", "[offsets]\ncount = 999\n"), (Lines{"1 PS0031"}));
}

TEST(ModelProgram, OffsetMemoryRanges) {
  // Geometry and wear, as far as they go and one digit farther, and in G91 by their sum.
  EXPECT_EQ(moves("G10 L11 P1 R-999.999\nG91 G10 L11 P1 R-0.001\n"), (Lines{"1 H1=-999.999", "2 PS0032"}));
  EXPECT_EQ(moves("G10 L11 P1 R999.99\nG10 L11 P1 R1000\n", "increment = \"IS-A\"\n"),
            (Lines{"1 H1=999.99", "2 PS0032"}));
  EXPECT_EQ(moves("G10 L11 P1 R999.9999\nG10 L11 P1 R1000\n", "increment = \"IS-C\"\n"),
            (Lines{"1 H1=999.9999", "2 PS0032"}));
  EXPECT_EQ(moves("G10 L11 P1 R99.9999\nG10 L11 P1 R100\n", "units = \"inch\"\n"), (Lines{"1 H1=99.9999", "2 PS0032"}));
  const std::string b = "[offsets]\nmemory = \"B\"\n";
  EXPECT_EQ(moves("G10 L11 P1 R99.999\nG10 L11 P1 R100\n", b), (Lines{"1 H1.wear=99.999", "2 PS0032"}));
  EXPECT_EQ(moves("G10 L10 P1 R999.999\nG10 L11 P1 R0.001\nG43 H1\n", b),
            (Lines{"1 H1.geometry=999.999", "2 H1.wear=0.001", "3 PS0029"}));
}

TEST(ModelProgram, WritesThatCannotBe) {
  for (const char* block : {"G10 P1 R1", "G10 L4 P1 R1", "G10 L10 P1 R1", "G10 L12 P1 R1"})
    EXPECT_EQ(moves(std::string(block) + "\n"), (Lines{"1 PS0010"})) << block;
  for (const char* block : {"G10 L11 R1", "G10 L11 P0 R1", "G10 L11 P401 R1", "G10 L11 P1.5 R1", "G10 L11 P-1 R1"})
    EXPECT_EQ(moves(std::string(block) + "\n"), (Lines{"1 PS0031"})) << block;
  EXPECT_EQ(moves("G10 L11 P1\nX1\n"), (Lines{"2 rapid X1 Y0 Z0 C0"}));
}

// A number in one table counts for H and D; where both tables have it each reads its own; memory C never shares.
TEST(ModelProgram, SharedNumbers) {
  const std::string program = "G43 Z0 H1\nG49\nG41.3 D1\nX100\n";
  const std::string both = "[offsets.H]\n1 = 10\n[offsets.D]\n1 = 20\n";
  EXPECT_EQ(moves(program, "[offsets.D]\n1 = 20\n"),
            (Lines{"1 rapid X0 Y0 Z20 C0", "2 rapid X0 Y0 Z0 C0", "3 rapid X-20 Y0 Z0 C0 (start-up)",
                   "4 rapid X80 Y0 Z0 C0"}));
  EXPECT_EQ(moves(program, both), (Lines{"1 rapid X0 Y0 Z10 C0", "2 rapid X0 Y0 Z0 C0",
                                         "3 rapid X-20 Y0 Z0 C0 (start-up)", "4 rapid X80 Y0 Z0 C0"}));
  EXPECT_EQ(moves(program, "[offsets]\nmemory = \"C\"\n[offsets.H]\n1 = 10\n"),
            (Lines{"1 rapid X0 Y0 Z10 C0", "2 rapid X0 Y0 Z0 C0", "3 rapid X0 Y0 Z0 C0 (start-up)",
                   "4 rapid X100 Y0 Z0 C0"}));
}

TEST(ModelProgram, LastOfAGroupAndOfAnAddressCounts) {
  EXPECT_EQ(moves("G00 G01 X1 X2\nG90 G91 X1\nG28 G04 X1\n"), (Lines{"1 linear X2 Y0 Z0 C0", "2 linear X3 Y0 Z0 C0"}));
}

TEST(ModelProgram, DwellWordsAreNoPositions) {
  EXPECT_EQ(moves("G04 X2.5\nG04 P100\nX1\n"), (Lines{"3 rapid X1 Y0 Z0 C0"}));
  // I J K of a dwell ask for no three-dimensional compensation.
  EXPECT_EQ(moves("G41 G04 I1 J2 K3\nX1\n"), (Lines{"2 rapid X1 Y0 Z0 C0"}));
}

TEST(ModelProgram, UnknownCodes) {
  for (const char* code : {"G06", "G43.6", "G30.2", "G43.51", "G999999999"})
    EXPECT_EQ(moves(std::string("X1\n") + code + " X2\n"), (Lines{"1 rapid X1 Y0 Z0 C0", "2 PS0010"})) << code;
  for (const char* code : {"G38", "G41.4", "G54.2", "G68"})
    EXPECT_EQ(moves(std::string("X1\n") + code + " X2\n"), (Lines{"1 rapid X1 Y0 Z0 C0", "2 " + std::string(code)}))
        << code;
  EXPECT_EQ(moves("G1.0 X1\nG030.10 X0\n").size(), 3U);  // the value counts, not the spelling
}

// The block at fault makes nothing: no move, no write; the run is over.
TEST(ModelProgram, AnAlarmEndsTheRun) {
  EXPECT_EQ(moves("X1\nX2 Y1.2.3\nX3\n"), (Lines{"1 rapid X1 Y0 Z0 C0", "2 PS0007"}));
  EXPECT_EQ(moves("G10 L11 P1 R1 H401\nX1\n"), (Lines{"1 PS0030"}));
  const auto done = run(setup(), "N7 X1 ?\n");
  EXPECT_EQ(done.events().at(0).n, 7U);
}

TEST(ModelProgram, OrderOfAlarms) {
  EXPECT_EQ(moves("G77.7 H401\n"), (Lines{"1 PS0010"}));
  EXPECT_EQ(moves("H401 G68\n"), (Lines{"1 G68"}));
  EXPECT_EQ(moves("G43.5 G28 X0 H401\n"), (Lines{"1 PS0030"}));
  EXPECT_EQ(moves("G43.5 G28 X0 Q1\n"), (Lines{"1 FORBIDDEN_UNDER_TOOL_DIRECTION"}));
  EXPECT_EQ(moves("G43 H1\nG43.5 Q1\n", "[offsets.H]\n1 = 1\n").back(), "2 LENGTH_OFFSET_EXCLUSION");
  EXPECT_EQ(moves("G41.3 D1 X5 G54\n"), (Lines{"1 PS5406"}));
  EXPECT_EQ(moves("G41.3 D1\nX5\nG10 L11 P0 R1\n").back(), "3 FORBIDDEN_IN_3D_COMPENSATION");
  EXPECT_EQ(moves("G02 G43 X5 H1\n", "[offsets.H]\n1 = 1000\n"), (Lines{"1 PS0022"}));
}

TEST(ModelProgram, EndOfProgram) {
  EXPECT_EQ(moves("X1 M30\nX2\n"), (Lines{"1 rapid X1 Y0 Z0 C0"}));
  EXPECT_EQ(moves("M02\nX2\n"), Lines{});
  EXPECT_EQ(moves("M00\nM01\nX2\n"), (Lines{"3 rapid X2 Y0 Z0 C0"}));
}

TEST(ModelProgram, SetupsOfOtherControls) {
  spec::Setup other;
  other.control = spec::Control::heidenhain;
  model::Recorder recorder;
  test::Collector sink;
  EXPECT_THROW(model::Engine(other, recorder, sink), spec::InputError);
}

// A machine may lack axes of the space.
TEST(ModelProgram, FewerAxes) {
  const std::string lathe = "control = \"fanuc\"\naxes = [\"X\", \"Z\"]\n[offsets.H]\n1 = 3\n";
  EXPECT_EQ(test::lines(run(lathe, "G18 G43 X1 H1\nG02 X3 Z0 R1\n")), (Lines{"1 rapid X1 Z3", "2 arc X3 Z3"}));
  EXPECT_EQ(test::lines(run(lathe, "G17 G03 X2 I1\n")), (Lines{"1 arc X2 Z0"}));
}

}  // namespace
