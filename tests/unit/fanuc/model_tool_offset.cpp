// Tool offset G45 to G48. Expected values: the worked examples and tables of the fact sheet (14.3), and derivations by
// hand in the comments.
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;
using test::Lines;
using test::lines;
using test::run;
using test::Show;

constexpr const char* kPlane = "control = \"fanuc\"\naxes = [\"X\", \"Y\"]\n";
constexpr const char* kSpace = "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"W\", \"B\"]\n";
constexpr const char* kTph = "\"5001#5\" = 1\n";
constexpr const char* kOfh = "\"5001#2\" = 1\n";

// D1 and so on: the values of `d`.
std::string plane(const std::string& d, const std::string& parameters = "") {
  return std::string(kPlane) + "[parameters]\n" + parameters + "[offsets.D]\n" + d;
}

Lines points(const std::string& setup, const std::string& program) { return lines(run(setup, program), Show::point); }

// Where the tool ends, and nothing else: "X1 Y2".
Lines ends(const std::string& setup, const std::string& program) {
  Lines result;
  const test::Run made = run(setup, program);
  for (const model::Event& event : made.events())
    result.push_back(event.kind == spec::EventKind::move ? test::text(event.point, made.setup.axes, 15)
                                                         : std::string(event.number.view()));
  return result;
}

// Table 14.1: travel ±1000, offset ±10, G45 to G48.
TEST(ModelToolOffset, Table) {
  const std::string setup = plane("1 = 10\n2 = -10\n");
  const auto end = [&](const char* code, const char* x, const char* d) {
    return ends(setup, std::string("G91 ") + code + " " + x + " " + d + "\n").at(0);
  };
  const char* const expected[4][4] = {{"X1010 Y0", "X990 Y0", "X-1010 Y0", "X-990 Y0"},
                                      {"X990 Y0", "X1010 Y0", "X-990 Y0", "X-1010 Y0"},
                                      {"X1020 Y0", "X980 Y0", "X-1020 Y0", "X-980 Y0"},
                                      {"X980 Y0", "X1020 Y0", "X-980 Y0", "X-1020 Y0"}};
  const char* const codes[4] = {"G45", "G46", "G47", "G48"};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(end(codes[i], "X1000", "D1"), expected[i][0]);
    EXPECT_EQ(end(codes[i], "X1000", "D2"), expected[i][1]);
    EXPECT_EQ(end(codes[i], "X-1000", "D1"), expected[i][2]);
    EXPECT_EQ(end(codes[i], "X-1000", "D2"), expected[i][3]);
  }
}

// The sheet's table of zero travels, with G47 and G48 by the same rule; G90 does not move.
TEST(ModelToolOffset, ZeroTravelGoesByTheSignWrittenBeforeIt) {
  const std::string setup = plane("1 = 12.34\n");
  EXPECT_EQ(ends(setup, "G91 G45 X0 D1\n").at(0), "X12.34 Y0");
  EXPECT_EQ(ends(setup, "G91 G45 X-0 D1\n").at(0), "X-12.34 Y0");
  EXPECT_EQ(ends(setup, "G91 G46 X0 D1\n").at(0), "X-12.34 Y0");
  EXPECT_EQ(ends(setup, "G91 G46 X-0. D1\n").at(0), "X12.34 Y0");
  EXPECT_EQ(ends(setup, "G91 G47 X0 D1\n").at(0), "X24.68 Y0");
  EXPECT_EQ(ends(setup, "G91 G48 X0 D1\n").at(0), "X-24.68 Y0");
  EXPECT_EQ(points(setup, "G90 G45 X0 D1\n"), (Lines{"1 rapid X0 Y0"}));
}

TEST(ModelToolOffset, ReversesWhereTheOffsetIsLargerThanTheTravel) {
  EXPECT_EQ(ends(plane("1 = 3.7\n"), "G91 G46 X2.5 D1\n").at(0), "X-1.2 Y0");
  EXPECT_EQ(ends(plane("1 = 15\n"), "G91 G48 X20 D1\n").at(0), "X-10 Y0");
}

