// SPDX-License-Identifier: Apache-2.0
// What this project does not follow says its name; what changes nothing is read.
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "spec/language/heidenhain/klartext_reader.h"
#include "spec/language/heidenhain/unsupported.h"
#include "tests/support/usual_number.h"

namespace {

using namespace toolcomp::spec;
using klartext::Block;
using klartext::Reader;

// What is said of the last block of the text: "E_UNSUPPORTED@LINE:COLUMN message" of an alarm, "passed over: message",
// or "read".
std::string said(std::string_view text) {
  Setup setup;
  setup.control = Control::heidenhain;
  setup.axes = Axes("XYZABC");
  Reader reader(text_source(text), setup);
  Block block;
  while (reader.next(block)) {
  }
  const char* const name = klartext::not_supported(block);
  const std::string message = name == nullptr ? "" : name;
  if (!block.alarm) return name == nullptr ? "read" : "passed over: " + message;
  EXPECT_EQ(block.alarm->beyond, block.alarm->cause == toolcomp::spec::AlarmCause::not_supported);
  return toolcomp::test::usual_number(block.alarm->cause) + '@' + std::to_string(block.alarm->line) + ':' +
         std::to_string(block.alarm->column) + ' ' + message;
}

TEST(KlartextUnsupported, StatementsSayTheirName) {
  EXPECT_EQ(said("12 C X+1 Y+2 DR+\n"), "E_UNSUPPORTED@1:4 C (circle) is not supported");
  EXPECT_EQ(said("CC\n"), "E_UNSUPPORTED@1:1 CC (centre of a circle, pole) is not supported");
  EXPECT_EQ(said("RND R5 F20\n"), "E_UNSUPPORTED@1:1 RND (rounding) is not supported");
  EXPECT_EQ(said("chf 2\n"), "E_UNSUPPORTED@1:1 CHF (chamfer) is not supported");
  EXPECT_EQ(said("L X1\n  APPR LCT X+5 Y+5 R2 RL\n"),
            "E_UNSUPPORTED@2:3 APPR (approach of a contour) is not supported");
  EXPECT_EQ(said("LP PR+10 PA+30\n"), "E_UNSUPPORTED@1:1 LP (polar coordinates) is not supported");
  EXPECT_EQ(said("CYCL CALL M3\n"), "E_UNSUPPORTED@1:1 CYCL CALL (machining cycles) is not supported");
  EXPECT_EQ(said("PLANE RELATIV SPB45 TURN\n"), "E_UNSUPPORTED@1:1 PLANE RELATIV is not supported");
  EXPECT_EQ(said("FUNCTION MODE TURN\n"), "E_UNSUPPORTED@1:1 FUNCTION MODE other than MILL is not supported");
  EXPECT_EQ(said("TRANS MIRROR AXIS X\n"), "E_UNSUPPORTED@1:1 TRANS MIRROR is not supported");
  EXPECT_EQ(said("TRANS DATUM TABLE TABLINE2\n"), "E_UNSUPPORTED@1:13 TRANS DATUM TABLE is not supported");
  EXPECT_EQ(said("TCH PROBE 417\n"), "E_UNSUPPORTED@1:1 TCH PROBE (touch probe cycles) is not supported");
  EXPECT_EQ(said("PATTERN DEF POS1 (X+1 Y+2 Z+0)\n"), "E_UNSUPPORTED@1:1 PATTERN DEF is not supported");
  EXPECT_EQ(said("SEL PGM \"A.H\"\n"), "E_UNSUPPORTED@1:1 SEL PGM is not supported");
}

TEST(KlartextUnsupported, OtherWordsAreNoKlartext) {
  EXPECT_EQ(said("C+5 X1\n"), "E_SYNTAX@1:1 ");
  EXPECT_EQ(said("CIRCLE\n"), "E_SYNTAX@1:1 ");
  EXPECT_EQ(said("PLANE LEVEL\n"), "E_SYNTAX@1:7 ");
  EXPECT_EQ(said("FUNCTION X1\n"), "E_SYNTAX@1:10 ");
  EXPECT_EQ(said("FN 77: Q1 = 2\n"), "E_SYNTAX@1:4 ");
  EXPECT_EQ(said("Q8 = X\n"), "E_SYNTAX@1:6 ");
  EXPECT_EQ(said("G01 X+1\n"), "E_SYNTAX@1:1 ");
}

TEST(KlartextUnsupported, ArithmeticAndJumps) {
  EXPECT_EQ(said("FN 1: Q1 = +Q2 + +5\n"), "E_UNSUPPORTED@1:1 FN 1 (addition) is not supported");
  EXPECT_EQ(said("FN 4: Q4 = +4 DIV +Q2\n"), "E_UNSUPPORTED@1:1 FN 4 (division) is not supported");
  EXPECT_EQ(said("FN 1: Q1 = 2\n"), "E_SYNTAX@1:4 ") << "no sum";
  EXPECT_EQ(said("FN 9: IF +Q1 EQU +0 GOTO LBL 99\n"), "E_UNSUPPORTED@1:1 FN 9 (jump if equal) is not supported");
  EXPECT_EQ(said("Q1 = Q2 + 1\n"), "E_UNSUPPORTED@1:9 a formula of Q parameters is not supported");
  EXPECT_EQ(said("Q1 = SIN 30\n"), "E_UNSUPPORTED@1:6 a formula of Q parameters is not supported");
  EXPECT_EQ(said("Q1 = ( Q2 )\n"), "E_UNSUPPORTED@1:6 a formula of Q parameters is not supported");
  EXPECT_EQ(said("Q1 = - Q2\n"), "E_UNSUPPORTED@1:6 a formula of Q parameters is not supported");
  EXPECT_EQ(said("QS1 = \"A\"\n"), "E_UNSUPPORTED@1:1 QS (string parameters) is not supported");
  EXPECT_EQ(said("Q1 = -Q2 ; - 1\n"), "read");
}

TEST(KlartextUnsupported, MFunctions) {
  EXPECT_EQ(said("L X1 M140 MB50\n"), "E_UNSUPPORTED@1:6 M140 (retraction along the tool axis) is not supported");
  EXPECT_EQ(said("L X1 M3 M99\n"), "E_UNSUPPORTED@1:9 M99 (cycle call) is not supported");
  EXPECT_EQ(said("M89\n"), "E_UNSUPPORTED@1:1 M89 (cycle call) is not supported");
  EXPECT_EQ(said("M94 C\n"), "passed over: M94 (reduced display of rotary axes) is not supported");
  EXPECT_EQ(said("L X1 M97 M3\n"), "passed over: M97 (small contour steps) is not supported");
  EXPECT_EQ(said("M103 F20\n"), "passed over: M103 (feed factor for plunging) is not supported");
  EXPECT_EQ(said("M120 LA3\n"), "passed over: M120 (look-ahead of the radius compensation) is not supported");
  EXPECT_EQ(said("M97\nL X1\n"), "read") << "of the last block alone";
  for (const char* text : {"M3 M8", "M13", "M25", "M116", "M118 X1 Y1", "M126 M127", "M136", "M138 A C", "L X1 M91"})
    EXPECT_EQ(said(text), "read") << text;
}

TEST(KlartextUnsupported, CyclesThatActWhereTheyAreDefined) {
  EXPECT_EQ(said("CYCL DEF 8.0 MIRROR\n"), "read");
  EXPECT_EQ(said("CYCL DEF 8.1\n"), "read");
  EXPECT_EQ(said("CYCL DEF 8.1 X\n"), "E_UNSUPPORTED@1:14 CYCL DEF 8 (mirroring) is not supported");
  EXPECT_EQ(said("CYCL DEF 10.1 ROT+0.000 ; none\n"), "read");
  EXPECT_EQ(said("CYCL DEF 10.1 ROT-0.001\n"), "E_UNSUPPORTED@1:15 CYCL DEF 10 (rotation) is not supported");
  EXPECT_EQ(said("CYCL DEF 10.1 IROT+5\n"), "E_UNSUPPORTED@1:15 CYCL DEF 10 (rotation) is not supported");
  EXPECT_EQ(said("CYCL DEF 10.1 ROT+Q1\n"), "E_UNSUPPORTED@1:15 CYCL DEF 10 (rotation) is not supported");
  EXPECT_EQ(said("CYCL DEF 11.1 SCL 1.00\n"), "read");
  EXPECT_EQ(said("CYCL DEF 11.1 SCL 0.995\n"), "E_UNSUPPORTED@1:15 CYCL DEF 11 (scaling) is not supported");
  EXPECT_EQ(said("CYCL DEF 26.1 X1.1\n"), "E_UNSUPPORTED@1:15 CYCL DEF 26 (scaling by axis) is not supported");
  EXPECT_EQ(said("CYCL DEF 7.1 #5\n"), "E_UNSUPPORTED@1:14 CYCL DEF 7 with a datum table is not supported");
  EXPECT_EQ(said("CYCL DEF 220 PATTERN ~\n Q1=2\n"),
            "E_UNSUPPORTED@1:14 CYCL DEF 220 (pattern on a circle) is not supported");
  EXPECT_EQ(said("CYCL DEF 19.1 A+0 B+0 C+0 ABST50 ~ F100\n"), "read");
  EXPECT_EQ(said("CYCL DEF 19.1 A+0 B+45\n"), "passed over: CYCL DEF 19 (working plane) is not supported");
  EXPECT_EQ(said("CYCL DEF 200 DRILLING ~\n Q200=2 ;SET-UP ~\n Q201=-5\n"), "read");
  EXPECT_EQ(said("CYCL DEF 32.1 T0.01\n"), "read");
}

TEST(KlartextUnsupported, TheFirstPresetIsThatOfTheSetup) {
  EXPECT_EQ(said("CYCL DEF 247 DATUM ~\n Q339=+3 ;DATUM NUMBER\n"), "read");
  EXPECT_EQ(said("CYCL DEF 247 DATUM ~\n Q339=+3\nCYCL DEF 247 DATUM ~\n Q339=+3\n"), "read");
  EXPECT_EQ(said("CYCL DEF 247 DATUM ~\n Q339=+3\nCYCL DEF 247 DATUM ~\n Q339=+4\n"),
            "passed over: another preset than the first is not supported");
  EXPECT_EQ(said("PRESET SELECT #3\n"), "read");
  EXPECT_EQ(said("CYCL DEF 247 DATUM ~\n Q339=3\nPRESET SELECT #5\n"),
            "passed over: another preset than the first is not supported");
  EXPECT_EQ(said("PRESET SELECT\n"), "E_SYNTAX@1:14 ");
}

TEST(KlartextUnsupported, PlanesThatTurnSomething) {
  EXPECT_EQ(said("PLANE RESET TURN FMAX\n"), "read");
  EXPECT_EQ(said("PLANE SPATIAL SPA+0 SPB+0 SPC+0 MOVE ABST50 FMAX\n"), "read");
  EXPECT_EQ(said("L B+0 C+0\nPLANE RESET TURN\n"), "read");
  EXPECT_EQ(said("PLANE SPATIAL SPA+0 SPB+1 SPC+0 STAY\n"),
            "passed over: PLANE SPATIAL (tilted working plane) is not supported");
  EXPECT_EQ(said("PLANE SPATIAL SPA+0 SPB+Q1 SPC+0 STAY\n"),
            "passed over: PLANE SPATIAL (tilted working plane) is not supported");
  constexpr const char* kTurns = "passed over: PLANE with MOVE or TURN (positioning of rotary axes) is not supported";
  EXPECT_EQ(said("L B+10\nL B+0\nPLANE RESET TURN\n"), kTurns);
  EXPECT_EQ(said("L IC+0\nPLANE SPATIAL SPA+0 SPB+0 SPC+0 TURN\n"), kTurns);
  EXPECT_EQ(said("L B+10\nPLANE RESET STAY\n"), "read");
}

TEST(KlartextUnsupported, WhatHasNoEffectIsRead) {
  for (const char* text :
       {"BLK FORM CYLINDER Z R50 L100 DIST+5", "BLK FORM ROTATION Z DIM_R LBL 5", "BLK FORM FILE \"A.STL\"",
        "SEL TABLE \"A.D\"", "SEL PATTERN \"A.PNT\"", "SEL CONTOUR \"A\"", "FUNCTION MODE MILL",
        "FUNCTION MODE MILL \"KINEMATICS\"", "FUNCTION COUNT INC", "FUNCTION DCM OFF", "FUNCTION DWELL TIME1",
        "FUNCTION FEED DWELL RESET", "FUNCTION LIFTOFF RESET", "FUNCTION S-PULSE RESET", "TRANS DATUM RESET",
        "TRANS DATUM AXIS X+5", "STOP M6", "LBL 99"})
    EXPECT_EQ(said(text), "read") << text;
  EXPECT_EQ(said("TRANS DATUM AXIS B5\n"), "E_SYNTAX@1:18 ");
}

}  // namespace
