// SPDX-License-Identifier: Apache-2.0
// The programmed contour: examples worked out by hand, and the same contact with and without it.
#include "corpus/examples/heidenhain/tools.h"

namespace toolcomp::corpus {
namespace {

#define BLOCK_11(side) "11 L " FLANK_P_11 " C-267.9784 B-20.0115 " side " M128\n"

constexpr Example kExamples[] = {
    {"E9 and E10 under RL: blocks 11 and 13 beside the contour by the full radius of 5.9.", TOOL_1(END_MILL),
     "10 TOOL CALL 1 Z\n" CONTOUR BLOCK_11("RL") "13 LN " FLANK_P_12 " " FLANK_T "\n"},
    {"E9 and E10 under RR.", TOOL_1(END_MILL),
     "10 TOOL CALL 1 Z\n" CONTOUR BLOCK_11("RR") "13 LN " FLANK_P_12 " " FLANK_T "\n"},
    {"E13: normal and tool along Z: the tip is the programmed point.", TOOL_1(TOROID_E11),
     "TOOL CALL 1 Z\n" CONTOUR "M128\nLN X10 Y20 Z5 NX0 NY0 NZ1 TX0 TY0 TZ1\n"},
    {"E16: the tool touches at the programmed point: TIP' = (223/50, 0, -21/50).", TOOL_1(TOROID_E16),
     "TOOL CALL 1 Z\n" CONTOUR "LN X0 Y0 Z0 NX0.6 NY0 NZ0.8 M107\n"},
    {"E16 at its contact point under OFF, q = (-4.2, 0, 0.4): the tip is the same as under OFF, TIP' = (13/50, 0, "
     "-1/50).",
     TOOL_1(TOROID_E16), "TOOL CALL 1 Z\n" CONTOUR "LN X-4.2 Y0 Z0.4 NX0.6 NY0 NZ0.8 M107\n"},
    {"Block 13 of face milling at the contact point of E1, rounded to 15 decimals: the tip of E1.", TOOL_1(REWORKED),
     "TOOL CALL 1 Z\n" CONTOUR "LN X+37.405832093293828 Y+8.144653760860809 Z-2.310969632306029 " FACE_N " " FACE_T
     " R0 M128\n"},
};

#undef BLOCK_11

}  // namespace

std::span<const Example> programmed_contour_examples() { return kExamples; }

}  // namespace toolcomp::corpus
