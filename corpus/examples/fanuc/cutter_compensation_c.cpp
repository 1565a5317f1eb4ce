// SPDX-License-Identifier: Apache-2.0
// Cutter compensation C: the manual's program of 14.5, start-up (14.6.2) and cancel (14.6.4).
#include "corpus/examples.h"

namespace toolcomp::corpus {
namespace {

#define CUTTER(parameters, d) \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[parameters]\n" parameters "[offsets.D]\n" d "\n"
#define TYPE_B "\"5003#0\" = 1\n"
#define SUV "\"5003#1\" = 1\n"

#define FIGURE(start, cancel)                                                                          \
  "G92 X0 Y0 Z0\nN1 G90 G17 G00 " start                                                                \
  " D07 X250.0 Y550.0\nN2 G01 Y900.0 F150\nN3 X450.0\n"                                                \
  "N4 G03 X500.0 Y1150.0 R650.0\nN5 G02 X900.0 R-250.0\nN6 G03 X950.0 Y900.0 R650.0\nN7 G01 X1150.0\n" \
  "N8 Y550.0\nN9 X700.0 Y650.0\nN10 X250.0 Y550.0\nN11 G00 " cancel " X0 Y0\n"

// The start-up block A from (0, 0) to (40, 0), then B.
#define START(side, b) "G17 G90 G01 F100 " side " D1 X40.\n" b "\n"
#define START_A(side, b) CUTTER("", "1 = 10"), START(side, b)
#define START_B(side, b) CUTTER(TYPE_B, "1 = 10"), START(side, b)

// In offset mode from (-40, 0): A from (0, 0) to (40, 0), then the cancel block B.
#define FROM(x, y) "\n[position]\nX = " x "\nY = " y
#define LINE_A "G17 G90 G01 F100 G41 D1 X0 Y0\nX40.\n"
#define CANCEL_A(b) CUTTER("", "1 = 10" FROM("-40", "0")), LINE_A b "\n"
#define CANCEL_B(b) CUTTER(TYPE_B, "1 = 10" FROM("-40", "0")), LINE_A b "\n"
// A is an arc: to (60, -40), then about (10, -40); to (0, -20), then about (0, 30); to (0, 80), then about (0, 30).
#define OBTUSE_ARC "G17 G90 G01 F100 G42 D1 X60. Y-40.\nG03 X40. Y0 I-50. J0\nG01 G40 X0 Y0\n"
#define ACUTE_ARC "G17 G90 G01 F100 G42 D1 X0 Y-20.\nG03 X40. Y0 I0 J50.\nG01 G40 X0 Y0\n"
#define INNER_ARC "G17 G90 G01 F100 G42 D1 X0 Y80.\nG02 X40. Y0 I0 J-50.\nG01 G40 X0 Y0\n"

constexpr Example kExamples[] = {
    {"14.5, D07 = 10: (240,550) (240,910) (443.295878967653,910) (489.9915665097066,1146.714456444996) "
     "(910.0084334902934,1146.714456444996) (956.704121032347,910) (1160,910) (1160,540) "
     "(1157.592566023653,538.0688248199739) (700,639.756061714119) (252.1693045781866,540.2381293981605) (0,0).",
     CUTTER("", "7 = 10"), FIGURE("G41", "G40")},
    {"14.5, D07 = 20: (230,550) (230,920) (436.5151319446072,920) (479.9666946292995,1143.522063767303) "
     "(920.0333053707005,1143.522063767303) (963.4848680553928,920) (1170,920) (1170,530) "
     "(1165.185132047306,526.1376496399478) (700,629.512123428238) (254.3386091563731,530.4762587963209) (0,0).",
     CUTTER("", "7 = 20"), FIGURE("G41", "G40")},
    {"14.5, D07 = -10, sides exchanged: (260,550) (260,890) (456.6666666666667,890), corner (459.2307692307692, "
     "896.1538461538462), (510,1150), corners (510,1153.333333333333) (508,1156), (892,1156), corners "
     "(890,1153.333333333333) (890,1150), (940.7692307692308,896.1538461538462), corner (943.3333333333333,890), "
     "(1140,890) (1140,562.4661605081032) (700,660.243938285881) (247.8306954218134,559.7618706018395) (0,0).",
     CUTTER("", "7 = -10"), FIGURE("G41", "G40")},
    {"14.5 check iii, G42 with D07 = 10 gives what G41 gives with -10.", CUTTER("", "7 = 10"), FIGURE("G42", "G40")},
    {"14.5 check iv, D00 in N11 cancels as G40 does.", CUTTER("", "7 = 10"), FIGURE("G41", "D00")},
    {"14.5 check v, an arc as start-up block: PS0034 at N1.", CUTTER("", "7 = 10"),
     "N1 G90 G17 G02 G41 D07 X250.0 Y550.0 R400.0 F150\nN2 G01 Y900.0\n"},

    {"14.6.2 #1, type A, inner: (30,0).", START_A("G41", "X40. Y30.")},
    {"14.6.2 #2, type A, straight on: (40,10).", START_A("G41", "X80. Y0")},
    {"14.6.2 #3, type A, exactly 90: (50,0).", START_A("G41", "X40. Y-30.")},
    {"14.6.2 #4, type A, obtuse: (46,8).", START_A("G41", "X80. Y-30.")},
    {"14.6.2 #7, type A, acute: (48,6).", START_A("G42", "X10. Y40.")},
    {"14.6.2 #8, type A, obtuse with an arc: (46,8).", START_A("G41", "G02 X60. Y-40. I-30. J-40.")},
    {"14.6.2 #10, type A, acute with an arc: (48,-6).", START_A("G41", "G02 X0 Y-20. I-40. J30.")},
    {"14.6.2 #11, type A, below 1 degree: (100.099995000375,-9.999500037496875).", CUTTER("", "1 = 10"),
     "G17 G90 G01 F100 G41 D1 X100.\nX0 Y-1.\n"},
    {"14.6.2 #1, type B, inner: (30,0).", START_B("G41", "X40. Y30.")},
    {"14.6.2 #2, type B, straight on: (40,10).", START_B("G41", "X80. Y0")},
    {"14.6.2 #3, type B, exactly 90: (40,10) (50,10).", START_B("G41", "X40. Y-30.")},
    {"14.6.2 #4, type B, obtuse: (40,10) (43.33333333333333,10).", START_B("G41", "X80. Y-30.")},
    {"14.6.2 #7, type B, acute: (40,-10) (50,-10) (54,-2).", START_B("G42", "X10. Y40.")},
    {"14.6.2 #8, type B, obtuse with an arc: (40,10) (43.33333333333333,10) (46,8).",
     START_B("G41", "G02 X60. Y-40. I-30. J-40.")},
    {"14.6.2 #10, type B, acute with an arc: (40,10) (50,10) (54,2) (48,-6).",
     START_B("G41", "G02 X0 Y-20. I-40. J30.")},
    {"14.6.2 #11, type B, below 1 degree: the one vector of type A.", CUTTER(TYPE_B, "1 = 10"),
     "G17 G90 G01 F100 G41 D1 X100.\nX0 Y-1.\n"},
    {"14.6.2, SUV = 0: a lone G41 moves nothing, the next block is the start-up block: (40,10).", CUTTER("", "1 = 10"),
     "G17 G90 G01 F100\nG41 D1\nX40.\nX80.\n"},
    {"14.6.2, SUV = 1: a lone G41 moves to the head of the vector perpendicular to the next movement, (0,10), and a "
     "lone G40 removes the vector at once, (80,0).",
     CUTTER(SUV, "1 = 10"), "G17 G90 G01 F100\nG41 D1\nX40.\nX80.\nG40\nX90.\n"},
    {"14.6.2, 5003#1 = 1: a second lone G41, after one whose look-ahead ended without a block that moves: start-up at "
     "line 4 to (-1.6,1.2).",
     CUTTER(SUV, "1 = 2"), "G90 G00 X0 Y0\nG41 D1\nM05\nG41 D1\nG01 X30. Y40. F100\nX60. Y80.\n"},

    {"14.6.4 #1, type A, inner: (40,10).", CANCEL_A("G40 X40. Y30.")},
    {"14.6.4 #2, type A, exactly 90: (40,10).", CANCEL_A("G40 X40. Y-30.")},
    {"14.6.4 #3, type A, obtuse: (40,10).", CANCEL_A("G40 X80. Y-30.")},
    {"14.6.4 #4, type A, acute: (40,10).", CANCEL_A("G40 X10. Y-40.")},
    {"14.6.4 #5, type A, 135 degrees: (40,10).", CANCEL_A("G40 X70. Y-30.")},
    {"14.6.4 #6, type A, below 1 degree: (100,10).", CUTTER("", "1 = 10" FROM("-40", "0")),
     "G17 G90 G01 F100 G41 D1 X0 Y0\nX100.\nG40 X0 Y-1.\n"},
    {"14.6.4 #7, type A, obtuse after an arc: (46,8).", CUTTER("", "1 = 10" FROM("60", "-80")), OBTUSE_ARC},
    {"14.6.4 #8, type A, acute after an arc: (48,-6).", CUTTER("", "1 = 10" FROM("-40", "-20")), ACUTE_ARC},
    {"14.6.4 #9, type A, inner after an arc: (32,6).", CUTTER("", "1 = 10" FROM("-40", "80")), INNER_ARC},
    {"14.6.4 #1, type B, inner: (40,10).", CANCEL_B("G40 X40. Y30.")},
    {"14.6.4 #2, type B, exactly 90: (50,10) (50,0).", CANCEL_B("G40 X40. Y-30.")},
    {"14.6.4 #3, type B, obtuse: (43.33333333333333,10) (46,8).", CANCEL_B("G40 X80. Y-30.")},
    {"14.6.4 #4, type B, acute: (50,10) (54,2) (48,-6).", CANCEL_B("G40 X10. Y-40.")},
    {"14.6.4 #5, type B, 135 degrees: (44.14213562373095,10) (47.07106781186548,7.071067811865475).",
     CANCEL_B("G40 X70. Y-30.")},
    {"14.6.4 #6, type B, below 1 degree: the one vector of type A.", CUTTER(TYPE_B, "1 = 10" FROM("-40", "0")),
     "G17 G90 G01 F100 G41 D1 X0 Y0\nX100.\nG40 X0 Y-1.\n"},
    {"14.6.4 #7, type B, obtuse after an arc: (46,8) (43.33333333333333,10) (40,10).",
     CUTTER(TYPE_B, "1 = 10" FROM("60", "-80")), OBTUSE_ARC},
    {"14.6.4 #8, type B, acute after an arc: (48,-6) (54,2) (50,10) (40,10).",
     CUTTER(TYPE_B, "1 = 10" FROM("-40", "-20")), ACUTE_ARC},
    {"14.6.4 #9, type B, inner after an arc: (32,6).", CUTTER(TYPE_B, "1 = 10" FROM("-40", "80")), INNER_ARC},
    {"14.6.4 #10, G40 alone, then a move: N6 ends at (40,10), N8 goes to (40,-30).",
     CUTTER("", "1 = 10" FROM("-40", "0")), "G17 G90 G01 F100 G41 D1 X0 Y0\nN6 X40.\nN7 G40\nN8 X40. Y-30.\n"},
    {"14.6.4, an arc as cancel block: PS0034.", CANCEL_A("G40 G02 X60. Y-20. R20.")},
};

#undef CUTTER
#undef TYPE_B
#undef SUV
#undef FIGURE
#undef START
#undef START_A
#undef START_B
#undef FROM
#undef LINE_A
#undef CANCEL_A
#undef CANCEL_B
#undef OBTUSE_ARC
#undef ACUTE_ARC
#undef INNER_ARC

}  // namespace

std::span<const Example> cutter_compensation_c_examples() { return kExamples; }

}  // namespace toolcomp::corpus
