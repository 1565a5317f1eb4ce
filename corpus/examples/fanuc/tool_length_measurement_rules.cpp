// SPDX-License-Identifier: Apache-2.0
// Automatic tool length measurement: one program for each rule that generated programs seldom meet, or that leaves the
// run undecided.
#include "corpus/examples.h"

namespace toolcomp::corpus {
namespace {

#define MEASURE(touch)                                                                                  \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[parameters]\n6241 = 1000\n6251 = 20\n6254 = 5\n" \
  "[position]\nZ = 760\n[measurement]\nZ = \"" touch "\"\n[offsets.H]\n1 = 15\n[offsets.D]\n1 = 10\n"

constexpr Example kRules[] = {
    {"The tool stands on the commanded coordinate: undecided after the move to Z200.", MEASURE("198"),
     "H01\nG00 Z200.\nG37 Z200.\n",
     "2 p G0 0 0 200\n"
     "3 fanuc.length-measurement.start-on-the-coordinate\n"},
    {"The block starts at point B, where the measuring feed begins: there is no rapid part, and the measuring move "
     "goes from 220 to 198.",
     MEASURE("198"), "H01\nG00 Z220.\nG37 Z200.\n",
     "2 p G0 0 0 220\n"
     "3 m G1 0 0 198\n"
     "3 H1=13\n"},
    {"The signal comes on exactly at point B, 220, where the measuring feed would begin. That is too early: no "
     "measuring move, PS0080.",
     MEASURE("220"), "H01\nG37 Z200.\n",
     "2 p G0 0 0 220\n"
     "2 PS0080\n"},
    {"G44 is in force, H1 = 15: at the coordinate 213 the axis reaches the position 198. The formula is the same under "
     "G44, 15 + 13 = 28, but 213 is out of the permitted range: PS0080 at 213.",
     MEASURE("198"), "G44 H01\nG37 Z200.\n",
     "1 p G0 0 0 760\n"
     "2 p G0 0 0 220\n"
     "2 m G1 0 0 213\n"
     "2 PS0080\n"},
    {"G44 is in force, H1 = 15, signal at 183: the axis reaches it at the coordinate 198, and 15 - 2 = 13 is written.",
     MEASURE("183"), "G44 H01\nG37 Z200.\n",
     "1 p G0 0 0 760\n"
     "2 p G0 0 0 220\n"
     "2 m G1 0 0 198\n"
     "2 H1=13\n"},
    {"G43 in the block of G37: MEASUREMENT_FORMAT.", MEASURE("198"), "H01\nG43 G37 Z200.\n", "2 MEASUREMENT_FORMAT\n"},
    {"G43 and H in the block of G37: PS0082.", MEASURE("198"), "G43 G37 Z200. H01\n", "1 PS0082\n"},
    {"G37 in cutter compensation: PS0036.", MEASURE("198"), "H01\nG01 F100 G41 X50. D1\nG37 Z200.\n",
     "2 s G1 50 10\n"
     "3 PS0036\n"},
};

#undef MEASURE

}  // namespace

std::span<const Example> tool_length_measurement_rules() { return kRules; }

}  // namespace toolcomp::corpus