TEST(ModelToolOffset, EveryAxisTakesTheOffset) {
  EXPECT_EQ(points(plane("4 = 200\n"), "G91 G45 G01 X1000 Y500 D04\n"), (Lines{"1 linear X1200 Y700"}));
  EXPECT_EQ(points(plane("20 = 50\n"), "G91 G45 X220 Y60 D20\n"), (Lines{"1 rapid X270 Y110"}));
  EXPECT_EQ(points(plane("1 = 30\n"), "G91 G45 G1 X100 Y40 D1\n"), (Lines{"1 linear X130 Y70"}));
  // An additional linear axis too; a rotary one goes as programmed.
  EXPECT_EQ(lines(run(std::string(kSpace) + "[offsets.D]\n1 = 3\n", "G91 G45 W10 B10 D1\n")),
            (Lines{"1 rapid X0 Y0 Z0 W13 B10"}));
}

// The program of the manual, cutter of 20 mm.
TEST(ModelToolOffset, Manual) {
  const std::string program =
      "N1 G91 G46 G00 X80 Y50 D01\nN2 G47 G01 X50\nN3 Y40\nN4 G48 X40\nN5 Y-40\nN6 G45 X30\nN7 G45 G03 X30 Y30 J30\n"
      "N8 G45 G01 Y20\nN9 G46 X0\nN10 G46 G02 X-30 Y30 J30\nN11 G45 G01 Y0\nN12 G47 X-120\nN13 G47 Y-80\n"
      "N14 G46 G00 X-80 Y-50\n";
  const test::Run made = run(plane("1 = 10\n"), program);
  EXPECT_EQ(
      lines(made, Show::point),
      (Lines{"1 rapid X70 Y40", "2 linear X140 Y40", "3 linear X140 Y80", "4 linear X160 Y80", "5 linear X160 Y40",
             "6 linear X200 Y40", "7 arc X240 Y80", "8 linear X240 Y110", "9 linear X230 Y110", "10 arc X210 Y130",
             "11 linear X210 Y140", "12 linear X70 Y140", "13 linear X70 Y40", "14 rapid X0 Y0"}));
  Lines programmed;
  for (const model::Event& event : made.events())
    programmed.push_back(test::text(event.programmed, made.setup.axes, 15));
  EXPECT_EQ(programmed, (Lines{"X80 Y50", "X130 Y50", "X130 Y90", "X170 Y90", "X170 Y50", "X200 Y50", "X230 Y80",
                               "X230 Y100", "X230 Y100", "X200 Y130", "X200 Y130", "X80 Y130", "X80 Y50", "X0 Y0"}));
  // Centres start + J: (200, 40 + 40) and (230, 110 + 20); quarter circles.
  const auto& n7 = *made.events().at(6).arc;
  EXPECT_EQ(test::text(n7.center, made.setup.axes, 15), "X200 Y80");
  EXPECT_EQ(n7.sweep->decimal(15), "90");
  EXPECT_FALSE(n7.radius);
  const auto& n10 = *made.events().at(9).arc;
  EXPECT_EQ(test::text(n10.center, made.setup.axes, 15), "X230 Y130");
  EXPECT_EQ(n10.sweep->decimal(15), "90");
}

TEST(ModelToolOffset, ShiftStaysInG90UntilTheOppositeCode) {
  const std::string setup = plane("1 = 10\n") + "[position]\nX = 100\n";
  EXPECT_EQ(ends(setup, "G45 X150 D1\nX200\nG46 X250\nG46 X250\n"),
            (Lines{"X160 Y0", "X210 Y0", "X250 Y0", "X250 Y0"}));
  // G49, D0, G40, another workpiece system and G92 leave it.
  EXPECT_EQ(ends(setup + "[workpiece.G55]\nX = 1\n", "G45 X150 D1\nG49 G40 D0\nG55\nX200\nG92 X0\nX1\n"),
            (Lines{"X160 Y0", "X210 Y0", "X11 Y0"}));
}

TEST(ModelToolOffset, ThreeQuarterCircle) {
  const test::Run made = run(plane("1 = 10\n"), "G91 G45 G02 X30 Y-30 I30 D1\n");
  EXPECT_EQ(lines(made, Show::point), (Lines{"1 arc X40 Y-40"}));
  EXPECT_EQ(test::text(made.events().at(0).arc->center, made.setup.axes, 15), "X40 Y0");
  EXPECT_EQ(made.events().at(0).arc->sweep->decimal(15), "270");
}

// A later arc keeps its radius: start (110, 0), end programmed (120, 20), centre start + (0, 20), all 10 further.
TEST(ModelToolOffset, LaterArcsAreShiftedWithTheirCentre) {
  const test::Run made = run(plane("1 = 10\n"), "G91 G45 X100 D1\nG03 X20 Y20 J20\n");
  EXPECT_EQ(lines(made, Show::point).at(1), "2 arc X130 Y20");
  EXPECT_EQ(test::text(made.events().at(1).arc->center, made.setup.axes, 15), "X110 Y20");
  EXPECT_FALSE(made.events().at(1).arc->radius);
}

