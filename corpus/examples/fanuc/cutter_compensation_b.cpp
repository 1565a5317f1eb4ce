// SPDX-License-Identifier: Apache-2.0
// Cutter compensation B: the examples of chapter 14, 14.4.
#include "corpus/examples.h"

namespace toolcomp::corpus {
namespace {

#define CUTTER_B(values) \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\ncutter_compensation = \"B\"\n[offsets.D]\n" values "\n"
// The examples with H: with OFH = 1 the number of the cutter also comes from H.
#define BY_H(number, value)                                                          \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\ncutter_compensation = \"B\"\n" \
  "[parameters]\n\"5001#2\" = 1\n[offsets.H]\n" number " = " value "\n"
#define FIGURE                                                                                                \
  "N1 G91 G17 G00 G41 J1. X20. Y20. H08\nN2 G01 Z-25. F100.\nN3 Y40. F250.\nN4 G39 I40. J20.\nN5 X40. Y20.\n" \
  "N6 G39 I40.\nN7 G02 X40. Y-40. R40.\nN8 X-20. Y-20. R20.\nN9 G01 X-60.\nN10 G00 Z25.\nN11 G40 X-20. Y-20.\n"

// Figures that the derivation does not give are worked out by hand: d times the unit normal of a block at its end.
constexpr Example kExamples[] = {
    {"14.4 example 1, G41 from (0, 0) to (30, 40) with an offset of 10: head (22, 46).", BY_H("1", "10"),
     "G00 G41 X30. Y40. H1\n", "1 s G0 22 46\n"},
    {"14.4 example 2, the same with I0 J1: the vector is perpendicular to (0, 1), head (20, 40).", BY_H("1", "10"),
     "G00 G41 X30. Y40. I0 J1. H1\n", "1 s G0 20 40\n"},
    {"14.4 example 3, G42: head (38, 34).", BY_H("1", "10"), "G00 G42 X30. Y40. H1\n", "1 s G0 38 34\n"},
    {"14.4 example 4, G41 with I1 J1: head (30 - 10/sqrt 2, 40 + 10/sqrt 2).", BY_H("1", "10"),
     "G00 G41 X30. Y40. I1. J1. H1\n", "1 s G0 22.92893218813452 47.07106781186548\n"},
    {"14.4 example 6, the manual's figure, H08 = 5: (15,20) (15,60), G39 to (17.76393202250021, 64.47213595499958), "
     "(57.76393202250021, 84.47213595499958), G39 to (60,85), R45 to (105,40), R25 to (80,15), (20,15), (0,0).",
     BY_H("8", "5"), FIGURE,
     "1 s G0 15 20 0\n"
     "2 p G1 15 20 -25\n"
     "3 p G1 15 60 -25\n"
     "4 c G2 17.76393202250021 64.47213595499958 -25 O 20 60 w 63.434948822922\n"
     "5 p G1 57.76393202250021 84.47213595499958 -25\n"
     "6 c G2 60 85 -25 O 60 80\n"
     "7 p G2 105 40 -25 O 60 40 w 90\n"
     "8 p G2 80 15 -25 O 80 40 w 90\n"
     "9 p G1 20 15 -25\n"
     "10 p G0 20 15 0\n"
     "11 e G0 0 0 0\n"},
    {"14.4 example 6 with H08 = 10: (10,20) (10,60), G39 to (15.52786404500042, 68.94427190999916), "
     "(55.52786404500042, 88.94427190999916), G39 to (60,90), R50 to (110,40), R30 to (80,10), (20,10), (0,0).",
     BY_H("8", "10"), FIGURE,
     "1 s G0 10 20 0\n"
     "2 p G1 10 20 -25\n"
     "3 p G1 10 60 -25\n"
     "4 c G2 15.52786404500042 68.94427190999916 -25 O 20 60\n"
     "5 p G1 55.52786404500042 88.94427190999916 -25\n"
     "6 c G2 60 90 -25 O 60 80\n"
     "7 p G2 110 40 -25 O 60 40\n"
     "8 p G2 80 10 -25 O 80 40\n"
     "9 p G1 20 10 -25\n"
     "10 p G0 20 10 0\n"
     "11 e G0 0 0 0\n"},
    {"14.4 example 7, G42 with an offset of 5, G39 I-40 at (0, 60): from (5, 60) counter-clockwise to (0, 65).",
     CUTTER_B("1 = 5"), "G01 F100 G42 Y60. D1\nG39 I-40.\nX-40.\n",
     "1 s G1 5 60\n"
     "2 c G3 0 65 O 0 60\n"
     "3 p G1 -40 65\n"},
    {"14.4 example 8, G41 to G42 with an offset of 10: from (40, 10) straight to (80, -10).", CUTTER_B("1 = 10"),
     "G01 F100 G41 X40. D1\nG42 X80.\n",
     "1 s G1 40 10\n"
     "2 p G1 80 -10\n"},
    {"14.4, G40 alone removes the vector at once: from (40, 10) to (40, 0).", CUTTER_B("1 = 10"),
     "G01 F100 G41 X40. D1\nG40\n",
     "1 s G1 40 10\n"
     "2 e G1 40 0\n"},
    {"14.4, a negative value exchanges G41 and G42: head (38, 34).", CUTTER_B("1 = -10"), "G00 G41 X30. Y40. D1\n",
     "1 s G0 38 34\n"},
    {"14.4, no intersection at a corner: straight from head to head, (40, 10) to (30, 30).", CUTTER_B("1 = 10"),
     "G01 F100 G41 X40. D1\nY30.\n",
     "1 s G1 40 10\n"
     "2 p G1 30 30\n"},
    {"14.4, a block without movement in the plane keeps the vector: (40, 10) at Z5.", CUTTER_B("1 = 10"),
     "G01 F100 G41 X40. D1\nZ5.\n",
     "1 s G1 40 10 0\n"
     "2 p G1 40 10 5\n"},
    {"14.4, another offset value in G01 takes effect at the end of its block: (40, 10), then (80, 4).",
     CUTTER_B("1 = 10\n2 = 4"), "G01 F100 G41 X40. D1\nX80. D2\n",
     "1 s G1 40 10\n"
     "2 p G1 80 4\n"},
    {"14.4, an arc at the start-up: PS0034.", CUTTER_B("1 = 10"), "G02 G41 X40. R20. D1 F100\n", "1 PS0034\n"},
    {"14.4, G39 without G41 or G42: PS0035.", CUTTER_B("1 = 10"), "G01 F100 X10.\nG39 I1.\n",
     "1 p G1 10 0\n"
     "2 PS0035\n"},
    {"14.4, the plane changes under G41: PS0037.", CUTTER_B("1 = 10"), "G01 F100 G41 X40. D1\nG18 X50.\n",
     "1 s G1 40 10\n"
     "2 PS0037\n"},
    {"14.4, G45 under G41: PS0042.", CUTTER_B("1 = 10"), "G01 F100 G41 X40. D1\nG45 X50.\n",
     "1 s G1 40 10\n"
     "2 PS0042\n"},
};

#undef CUTTER_B
#undef BY_H
#undef FIGURE

}  // namespace

std::span<const Example> cutter_compensation_b_examples() { return kExamples; }

}  // namespace toolcomp::corpus
