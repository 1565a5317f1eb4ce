// SPDX-License-Identifier: Apache-2.0
// Tool center point control: one program for each rule that generated programs seldom meet, worked out by hand.
#include "corpus/examples/fanuc/machines.h"

namespace toolcomp::corpus {
namespace {

#define LENGTHS "[offsets.H]\n1 = 10\n2 = 20\n"
#define OFFSETS LENGTHS "[offsets.D]\n1 = 1\n"
#define WITHOUT(rest) "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n" rest
#define WORKPIECE "\"19696#5\" = 1\n"
// A table axis C only: the first axis is hypothetical.
#define ONE_AXIS                                                                                               \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"C\"]\n[parameters]\n19680 = 12\n19681 = 0\n19682 = 1\n" \
  "\"19696#0\" = 1\n19686 = 4\n19687 = 3\n19689 = 1\n"
#define MOVES "tip_control_cancel = \"moves\"\n"
#define TILTED_45 "19698 = 45\n"

constexpr Example kRules[] = {
    {"G43.4 without kinematics: PS5459 at line 1.", WITHOUT(LENGTHS), "G43.4 H1\n"},
    {"G43.5 without kinematics, length 10: from X to Z the tool follows the great circle, (1, 0, 1)/sqrt 2 in the "
     "middle. From Z to -Z it keeps its direction until the end of the block; there the control point is 10 below the "
     "tip.",
     WITHOUT(LENGTHS), "G90 G43.5 H1 I1 J0 K0\nG01 X10. I0 J0 K1 F100\nX20. I0 J0 K-1\n", "", 2},
    {"G43.5 without kinematics, Q 90: the upright tool leans into the travel and is then along X.", WITHOUT(LENGTHS),
     "G90 G43.5 H1 Q90\nG01 X10. F100\n"},
    {"A hypothetical axis, G43.5: PS5459 at line 1.", ONE_AXIS LENGTHS, "G43.5 H1\n"},
    {"A hypothetical axis, G43.4 with P1: C turns evenly, and the tip at X 10 ends at (0, -10).", ONE_AXIS LENGTHS,
     "G90 G43.4 H1 P1 X10.\nG01 C90. F100\n", "", 2},
    {"A head with a tool-side axis along the tool, G43.5: PS5459 at line 1.",
     MACHINE(BC, "19680 = 2\n19681 = 4\n19682 = 2\n19686 = 5\n19687 = 3\n", "", ""), "G43.5 H0\n"},

    {"G43 with a length of 10, then G43.4: LENGTH_OFFSET_EXCLUSION at line 2.", HC("", LENGTHS), "G43 H1\nG43.4 H1\n"},
    {"G44 under G43.4: LENGTH_OFFSET_EXCLUSION at line 2.", HC("", LENGTHS), "G43.4 H1\nG44 H1\n"},
    {"G43.5 again under G43.4 on a table turned by 90: the tip at (10, 0) on the table is at (0, -10) in the workpiece "
     "system. These are its new coordinates.",
     TAC("", LENGTHS), "G90 G43.4 H1 P0 X10.\nG01 C90. F100\nG43.5 H1 P1\nG01 Z5. I0 J1 K1\n"},
    {"G49: the control point at (10, 0, 0) becomes the programmed position, G91 X5 goes to 15.", HC("", LENGTHS),
     "G90 G43.4 H1 B90.\nG49\nG91 G01 X5. F100\n"},
    {"G49 on a turned table, length 10: the tip is at (10, 0, 0) on the table and at (0, -10, 0) in the workpiece "
     "system, the axes are at (0, -10, 10). G91 X5 goes to (5, -10, 10).",
     TAC("", LENGTHS), "G90 G43.4 H1 P0 X10.\nG01 C90. F100\nG49\nG91 X5.\n"},
    {"G49 with a shift of 2 in X from G47: the tip is at (12, 0, 0) on the table and at (0, -12, 0) in the workpiece "
     "system, the axes are at (0, -12, 10), or (-2, -12, 10) without the shift. G91 X5 goes to programmed (3, -12, "
     "10).",
     TAC("", OFFSETS), "G91 G47 X0 D1\nG90 G43.4 H1 P0 X10.\nG01 C90. F100\nG49\nG91 X5.\n"},
    {"G43.5 again with a shift of 2 in X from G47: the tip at (0, -12, 0) in the workpiece system has the programmed "
     "position (-2, -12, 0).",
     TAC("", OFFSETS), "G91 G47 X0 D1\nG90 G43.4 H1 P0 X10.\nG01 C90. F100\nG43.5 H1 P1\nG01 Z5. I0 J1 K1\n"},
    {"G28 under G43.4: FORBIDDEN_UNDER_TOOL_DIRECTION at line 2.", HC("", ""), "G43.4 H0\nG28 X0\n"},
    {"G43.4 under G02: TOOL_DIRECTION_FORMAT at line 1.", HC("", ""), "G02 G43.4 H0\n"},
    {"G49 in tool side compensation: TOOL_DIRECTION_FORMAT at line 3.", HC("", OFFSETS),
     "G90 G43.4 H1\nG01 G41.2 D1 X10. F100\nX20. G49\n"},

    {"WKP = 1 and G43.5: PS5459 at line 1.", HC(WORKPIECE, ""), "G43.5 H0\n"},
    {"WKP = 1, the table turns by 90 while the tip goes from (10, 0) to (0, 10) in the workpiece system, which is "
     "(-10, 0) on the table: the tip passes the centre of the table.",
     TAC(WORKPIECE, LENGTHS), "G90 G43.4 H1 P0 X10.\nG01 X0 Y10. C90. F100\n", "", 2},
    {"WKP = 1, only the table turns, by 90: the tip goes with it from (0, 10) to (10, 0). G91 Y5 is measured from "
     "there.",
     TAC(WORKPIECE, LENGTHS), "G90 G43.4 H1 P0 Y10.\nG01 C90. F100\nG91 Y5.\n", "", 2},
    {"WKP = 1 and tool side compensation on a table: COMPENSATION_IN_WORKPIECE_SYSTEM at line 2.",
     TAC(WORKPIECE, OFFSETS), "G90 G43.4 H1\nG01 G41.2 D1 X10. F100\nX20.\n"},
    {"WKP = 1 and tool side compensation on a head: as with WKP = 0, the tool moves along Y 1.", HC(WORKPIECE, OFFSETS),
     "G90 G43.4 H1\nG01 G41.2 D1 X10. F100\nX20.\nG40 X30.\n"},
    {"WKP = 1, an arc while A turns: PS5421 at line 2.", TAC(WORKPIECE, ""),
     "G90 G43.4 H0\nG03 X10. Y10. R10. A10. F100\n"},
    {"WKP = 1, an arc of XY while C turns: ARC_WITH_TABLE_TURNED at line 2.", TAC(WORKPIECE, ""),
     "G90 G43.4 H0\nG03 X10. Y10. R10. C10. F100\n"},
    {"WKP = 1, an arc while the table does not turn: its centre is (0, 10).", TAC(WORKPIECE, ""),
     "G90 G43.4 H0\nG03 X10. Y10. R10. F100\n"},
    {"WKP = 1, A 90 puts the C axis along Y. C has turned by 10 since G43.4, and now it is not normal to XY: PS5421 at "
     "line 4.",
     TAC(WORKPIECE, ""), "G90 G01 A90. F100\nG43.4 H0\nC10.\nG17 G02 X10. Y10. R10.\n",
     "1 programmed A=90\n2 programmed\n3 programmed C=10\n4 PS5421\n"},
    {"WKP = 1, A and C turned before G43.4: an arc of XY is allowed.", TAC(WORKPIECE, ""),
     "G90 G01 A90. C10. F100\nG43.4 H0\nG17 G02 X10. Y10. R10.\n",
     "1 programmed A=90 C=10\n2 programmed\n3 programmed X=10 Y=10 x=10 y=10\n"},
    {"WKP = 1, an R block whose end is its start makes no arc: C may turn, and the tip stays at (0, 0).",
     TAC(WORKPIECE, ""), "G90 G43.4 H0\nG17 G02 X0 Y0 R5. C10. F100\n", "1 programmed\n2 programmed C=10\n"},
    {"WKP = 1 and CIR = 0, a G02 block without R and centre is a line: C may turn, and the tip goes to (10, 10).",
     TAC(WORKPIECE "\"3403#5\" = 0\n", ""), "G90 G43.4 H0\nG17 G02 X10. Y10. C10. F100\n",
     "1 programmed\n2 programmed X=10 Y=10 x=10 y=10 C=10\n"},
    {"WKP = 1, the C axis is along Y and normal to ZX, but C has turned since G43.4: ARC_WITH_TABLE_TURNED at line 4.",
     TAC(WORKPIECE, ""), "G90 G01 A90. F100\nG43.4 H0\nC10.\nG18 G02 X10. Z10. R10.\n",
     "1 programmed A=90\n2 programmed\n3 programmed C=10\n4 ARC_WITH_TABLE_TURNED\n"},

    {"tip_control_cancel = moves: G49 moves the axes back by the length of 10 along X. X5 is then measured from the "
     "tip.",
     MOVES HC("", LENGTHS), "G90 G43.4 H1 B90.\nG49\nG91 G01 X5. F100\n",
     "1 programmed X=10 Z=0\n2 programmed X=0 Y=0 Z=0 B=90 x=0\n3 programmed X=5 Z=0\n"},
    {"tip_control_cancel = moves on a turned table: the tip is at (10, 0, 0) on the table and at (0, -10, 0) in the "
     "workpiece system. The axes move there. G91 X5 goes to (5, -10, 0).",
     MOVES TAC("", LENGTHS), "G90 G43.4 H1 P0 X10.\nG01 C90. F100\nG49\nG91 X5.\n",
     "1 programmed X=10 Z=10\n2 programmed X=0 Y=-10 Z=10\n3 programmed X=0 Y=-10 Z=0 x=0 y=-10\n"
     "4 programmed X=5 Y=-10 Z=0\n"},
    {"tip_control_cancel = moves, with an axis word in the block of G49: G91 X5 is measured from the tip.",
     MOVES HC("", LENGTHS), "G90 G43.4 H1 B90. X3.\nG49 G91 G01 X5. F100\n",
     "1 programmed X=13\n2 programmed X=8 Z=0 x=8\n"},
    {"tip_control_cancel = moves without kinematics: G49 moves the axes back by the length of 10 along (1, 0, 0).",
     MOVES WITHOUT(LENGTHS), "G90 G43.5 H1 I1 J0 K0\nG49\n", "1 programmed X=10\n2 programmed X=0\n"},

    {"Rotary axes alone: the tip stays at 0, and the control point goes from (0, 0, 10) to (10, 0, 0).",
     HC("", LENGTHS), "G90 G43.4 H1\nG01 B90. F100\n", "", 2},
    {"H2 alone at B 90: the control point moves evenly from 10 to 20.", HC("", LENGTHS),
     "G90 G43.4 H1 B90.\nG01 X0 F100\nH2\n", "", 2},
    {"The same with 5006#6 = 1, a parameter for length offsets along axes only.", HC("\"5006#6\" = 1\n", LENGTHS),
     "G90 G43.4 H1 B90.\nG01 X0 F100\nH2\n", "1 programmed X=10\n2 programmed X=10\n3 programmed X=20\n"},
    {"A head with 19711 = 40, tool length 10, B 90: the control point is 50 from the tip, along X.",
     MBC("19711 = 40\n", LENGTHS), "G90 G43.4 H1 P0\nG01 X1. B90. F100\n"},
    {"Tool side compensation under G43.4, length 10: the tool moves along Y 1, the control point 10 above it.",
     HC("", OFFSETS), "G90 G43.4 H1\nG01 G41.2 D1 X10. F100\nX20.\nG40 X30.\n", "", 2},

    {"I0 J0 K0: PS5421 at line 2.", HC("", ""), "G43.5 H0\nG01 I0 J0 K0 F100\n"},
    {"A rotary word under G43.5: PS5421 at line 2.", HC("", ""), "G43.5 H0\nG01 B10. F100\n"},
    {"A rotary word under G43.5 with tool side compensation: PS5460 at line 3.", HC("", OFFSETS),
     "G90 G43.5 H0\nG01 G41.6 D1 X10. F100\nX20. B10.\n"},
    {"I J K in the block of G43.5 on a table: PS5421 at line 1.", TAC("", ""), "G43.5 H0 I0 J0 K1\n"},
    {"I J K in the block of G43.5 on a head: B 90, the control point (10, 0, 0).", HC("", LENGTHS),
     "G43.5 H1 I1 J0 K0\n"},
    {"Q while the tool is along the travel does not lean the tool.", HC("", ""),
     "G90 G43.5 H0 Q5\nG01 Z10. I0 J0 K1 F100\n"},
    {"Q 30 leans the tool from the direction that is kept, Z, in each block separately: (1/2, 0, sqrt 3/2), then (0, "
     "1/2, sqrt 3/2).",
     HC("", ""), "G90 G43.5 H0 P0 Q30\nG01 X10. I0 J0 K1 F100\nY10.\nM08\n"},
    {"Q 90 in an arc from (0,0) to (10,10) about (0,10): the arc ends along Y, and the tool is then along Y.",
     HC("", ""), "G90 G17 G43.5 H0 Q90\nG03 X10. Y10. R10. I0 J0 K1 F100\n"},
    {"Q 30 in a helix, a quarter of a circle of radius 10 that rises by 20: the tool leans toward (0, 5 pi, 20).",
     HC("", ""), "G90 G17 G43.5 H0 P0 Q30\nG03 X10. Y10. Z20. R10. I1 J0 K0 F100\n"},
    {"Q 30 in a clockwise helix of three quarters of that circle: the tool leans toward (0, -15 pi, 20).", HC("", ""),
     "G90 G17 G43.5 H0 P0 Q30\nG02 X10. Y10. Z20. R-10. I1 J0 K0 F100\n"},
    {"B with its zero at 30, length 10: at B 0 the tool leans by 30, at B 60 it is along X.",
     HC("", LENGTHS "[workpiece.G54]\nB = 30\n"), "G90 G43.4 H1 P0\nG01 X10. B60. F100\n"},
    {"The same with programmed angles: the tool is upright at B 0 and leans by 60 at B 60.",
     "rotary_angles = \"programmed\"\n" HC("", LENGTHS "[workpiece.G54]\nB = 30\n"),
     "G90 G43.4 H1 P0\nG01 X10. B60. F100\n"},
    {"After G55 B 30 is called 0, after G92 it is called 5: the tool still leans by 30, and by 55 at B 30.",
     HC("", LENGTHS "[workpiece.G55]\nB = 30\n"), "G90 G00 B30.\nG55 X1.\nG92 B5.\nX2.\nG43.4 H1 P0\nG01 B30. F100\n"},
    {"C with its zero at 100, at the angle 45: both pairs of -1 1 2 move equally far. The angle -45, C -145, is nearer "
     "to 0.",
     HC("", "[workpiece.G54]\nC = 100\n[position]\nC = -55\n"), "G90 G43.5 H0 P0\nG01 I-1 J1 K2 F100\n"},
    {"B with its zero at 30 and a range from 0 to 30: the angle 26.565051177078, B -3.434948822922, is inside.",
     HC(RANGES("0", "0", "30", "0"), "[workpiece.G54]\nB = 30\n"), "G90 G43.5 H0 P0\nG01 I1 J0 K2 F100\n"},

    {"Without I J K and Q the rotary axes do not move, even if they are out of their range.",
     HC(RANGES("10", "5", "10", "5"), ""), "G90 G43.5 H0\nG01 X10. F100\n"},

    {"Tilted by RA 45, (3,4,5) is on the edge of reach toward Z: one pair.", HC(TILTED_45, ""),
     "G90 G43.5 H0 P0\nG01 I3 J4 K5 F100\n"},
    {"Tilted by RA 45, (1,0,10) is too near to Z: PS5459.", HC(TILTED_45, ""), "G90 G43.5 H0 P0\nG01 I1 J0 K10 F100\n"},
    {"Tilted by RA 45, (3,4,-5) is on the edge of reach away from Z.", HC(TILTED_45, ""),
     "G90 G43.5 H0 P0\nG01 I3 J4 K-5 F100\n"},
    {"Tilted by RA 45, (0,1,-10) is too near to -Z: PS5459.", HC(TILTED_45, ""),
     "G90 G43.5 H0 P0\nG01 I0 J1 K-10 F100\n"},

    {"At C 45, 1 -1 2: both pairs move equally far, and C -45 and B 35.264389682754654 are nearer to 0.",
     HC("", "[position]\nC = 45\n"), "G90 G43.5 H0 P0\nG01 I1 J-1 K2 F100\n"},
    {"Tilted by RB 20, at B -20, 0 1 1: C 90 and -90 are equal, and B 25 is nearer to 0 than B -65.",
     HC("19699 = 20\n", "[position]\nB = -20\n"), "G90 G43.5 H0 P0\nG01 I0 J1 K1 F100\n"},
    {"Tilted by RB -20, at B 20, 0 1 1: B -25 is nearer to 0 than B 65, with C -90.",
     HC("19699 = -20\n", "[position]\nB = 20\n"), "G90 G43.5 H0 P0\nG01 I0 J1 K1 F100\n"},
    {"From B 90 to the opposite direction: C moves by 180 either way, and neither end is nearer to 0. The greater one "
     "is taken, C 180.",
     HC(RANGES("0", "0", "100", "1"), "[position]\nB = 90\n"), "G90 G43.5 H0 P0\nG01 I-1 J0 K0 F100\n"},
    {"B 90 exactly at its limit is inside.", HC(RANGES("180", "-180", "90", "0"), ""),
     "G90 G43.5 H0 P0\nG01 I1 J0 K0 F100\n"},
    {"The range of C does not allow the way through 0: from 350 C goes back to 36.869897645844, because "
     "396.869897645844 is out of range.",
     HC(RANGES("360", "0", "90", "1"), "[position]\nC = 350\nB = 45\n"), "G90 G43.5 H0 P0\nG01 I4 J3 K5 F100\n"},
    {"The tool upright, the range of C from 10 to 20: C goes from 0 to its nearest limit, 10.",
     HC(RANGES("20", "10", "90", "-90"), ""), "G90 G43.5 H0 P0\nG01 I0 J0 K1 F100\n"},
    {"A lower limit above the upper limit: PS5459 at the block of G43.5.", HC(RANGES("0", "10", "90", "0"), ""),
     "G43.5 H0\n"},

    {"An arc about (0,10) while C turns by 90 at B 90, length 10: in the middle the tip is at 10 (sin 45, 1 - cos 45), "
     "and the tool is at azimuth 45.",
     HC("", LENGTHS), "G90 G17 G43.4 H1 P0 B90.\nG03 X10. Y10. R10. C90. F100\n", "", 2},
    {"An arc under G43.5 without R: PS5421 at line 2.", HC("", ""), "G43.5 H0\nG02 X10. Y10. I1 J0 K1 F100\n"},
    {"A rotary axis alone under G02: PS5421 at line 2.", HC("", ""), "G43.4 H0\nG02 C90. F100\n"},
    {"I J K alone under G02: PS5421 at line 2.", HC("", ""), "G43.5 H0\nG02 I1 J0 K1 F100\n"},
};

#undef LENGTHS
#undef OFFSETS
#undef WITHOUT
#undef MOVES
#undef WORKPIECE
#undef ONE_AXIS
#undef TILTED_45

}  // namespace

std::span<const Example> tool_center_point_control_rules() { return kRules; }

}  // namespace toolcomp::corpus
