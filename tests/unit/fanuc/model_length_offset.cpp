// SPDX-License-Identifier: Apache-2.0
// Rules of the tool length offset that the worked examples do not show. Expected values are derived in the comments.
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;
using test::Lines;
using test::lines;
using test::run;

// H1 = 10, H2 = 20, H3 = 30, H4 = -5.
std::string setup(const std::string& parameters = "", const std::string& more = "") {
  return "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"W\", \"B\"]\n[parameters]\n" + parameters +
         "[offsets.H]\n1 = 10\n2 = 20\n3 = 30\n4 = -5\n" + more;
}
constexpr const char* kTypeB = "\"5001#1\" = 1\n";
constexpr const char* kTypeC = "\"5001#0\" = 1\n";
constexpr const char* kOfh = "\"5001#2\" = 1\n";
constexpr const char* kTal = "\"5001#3\" = 1\n";
constexpr const char* kEvo = "\"5001#6\" = 1\n";

Lines moves(const std::string& parameters, const std::string& program) {
  return lines(run(setup(parameters), program));
}

TEST(ModelLengthOffset, SubtractsUnderG44WithTheSignOfTheValue) {
  EXPECT_EQ(moves("", "G44 Z0 H1\nZ0 H4\n"), (Lines{"1 rapid X0 Y0 Z-10 W0 B0", "2 rapid X0 Y0 Z5 W0 B0"}));
}

TEST(ModelLengthOffset, TypeBOffsetsTheAxisNormalToThePlane) {
  EXPECT_EQ(moves(kTypeB, "G17 G43 Z0 H1\nG49\nG18 G43 Y0 H1\nG49\nG19 G43 X0 H1\n"),
            (Lines{"1 rapid X0 Y0 Z10 W0 B0", "2 rapid X0 Y0 Z0 W0 B0", "3 rapid X0 Y10 Z0 W0 B0",
                   "4 rapid X0 Y0 Z0 W0 B0", "5 rapid X10 Y0 Z0 W0 B0"}));
}

// H0 cancels the axis normal to the plane, G49 all; three axes cannot be cancelled by G49 (PS0015).
TEST(ModelLengthOffset, CancelsByNumberAndByCode) {
  EXPECT_EQ(moves(kTypeB, "G19 G43 H1\nG18 G43 H2\nH0\nG18 G43 H2\nG49\n"),
            (Lines{"1 rapid X10 Y0 Z0 W0 B0", "2 rapid X10 Y20 Z0 W0 B0", "3 rapid X10 Y0 Z0 W0 B0",
                   "4 rapid X10 Y20 Z0 W0 B0", "5 rapid X0 Y0 Z0 W0 B0"}));
  EXPECT_EQ(moves(kTypeB, "G19 G43 H1\nG18 G43 H2\nG17 G43 H3\nG49\n"),
            (Lines{"1 rapid X10 Y0 Z0 W0 B0", "2 rapid X10 Y20 Z0 W0 B0", "3 rapid X10 Y20 Z30 W0 B0", "4 PS0015"}));
  // H0 on one of them, then two are left.
  EXPECT_EQ(moves(kTypeB, "G19 G43 H1\nG18 G43 H2\nG17 G43 H3\nH0\nG49\n").back(), "5 rapid X0 Y0 Z0 W0 B0");
}

TEST(ModelLengthOffset, TypeCNeedsAnAxis) {
  EXPECT_EQ(moves(kTypeC, "G43 H1\n"), (Lines{"1 PS0027"}));
  EXPECT_EQ(moves(kTypeC, "G43 B10. H1\n"), (Lines{"1 PS0027"}));      // a rotary axis is none
  EXPECT_EQ(moves(kTypeC, "G04 G43 X1.0 H1\n"), (Lines{"1 PS0027"}));  // X is the dwell time
  EXPECT_EQ(moves(kTypeC, "G43 W5 B10. H1\n"), (Lines{"1 rapid X0 Y0 Z0 W15 B10"}));
}

