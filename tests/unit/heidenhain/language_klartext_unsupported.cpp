// SPDX-License-Identifier: Apache-2.0
// What this project does not follow says its name; what changes nothing is read.
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "spec/language/alarm.h"
#include "spec/language/heidenhain/klartext_reader.h"
#include "tests/support/usual_number.h"

namespace {

using namespace toolcomp::spec;
using klartext::Block;
using klartext::Reader;

// What is said of the last block of the text: "LINE:COLUMN message" of what is not supported or not judged,
// "NUMBER@LINE:COLUMN" of another alarm, or "read".
std::string said(std::string_view text) {
  Setup setup;
  setup.control = Control::heidenhain;
  setup.axes = Axes("XYZABC");
  Reader reader(text_source(text), setup);
  Block block;
  while (reader.next(block)) {
  }
  if (!block.alarm) return "read";
  const std::string place = std::to_string(block.alarm->line) + ':' + std::to_string(block.alarm->column);
  if (const char* const message = beyond(block)) return place + ' ' + message;
  return toolcomp::test::usual_number(block.alarm->cause) + '@' + place;
}

TEST(KlartextUnsupported, StatementsSayTheirName) {
  EXPECT_EQ(said("12 C X+1 Y+2 DR+\n"), "1:4 C (circle) is not supported");
  EXPECT_EQ(said("RND R5 F20\n"), "1:1 RND (rounding) is not supported");
  EXPECT_EQ(said("chf 2\n"), "1:1 CHF (chamfer) is not supported");
  EXPECT_EQ(said("L X1\n  APPR LCT X+5 Y+5 R2\n"), "2:3 APPR (approach of a contour) is not supported");
  EXPECT_EQ(said("LP PR+10 PA+30\n"), "1:1 LP (polar coordinates) is not supported");
  EXPECT_EQ(said("CYCL CALL M3\n"), "1:1 CYCL CALL (of a cycle other than a drilling cycle) is not supported");
  EXPECT_EQ(said("PLANE RELATIV SPB45 TURN\n"), "1:1 PLANE RELATIV (tilted working plane) is not judged");
  EXPECT_EQ(said("FUNCTION MODE TURN\n"), "1:1 FUNCTION MODE (other than MILL) is not supported");
  EXPECT_EQ(said("TRANS MIRROR AXIS X\n"), "1:1 TRANS MIRROR is not supported");
  EXPECT_EQ(said("TRANS DATUM TABLE TABLINE2\n"), "1:13 TRANS DATUM TABLE is not supported");
  EXPECT_EQ(said("TCH PROBE 417\n"), "1:1 TCH PROBE (touch probe cycles) is not supported");
  EXPECT_EQ(said("PATTERN DEF POS1 (X+1 Y+2 Z+0)\n"), "1:1 PATTERN DEF is not supported");
  EXPECT_EQ(said("SEL PGM \"A.H\"\n"), "1:1 SEL PGM is not supported");
}

TEST(KlartextUnsupported, OtherWordsAreNoKlartext) {
  EXPECT_EQ(said("C+5 X1\n"), "E_SYNTAX@1:1");
  EXPECT_EQ(said("CIRCLE\n"), "E_SYNTAX@1:1");
  EXPECT_EQ(said("PLANE LEVEL\n"), "E_SYNTAX@1:7");
  EXPECT_EQ(said("FUNCTION X1\n"), "E_SYNTAX@1:10");
  EXPECT_EQ(said("FN 77: Q1 = 2\n"), "E_SYNTAX@1:4");
  EXPECT_EQ(said("Q8 = X\n"), "E_SYNTAX@1:6");
  EXPECT_EQ(said("G01 X+1\n"), "E_SYNTAX@1:1");
}

TEST(KlartextUnsupported, ArithmeticAndJumps) {
  EXPECT_EQ(said("FN 9: IF +Q1 EQU +0 GOTO LBL 99\n"), "1:1 FN 9 (jump if equal) is not supported");
  EXPECT_EQ(said("FN9: IF +Q1 EQU +0 GOTO LBL 99\n"), "1:1 FN 9 (jump if equal) is not supported");
  EXPECT_EQ(said("FN 5: Q1 = SQRT 2\n"), "1:1 FN 5 (square root) is not supported");
  EXPECT_EQ(said("FN 1: Q1 = 2\n"), "E_SYNTAX@1:12") << "no sum";
  EXPECT_EQ(said("Q1 = SIN 30\n"), "1:6 SIN (in a formula) is not supported");
  EXPECT_EQ(said("Q1 = 2 * SQRT 2\n"), "1:10 SQRT (in a formula) is not supported");
  EXPECT_EQ(said("Q1 = 2 ^ 3\n"), "1:11 ^ (in a formula) is not supported");
  EXPECT_EQ(said("Q1 = 1 / 3\n"),
            "1:11 Q = (a formula whose value is not a decimal of at most 18 digits) is not supported");
  EXPECT_EQ(said("QS1 = \"A\"\n"), "1:1 QS (string parameters) is not supported");
  EXPECT_EQ(said("Q1 = -Q2 ; - 1\n"), "read");
  EXPECT_EQ(said("Q1 = ( 2 + 3\n"), "E_SYNTAX@1:6");
}

// What FN 18 reads nobody knows here: its parameter ends the run where a word takes it, not before.
TEST(KlartextUnsupported, SystemData) {
  EXPECT_EQ(said("FN 18: SYSREAD Q7 = ID270 NR1 IDX1\nL X1\n"), "read");
  EXPECT_EQ(said("FN18: SYSREAD Q7 = ID270 NR1\nL X+Q7\n"), "2:1 Q (set by FN 18) is not supported");
  EXPECT_EQ(said("FN 18: SYSREAD Q7 = ID270\nQ8 = Q7 + 1\n"), "2:6 Q (set by FN 18) is not supported");
  EXPECT_EQ(said("FN 18: SYSREAD Q7 = ID270\nQ8 = Q7\nL X1\n"), "read");
  EXPECT_EQ(said("FN 18: SYSREAD Q7 = ID270\nQ8 = Q7\nL X1 FQ8\n"), "3:1 Q (set by FN 18) is not supported");
  EXPECT_EQ(said("FN 18: SYSREAD Q7 = ID270\nQ7 = 5\nL X+Q7\n"), "read") << "it has a value again";
  EXPECT_EQ(said("FN 18: Q7\n"), "E_SYNTAX@1:8");
}

// Under RL or RR without TCPM, where lines are out of scope, arcs and approaches end as lines do.
TEST(KlartextUnsupported, ContoursBesideThePath) {
  for (const char* text :
       {"L X1 RL\nCR X+5 Y+5 R-10 DR+ F100 M3", "L X1 RR\nCT X+5 Y+5", "L X1 RL\nC X+5 IY+5 DR-",
        "APPR LCT X+5 Y+5 Z-3 R2 RL F100", "APPR LT X+5 Y+5 LEN10 RR", "APPR CT X+5 Y+5 CCA90 R+7 RL",
        "L X1 RL\nDEP LCT X+5 Y+5 R2 F100", "L X1 RL\nDEP LT LEN10 F100", "L X1 RR\nDEP LN LEN+5",
        "L X1 RL\nDEP CT CCA180 R+8 M9", "M128\nL X1 RL\nM129\nL R0\nL X2 RL\nDEP LT LEN10", "L X1 RL\nRND R5 F20",
        "L X1 RL\nCHF 2", "CC X+0 Y+0", "CC"})
    EXPECT_EQ(said(text), "read") << text;
  EXPECT_EQ(said("L X1 R0\nCR X+5 Y+5 R10 DR+\n"), "2:1 CR (circle by radius) is not supported");
  EXPECT_EQ(said("L X1 RL\nCR X+5 Y+5 R10 DR+ R0\n"), "2:1 CR (circle by radius) is not supported");
  EXPECT_EQ(said("M128\nL X1 RL\nCR X+5 Y+5 R10 DR+\n"), "3:1 CR (circle by radius) is not supported");
  EXPECT_EQ(said("L X1 RL\nCR R10 DR+\n"), "2:1 CR (circle by radius) is not supported");
  EXPECT_EQ(said("L X1 RL\nCR X+5 YO R10 DR+\n"), "E_SYNTAX@2:8");
  EXPECT_EQ(said("APPR PLT PR+5 PA+5 LEN10 RL\n"), "1:1 APPR (approach of a contour) is not supported");
  EXPECT_EQ(said("DEP LT LEN10\n"), "1:1 DEP (departure from a contour) is not supported");
  EXPECT_EQ(said("L X1 RL\nDEP PLCT PR+5 PA+5 R2\n"), "2:1 DEP (departure from a contour) is not supported");
  EXPECT_EQ(said("M128\nL X1 RL\nM129\nDEP LT LEN10\n"), "4:1 DEP (departure from a contour) is not supported");
  EXPECT_EQ(said("L X1 RL\nM128\nM129\nDEP LT LEN10\n"), "4:1 DEP (departure from a contour) is not supported");
  EXPECT_EQ(said("L X1 RL\nDEP LT X+5 LEN10\n"), "2:1 DEP (departure from a contour) is not supported");
}

TEST(KlartextUnsupported, MFunctions) {
  EXPECT_EQ(said("L X1 M140 MB50\n"),
            "1:6 M140 (retraction along the tool axis) in a block that moves is not supported");
  EXPECT_EQ(said("STOP M140 MB MAX\n"),
            "1:6 M140 (retraction along the tool axis) in a block that moves is not supported");
  for (const char* text :
       {"M140 MB MAX", "L M140 MB MAX", "L R0 FMAX M140 MB+50 M9", "M3 M140 MB 2.5 F500", "M140 MB+Q1", "L M140 MBMAX"})
    EXPECT_EQ(said(text), "read") << text;
  EXPECT_EQ(said("L M140\n"), "E_SYNTAX@1:7");
  EXPECT_EQ(said("L M140 MB\n"), "E_SYNTAX@1:8");
  EXPECT_EQ(said("L M140 MB MIN\n"), "E_SYNTAX@1:8");
  EXPECT_EQ(said("L X1 M3 M99\n"), "1:9 M99 (cycle call, of a cycle other than a drilling cycle) is not supported");
  EXPECT_EQ(said("M89\n"), "1:1 M89 (cycle call after every block) is not supported");
  const std::string cycle = "CYCL DEF 200 DRILLING Q200=2 Q201=-5\n";
  EXPECT_EQ(said(cycle + "L X1 M99\n"), "read");
  EXPECT_EQ(said(cycle + "CYCL CALL M3\n"), "read");
  EXPECT_EQ(said(cycle + "CYCL DEF 32.0 TOLERANCE\nM99\n"), "read") << "a cycle that nobody calls";
  EXPECT_EQ(said(cycle + "CYCL DEF 251 POCKET Q201=-5\nM99\n"),
            "3:1 M99 (cycle call, of a cycle other than a drilling cycle) is not supported");
  EXPECT_EQ(said(cycle + "L X1 RL M99\n"), "2:9 M99 (cycle call, under RL, RR or TCPM) is not supported");
  EXPECT_EQ(said("M128\n" + cycle + "CYCL CALL\n"), "3:1 CYCL CALL (under RL, RR or TCPM) is not supported");
  EXPECT_EQ(said("M128\n" + cycle + "L X1 M129 M99\n"), "3:11 M99 (cycle call, under RL, RR or TCPM) is not supported");
  EXPECT_EQ(said(cycle + "Q201 = 5\nCYCL CALL\n"), "3:1 CYCL CALL (with a depth above the surface) is not supported");
  EXPECT_EQ(said(cycle + "CYCL CALL PAT FMAX\n"), "2:11 CYCL CALL (POS, PAT) is not supported");
  EXPECT_EQ(said("CYCL DEF 240 CENTERING Q343=1 Q201=-5\nM99\n"),
            "2:1 M99 (cycle call, of cycle 240 by diameter) is not supported");
  EXPECT_EQ(said(cycle + "LN X1 Y1 Z1 NX0 NY0 NZ1 M99\n"),
            "2:25 M99 (cycle call, in a block other than L and M functions) is not supported");
  EXPECT_EQ(said("CYCL DEF 200 Q200=\n"), "E_SYNTAX@1:14");
  EXPECT_EQ(said("L X1 M144\n"), "1:6 M144 (compensation of the kinematics) is not judged");
  EXPECT_EQ(said("M114\n"), "1:1 M114 (compensation of the machine geometry) is not judged");
  EXPECT_EQ(said("M124 T0.1\n"), "1:1 M124 (suppression of points) is not judged");
  for (const char* text : {"M3 M8", "M13", "M25", "M116", "M118 X1 Y1", "M126 M127", "M136", "M138 A C", "L X1 M91",
                           "M103 F20", "L X1 M130"})
    EXPECT_EQ(said(text), "read") << text;
}

// Corners of RL and RR have a path here under TCPM alone.
TEST(KlartextUnsupported, MFunctionsOfCorners) {
  for (const char* text :
       {"L X1 RL M97", "M128\nL X1 M97", "M128\nL X1 RL\nTOOL CALL 1 Z\nL X2 M98", "M128\nL X1 RL\nM129\nL X2 M120 LA3",
        "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\nL X1 RL\n"
        "L X2 R0 M197"})
    EXPECT_EQ(said(text), "read") << text;
  EXPECT_EQ(said("M128\nL X1 RL M97\n"), "2:9 M97 (small contour steps) is not judged");
  EXPECT_EQ(said("FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\nL X1 RR\nL X2 M98\n"),
            "3:6 M98 (open contour corners) is not judged");
  EXPECT_EQ(said("M128\nL X1 RL\nL X2 M120 LA3\n"), "3:6 M120 (look-ahead of the radius compensation) is not judged");
}

// M94 takes whole turns from a rotary position: increments count from another value until it is named again.
TEST(KlartextUnsupported, WholeTurns) {
  for (const char* text : {"M94 C\nL C+10", "M94 C\nL C+10\nL IC+10", "M94\nL X1", "L IC+10\nM94 C"})
    EXPECT_EQ(said(text), "read") << text;
  EXPECT_EQ(said("M94 C\nL X1\nL IC+10\n"), "3:1 M94 (removal of whole turns of rotary axes) is not judged");
}

TEST(KlartextUnsupported, CyclesThatActWhereTheyAreDefined) {
  EXPECT_EQ(said("CYCL DEF 8.0 MIRROR\n"), "read");
  EXPECT_EQ(said("CYCL DEF 8.1\n"), "read");
  EXPECT_EQ(said("CYCL DEF 8.1 X\n"), "1:14 CYCL DEF 8 (mirroring) is not supported");
  EXPECT_EQ(said("CYCL DEF 10.1 ROT+0.000 ; none\n"), "read");
  EXPECT_EQ(said("CYCL DEF 10.1 ROT-0.001\n"), "1:15 CYCL DEF 10 (rotation) is not supported");
  EXPECT_EQ(said("CYCL DEF 10.1 IROT+5\n"), "1:15 CYCL DEF 10 (rotation) is not supported");
  EXPECT_EQ(said("CYCL DEF 10.1 ROT+Q1\n"), "1:15 CYCL DEF 10 (rotation) is not supported");
  EXPECT_EQ(said("CYCL DEF 11.1 SCL 1.00\n"), "read");
  EXPECT_EQ(said("CYCL DEF 11.1 SCL 0.995\n"), "1:15 CYCL DEF 11 (scaling) is not supported");
  EXPECT_EQ(said("CYCL DEF 26.1 X1.1\n"), "1:15 CYCL DEF 26 (scaling by axis) is not supported");
  EXPECT_EQ(said("CYCL DEF 7.1 #5\n"), "1:14 CYCL DEF 7 # (a datum table) is not supported");
  EXPECT_EQ(said("CYCL DEF 220 PATTERN ~\n Q1=2\n"), "1:14 CYCL DEF 220 (pattern on a circle) is not supported");
  EXPECT_EQ(said("CYCL DEF 19.1 A+0 B+0 C+0 ABST50 ~ F100\n"), "read");
  EXPECT_EQ(said("CYCL DEF 19.1 A+0 B+45\n"), "1:19 CYCL DEF 19 (tilted working plane) is not judged");
  EXPECT_EQ(said("CYCL DEF 200 DRILLING ~\n Q200=2 ;SET-UP ~\n Q201=-5\n"), "read");
  EXPECT_EQ(said("CYCL DEF 32.1 T0.01\n"), "read");
}

TEST(KlartextUnsupported, TheFirstPresetIsThatOfTheSetup) {
  EXPECT_EQ(said("CYCL DEF 247 DATUM ~\n Q339=+3 ;DATUM NUMBER\n"), "read");
  EXPECT_EQ(said("CYCL DEF 247 DATUM ~\n Q339=+3\nCYCL DEF 247 DATUM ~\n Q339=+3\n"), "read");
  EXPECT_EQ(said("CYCL DEF 247 DATUM ~\n Q339=+3\nCYCL DEF 247 DATUM ~\n Q339=+4\n"),
            "4:2 CYCL DEF 247 (a preset other than the first) is not judged");
  EXPECT_EQ(said("PRESET SELECT #3\n"), "read");
  EXPECT_EQ(said("CYCL DEF 247 DATUM ~\n Q339=3\nPRESET SELECT #5\n"),
            "3:15 PRESET SELECT (a preset other than the first) is not judged");
  EXPECT_EQ(said("PRESET SELECT\n"), "E_SYNTAX@1:14");
}

TEST(KlartextUnsupported, PlanesThatTurnSomething) {
  EXPECT_EQ(said("PLANE RESET TURN FMAX\n"), "read");
  EXPECT_EQ(said("PLANE SPATIAL SPA+0 SPB+0 SPC+0 MOVE ABST50 FMAX\n"), "read");
  EXPECT_EQ(said("L B+0 C+0\nPLANE RESET TURN\n"), "read");
  EXPECT_EQ(said("PLANE SPATIAL SPA+0 SPB+1 SPC+0 STAY\n"), "1:1 PLANE SPATIAL (tilted working plane) is not judged");
  EXPECT_EQ(said("PLANE SPATIAL SPA+0 SPB+Q1 SPC+0 STAY\n"), "1:1 PLANE SPATIAL (tilted working plane) is not judged");
  EXPECT_EQ(said("L B+10\nL B+0\nPLANE RESET TURN\n"), "3:1 PLANE RESET (with MOVE or TURN) is not judged");
  EXPECT_EQ(said("L IC+0\nPLANE SPATIAL SPA+0 SPB+0 SPC+0 TURN\n"),
            "2:1 PLANE SPATIAL (tilted working plane) is not judged");
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
  EXPECT_EQ(said("TRANS DATUM AXIS B5\n"), "E_SYNTAX@1:18");
}

}  // namespace
