// SPDX-License-Identifier: Apache-2.0
// Tool side compensation: the worked examples TS1 to TS11 and the manual's interference figure, with the tool axis
// given by rotary words (G41.2, G42.2) and, if I J K can give it exactly, under G43.5 (G41.6, G42.6). The block before
// each corner goes straight on, so that its vector at the start is the perpendicular.
#include "corpus/examples.h"

namespace toolcomp::corpus {
namespace {

// No machine: the program gives the tool axis.
#define VECTOR(parameters, value, position)                                                                \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[parameters]\n" parameters "[offsets.D]\n1 = " value \
  "\n"                                                                                                     \
  "[position]\n" position
// A head: C carries B.
#define HEAD(parameters, value, position)                                                                            \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[parameters]\n19680 = 2\n19681 = 5\n19682 = 3\n" \
  "19686 = 4\n19687 = 2\n" parameters "[offsets.D]\n1 = " value "\n[position]\n" position
// A head: C carries A.
#define HEAD_A(parameters, position)                                                                                 \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"A\", \"C\"]\n[parameters]\n19680 = 2\n19681 = 5\n19682 = 3\n" \
  "19686 = 4\n19687 = 1\n" parameters "[offsets.D]\n1 = 10\n[position]\n" position
#define TYPE_B "\"5003#0\" = 1\n"
#define TYPE_C "\"5003#1\" = 1\n"
#define BEFORE_X "X = -40\n"
#define BEFORE_Y "Y = -40\n"
#define UNTILTED "G43.5 H0 I0 J0 K1\n"
#define TILTED "G43.5 H0 I3 J0 K4\n"
#define TILT_B "B36.8698976458440"  // of cosine 4/5 but for the last digits

#define TS1(code) "G90 G17 G01 " code " D1 X0 Y0 F1000\nX100.\nY100.\nG40 Y150.\n"
#define TS2(code) "G90 G17 G01 " code " D1 X0 Y0 F1000\nY100.\nX100.\nG40 X150.\n"
#define TS3(code) "G90 G17 G01 " code " D1 X0 Y0 F1000\nY100. F700\nX94. Y40. Z-8. F500\nG40 X188. Y-20. Z-16.\n"
#define TS6(code, turn) "G90 G17 G01 " code " D1 X0 Y0 F1000\nX50.\n" turn "\nY100.\nX150.\nG40 X200.\n"
#define START(code, next) "G90 G17 G01 " code " D1 Y100. F1000\n" next "\n"
#define START_C(code, next) "G90 G17 G01 Y100. F1000\n" code " D1\n" next "\n"
#define OBTUSE "X100."
#define ACUTE "X94. Y40. Z-8."
#define CANCEL(code, cancel) "G90 G17 G01 " code " D1 X0 Y0 F1000\nY100.\n" cancel "\n"

// From A to B with Va, then only the tool turns to Vb, then from B to C.
#define FIGURE(code, first, q, turn, again, corner_c) \
  first "G90 G01 " code " D1 X0 Y0 Z0 F1000\nY-200. Z-200." q "\n" turn "\n" again "Y-400. Z0\n" corner_c
#define AWAY "G40 Y-440. Z40.\n"
#define TS8(parameters, q, again) \
  HEAD_A(parameters, "Y = 40\nZ = 40\n"), FIGURE("G41.2", "G90 G00 A46.\n", q, "A-45.", again, AWAY)
#define TS9(parameters, q, again)               \
  VECTOR(parameters, "10", "Y = 40\nZ = 40\n"), \
      FIGURE("G41.6", "G90 G00 G43.5 H0 I0 J-4 K3\n", q, "I0 J4 K3", again, AWAY)
#define TS9C(setup, head, code, turn) \
  setup, head "G90 G01 " code " D1 X0 Y0 F1000\nX100.\n" turn "\nX0 Y50.\nG40 X-100. Y100.\n"

#define TS10(code, other, next) "G90 G17 G01 " code " D1 X0 Y0 F1000\nX100.\n" other next "\n"
#define TS11(arc, cancel) \
  HEAD("", "10", BEFORE_X), "G90 G17 G01 G41.2 D1 X0 Y0 F1000\nX100.\n" arc "\nG01 G40 " cancel "\n"

constexpr Example kExamples[] = {
    {"TS1: VT Z, r 5, left turn of 90 degrees, G41.2: inner, V = (-5, 5, 0).", HEAD("", "5", BEFORE_X), TS1("G41.2")},
    {"TS1 with G42.2: outer of 90 degrees, V = (5, -5, 0).", HEAD("", "5", BEFORE_X), TS1("G42.2")},
    {"TS1 by I J K, G41.6: V = (-5, 5, 0).", VECTOR("", "5", BEFORE_X), UNTILTED TS1("G41.6")},
    {"TS1 by I J K, G42.6: V = (5, -5, 0).", VECTOR("", "5", BEFORE_X), UNTILTED TS1("G42.6")},

    {"TS2 by I J K: VT (3/5, 0, 4/5), r 10, (0,0,0) (0,100,0) (100,0,0) on, G41.6: outer obtuse, V = (-8, 10, 6).",
     VECTOR("", "10", BEFORE_Y), TILTED TS2("G41.6")},
    {"TS2 by I J K, G42.6: inner, V = (8, -10, -6).", VECTOR("", "10", BEFORE_Y), TILTED TS2("G42.6")},
    {"TS2 by B, G41.2: V = (-8, 10, 6) but for the last digits of B.",
     HEAD("", "10", BEFORE_Y "B = 36.8698976458440\n"), TS2("G41.2")},
    {"TS2 by B, G42.2: V = (8, -10, -6) but for the last digits of B.",
     HEAD("", "10", BEFORE_Y "B = 36.8698976458440\n"), TS2("G42.2")},

    {"TS3 by I J K: VT (3/5, 0, 4/5), r 10, (0,0,0) (0,100,0) (94,40,-8), G41.6: outer acute, V1 = (-8, 10, 6), V2 = "
     "(-1.6, 14, 1.2). Up to V1 with F700, from there with F500.",
     VECTOR("", "10", BEFORE_Y), TILTED TS3("G41.6")},
    {"TS3 by I J K, G42.6: inner, V = (8, -20, -6).", VECTOR("", "10", BEFORE_Y), TILTED TS3("G42.6")},
    {"TS3 by B, G41.2: V1 = (-8, 10, 6), V2 = (-1.6, 14, 1.2) but for the last digits of B.",
     HEAD("", "10", BEFORE_Y "B = 36.8698976458440\n"), TS3("G41.2")},
    {"TS3 by B, G42.2: V = (8, -20, -6) but for the last digits of B.",
     HEAD("", "10", BEFORE_Y "B = 36.8698976458440\n"), TS3("G42.2")},

    {"TS6 by I J K: line 4 only turns the tool. Line 3 ends with V = (-5, 5, 0) for VT Z, and line 4 keeps V. Line 5 "
     "ends with (-4, 5, 3) for VT (3/5, 0, 4/5).",
     VECTOR("", "5", BEFORE_X), UNTILTED TS6("G41.6", "I3 J0 K4")},
    {"TS6 by B: the same but for the last digits of B.", HEAD("", "5", BEFORE_X), TS6("G41.2", TILT_B)},

    {"TS7 start (a), type A: VT (3/5, 0, 4/5), r 10: (0, 10, 0).", VECTOR("", "10", ""), TILTED START("G41.6", OBTUSE)},
    {"TS7 start (a), type B: (-8, 0, 6), (-8, 10, 6).", VECTOR(TYPE_B, "10", ""), TILTED START("G41.6", OBTUSE)},
    {"TS7 start (a), type C: an inserted block to (0, 110, 0).", VECTOR(TYPE_C, "10", ""),
     TILTED START_C("G41.6", OBTUSE)},
    {"TS7 start (b), type A: (4.8, 8, -3.6).", VECTOR("", "10", ""), TILTED START("G41.6", ACUTE)},
    {"TS7 start (b), type B: (-8, 0, 6), (-8, 10, 6), (-1.6, 14, 1.2).", VECTOR(TYPE_B, "10", ""),
     TILTED START("G41.6", ACUTE)},
    {"TS7 start (b), type C: an inserted block to (4.8, 108, -3.6).", VECTOR(TYPE_C, "10", ""),
     TILTED START_C("G41.6", ACUTE)},
    {"TS7 start (a) with G42.6, type A, inner: (0, -10, 0).", VECTOR("", "10", ""), TILTED START("G42.6", OBTUSE)},
    {"TS7 start (a) with G42.6, type B, inner: (0, -10, 0).", VECTOR(TYPE_B, "10", ""), TILTED START("G42.6", OBTUSE)},
    {"TS7 cancel, type A: (-8, 0, 6), then (100, 100, 0).", VECTOR("", "10", BEFORE_Y),
     TILTED CANCEL("G41.6", "G40 X100.")},
    {"TS7 cancel, type B: (-8, 10, 6), (0, 10, 0), then (100, 100, 0).", VECTOR(TYPE_B, "10", BEFORE_Y),
     TILTED CANCEL("G41.6", "G40 X100.")},
    {"TS7 cancel, type C: an inserted block from (-8, 100, 6) to (0, 100, 0).", VECTOR(TYPE_C, "10", ""),
     TILTED "G90 G17 G01 G41.6 D1 F1000\nY100.\nG40\n"},
    {"TS7 by B, start (b), type B: (-8, 0, 6), (-8, 10, 6), (-1.6, 14, 1.2) but for the last digits of B.",
     HEAD(TYPE_B, "10", "B = 36.8698976458440\n"), START("G41.2", ACUTE)},

    {"TS8, the manual's interference figure: 91 degrees between the tool axes, overcut: PS0041 at line "
     "3.",
     TS8("", "", "")},
    {"TS8 with Q1: V = (10, 0, 0).", TS8("", " Q1", "")},
    {"TS8 with Q2: V1 = (10, -6.946583704589972867, -7.193398003386511394) alone.", TS8("", " Q2", "")},
    {"TS8 with Q3: V1 and V2 = (-10, -6.946583704589972867, -7.193398003386511394).", TS8("", " Q3", "")},
    {"TS8 with G41.2 again in the next block: V = (10, 0, 0).", TS8("", "", "G41.2 ")},
    {"TS8 with the tool turning in the next block itself: PS0041 at line 3.", HEAD_A("", "Y = 40\nZ = 40\n"),
     "G90 G00 A46.\nG01 G41.2 D1 X0 Y0 Z0 F1000\nY-200. Z-200.\nY-400. Z0 A-45.\n" AWAY},
    {"TS8 with 19605#5 = 1, no check: V1 and V2.", TS8("\"19605#5\" = 1\n", "", "")},
    {"TS8 with 6261 = 91, exactly the limit: PS0041 at line 3.", TS8("6261 = 91\n", "", "")},
    {"TS8 with 6261 = 91.001: V1 and V2.", TS8("6261 = \"91.001\"\n", "", "")},
    {"TS9: the same with I J K, VT (0, -4/5, 3/5), then (0, 4/5, 3/5): PS0041 at line 3.", TS9("", "", "")},
    {"TS9 with Q1: V = (10, 0, 0).", TS9("", " Q1", "")},
    {"TS9 with Q2: V1 = (10, -6, -8) alone.", TS9("", " Q2", "")},
    {"TS9 with Q3: V1 and V2 = (-10, -6, -8).", TS9("", " Q3", "")},
    {"TS9 with G41.6 again in the next block: V = (10, 0, 0).", TS9("", "", "G41.6 ")},
    {"TS9 with 19605#5 = 1, no check: V1 and V2.", TS9("\"19605#5\" = 1\n", "", "")},
    {"TS9c: VT Z, then (0, -4/5, 3/5), but Wa and Wb point against each other: no alarm. The vector of the inner "
     "corner is (-10 (2 + sqrt 5), 10, 0); the last block ends with 10 (-30, -60, -80) / sqrt 10900.",
     TS9C(VECTOR("", "10", BEFORE_X), UNTILTED, "G41.6", "I0 J-4 K3")},

    {"TS10, G41.2 to G42.2, reversal: V = (0, 10, 0).", HEAD("", "10", BEFORE_X),
     TS10("G41.2", "G42.2 ", "X0\nG40 X-40.")},
    {"TS10, G41.2 to G42.2, left turn: V = (10, 10, 0).", HEAD("", "10", BEFORE_X),
     TS10("G41.2", "G42.2 ", "Y100.\nG40 Y140.")},
    {"TS10, G41.2 to G42.2, right turn: V = (-10, 10, 0).", HEAD("", "10", BEFORE_X),
     TS10("G41.2", "G42.2 ", "Y-100.\nG40 Y-140.")},
    {"TS10, G41.2 to G42.2, straight on: V = (0, -10, 0).", HEAD("", "10", BEFORE_X),
     TS10("G41.2", "G42.2 ", "X200.\nG40 X240.")},
    {"TS10, reversal with G41.2 kept: V1 = (10, 10, 0), V2 = (10, -10, 0).", HEAD("", "10", BEFORE_X),
     TS10("G41.2", "", "X0\nG40 X-40.")},
    {"TS10 by I J K, G41.6 to G42.6, reversal: V = (0, 10, 0).", VECTOR("", "10", BEFORE_X),
     UNTILTED TS10("G41.6", "G42.6 ", "X0\nG40 X-40.")},
    {"TS10 by I J K, G41.6 to G42.6, left turn: V = (10, 10, 0).", VECTOR("", "10", BEFORE_X),
     UNTILTED TS10("G41.6", "G42.6 ", "Y100.\nG40 Y140.")},
    {"TS10 by I J K, G41.6 to G42.6, right turn: V = (-10, 10, 0).", VECTOR("", "10", BEFORE_X),
     UNTILTED TS10("G41.6", "G42.6 ", "Y-100.\nG40 Y-140.")},
    {"TS10 by I J K, G41.6 to G42.6, straight on: V = (0, -10, 0).", VECTOR("", "10", BEFORE_X),
     UNTILTED TS10("G41.6", "G42.6 ", "X200.\nG40 X240.")},
    {"TS10 by I J K, reversal with G41.6 kept: V1 = (10, 10, 0), V2 = (10, -10, 0).", VECTOR("", "10", BEFORE_X),
     UNTILTED TS10("G41.6", "", "X0\nG40 X-40.")},
    {"TS10 by I J K, the points of TS3, VT (3/5, 0, 4/5), G41.6 to G42.6: V = (-8, -5, 6).", VECTOR("", "10", BEFORE_Y),
     TILTED "G90 G17 G01 G41.6 D1 X0 Y0 F1000\nY100.\nG42.6 X94. Y40. Z-8.\nG40 X188. Y-20. Z-16.\n"},

    {"TS11, clockwise arc about (60,30), acute: (10, 10, 0), (14, 2, 0), (8, -6, 0).",
     TS11("G02 X30. Y-10. I-40. J30.", "X-10. Y20.")},
    {"TS11, clockwise arc about (60,-30), obtuse: (5, 10, 0), (8, 6, 0).",
     TS11("G02 X90. Y-70. I-40. J-30.", "X50. Y-100.")},
    {"TS11, clockwise arc about (140,-30), inner: V = (40 - 20 sqrt 5, 10, 0) = (-4.721359549995793928, 10, 0).",
     TS11("G02 X170. Y10. I40. J-30.", "X210. Y-20.")},
    {"TS11, counter-clockwise arc about (60,30), inner: V = (20 sqrt 3 - 40, 10, 0) = (-5.358983848622454129, 10, 0).",
     TS11("G03 X90. Y70. I-40. J30.", "X50. Y100.")},
    {"TS11 under G43.5, the arc by R, acute: (10, 10, 0), (14, 2, 0), (8, -6, 0).", VECTOR("", "10", BEFORE_X),
     UNTILTED "G90 G17 G01 G41.6 D1 X0 Y0 F1000\nX100.\nG02 X30. Y-10. R50.\nG01 G40 X-10. Y20.\n"},

    // What is decided at each corner separately.
    {"Whether a block moves is decided at each corner separately: line 6 moves along the tool (0, 1, 0) of line 5 and "
     "turns it to (-4, 4, 7)/9. The corner at the end of line 5 skips line 6. Line 6 ends at (46.516308380, "
     "83.483691620, 46.018638149).",
     VECTOR("\"5008#0\" = 1\n", "5", ""),
     "G43.5 H0 P0\nG00 X-50 Y0 Z0 J1 K0\nG41.6 G01 D1 X0 Z0 F1000\nX50\nZ50\nY80 I-4 J4 K7\nX100\n"},
    {"No. 19630 is compared at each corner separately: line 4 is 29 long in the plane of line 3, but 5.8 in its own "
     "plane. This is below the limit of 12, and line 4 keeps the vector.",
     "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"A\", \"B\", \"C\"]\n[parameters]\n19680 = 2\n19681 = 6\n"
     "19682 = 3\n19686 = 5\n19687 = 2\n\"5008#0\" = 1\n\"19605#5\" = 1\n19630 = 12\n[offsets.D]\n1 = \"3.25\"\n",
     "G90 G43.4 H0\nG00 X-34.151 Y-80 Z-4 B5 C42.882\nG41.2 G01 D1 X-34.151 Y-55 Z-4 F1000\n"
     "G01 X-10.739 Y-33 Z26.445 B54 C44.786\nX60\n"},
};

#undef VECTOR
#undef HEAD
#undef HEAD_A
#undef TYPE_B
#undef TYPE_C
#undef BEFORE_X
#undef BEFORE_Y
#undef UNTILTED
#undef TILTED
#undef TILT_B
#undef TS1
#undef TS2
#undef TS3
#undef TS6
#undef START
#undef START_C
#undef OBTUSE
#undef ACUTE
#undef CANCEL
#undef FIGURE
#undef AWAY
#undef TS8
#undef TS9
#undef TS9C
#undef TS10
#undef TS11

}  // namespace

std::span<const Example> tool_side_compensation_examples() { return kExamples; }

}  // namespace toolcomp::corpus
