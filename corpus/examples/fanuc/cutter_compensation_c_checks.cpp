// SPDX-License-Identifier: Apache-2.0
// Cutter compensation C: the interference check (14.6.5, 14.6.6), machine positions (14.6.8) and G39 (14.6.9).
#include "corpus/examples.h"

namespace toolcomp::corpus {
namespace {

#define CUTTER(parameters, d, x)                                                                       \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[parameters]\n" parameters "[offsets.D]\n1 = " d \
  "\n"                                                                                                 \
  "[position]\nX = " x "\n"
// From (-40, 0): A from (0, 0) to (40, 0), then the rest.
#define A_LINE(rest) CUTTER("", "10", "-40"), "G17 G90 G01 F100 G41 D1 X0 Y0\nX40.\n" rest "\n"
#define CCN "\"5003#2\" = 1\n"
#define TYPE_B "\"5003#0\" = 1\n"
#define AFTER(parameters, rest) CUTTER(parameters, "10", "-40"), "G17 G90 G01 F100 G41 D1 X0 Y0\nX40.\n" rest "\n"
#define AFTER_G53(parameters, rest) AFTER(parameters, "G53 X200. Y100.\nX80. Y60.\n" rest)
#define D5 "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[offsets.D]\n1 = 5\n"

constexpr Example kExamples[] = {
    {"14.6.5 #1, a groove of width 15, offset 10: D.D' = -75, PS0041 after (30,10).", A_LINE("Y15.\nX0")},
    {"14.6.5 #2, a groove of exactly twice the offset is cut: (30,10) twice.", A_LINE("Y20.\nX0")},
    {"14.6.5 #3, a groove of 25: (30,10) (30,15).", A_LINE("Y25.\nX0")},
    {"14.6.5 #4, a step of 5: (30,10) (30,15).", A_LINE("Y5.\nX80.")},
    {"14.6.5 #5, a notch: D.D' = -25, and one pair is dropped; D.D' = -5 with the last pair, PS0041 after (50,10).",
     A_LINE("X37. Y-4.\nX80.")},
    {"14.6.5 #6, a tangent arc of R8: R' = -2, PS0041 after (40,10).", A_LINE("G03 X48. Y8. I0 J8.\nG01 Y40.")},
    {"14.6.5 #6, a tangent arc of R10: R' = 0, the tool stands at (40,10).", A_LINE("G03 X50. Y10. I0 J10.\nG01 Y40.")},
    {"14.6.5, vectors dropped: an arc of R5 between the groups (50,10) (50,0) and (40,0) (40,10) (60,10) runs straight "
     "to (60,10).",
     A_LINE("G03 X50. Y0 I5. J0\nG01 Y-20.")},
    {"14.6.5 #1 with CNI = 1: no check, (30,10) (30,5).", AFTER("\"5008#0\" = 1\n", "Y15.\nX0")},

    {"14.6.6 example 1, one Z block after the start-up: the start vector comes from N6, (490,400).",
     CUTTER("", "10", "0"), "N1 G91 G00 G41 X500.0 Y400.0 D1\nN3 G01 Z-300.0 F100\nN6 Y100.0 F200\n"},
    {"14.6.6 example 2, two Z blocks: the vector is perpendicular to N1, (493.7530495244558,407.8086880944303).",
     CUTTER("", "10", "0"), "N1 G91 G00 G41 X500.0 Y400.0 D1\nN3 G01 Z-250.0\nN5 Z-50.0 F100\nN6 Y100.0 F200\n"},
    {"14.6.6 example 3, first a block in the direction of the cut: (490,400) (490,500), then along X490.",
     CUTTER("", "10", "0"),
     "N1 G91 G00 G41 X500.0 Y400.0 D1\nN2 Y100.0\nN3 Z-250.0\nN5 G01 Z-50.0 F100\nN6 Y100.0 F200\n"},

    {"14.6.8 #2, CCN = 0, type A: (40,10), (200,100), start-up to (80,50).", AFTER_G53("", "X0")},
    {"14.6.8 #2, CCN = 0, type B: (83.16227766016838,50.51316701949486) (81.62277660168379,50).",
     AFTER_G53(TYPE_B, "X0")},
    {"14.6.8 #2, CCN = 1: (81.62277660168379,50).", AFTER_G53(CCN, "X0")},
    {"14.6.8 #3, CCN = 0, inner: (90,60).", AFTER_G53("", "Y0")},
    {"14.6.8 #3, CCN = 1: (90,52.79240779943874).", AFTER_G53(CCN, "Y0")},
    {"14.6.8 #4, CCN = 0, type A, acute: (70,60).", AFTER_G53("", "Y160.")},
    {"14.6.8 #4, CCN = 0, type B: (83.16227766016838,50.51316701949486) (73.67544467966324,47.35088935932648) "
     "(70,50).",
     AFTER_G53(TYPE_B, "Y160.")},
    {"14.6.8 #4, CCN = 1: (73.67544467966324,47.35088935932648) (70,50).", AFTER_G53(CCN, "Y160.")},
    {"14.6.8 #5, G28 with CCN = 1: (30,10), intermediate head (30,60), reference position.",
     AFTER(CCN, "G28 X40. Y60.")},
    {"14.6.8 #5, G28 with CCN = 0: (40,10), intermediate point (40,60), reference position.",
     AFTER("", "G28 X40. Y60.")},
    {"14.6.8 #6, G28 with CCN = 1: (43.33333333333333,10), intermediate head (106,-37).",
     AFTER(CCN, "G28 X100. Y-45.")},

    {"14.6.9 #1, G42 and G39: (5,10), arc counter-clockwise to (0,15), N3 along Y15.", D5 "[position]\nY = -10\n",
     "G17 G90 G01 F100 G42 D1 X0 Y0\nN1 Y10.0\nN2 G39\nN3 X-10.0\n"},
    {"14.6.9 #2, G39 I-1 J2: (5,10), arc to (4.472135954999579,12.23606797749979).", D5 "[position]\nY = -10\n",
     "G17 G90 G01 F100 G42 D1 X0 Y0\nN1 Y10.0\nN2 G39 I-1.0 J2.0\nN3 X-10.0 Y20.0\n"},
    {"14.6.9 #3, G41 and G39: (40,10), arc clockwise to (46,8).", A_LINE("G39\nX80. Y-30.")},
    {"14.6.9 #4, G39 I3 J-4: (40,10), arc clockwise to (48,6).", A_LINE("G39 I3. J-4.\nX80. Y-30.")},
    {"14.6.9 #5, an inner corner: (40,5), arc clockwise by 270 degrees to (35,0).", D5 "[position]\nX = -40\n",
     "G17 G90 G01 F100 G41 D1 X0 Y0\nX40.\nG39\nY30.\n"},
    {"14.6.9 #6, straight on: no arc.", A_LINE("G39\nX80.")},
    {"14.6.9, G39 in cancel mode: PS0035.", D5, "G17 G90 G01 F100 X40.\nG39\n"},
};

#undef CUTTER
#undef A_LINE
#undef CCN
#undef TYPE_B
#undef AFTER
#undef AFTER_G53
#undef D5

}  // namespace

std::span<const Example> cutter_compensation_c_checks() { return kExamples; }

}  // namespace toolcomp::corpus
