// SPDX-License-Identifier: Apache-2.0
// Peripheral milling: blocks 11 to 13 of the manual's example, worked out by hand
// (heidenhain.peripheral.example-reworked).
#include "corpus/examples/heidenhain/tools.h"

namespace toolcomp::corpus {
namespace {

#define BLOCK_11(side) "11 L " FLANK_P_11 " C-267.9784 B-20.0115 " side " M128\n"

constexpr Example kExamples[] = {
    {"E8: block 12, LN with a normal nearly at right angles to T; an end mill of 12 mm re-worked to 11.8 mm.",
     TOOL_1(END_MILL), "10 TOOL CALL 1 Z\n12 LN " FLANK_P_12 " " FLANK_N " " FLANK_T " R0 M128\n"},
    {"E9 and E10: blocks 11 and 13 under RL: the first compensated block, and the last.", TOOL_1(END_MILL),
     "10 TOOL CALL 1 Z\n" BLOCK_11("RL") "13 LN " FLANK_P_12 " " FLANK_T "\n"},
    {"E9 and E10 under RR.", TOOL_1(END_MILL),
     "10 TOOL CALL 1 Z\n" BLOCK_11("RR") "13 LN " FLANK_P_12 " " FLANK_T "\n"},
    {"E10 under R0: block 13 has no side. W_NO_LATERAL, and the tip goes to P.", TOOL_1(END_MILL),
     "10 TOOL CALL 1 Z\n" BLOCK_11("R0") "13 LN " FLANK_P_12 " " FLANK_T " R0\n"},
    {"Blocks 11, 12 and 13 one after another, RL in block 11 and R0 in block 12 with its normal: block 11 ends in the "
     "direction of block 12.",
     TOOL_1(END_MILL),
     "10 TOOL CALL 1 Z\n" BLOCK_11("RL") "12 LN " FLANK_P_12 " " FLANK_N " " FLANK_T " R0\n13 LN " FLANK_P_12
                                         " " FLANK_T "\n"},
};

#undef BLOCK_11

}  // namespace

std::span<const Example> peripheral_milling_examples() { return kExamples; }

}  // namespace toolcomp::corpus
