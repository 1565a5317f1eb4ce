// SPDX-License-Identifier: Apache-2.0
// Tool offset G45 to G48 in the exact engine, by hand. The worked examples of 14.3 stand in
// golden/fanuc/corpus_examples_chapter_14.cpp.
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

// G90 does not move, whatever the sign written before the zero.
TEST(ModelToolOffset, NoTravelUnderG90) {
  EXPECT_EQ(points(plane("1 = 12.34\n"), "G90 G45 X0 D1\n"), (Lines{"1 rapid X0 Y0"}));
}

// An additional linear axis takes the offset too; a rotary one goes as programmed.
TEST(ModelToolOffset, EveryLinearAxisTakesTheOffset) {
  EXPECT_EQ(lines(run(std::string(kSpace) + "[offsets.D]\n1 = 3\n", "G91 G45 W10 B10 D1\n")),
            (Lines{"1 rapid X0 Y0 Z0 W13 B10"}));
}

TEST(ModelToolOffset, ShiftStaysInG90UntilTheOppositeCode) {
  const std::string setup = plane("1 = 10\n") + "[position]\nX = 100\n";
  // G49, D0, G40, another workpiece system and G92 leave it.
  EXPECT_EQ(ends(setup + "[workpiece.G55]\nX = 1\n", "G45 X150 D1\nG49 G40 D0\nG55\nX200\nG92 X0\nX1\n"),
            (Lines{"X160 Y0", "X210 Y0", "X11 Y0"}));
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