TEST(ModelLengthOffset, TypeCOnSeveralAxes) {
  EXPECT_EQ(moves(kTypeC, "G43 X1 Y2 H1\n"), (Lines{"1 PS0027"}));
  // Both are then the axes offset last.
  EXPECT_EQ(moves(std::string(kTypeC) + kTal, "G43 X1 Y2 H1\nH2\n"),
            (Lines{"1 rapid X11 Y12 Z0 W0 B0", "2 rapid X21 Y22 Z0 W0 B0"}));
  // The same axis again is no second axis; after H0 another one is free.
  EXPECT_EQ(moves(kTypeC, "G43 X1 H1\nG44 X1 H1\nH0\nG43 Y1 H1\n"),
            (Lines{"1 rapid X11 Y0 Z0 W0 B0", "2 rapid X-9 Y0 Z0 W0 B0", "3 rapid X1 Y0 Z0 W0 B0",
                   "4 rapid X1 Y11 Z0 W0 B0"}));
}

TEST(ModelLengthOffset, OfhFirstCodeWithoutNumberTakesZeroAndALaterOneKeepsItsNumber) {
  EXPECT_EQ(moves(kOfh, "G43 Z5\nG43 Z5 H1\nG44 Z5\nG49\nG43 Z5\n"),
            (Lines{"1 rapid X0 Y0 Z5 W0 B0", "2 rapid X0 Y0 Z15 W0 B0", "3 rapid X0 Y0 Z-5 W0 B0",
                   "4 rapid X0 Y0 Z5 W0 B0", "5 rapid X0 Y0 Z5 W0 B0"}));
}

TEST(ModelLengthOffset, NumberSurvivesItsCancel) {
  EXPECT_EQ(moves("", "G43 Z0 H1\nG49\nH2\nG43 Z0\n"),
            (Lines{"1 rapid X0 Y0 Z10 W0 B0", "2 rapid X0 Y0 Z0 W0 B0", "4 rapid X0 Y0 Z20 W0 B0"}));
}

TEST(ModelLengthOffset, LoneCodesMoveOnlyWhereTheOffsetChanges) {
  EXPECT_EQ(moves("", "G43\nG43 H1\nH1\nG43\nG49\nG49\nH2\n"),
            (Lines{"2 rapid X0 Y0 Z10 W0 B0", "5 rapid X0 Y0 Z0 W0 B0"}));
  // Under G02 such a move is straight.
  EXPECT_EQ(moves("", "G02 G43 H1\n"), (Lines{"1 linear X0 Y0 Z10 W0 B0"}));
}

TEST(ModelLengthOffset, Numbers) {
  EXPECT_EQ(moves("", "H400\nH401\n"), (Lines{"2 PS0030"}));
  EXPECT_EQ(moves("", "X1 D401\n"), (Lines{"1 PS0030"}));
  EXPECT_EQ(lines(run(setup("", "5 = 1000\n"), "H5\nG43 H5\n")), (Lines{"2 PS0029"}));
  EXPECT_EQ(lines(run(setup("", "5 = \"999.999\"\n"), "G43 H5\n")), (Lines{"1 rapid X0 Y0 Z999.999 W0 B0"}));
}

// An edited value: with EVO = 0 at the next H, G43 or G44, with EVO = 1 in the next block, on the axes offset last.
TEST(ModelLengthOffset, EditedValue) {
  const std::string program = "G43 H1\nG10 L11 P1 R11\nM05\nX1\nH1\n";
  EXPECT_EQ(moves("", program),
            (Lines{"1 rapid X0 Y0 Z10 W0 B0", "2 H1=11", "4 rapid X1 Y0 Z10 W0 B0", "5 rapid X1 Y0 Z11 W0 B0"}));
  EXPECT_EQ(moves(kEvo, program),
            (Lines{"1 rapid X0 Y0 Z10 W0 B0", "2 H1=11", "3 rapid X0 Y0 Z11 W0 B0", "4 rapid X1 Y0 Z11 W0 B0"}));
  // An edited value of an axis that keeps its vector does not wait for a block without G40.
  EXPECT_EQ(moves(kEvo, "G43 H1\nG10 L11 P1 R11\nG40\n"),
            (Lines{"1 rapid X0 Y0 Z10 W0 B0", "2 H1=11", "3 rapid X0 Y0 Z11 W0 B0"}));
  // Type C waits for H.
  EXPECT_EQ(moves(std::string(kTypeC) + kEvo, "G43 Z0 H1\nG10 L11 P1 R11\nX1\nH1\n"),
            (Lines{"1 rapid X0 Y0 Z10 W0 B0", "2 H1=11", "3 rapid X1 Y0 Z10 W0 B0", "4 rapid X1 Y0 Z11 W0 B0"}));
  // Y was offset before Z: only Z follows the edit.
  EXPECT_EQ(moves(std::string(kTypeB) + kEvo, "G18 G43 H1\nG17 G43 H1\nG10 L11 P1 R11\nM05\n").back(),
            "4 rapid X0 Y10 Z11 W0 B0");
}

