// SPDX-License-Identifier: Apache-2.0
// Cutter compensation C: one program for each rule that generated programs seldom meet, or that leaves the run
// undecided.
#include "corpus/examples.h"

namespace toolcomp::corpus {
namespace {

#define CUTTER(parameters, d, x, y)                                                                    \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[parameters]\n" parameters "[offsets.D]\n1 = " d \
  "\n"                                                                                                 \
  "[position]\nX = " x "\nY = " y "\n"
// From (-40, 0), with a head at (0, 10): A from (0, 0) to (40, 0), then the rest.
#define A_LINE(rest) CUTTER("", "10", "-40", "0"), "G17 G90 G01 F100 G41 D1 X0 Y0\nX40.\n" rest "\n"
#define A_WITH(parameters, rest) CUTTER(parameters, "10", "-40", "0"), "G17 G90 G01 F100 G41 D1 X0 Y0\nX40.\n" rest "\n"
#define A_30I(parameters, rest)                                                                    \
  "control = \"fanuc\"\nseries = \"30i\"\naxes = [\"X\", \"Y\", \"Z\"]\n[parameters]\n" parameters \
  "[offsets.D]\n1 = 10\n[position]\nX = -40\nY = 0\n",                                             \
      "G17 G90 G01 F100 G41 D1 X0 Y0\nX40.\n" rest "\n"
#define CNC "\"5008#1\" = 1\n"
#define CNV "\"5008#3\" = 1\n"
// B and C after A: groups (50,10) (54,2) and (57,6). Both pairs of vectors interfere in B.
#define NOTCH "X37. Y-4.\nX80."
// An arc of R5 between (50,10) (50,0) and (40,0) (40,10) (60,10).
#define SMALL_ARC "G03 X50. Y0 I5. J0\nG01 Y-20."
#define A_CCN(rest) CUTTER("\"5003#2\" = 1\n", "10", "-40", "0"), "G17 G90 G01 F100 G41 D1 X0 Y0\nX40.\n" rest "\n"
// The same with parameters.
#define A_READS(parameters, rest) \
  CUTTER(parameters, "10", "-40", "0"), "G17 G90 G01 F100 G41 D1 X0 Y0\nX40.\n" rest "\n"
// The program of the manual's figure, from (0, 0).
#define READS(parameters) \
  CUTTER(parameters, "10", "0", "0"), "G17 G91 G01 F100 G41 D1 X10. Y10.\nX100. Y100.\nS21\nG04 X10.\nX100.\n"
#define SERIES_30I "series = \"30i\"\n"

constexpr Example kRules[] = {
    {"G41 again after a lone G40, before the vector is removed: undecided.", A_LINE("G40\nG41\nX60.")},
    {"Two blocks without motion after G39: undecided.", A_LINE("G39\nM05\nM03\nY30.")},
    {"G39 followed by the end of the program makes no arc: (40,10).", A_LINE("G39")},
    {"G41.3 without a D number after G42 without a D number, in a block with G10: G10 writes one value, then Z moves "
     "to 275.7.",
     "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[offsets.H]\n1 = 15\n",
     "G90 G01 F100 G42 X177.\nG41.3 G10 L11 P1 R.7\nG43 Z275. H1\n"},
    {"G92 of an axis of the plane under G41: A ends at its programmed point (40,0), which is (0,0) after G92. The next "
     "block ends at (60,10).",
     A_LINE("G92 X0\nX60.")},
    {"14.6.3, G92 after an acute corner: (294.7477426856111,713.1306432859723) (304.4721359549996,713.4164078649987), "
     "then the programmed point (600,100), which is (100,200) after G92, then the vector of N8.",
     CUTTER("", "10", "-30", "-70"),
     "N4 G17 G91 G01 F100 G41 D1 X30. Y70.\nN5 X300. Y700.\nN6 X300. Y-600.\nN7 G92 X100. Y200.\n"
     "N8 G01 X400. Y800.\n"},
    {"G92 after the start-up block: this block too ends at its programmed point. The block after G92 ends at its inner "
     "corner.",
     CUTTER("", "10", "-40", "0"), "G17 G90 G01 F100 G41 D1 X0 Y0\nG92 X100.\nX140.\nY50.\n"},
    {"G52 after one block without motion: A also ends at its programmed point, which is (60,0) after G52. The next "
     "block ends at (40,-10).",
     A_LINE("M05\nG52 X-20.\nX40.")},
    {"G92 before an arc: from (0,0), at a distance of 30 from the centre, the tool runs a spiral to R' = 20.",
     A_LINE("G92 X0\nG03 X30. Y30. J30.")},
    {"G40 in the block of G92: the mode is off, and the next move has the cause `programmed`.",
     A_LINE("G40 G92 X0\nX60.")},
    {"G92 after two blocks without motion, when the tool stands at P1: undecided.", A_LINE("M05\nM03\nG92 X0\nX60.")},
    {"G92 after a lone G40, while the vector is still to be removed: undecided.", A_LINE("G40\nG92 X0\nX60.")},
    {"CNC = 1, a groove of width 15: no alarm, (30,10) (30,5).", A_WITH(CNC, "Y15.\nX0")},
    {"CNC = 1, a notch: (54,2) is dropped. D.D' = -5 with the last pair, but the block runs, (50,10) (57,6).",
     A_WITH(CNC, NOTCH)},
    {"CNC = 1, an arc whose only pair interferes because R' = -2: PS0041 after (40,10).",
     A_WITH(CNC, "G03 X48. Y8. I0 J8.\nG01 Y40.")},
    {"CNV = 1 on series 16i has no effect: vectors are dropped, (50,10) (60,10).", A_WITH(CNV, SMALL_ARC)},
    {"CNV = 1 on series 30i: no vector is dropped, PS0041 after (50,10).", A_30I(CNV, SMALL_ARC)},
    {"CNV = 1 and CNC = 1 on series 30i, a notch: all vectors stay, (50,10) (54,2) (57,6).", A_30I(CNC CNV, NOTCH)},
    {"Offset circles that touch from outside: radii 13 and 15, centres 14 apart, offset 7: 6 + 8 = 14, (6,0).",
     CUTTER("", "7", "-19", "-22"),
     "G17 G90 G01 F100 G41 D1 X5. Y-12.\nG03 X5. Y12. I-5. J12.\nX23. Y-12. I9. J-12.\n"},
    {"Offset circles that touch from inside: radii 15 and 13, centres 14 apart, offset 8: 21 - 7 = 14, (-7,0).",
     CUTTER("", "8", "40", "15"), "G17 G90 G01 F100 G41 D1 X0 Y15.\nG03 X9. Y-12. I0 J-15.\nG02 X14. Y13. I5. J12.\n"},
    {"An offset circle of radius 0 that is not on the offset line: PS0033 at A.", A_LINE("G03 X28. Y16. I-6. J8.")},
    {"G40 with I-10 J0, parallel to the line: (40,10).", A_LINE("G40 X40. Y-30. I-10. J0")},
    {"G40 with I10 J10, 45 degrees to the left: (35.85786437626905,10).", A_LINE("G40 X80. Y-30. I10. J10.")},
    {"G41 with I J K is three-dimensional: PS0010.", A_LINE("G41 X60. I1. J1. K1.")},
    {"An arc that ends at its centre: PS0038. A ends with the perpendicular vector, (40,10).",
     A_LINE("G03 X60. Y0 I20. J0")},
    {"An arc whose centre is its start: PS0038 as well.", A_LINE("G03 X60. Y0 I0 J0")},
    {"G53 of an axis outside the plane keeps the vector: (40,10) at Z5, then (80,10).", A_LINE("G53 Z5.\nX80.")},
    {"G53 of one axis of the plane, CCN = 0: both components of the vector are removed: (100,0).",
     A_LINE("G53 X100.\nX140.")},
    {"G53 of one axis of the plane, CCN = 1: both components are removed as well: (100,0).", A_CCN("G53 X100.\nX140.")},
    {"G28 of one axis of the plane, CCN = 1: the vector is there at the intermediate point (60,10). Both components "
     "are removed at the reference position.",
     A_CCN("G28 X60.")},
    {"G28 with CCN = 1 and no travel to the intermediate point: the vector is kept there, (40,10), then the tool goes "
     "to (0,0).",
     A_CCN("G28 X40. Y0")},
    {"The side changes in the block after the start-up: the start-up block ends with the perpendicular vector, (0,10), "
     "then DIR_CHANGE_AT_STARTUP.",
     CUTTER("", "10", "-40", "0"), "G17 G90 G01 F100 G41 D1 X0 Y0\nG42 X40. Y30.\n"},

    // How far the control reads ahead.
    {"M00 stops the look-ahead: the block before it ends with the perpendicular vector, (-10,100), not at the corner, "
     "(-10,110).",
     CUTTER("", "10", "0", "0"), "G17 G91 G01 G41 D1 Y50. F100\nY50.\nM00\nX50.\n",
     "1 s G1 -10 50\n2 p G1 -10 100\n4 p G1 50 110\n"},
    {"G53 without an axis word stops the look-ahead too: (40,10), not (30,10).", A_LINE("G53\nY30."),
     "1 s G1 0 10\n2 p G1 40 10\n4 p G1 30 30\n"},
    {"M08 stops the look-ahead if No. 3411 is 8: (40,10).", A_READS("3411 = 8\n", "M08\nY30."),
     "1 s G1 0 10\n2 p G1 40 10\n4 p G1 30 30\n"},
    {"M08 stops the look-ahead if it is in the range from No. 3431 to No. 3432: (40,10).",
     A_READS("3431 = 7\n3432 = 8\n", "M08\nY30."), "1 s G1 0 10\n2 p G1 40 10\n4 p G1 30 30\n"},
    {"M08 does not stop the look-ahead if it is above the range from No. 3421 to No. 3422: (30,10).",
     A_READS("3421 = 5\n3422 = 7\n", "M08\nY30."), "1 s G1 0 10\n2 p G1 30 10\n4 p G1 30 30\n"},
    {"A block that stops the look-ahead and moves: the corner before it is made, (30,10), and the block itself ends "
     "with the perpendicular vector, (30,30).",
     A_READS("3411 = 8\n", "Y30. M08\nX20."), "1 s G1 0 10\n2 p G1 30 10\n3 p G1 30 30\n4 p G1 20 20\n"},
    {"G39 before M01 makes no arc.", A_LINE("G39\nM01\nY30."), "1 s G1 0 10\n2 p G1 40 10\n5 p G1 30 30\n"},
    {"Two blocks without motion, 16i: the perpendicular vector, (110,110) + 10 (-1,1)/sqrt 2.", READS(""),
     "1 s G1 2.9289321881345 17.0710678118655\n2 p G1 102.9289321881345 117.0710678118655\n5 p G1 210 120\n"},
    {"The same with No. 19625, which the 16i does not have.", READS("19625 = 5\n"),
     "1 s G1 2.9289321881345 17.0710678118655\n2 p G1 102.9289321881345 117.0710678118655\n5 p G1 210 120\n"},
    {"The same on the 30i, which reads three blocks.", SERIES_30I READS(""),
     "1 s G1 2.9289321881345 17.0710678118655\n2 p G1 102.9289321881345 117.0710678118655\n5 p G1 210 120\n"},
    {"The 30i reads five blocks: the corner, (110,110) + 10 (1 - sqrt 2,1).", SERIES_30I READS("19625 = 5\n"),
     "1 s G1 2.9289321881345 17.0710678118655\n2 p G1 105.857864376269 120\n5 p G1 210 120\n"},
    {"The 30i reads four blocks: A, two blocks without motion, and B.", SERIES_30I READS("19625 = 4\n"),
     "1 s G1 2.9289321881345 17.0710678118655\n2 p G1 105.857864376269 120\n5 p G1 210 120\n"},
    {"A travel of 0 with an axis word counts as several blocks without motion, however many blocks are read: (40,10).",
     SERIES_30I A_READS("19625 = 8\n", "X40.\nY30."), "1 s G1 0 10\n2 p G1 40 10\n3 p G1 40 10\n4 p G1 30 30\n"},
    {"After a lone G40 an axis word removes the vector, although the travel is 0: (-20,-20). The next pass starts "
     "there.",
     CUTTER("", "4", "-20", "-20"),
     "G17 G90 G01 G41 D1 X0 Y40. F500\nY0\nX80.\nX-20. Y-20.\nG40\nG00 Z5.\nG00 X-20. Y-20.\nG01 G41 X0 Y40.\n",
     "1 s G1 4 40\n2 p G1 4 4\n3 p G1 84 4\n4 c G1 84.7067872433164 -3.1378581622109\n"
     "4 p G1 -19.2155354594473 -23.9223227027637\n6 p G0 -19.2155354594473 -23.9223227027637 5\n7 e G0 -20 -20 5\n"
     "8 s G1 -3.7947331922021 41.2649110640674 5\n"},
    {"After a lone G40, once an axis word has removed the vector, the plane may be changed.",
     A_LINE("G40\nX40. Y0\nG18 X50."), "1 s G1 0 10\n2 p G1 40 10\n4 e G1 40 0\n5 p G1 50 0\n"},
};

#undef CUTTER
#undef A_LINE
#undef A_WITH
#undef A_30I
#undef CNC
#undef CNV
#undef NOTCH
#undef SMALL_ARC
#undef A_CCN
#undef A_READS
#undef READS
#undef SERIES_30I

}  // namespace

std::span<const Example> cutter_compensation_c_rules() { return kRules; }

}  // namespace toolcomp::corpus
