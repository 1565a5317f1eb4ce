// SPDX-License-Identifier: Apache-2.0
// Tool side compensation: one program for each rule that generated programs seldom meet. VT is Z and the value 10
// unless the comment says otherwise.
#include "corpus/examples.h"

namespace toolcomp::corpus {
namespace {

#define MEMORY "[offsets.H]\n1 = 100\n[offsets.D]\n1 = 10\n2 = -5\n3 = 0\n4 = 4\n[position]\n"
#define VECTOR(axes, parameters) "control = \"fanuc\"\naxes = [" axes "]\n[parameters]\n" parameters MEMORY
// A head: C carries B.
#define HEAD(parameters)                                                                                             \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[parameters]\n19680 = 2\n19681 = 5\n19682 = 3\n" \
  "19686 = 4\n19687 = 2\n" parameters MEMORY
// B turns the tool, C the table; A carries C.
#define MIXED(parameters)                                                                                             \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[parameters]\n19680 = 21\n19681 = 4\n19682 = 2\n" \
  "19686 = 5\n19687 = 3\n19689 = 1\n" parameters MEMORY
#define MIXED_ROWS "1 s G1 0 10 0\n2 p G1 100 10 0\n"
#define TABLE(parameters)                                                                                             \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"A\", \"C\"]\n[parameters]\n19680 = 12\n19681 = 4\n19682 = 1\n" \
  "19684 = 1\n19686 = 5\n19687 = 3\n19689 = 1\n" parameters MEMORY
#define TABLE_LINES "G90 G01 A90. F1000\nG41.2 D1 X0\nX100.\nG40 X150.\n"
#define TURNED_ROWS "1 p G1 -40 0 0\n2 s G1 0 0 10\n3 p G1 100 0 10\n4 e G1 150 0 0\n"
#define XYZ "\"X\", \"Y\", \"Z\""
#define TYPE_B "\"5003#0\" = 1\n"
#define TYPE_C "\"5003#1\" = 1\n"
#define SERIES_30I "series = \"30i\"\n"
#define BEFORE_X "X = -40\n"
#define BEFORE_Y "Y = -40\n"

// The start-up block from (-40, 0, 0) to (0, 0, 0).
#define LEFT "G90 G17 G01 G41.2 D1 X0 Y0 F1000\n"
#define RIGHT "G90 G17 G01 G42.2 D1 X0 Y0 F1000\n"
#define HERE HEAD("") BEFORE_X
// The same by I J K, and from (0, -40, 0) with VT (3/5, 0, 4/5).
#define LEFT_VECTOR "G43.5 H0 I0 J0 K1\nG90 G17 G01 G41.6 D1 X0 Y0 F1000\n"
#define LEFT_TILTED "G43.5 H0 I3 J0 K4\nG90 G17 G01 G41.6 D1 X0 Y0 F1000\n"
#define THERE VECTOR(XYZ, "") BEFORE_X
#define TILTED_THERE VECTOR(XYZ, "") BEFORE_Y

constexpr Example kRules[] = {
    // Words.
    {"G41.6 without G43.5: TOOL_SIDE_MODE at line 1.", HERE, "G41.6 D1 X10.\n"},
    {"G42.2 under G43.5: TOOL_SIDE_MODE at line 2.", THERE, "G43.5 H0\nG01 G42.2 D1 X10. F1000\n"},
    {"G18 in the mode: PS0037 at line 3; line 2 ends with the perpendicular.", HERE, LEFT "X100.\nG18\n"},
    {"G19 in the block that cancels: PS0037 at line 3.", HERE, LEFT "X100.\nG40 G19 X150.\n"},
    {"G54 in the mode: FORBIDDEN_IN_3D_COMPENSATION at line 3.", HERE, LEFT "X100.\nG54\n"},
    {"M08 with an axis word in the mode: FORBIDDEN_IN_3D_COMPENSATION at line 3.", HERE, LEFT "X100.\nY100. M08\n"},
    {"G04 in the block that cancels: FORBIDDEN_IN_3D_COMPENSATION at line 3.", HERE, LEFT "X100.\nG40 G04 P1\n"},
    {"G41 in the mode: FORBIDDEN_IN_3D_COMPENSATION at line 3.", HERE, LEFT "X100.\nG41 X150.\n"},
    {"G41.3 in the mode: FORBIDDEN_IN_3D_COMPENSATION at line 3.", HERE, LEFT "X100.\nG41.3\n"},
    {"A rotary word under G43.5 in the mode: PS5460 at line 4.", VECTOR(XYZ ", \"B\"", "") BEFORE_X,
     LEFT_VECTOR "X100.\nX150. B1.\n"},
    {"Q4 in the mode: Q_FORMAT at line 3.", HERE, LEFT "X100.\nX150. Q4\n"},

    {"An outer corner of 135 degrees: obtuse, V = (10 (sqrt 2 - 1), 10, 0).", HERE,
     LEFT "X100.\nX150. Y-50.\nG40 X200. Y-100.\n"},

    // Machines of the 30i.
    {"30i, an arc on a mixed machine: PS5461 at line 3; line 2 ends with the perpendicular.",
     "series = \"30i\"\n" MIXED("") BEFORE_X, LEFT "X100.\nG02 X150. Y-50. R50.\n", MIXED_ROWS "3 PS5461\n"},
    {"30i, a table turned by A 90: VT is still Z, so the left of X is Y.", "series = \"30i\"\n" TABLE("") BEFORE_X,
     TABLE_LINES, "1 p G1 -40 0 0\n2 s G1 0 10 0\n3 p G1 100 10 0\n4 e G1 150 0 0\n"},
    {"30i with 19746#4 = 1: VT is seen from the table, as -Y, so the left of X is Z. The 16i does the same.",
     "series = \"30i\"\n" TABLE("\"19746#4\" = 1\n") BEFORE_X, TABLE_LINES, TURNED_ROWS},
    {"The 16i with the same table: the left of X is Z.", TABLE("") BEFORE_X, TABLE_LINES, TURNED_ROWS},
    {"30i with 19746#4 = 1 and 19696#5 = 1: as without 19746#4.",
     "series = \"30i\"\n" TABLE("\"19746#4\" = 1\n\"19696#5\" = 1\n") BEFORE_X, TABLE_LINES,
     "1 p G1 -40 0 0\n2 s G1 0 10 0\n3 p G1 100 10 0\n4 e G1 150 0 0\n"},

    // Arcs.
    {"G19 with VT X (B 90): the acute corner of TS11 with Y Z in place of X Y, (0, 10, 10), (0, 14, 2), (0, 8, -6).",
     HEAD("") "Y = -40\nB = 90\n",
     "G90 G19 G01 G41.2 D1 Y0 Z0 F1000\nY100.\nG02 Y30. Z-10. J-40. K30.\nG01 G40 Y-10. Z20.\n"},
    {"G18 with VT Y (B 90, C 90): the same with Z X in place of X Y, (10, 0, 10), (2, 0, 14), (-6, 0, 8).",
     HEAD("") "Z = -40\nB = 90\nC = 90\n",
     "G90 G18 G01 G41.2 D1 Z0 X0 F1000\nZ100.\nG02 Z30. X-10. K-40. I30.\nG01 G40 Z-10. X20.\n"},
    {"VT against Z (B 180): left is -Y, and G03 is clockwise as seen from the tool. The acute corner of TS11 turned "
     "about X: (10, -10, 0), (14, -2, 0), (8, 6, 0).",
     HERE "B = 180\n", LEFT "X100.\nG03 X30. Y10. I-40. J-30.\nG01 G40 X-10. Y-20.\n"},
    {"VT in the plane of the arc (B 90): undecided at line 3; left of Y is Z.", HEAD("") BEFORE_Y "B = 90\n",
     LEFT "Y50.\nG02 X50. Y100. I50. J0\n"},
    {"VT (3/5, 0, 4/5) and an arc of G17: ARC_PLANE_MISMATCH at line 4. Radius vectors (-32, 0, 24) and (0, 50, 0): "
     "the "
     "arc starts straight on with (-8, 0, 6) and ends with (0, 10, 0); about (50, 100) its radii are 58 and 60.",
     TILTED_THERE, LEFT_TILTED "Y100.\nG02 X50. Y150. R50.\nG01 G40 X100.\n"},
    {"A helix: the vectors of the arc in the plane.", HERE,
     LEFT "X100.\nG02 X30. Y-10. Z20. I-40. J30.\nG01 G40 X-10. Y20.\n"},
    {"An arc that ends at its centre: PS0038 at line 3.", HERE, LEFT "X100.\nG02 X100. Y-50. I0 J-50.\n"},
    {"An arc on the inside, smaller than the tool, R' = -5: line 2 ends with the perpendicular, PS0041 at line 3.",
     HERE, LEFT "X100.\nG03 X90. Y0 I-5. J0\n"},
    {"The value changes where the arc begins: the start of the arc of R6 uses the 10 of the line before, R' = -4, and "
     "not the 4 of the arc. Line 2 ends with the perpendicular, PS0041 at line 3.",
     HERE, LEFT "X100.\nG03 X106. Y6. I0 J6. D4\n"},
    {"Offset circles of radius 2 that lie apart: PS0033 at line 2.", HERE,
     LEFT "G03 X12. Y12. I0 J12.\nX0 Y0 I0 J-12.\n"},

    // Blocks without movement in the plane.
    {"A movement along the tool, VT (3/5, 0, 4/5): line 3 ends with the vector of the corner of Y and X, (-8, 10, 6), "
     "and line 4 keeps it.",
     TILTED_THERE, LEFT_TILTED "Y100.\nX30. Z40.\nX130.\nG40 X150.\n"},
    {"19630 = 0.5, a block of 0.4 does not count as a movement: line 2 ends with the vector of the corner of X and Y, "
     "(10, -10, 0), and line 3 keeps it.",
     HEAD("19630 = \"0.5\"\n") BEFORE_X, RIGHT "X100.\nX100.4\nY100.\nG40 Y150.\n"},
    {"19630 = 0.5, a block of exactly 0.5 counts as a movement: line 2 ends with (0, -10, 0), line 3 with (10, -10, "
     "0).",
     HEAD("19630 = \"0.5\"\n") BEFORE_X, RIGHT "X100.\nX100.5\nY100.\nG40 Y150.\n"},
    {"19630 = 0.5 is compared in the plane: a block of 0.4 in X and 30 along the tool does not count as a movement "
     "either.",
     HEAD("19630 = \"0.5\"\n") BEFORE_X, RIGHT "X100.\nX100.4 Z30.\nY100.\nG40 Y150.\n"},
    {"Two blocks without movement: line 2 ends with the perpendicular (0, -10, 0), line 5 starts from it.", HERE,
     RIGHT "X100.\nM08\nM09\nY100.\nG40 Y150.\n"},
    {"M00 stops the look-ahead: line 2 ends with the perpendicular (0, -10, 0).", HERE,
     RIGHT "X100.\nM00\nY100.\nG40 Y150.\n"},
    {"M08 stops the look-ahead if No. 3420 is 8.", HEAD("3420 = 8\n") BEFORE_X, RIGHT "X100.\nM08\nY100.\nG40 Y150.\n",
     "1 s G1 0 -10 0\n2 p G1 100 -10 0\n4 p G1 110 100 0\n5 e G1 100 150 0\n"},
    {"The 30i reads five blocks: it looks past three blocks without movement, to the corner (10, -10, 0).",
     SERIES_30I HEAD("19625 = 5\n") BEFORE_X, RIGHT "X100.\nM08\nM09\nM08\nY100.\nG40 Y150.\n",
     "1 s G1 0 -10 0\n2 p G1 110 -10 0\n6 p G1 110 100 0\n7 e G1 100 150 0\n"},
    {"The 30i reads five blocks: it does not look past four blocks without movement.",
     SERIES_30I HEAD("19625 = 5\n") BEFORE_X, RIGHT "X100.\nM08\nM09\nM08\nM09\nY100.\nG40 Y150.\n",
     "1 s G1 0 -10 0\n2 p G1 100 -10 0\n7 p G1 110 100 0\n8 e G1 100 150 0\n"},
    {"The corner of lines 4 and 5, straight on, (0, -10, 0), is known before that of lines 3 and 6, (-10, 10, 0), "
     "because lines 4 and 5 move along the tool of line 3. Line 5 ends with (-8, -10, 6), line 6 with (-8, 0, 6).",
     SERIES_30I VECTOR(XYZ, "19625 = 5\n") BEFORE_X, LEFT_VECTOR "X100.\nZ50. I3 J0 K4\nZ80.\nY100.\nG40 Y150.\n",
     "1 p G0 -40 0 0\n2 s G1 0 10 0\n3 p G1 90 10 0\n4 p G1 100 -10 50\n5 p G1 92 -10 86\n6 p G1 92 100 86\n7 e G1 100 "
     "150 80\n"},
    {"The same, but line 5 moves along the tool at its own end: it keeps (0, -10, 0), and line 6 starts from it.",
     SERIES_30I VECTOR(XYZ, "19625 = 5\n") BEFORE_X,
     LEFT_VECTOR "X100.\nZ50. I3 J0 K4\nZ80. I0 J0 K1\nY100.\nG40 Y150.\n",
     "1 p G0 -40 0 0\n2 s G1 0 10 0\n3 p G1 90 10 0\n4 p G1 100 -10 50\n5 p G1 100 -10 80\n6 p G1 90 100 80\n7 e G1 "
     "100 150 80\n"},
    {"Two rotations in a row: line 3 ends with the perpendicular (0, -10, 0), lines 4 and 5 keep it; line 6 ends with "
     "10 (0, -0.8, 0.6), right of X with VT (0, 0.6, 0.8).",
     THERE, "G43.5 H0 I0 J0 K1\nG01 G42.6 D1 X0 F1000\nX100.\nI1 J0 K1\nI0 J3 K4\nX200.\nG40 X250.\n"},
    {"A block across the tool at its start and along the tool at its end: line 4 moves along (3/5, 0, 4/5) and keeps "
     "(0, 10, 0). Line 5 starts from this vector and ends with (-8, 0, 6).",
     THERE, LEFT_VECTOR "X100.\nX130. Z40. I3 J0 K4\nY100.\nG40 Y150.\n"},
    {"A block along the previous tool direction, in which the tool turns to (3/5, 0, 4/5): the corner at the end of "
     "line 3 skips line 4, (-10, 10, 0). Line 4 ends with a corner of its own, (-8, -10, 6), line 5 with (-8, 0, 6).",
     THERE, LEFT_VECTOR "X100.\nZ50. I3 J0 K4\nY100.\nG40 Y150.\n"},
    {"A block that only turns the tool, then a block along the tool direction before it: both count as blocks without "
     "movement at the end of line 3, (0, 10, 0), and line 4 keeps this vector. Line 5 counts as a movement at its own "
     "end, (-8, -10, 6).",
     THERE, LEFT_VECTOR "X100.\nI3 J0 K4\nZ50.\nY100.\nG40 Y150.\n"},
    {"A block that is skipped by the corner before it, (10, 10, 0), runs against its own movement: PS0041 at line 4. "
     "Its own corner is (8, -10, -6).",
     THERE, LEFT_VECTOR "X100.\nZ3. I3 J0 K4\nY-100.\nG40 Y-150.\n"},
    {"19630 = 6 in the plane of the block's own tool: 9.999 along Z is 5.9994 across (3/5, 0, 4/5), so line 4 keeps "
     "(-10, 10, 0).",
     VECTOR(XYZ, "19630 = 6\n") BEFORE_X, LEFT_VECTOR "X100.\nZ9.999 I3 J0 K4\nY100.\nG40 Y150.\n"},
    {"19630 = 6 and exactly 6 in the plane of the block's own tool: 10 along Z counts as a movement, line 4 ends with "
     "(-8, -10, 6).",
     VECTOR(XYZ, "19630 = 6\n") BEFORE_X, LEFT_VECTOR "X100.\nZ10. I3 J0 K4\nY100.\nG40 Y150.\n"},
    {"No block follows at the end of the program: line 2 ends with the perpendicular (0, 10, 0).", HERE,
     LEFT "X100.\n"},

    // Start-up.
    {"Types A and B: G41.2 without movement makes no vector, and line 2 is the start-up block.", HERE,
     "G90 G17 G01 G41.2 D1 F1000\nX0\nX100.\nG40 X150.\n"},
    {"The start-up block turns the tool: its vector is made with VT at its end, (-8, 0, 6).", TILTED_THERE,
     "G43.5 H0 I0 J0 K1\nG01 G41.6 D1 Y0 I3 J0 K4 F1000\nY100.\nG40 Y150.\n"},
    {"Type B, obtuse before an arc: (0, 10, 0), (10/3, 10, 0), then (6, 8, 0).", HEAD(TYPE_B),
     "G90 G17 G01 G41.2 D1 X40. F1000\nG02 X60. Y-40. I-30. J-40.\n"},
    {"Type B, acute before an arc: (0, 10, 0), (10, 10, 0), then (14, 2, 0), (8, -6, 0).", HEAD(TYPE_B),
     "G90 G17 G01 G41.2 D1 X40. F1000\nG02 X0 Y-20. I-40. J30.\n"},
    {"Type A before an arc: (8, -6, 0).", HEAD(""), "G90 G17 G01 G41.2 D1 X40. F1000\nG02 X0 Y-20. I-40. J30.\n"},
    {"Type B below 1 degree: the one vector of type A.", HEAD(TYPE_B), "G90 G17 G01 G41.2 D1 X100. F1000\nX0 Y-1.\n"},
    {"type_b_without_perpendicular, obtuse: (10, 10, 0) alone at start-up, (10, -10, 0) at cancel.",
     "type_b_without_perpendicular = true\n" HEAD(TYPE_B), "G90 G17 G01 G41.2 D1 X100. F1000\nY-100.\nG40 X0\n"},
    {"type_b_without_perpendicular, acute: (10, 10, 0), (14, 2, 0) at start-up, the perpendicular of an arc stays.",
     "type_b_without_perpendicular = true\n" HEAD(TYPE_B),
     "G90 G17 G01 G41.2 D1 X40. F1000\nG02 X0 Y-20. I-40. J30.\n"},
    {"An arc as start-up block: PS0034 at line 1.", HERE, "G90 G17 G02 G41.2 D1 X0 Y0 R40. F1000\nG01 X100.\n"},
    {"The side changes in the block after the start-up: DIR_CHANGE_AT_STARTUP at line 2.", HERE, LEFT "G42.2 X100.\n"},
    {"The side changes after the start-up, in a block that counts as a movement only at its own end: "
     "DIR_CHANGE_AT_STARTUP at line 3.",
     THERE, LEFT_VECTOR "G42.6 Z50. I3 J0 K4\nY100.\n"},
    {"The side changes in the block with which the start-up makes its corner, after a block that this corner skips: "
     "DIR_CHANGE_AT_STARTUP at line 4. Line 3 goes from (0, 10, 0) to (0, -10, 0).",
     THERE, LEFT_VECTOR "Z50. I3 J0 K4\nG42.6 Y100.\n"},
    {"Start-up block and cancel block without a block between, type B: the perpendicular (0, 10, 0).",
     HEAD(TYPE_B) BEFORE_X, LEFT "G40 Y-100.\n"},
    {"Type C before an arc: an inserted move to (8, -6, 0).", HEAD(TYPE_C) BEFORE_X,
     "G90 G17 G01 X40. F1000\nG41.2 D1\nG02 X0 Y-20. I-40. J30.\nG01\nG40\n"},
    {"Type C with an axis word in the G41.2 block: TYPE_C_FORMAT at line 1.", HEAD(TYPE_C) BEFORE_X, LEFT "X100.\n"},
    {"Type C with a rotary word in the G41.2 block: TYPE_C_FORMAT at line 1.", HEAD(TYPE_C),
     "G01 G41.2 D1 B10. F1000\nX100.\n"},
    {"Type C under G02: TYPE_C_FORMAT at line 2.", HEAD(TYPE_C), "G02\nG41.2 D1\n"},
    {"Type C, the next block does not move: TYPE_C_FORMAT at line 1.", HEAD(TYPE_C),
     "G01 G41.2 D1 F1000\nM08\nX100.\n"},
    {"Type C with an axis word in the G40 block: TYPE_C_FORMAT at line 3.", HEAD(TYPE_C),
     "G01 G41.2 D1 F1000\nX100.\nG40 X150.\n"},

    // Cancel.
    {"Type B, obtuse after an arc: (6, 8, 0), (10/3, 10, 0), then (0, 10, 0).", HEAD(TYPE_B) "X = 60\nY = -80\n",
     "G90 G17 G01 G42.2 D1 X60. Y-40. F1000\nG03 X40. Y0 I-50. J0\nG01 G40 X0 Y0\n"},
    {"Type B, acute after an arc: (8, -6, 0), (14, 2, 0), then (10, 10, 0), (0, 10, 0).",
     HEAD(TYPE_B) "X = -40\nY = -20\n", "G90 G17 G01 G42.2 D1 X0 Y-20. F1000\nG03 X40. Y0 I0 J50.\nG01 G40 X0 Y0\n"},
    {"Type B, acute cancel of two lines: (10, 10, 0), then (14, 2, 0), (8, -6, 0).", HEAD(TYPE_B) BEFORE_X,
     LEFT "X40.\nG40 X10. Y-40.\n"},
    {"Type B, inner cancel: the perpendicular (0, 10, 0).", HEAD(TYPE_B) BEFORE_X, LEFT "X100.\nG40 Y50.\n"},
    {"An arc as cancel block: PS0034 at line 3.", HERE, LEFT "X100.\nG40 G02 X120. Y-20. R20.\n"},
    {"G40 without movement: line 2 ends with the perpendicular, line 4 removes the vector.", HERE,
     RIGHT "X100.\nG40\nY50.\n"},
    {"G40 with a movement along the tool: line 3 keeps (0, -10, 0), line 4 removes it.", HERE,
     RIGHT "X100.\nG40 Z30.\nY50.\n"},
    {"G40 with a movement along the previous tool direction, in which the tool turns: line 3 ends with the "
     "perpendicular (0, 10, 0). Line 4 counts as a movement at its own end and removes the vector.",
     THERE, LEFT_VECTOR "X100.\nG40 Z50. I3 J0 K4\nX0\n"},
    {"Type B, G40 with a movement along its own tool, (0, -3/5, 4/5): the group at the end of line 3 is that of a "
     "cancel, (10, 10, 0), then (10, 0, 0). Line 4 keeps the last vector, and line 5 removes it.",
     VECTOR(XYZ, TYPE_B) BEFORE_X, LEFT_VECTOR "X100.\nG40 Y-30. Z40. I0 J-3 K4\nX200.\n"},
    {"D0 cancels as G40 does.", HERE, LEFT "X100.\nD0 Y100.\nX0\n"},

    // Changes in the mode.
    {"G41.2 again: the perpendicular (0, 10, 0) at an inner corner.", HERE, LEFT "X100.\nG41.2 Y100.\nG40 Y150.\n"},
    {"G41.2 again, in a block without movement between the two blocks of the corner.", HERE,
     LEFT "X100.\nG41.2\nY100.\nG40 Y150.\n"},
    {"Another D takes effect at the end of its block, for both blocks of the corner: 4, V = (-4, 4, 0).", HERE,
     LEFT "X100. D4\nY100.\nG40 Y150.\n"},
    {"A negative value exchanges the sides: D2 = -5 under G41.2 gives (0, -5, 0).", HERE,
     "G90 G17 G01 G41.2 D2 X0 Y0 F1000\nX100.\nY100.\nG40 Y150.\n"},
    {"An offset number whose value is 0: vectors of length 0.", HERE,
     "G90 G17 G01 G41.2 D3 X0 Y0 F1000\nX100.\nY100.\nG40 Y150.\n"},
    {"The side changes at an arc: the offset circle of radius 40 and the line y = -40 meet at (10 sqrt 15, -40).", HERE,
     LEFT "G02 X30. Y-30. I0 J-30.\nG42.2 G01 X100.\nG40 X150.\n"},
    {"5010 = 20, the vectors of a reversal differ by exactly 20: the second is dropped.", HEAD("5010 = 20\n") BEFORE_X,
     LEFT "X100.\nX0\nG40 X-40.\n"},
    {"5010 = 21, above the difference: the second is dropped.", HEAD("5010 = 21\n") BEFORE_X,
     LEFT "X100.\nX0\nG40 X-40.\n"},
    {"5010 = 19.999: both vectors stay.", HEAD("5010 = \"19.999\"\n") BEFORE_X, LEFT "X100.\nX0\nG40 X-40.\n"},
    {"Q1 at a change of side: the perpendicular to the block before, (0, 10, 0).", HERE,
     LEFT "X100. Q1\nG42.2 Y100.\nG40 Y150.\n"},
    {"The same code again with a value of the other sign (D2 = -5): a change of side, (10, 10, 0).", HERE,
     LEFT "X100.\nG41.2 D2 Y100.\nG40 Y150.\n"},
    {"Q1 before the same code again with a value of the other sign: the perpendicular (0, 10, 0).", HERE,
     LEFT "X100. Q1\nG41.2 D2 Y100.\nG40 Y150.\n"},
    {"Q1 at a corner of one orientation: the perpendicular (0, 10, 0).", HERE, LEFT "X100. Q1\nY100.\nG40 Y150.\n"},
    {"Q2 at an acute corner of one orientation: K1, the first vector, alone.", HERE, LEFT "X100. Q2\nX0\nG40 X-40.\n"},
    {"Q2 with one vector changes nothing.", HERE, LEFT "X100. Q2\nY100.\nG40 Y150.\n"},

    {"19630 = 0.5: line 6, after lines of 1 mm, counts as a movement. The first number has more decimals than a "
     "control counts. With the value 1 the vector at the end is (0, 1, 0): X90 Y2.",
     "control = \"fanuc\"\naxes = [" XYZ "]\n[parameters]\n19630 = \"0.5\"\n[offsets.D]\n1 = 1\n",
     "G43.5\nG41.6 D1 X10.0000000\nX10 Y1\nY0\nX80 Y1\nX90\n"},

    // Interference.
    {"VT Z, then (-1, 0, 1) and a movement along it: exactly 45 degrees counts, and so does Wb = 0. PS0041 at line 3.",
     THERE, LEFT_VECTOR "X100.\nI-1 J0 K1\nX50. Z50.\n"},
    {"VT Z, then (-1, 0, 1) and a further movement in X: no alarm. Straight on with (0, 10, 0) everywhere.", THERE,
     LEFT_VECTOR "X100.\nI-1 J0 K1\nX150.\nG40 X200.\n"},
    {"VT Z, then (-1, 0, 1) and a movement in Y: Wa and Wb, Ra and Rb at right angles, no alarm. (-10, 10, 0), at the "
     "end 10 (-1, 0, -1) / sqrt 2.",
     THERE, LEFT_VECTOR "X100.\nI-1 J0 K1\nY50.\nG40 Y100.\n"},
    {"A slot narrower than the tool: PS0041 at line 3.", HERE, LEFT "X100.\nY5.\nX0\nG40 X-40.\n"},
    {"The same with 5008#0 = 1, no check.", HEAD("\"5008#0\" = 1\n") BEFORE_X, LEFT "X100.\nY5.\nX0\nG40 X-40.\n"},

    // The length offset in the mode.
    {"G43 in the mode: the length along Z is added to the compensated point.", HERE,
     LEFT "X100.\nG43 H1 X200.\nG40 X250.\n"},
};

#undef MEMORY
#undef VECTOR
#undef HEAD
#undef MIXED
#undef MIXED_ROWS
#undef TABLE
#undef TABLE_LINES
#undef TURNED_ROWS
#undef XYZ
#undef TYPE_B
#undef TYPE_C
#undef SERIES_30I
#undef BEFORE_X
#undef BEFORE_Y
#undef LEFT
#undef RIGHT
#undef HERE
#undef LEFT_VECTOR
#undef LEFT_TILTED
#undef THERE
#undef TILTED_THERE

}  // namespace

std::span<const Example> tool_side_compensation_rules() { return kRules; }

}  // namespace toolcomp::corpus