// The G10 block itself still has the value from before.
TEST(ModelLengthOffset, NumberInTheWritingBlock) {
  EXPECT_EQ(moves("", "G43 H2\nG10 L11 P1 R11 H1\nH1\n"),
            (Lines{"1 rapid X0 Y0 Z20 W0 B0", "2 rapid X0 Y0 Z10 W0 B0", "2 H1=11", "3 rapid X0 Y0 Z11 W0 B0"}));
}

TEST(ModelLengthOffset, CancelWithMachinePosition) {
  // Types A, B: G49 G53 clears every axis in that move; the mode is G49, so nothing comes back.
  EXPECT_EQ(moves(std::string(kTypeB) + kEvo, "G18 G43 H1\nG17 G43 H2\nG49 G53 X7\nX8\nH2\n"),
            (Lines{"1 rapid X0 Y10 Z0 W0 B0", "2 rapid X0 Y10 Z20 W0 B0", "3 rapid X7 Y0 Z0 W0 B0",
                   "4 rapid X8 Y0 Z0 W0 B0"}));
}

// In G91 the G53 block is ignored with its words: nothing moves, nothing is cancelled.
TEST(ModelLengthOffset, IncrementalMachinePositionIsIgnored) {
  EXPECT_EQ(moves("", "G43 H1\nG91 G53 Z-10\nG90 X1\n"), (Lines{"1 rapid X0 Y0 Z10 W0 B0", "3 rapid X1 Y0 Z10 W0 B0"}));
}

// Restores first (to intermediate 80 + 20), then takes away what it names.
TEST(ModelLengthOffset, ReferenceReturnRightAfterAMachinePosition) {
  EXPECT_EQ(moves(kEvo, "G43 Z0 H2\nG53 Z-10\nG28 Z80\n"),
            (Lines{"1 rapid X0 Y0 Z20 W0 B0", "2 rapid X0 Y0 Z-10 W0 B0", "3 rapid X0 Y0 Z100 W0 B0 (reference)",
                   "3 rapid X0 Y0 Z0 W0 B0 (reference)"}));
}

// In a block with G40 a number is only stored; it comes into force in the next block that may restore.
TEST(ModelLengthOffset, NumberBesideACutterCode) {
  EXPECT_EQ(moves(kEvo, "G43 Z0 H1\nG53 Z0\nG40 H2\nX1\n"),
            (Lines{"1 rapid X0 Y0 Z10 W0 B0", "2 rapid X0 Y0 Z0 W0 B0", "4 rapid X1 Y0 Z20 W0 B0"}));
  EXPECT_EQ(moves("", "G43 Z0 H1\nG53 Z0\nG40 G44 H2\nX1\nH2\n"),
            (Lines{"1 rapid X0 Y0 Z10 W0 B0", "2 rapid X0 Y0 Z0 W0 B0", "4 rapid X1 Y0 Z0 W0 B0",
                   "5 rapid X1 Y0 Z-20 W0 B0"}));
  // Without a vector taken away G40 has nothing to do with it.
  EXPECT_EQ(moves("", "G43 Z0 H1\nG40 H2\n"), (Lines{"1 rapid X0 Y0 Z10 W0 B0", "2 rapid X0 Y0 Z20 W0 B0"}));
}

// Type C: back with H on the axis offset last.
TEST(ModelLengthOffset, TypeCComesBackWithItsNumber) {
  EXPECT_EQ(moves(std::string(kTypeC) + kEvo, "G43 X0 H1\nG30.1 X5\nX5\nH1\n"),
            (Lines{"1 rapid X10 Y0 Z0 W0 B0", "2 rapid X15 Y0 Z0 W0 B0 (reference)",
                   "2 rapid X0 Y0 Z0 W0 B0 (reference)", "3 rapid X5 Y0 Z0 W0 B0", "4 rapid X15 Y0 Z0 W0 B0"}));
}

