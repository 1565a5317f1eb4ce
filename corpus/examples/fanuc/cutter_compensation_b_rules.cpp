// SPDX-License-Identifier: Apache-2.0
// Cutter compensation B: one program for each rule that generated programs seldom meet.
#include "corpus/examples.h"

namespace toolcomp::corpus {
namespace {

#define CUTTER_B \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\ncutter_compensation = \"B\"\n[offsets.D]\n1 = 10\n2 = 4\n"
#define LINE "G01 F100 G41 X40. D1\n"

constexpr Example kRules[] = {
    {"I0 J0 gives no direction: the vector (0, 10) is kept, and (40, 30) becomes the head (40, 40).", CUTTER_B,
     LINE "Y30. I0 J0\n",
     "1 s G1 40 10\n"
     "2 p G1 40 40\n"},
    {"A travel of zero keeps the vector: the head is (40, 10) twice.", CUTTER_B, LINE "G91 X0\n",
     "1 s G1 40 10\n"
     "2 p G1 40 10\n"},
    {"The code of the side is programmed again: heads (40, 10), then (30, 30).", CUTTER_B, LINE "G41 Y30.\n",
     "1 s G1 40 10\n"
     "2 p G1 30 30\n"},
    {"A new D number in an arc block: PS0034.", CUTTER_B, LINE "G02 X60. R10. D2\n",
     "1 s G1 40 10\n"
     "2 PS0034\n"},
    {"A tangent arc of R10 on the inside with an offset of 10: the tool stays at the centre (40, 10), the sweep is "
     "zero.",
     CUTTER_B, LINE "G03 X50. Y10. I0 J10.\n",
     "1 s G1 40 10\n"
     "2 p G3 40 10 O 40 10\n"},
    {"An arc that ends at its centre: PS0038.", CUTTER_B, LINE "G03 X60. Y0 I20. J0\n",
     "1 s G1 40 10\n"
     "2 PS0038\n"},
    {"G53 of an axis outside the plane keeps the vector: (40, 10) at Z5, then (80, 10).", CUTTER_B,
     LINE "G53 Z5.\nX80.\n",
     "1 s G1 40 10 0\n"
     "2 p G0 40 10 5\n"
     "3 p G1 80 10 5\n"},
    {"The vector (-10, 0) at the end of a line along Y is not radial for the arc after it: the tool runs a spiral "
     "about (40, 50), from (30, 10) at a distance of sqrt 1700 = 41.2310562561766 to (80, 50) at a distance of 40.",
     CUTTER_B, "G01 F100 G41 X40. Y-10. D1\nY10.\nG03 X90. Y50. I0 J40.\n",
     // The start-up: d times the left normal of (40, -10).
     "1 s G1 42.42535625036333 -0.298574998546681\n"
     "2 p G1 30 10\n"
     "3 p G3 80 50 O 40 50 r 41.2310562561766 40\n"},
};

#undef CUTTER_B
#undef LINE

}  // namespace

std::span<const Example> cutter_compensation_b_rules() { return kRules; }

}  // namespace toolcomp::corpus