TEST(ModelToolOffset, ArcsThatAreNoQuarters) {
  const std::string setup = plane("1 = 10\n2 = -30\n3 = -31\n");
  EXPECT_EQ(ends(setup, "G91 G45 G02 X60 Y0 I30 D1\n"), (Lines{"G45_ARC"}));      // a half circle
  EXPECT_EQ(ends(setup, "G91 G45 G02 X30 Y30 R30 D1\n"), (Lines{"G45_ARC"}));     // by R
  EXPECT_EQ(ends(setup, "G91 G45 G02 I30 D1\n"), (Lines{"G45_ARC"}));             // a full circle
  EXPECT_EQ(ends(setup, "G91 G45 G02 X30 Y29 I30 D1\n"), (Lines{"G45_ARC"}));     // a spiral
  EXPECT_EQ(ends(setup, "G91 G45 G02 X30 Y-30 J-30 D1\n"), (Lines{"X40 Y-40"}));  // the quarter by J
  EXPECT_EQ(ends(setup, "G91 G45 G02 X30 Y30 I30 J1 D1\n"), (Lines{"G45_ARC"}));
  // Radius 30: an offset of -30 leaves the start, -31 is too much.
  EXPECT_EQ(ends(setup, "G91 G45 G02 X30 Y-30 J-30 D2\n"), (Lines{"X0 Y0"}));
  EXPECT_FALSE(run(setup, "G91 G45 G02 X30 Y-30 J-30 D2\n").events().at(0).arc->sweep);
  EXPECT_EQ(ends(setup, "G91 G45 G02 X30 Y-30 J-30 D3\n"), (Lines{"PS0038"}));
}

TEST(ModelToolOffset, Numbers) {
  const std::string h = "[offsets.H]\n1 = 5\n[offsets.D]\n1 = 10\n2 = 20\n";
  const auto setup = [&](const std::string& p) { return std::string(kPlane) + "[parameters]\n" + p + h; };
  EXPECT_EQ(ends(setup(""), "H1 D2\nG45 X100\n"), (Lines{"X120 Y0"}));
  EXPECT_EQ(ends(setup(kTph), "H1 D2\nG45 X100\n"), (Lines{"X105 Y0"}));
  EXPECT_EQ(ends(setup(kTph), "G45 X100 H1\n"), (Lines{"X105 Y0"}));
  EXPECT_EQ(ends(setup(kTph), "G45 X100\n"), (Lines{"X100 Y0"}));
  // With OFH the last of D and H counts, whatever TPH says; of both in one block D.
  EXPECT_EQ(ends(setup(kOfh), "D2\nH1\nG45 X100\n"), (Lines{"X105 Y0"}));
  EXPECT_EQ(ends(setup(std::string(kOfh) + kTph), "H1 D2\nG45 X100\n"), (Lines{"X120 Y0"}));
  EXPECT_EQ(ends(setup(kTph), "G43\nG45 X100 H1\n"), (Lines{"G45_LENGTH_OFFSET"}));
  EXPECT_EQ(ends(setup(kTph), "G43\nG49 G45 X100 H1\n"), (Lines{"X105 Y0"}));
  EXPECT_EQ(ends(setup(""), "G45 D2\nG45 X100\n"), (Lines{"X120 Y0"}));  // without an axis word
}

// Machine and reference positions take the shift of the axes they name away.
TEST(ModelToolOffset, MachinePositions) {
  const std::string setup = plane("1 = 10\n") + "[reference.1]\nX = 7\n";
  EXPECT_EQ(ends(setup, "G45 X100 Y100 D1\nG53 X50\nX60 Y60\n"), (Lines{"X110 Y110", "X50 Y110", "X60 Y70"}));
  EXPECT_EQ(ends(setup, "G45 X100 Y100 D1\nG28 X50\nG29 X60\n"),
            (Lines{"X110 Y110", "X60 Y110", "X7 Y110", "X50 Y110", "X60 Y110"}));
}

TEST(ModelToolOffset, NotInCutterCompensation) {
  const std::string setup = plane("1 = 10\n");
  EXPECT_EQ(ends(setup, "G41 G45 X10 D1\n"), (Lines{"PS0042"}));
  EXPECT_EQ(ends(setup, "G41 D1\nG45\n"), (Lines{"PS0042"}));
}

}  // namespace