// H after the vector was taken away acts by the plane of its block, and nothing else comes back with it, whatever EVO
// is: the axis offset last is then another one.
TEST(ModelLengthOffset, NumberAfterwardsGoesByThePlane) {
  for (const char* parameters : {"\"5001#1\" = 1\n", "\"5001#1\" = 1\n\"5001#6\" = 1\n"})
    EXPECT_EQ(moves(parameters, "G17 G43 Z0 H1\nG53 Z0\nG19 H2\nY1\n"),
              (Lines{"1 rapid X0 Y0 Z10 W0 B0", "2 rapid X0 Y0 Z0 W0 B0", "3 rapid X20 Y0 Z0 W0 B0",
                     "4 rapid X20 Y1 Z0 W0 B0"}));
}

// Type C on X and Z, of which G53 takes Z away: the number of a G40 block is stored for both, X keeps its vector. The
// same where the offset taken away is 0 just now.
TEST(ModelLengthOffset, StoredMeansStoredForEveryAxis) {
  const std::string type_c = "\"5001#0\" = 1\n\"5001#3\" = 1\n";
  EXPECT_EQ(moves(type_c, "G43 X0 Z0 H1\nG53 Z0\nG40 H2 Y0\nH2\n"),
            (Lines{"1 rapid X10 Y0 Z10 W0 B0", "2 rapid X10 Y0 Z0 W0 B0", "3 rapid X10 Y0 Z0 W0 B0",
                   "4 rapid X20 Y0 Z20 W0 B0"}));
  EXPECT_EQ(moves("", "G43 Z0\nG53 Z0\nG40 H1 Z0\n").back(), "3 rapid X0 Y0 Z0 W0 B0");
}

// Found by fuzzing. Y has lost its vector and X was offset last: the number, or the mode, that is stored for Y acts on
// X in the next block, and on Y with G43.
TEST(ModelLengthOffset, WhatIsStoredActsOnTheAxesOffsetLast) {
  const std::string start = "G18 G43 Y0 H1\nG19 H2\nG53 Y0\nG18\n";
  const auto stored = [&](const std::string& parameters, const std::string& rest) {
    Lines seen = moves(kTypeB + parameters, start + rest);
    EXPECT_EQ(seen[2], "3 rapid X20 Y0 Z0 W0 B0");
    return Lines(seen.begin() + 3, seen.end());
  };
  EXPECT_EQ(stored(kEvo, "G40 H3\nG91\nG43\n"), (Lines{"6 rapid X30 Y0 Z0 W0 B0", "7 rapid X30 Y30 Z0 W0 B0"}));
  EXPECT_EQ(stored(kEvo, "G40 G44\nG91\n"), (Lines{"6 rapid X-20 Y0 Z0 W0 B0"}));
  EXPECT_EQ(stored("", "G40 H3\nG91\nG43\n"), (Lines{"7 rapid X20 Y30 Z0 W0 B0"}));
}

// A program number is no block; G43.5 takes the place of G43, so nothing comes back with it.
TEST(ModelLengthOffset, BlocksThatRestoreNothing) {
  EXPECT_EQ(moves(kEvo, "G43 Z0 H1\nG53 Z0\nO7\nX1\n"),
            (Lines{"1 rapid X0 Y0 Z10 W0 B0", "2 rapid X0 Y0 Z0 W0 B0", "4 rapid X1 Y0 Z10 W0 B0"}));
  EXPECT_EQ(moves(kEvo, "G43 Z0 H1\nG53 Z0\nG43.5 H2\n").back(), "3 rapid X0 Y0 Z20 W0 B0");
}

// 1.5 inch + 10 mm = 48.1 mm; 20 mm + 0.5 inch = 100/127 + 1/2 inch: the offset is in the units of the setup.
TEST(ModelLengthOffset, Units) {
  EXPECT_EQ(moves("", "G20 G43 Z1.5 H1\n"), (Lines{"1 rapid X0 Y0 Z48.1 W0 B0"}));
  const std::string inch =
      "control = \"fanuc\"\nunits = \"inch\"\naxes = [\"X\", \"Y\", \"Z\"]\n[offsets.H]\n1 = \"0.5\"\n";
  EXPECT_EQ(lines(run(inch, "G21 G43 Z20. H1\n")), (Lines{"1 rapid X0 Y0 Z1.28740157480315"}));
}

}  // namespace
