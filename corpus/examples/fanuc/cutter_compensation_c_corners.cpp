// SPDX-License-Identifier: Apache-2.0
// Cutter compensation C, corners in offset mode: the vector table and the examples of 14.6.3, and the other planes.
#include "corpus/examples.h"

namespace toolcomp::corpus {
namespace {

#define CUTTER(parameters, d, x, y)                                                                \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[parameters]\n" parameters "[offsets.D]\n" d \
  "\n"                                                                                             \
  "[position]\nX = " x "\nY = " y "\n"
// From (-40, 0), with a head at (0, 10): A from (0, 0) to (40, 0), then B.
#define A_LINE(b) CUTTER("", "1 = 10", "-40", "0"), "G17 G90 G01 F100 G41 D1 X0 Y0\nX40.\n" b "\n"
#define G42_LINE(parameters, x, y, path) CUTTER(parameters, "1 = 10", x, y), "G17 G90 G01 F100 G42 D1 " path "\n"
#define DROP(limit) \
  CUTTER("5010 = \"" limit "\"\n", "1 = 10", "-40", "0"), "G17 G90 G01 F100 G41 D1 X0 Y0\nX40.\nX20. Y-99.\n"
#define ROUND(limit)                                    \
  CUTTER("5010 = \"" limit "\"\n", "1 = 10", "0", "0"), \
      "G17 G90 G01 F100 G41 D1 X15. Y20.\nN5 X30. Y40.\nN6 G02 J-60.\n"
#define TURN(parameters)                                                    \
  CUTTER(parameters, "1 = 10", "60", "0"),                                  \
      "G17 G90 G01 F100 G41 D1 X100.\nG02 J-60.\nG01 G40 X70. Y-30. I-10. " \
      "J-10.\n"

constexpr Example kExamples[] = {
    {"14.6.3 #1, inner: (35,10).", A_LINE("X64. Y32.")},
    {"14.6.3 #2, inner at right angles: (30,10).", A_LINE("X40. Y30.")},
    {"14.6.3 #3, inner 45 degrees: (35.85786437626905,10).", A_LINE("X70. Y30.")},
    {"14.6.3 #5, exactly 90: one vector, (50,10).", A_LINE("X40. Y-30.")},
    {"14.6.3 #6, acute: (50,10) (54,2).", A_LINE("X10. Y-40.")},
    {"14.6.3 #8, reversal: the tool goes round the end, (50,10) (50,-10).", A_LINE("X0 Y0")},
    {"14.6.3 #9, line and arc, inner: (34.64101615137755,10).", A_LINE("G03 X0 Y80. I-40. J30.")},
    {"14.6.3 #9, the same with an offset of 17.5: (30,17.5).", CUTTER("", "1 = \"17.5\"", "-40", "0"),
     "G17 G90 G01 F100 G41 D1 X0 Y0\nX40.\nG03 X0 Y80. I-40. J30.\n"},
    {"14.6.3 #11, line and arc, obtuse: (43.33333333333333,10) (46,8).", A_LINE("G02 X60. Y-40. I-30. J-40.")},
    {"14.6.3 #12, line and arc, acute: (50,10) (54,2) (48,-6).", A_LINE("G02 X0 Y-20. I-40. J30.")},
    {"14.6.3 #13, arc and line, obtuse: (46,8) (43.33333333333333,10).",
     G42_LINE("", "60", "-80", "X60. Y-40.\nG03 X40. Y0 I-50. J0\nG01 X0 Y0")},
    {"14.6.3 #14, arc and line, acute: (48,-6) (54,2) (50,10).",
     G42_LINE("", "-40", "-20", "X0 Y-20.\nG03 X40. Y0 I0 J50.\nG01 X0 Y0")},
    {"14.6.3, arc and line, inner: (34.64101615137755,10).",
     G42_LINE("", "-40", "80", "X0 Y80.\nG02 X40. Y0 I0 J-50.\nG01 X0 Y0")},
    {"14.6.3 #15, arc and arc, obtuse: (-2.8,33.6) (0,34.41666666666667) (2.8,33.6).",
     CUTTER("", "1 = 10", "24", "-31"),
     "G17 G90 G01 F100 G41 D1 X0 Y-24.\nG02 X0 Y24. I7. J24.\nX0 Y-24. I-7. J-24.\n"},
    {"14.6.3, arc and arc, acute: (40,10) (50,10) (54,2) (48,-6).", CUTTER("", "1 = 10", "-10", "-90"),
     "G17 G90 G01 F100 G41 D1 X-10. Y-50.\nG02 X40. Y0 I50. J0\nX0 Y-20. I-40. J30.\n"},
    {"14.6.3, tangent joins of line, arc and line: one perpendicular vector each, (40,10) (60,30) (60,60).",
     A_LINE("G03 X70. Y30. I0 J30.\nG01 Y60.")},
    {"14.6.3 #18, change of direction: (50,10).", A_LINE("G42 X40. Y30.")},
    {"14.6.3 #19, change of direction in a U-turn: (40,10).", A_LINE("G42 X0 Y0")},
    {"14.6.3 #20, change of direction straight on, no intersection: (40,-10).", A_LINE("G42 X80. Y0")},
    {"14.6.3 #22, change of direction, line and arc: (56.5685424949238,10).", A_LINE("G42 G03 X0 Y80. I-40. J30.")},
    {"14.6.3 #23, change of direction, tangent: (40,-10).", A_LINE("G42 G03 X70. Y30. I0 J30.")},
    {"14.6.3, the sign of D changes: the side changes without G41 or G42, straight on, (40,-10).",
     CUTTER("", "1 = 10\n2 = -10", "-40", "0"), "G17 G90 G01 F100 G41 D1 X0 Y0\nX40.\nX80. D2\n"},
    {"14.6.3 #25, one M code between A and B: (30,10) (30,40).", A_LINE("M05\nY30.\nX80.")},
    {"14.6.3 #25, two M codes between A and B: A ends at (40,10), B goes from there to (30,40).",
     A_LINE("M05\nM03\nY30.\nX80.")},
    {"14.6.3, G91 X0 between A and B counts as two blocks: A ends at (40,10), B goes from there to (30,40).",
     A_LINE("G91 X0\nG90 Y30.\nX80.")},
    {"14.6.3, one Z block between A and B: Z moves at the head (30,10).", A_LINE("Z-5.\nY30.\nX80.")},
    {"14.6.3 #26, G41 again: A ends at (40,10).", A_LINE("G41 X40. Y30.")},
    {"14.6.3 #27, another D at B: corner A/B with 10, (50,10), corner B/C with 5, (45,-45).",
     CUTTER("", "1 = 10\n2 = 5", "-40", "0"), "G17 G90 G01 F100 G41 D1 X0 Y0\nX40.\nX40. Y-40. D2\nX0\n"},
    {"14.6.3 #28, No. 5010 = 2.2: the second vector (51.78217821782178,7.821782178217822) is dropped.", DROP("2.2")},
    {"14.6.3 #28, No. 5010 = 2: both vectors stay.", DROP("2")},
    {"14.6.3 #29, a full circle after a line: (25,50) (30,50).", ROUND("0")},
    {"14.6.3 #29, No. 5010 = 5: a vector before an arc of half a circle or more is not dropped.", ROUND("5")},
    {"14.6.3 #31, CNI = 1, G40 with I-10 J-10 after a full circle: the circle ends at "
     "(120.937502231726,6.795366607995099), after a sweep of only 17.4039858696496 degrees.",
     TURN("\"5008#0\" = 1\n")},
    {"14.6.5 #9, the same with the interference check: PS0041.", TURN("")},
    {"14.6.3 #32, the end is not on the arc: (105,-50), the radius grows from 60 to 65.",
     CUTTER("", "1 = 10", "0", "0"), "G17 G90 G01 F100 G41 D1 X40.\nG02 X95. Y-50. I0 J-50.\n"},
    {"14.6.3, no intersection: the offset line and the offset circle do not meet, PS0033 at A.",
     A_LINE("G03 X16. Y-10. I-12. J-5.")},
    {"14.6.3, G40 with I0 J0 is an ordinary cancel: (40,10).", A_LINE("G40 X40. Y-30. I0 J0")},
    {"14.6.3, G40 with I0 J-10 after a line: the vector (50,10), then to (80,-30).", A_LINE("G40 X80. Y-30. I0 J-10.")},
    {"14.5, G18: the first axis is Z, the second X. The inner corner #2 at Z40: Z30 X10.",
     "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[offsets.D]\n1 = 10\n[position]\nZ = -40\n",
     "G18 G90 G01 F100 G41 D1 Z0 X0\nZ40.\nX30.\n"},
    {"14.5, G19: the first axis is Y, the second Z. The inner corner #2 at Y40: Y30 Z10.",
     "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[offsets.D]\n1 = 10\n[position]\nY = -40\n",
     "G19 G90 G01 F100 G41 D1 Y0 Z0\nY40.\nZ30.\n"},
    {"14.5, a helix: the arc of #22 without the change of direction, while Z moves: (34.64101615137755,10), then "
     "(0,70) at Z8.",
     A_LINE("G03 X0 Y80. Z8. I-40. J30.")},
    {"14.5, a spiral from radius 5 m to 2 m, with larger numbers than usual: from (-1397.2,4790.4) to (-1990,0).",
     CUTTER("", "1 = 10", "-344", "5108"),
     "G17 G90 G01 F100 G41 D1 X-440. Y5080.\nX-1400. Y4800.\nG03 X-2000. Y0 I1400. J-4800.\nG01 Y-1000.\n"},
    {"14.5, the plane changes under G41: PS0037.", A_LINE("G18 X50.")},
    {"14.8, memory A: G10 L11 P3 R12 sets D3 too: (0,12) (40,12).", CUTTER("", "3 = 1", "-40", "0"),
     "G10 L11 P3 R12\nG17 G90 G01 F100 G41 D3 X0 Y0\nX40.\n"},
};

#undef CUTTER
#undef A_LINE
#undef G42_LINE
#undef DROP
#undef ROUND
#undef TURN

}  // namespace

std::span<const Example> cutter_compensation_c_corners() { return kExamples; }

}  // namespace toolcomp::corpus
