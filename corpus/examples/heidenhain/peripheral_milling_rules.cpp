// SPDX-License-Identifier: Apache-2.0
// Peripheral milling: one program for each rule of start, mitre, end and direction. Unless the comment says otherwise,
// the tool is along Z and RL is on the left of the travel. DR is -0.1, so the tip is 0.1 to the right of the contour.
#include "corpus/examples/heidenhain/tools.h"

namespace toolcomp::corpus {
namespace {

#define CALL "TOOL CALL 1 Z\n"
#define START CALL "L X0 Y-10 R0 M128\n"

constexpr Example kRules[] = {
    {"Round a square under RL: the first block ends in the direction of the next block, there are mitres at the "
     "corners, and the last block ends in its own direction; then the cancel.",
     TOOL_1(END_MILL), START "L Y0 RL\nL X20\nL Y20\nL X0\nL Y-10 R0\n"},
    {"The same under RR.", TOOL_1(END_MILL), START "L Y0 RR\nL X20\nL Y20\nL X0\nL Y-10 R0\n"},
    {"Nothing follows the first compensated block: it ends in its own direction.", TOOL_1(END_MILL),
     START "L X3 Y-6 RL\n"},
    {"Nothing follows the first compensated block, which has no direction: E_NO_DIRECTION.", TOOL_1(END_MILL),
     START "L Z5 RL\nM5\n"},
    {"An alarm follows the first compensated block: it ends in its own direction, then comes the alarm.",
     TOOL_1(END_MILL), START "L X3 Y-6 RL\nL X5 NX5\n"},
    {"An alarm follows a compensated block without direction: E_NO_DIRECTION of this block is raised instead.",
     TOOL_1(END_MILL), START "L Z5 RL\nL X5 NX5\n"},
    {"The first compensated block is the only one: the next block, without compensation, gives the direction, and RL "
     "the side.",
     TOOL_1(END_MILL), START "L Y0 RL\nL X20 R0\nL X30\n"},
    {"An LN block with a normal follows the first compensated block: its travel gives the direction.", TOOL_1(END_MILL),
     START "L Y0 RL\nLN X20 Y0 Z0 NX0 NY0.6 NZ0.8 TX0 TY0 TZ1 R0\n"},
    {"M30 in a compensated block: nothing follows.", TOOL_1(END_MILL), START "L Y0 RL\nL X20 M30\nL Y20\n"},
    {"END PGM after a compensated block: nothing follows.", TOOL_1(END_MILL),
     START "L Y0 RL\nL X20\nEND PGM A MM\nL Y20\n"},
    {"RL from an L block without an axis word. F and M blocks between are ignored.", TOOL_1(END_MILL),
     START "L RL F500\nL Y0\nM8\nL X20\nL R0 M9\nL Y20\n"},

    {"Blocks without movement and along the tool: the last direction is used.", TOOL_1(END_MILL),
     START "L Y0 RL\nL X20\nL X20\nL Z5\nL Y20\nL Y20\nL X0 R0\n"},
    {"A rotary word alone: nothing moves, and the last direction is used although the tool has turned.",
     TOOL_1(END_MILL), START "L Y0 RL\nL X20\nL A30\nL X40\nL Z50 R0\n"},
    {"No direction at the start of the contour: E_NO_DIRECTION names the first compensated block.", TOOL_1(END_MILL),
     START "L Y0 RL\nL Z5\nL X20\n"},
    {"Directions are forgotten after the last compensated block: E_NO_DIRECTION in line 6.", TOOL_1(END_MILL),
     START "L Y0 RL\nL X20\nL Y20 R0\nL X0 RL\nL Z5\n"},
    {"A reversal under RL: E_REVERSAL names the block that ends there.", TOOL_1(END_MILL),
     START "L Y0 RL\nL X20\nL X5\nL Y5\n"},
    {"Nearly a reversal: the offset lines meet far away.", TOOL_1(END_MILL),
     START "L Y0 RL\nL X24\nL X17 Y24\nL X0 R0\n"},
    {"RL to RR at a reversal: the tool stays on one side.", TOOL_1(END_MILL),
     START "L Y0 RL\nL X20\nL X5 RR\nL Y5 R0\n"},
    {"RL to RR straight on: E_REVERSAL.", TOOL_1(END_MILL), START "L Y0 RL\nL X20\nL X25 RR\nL Y5 R0\n"},
    {"RL to RR at a corner: the mitre with the side of each block.", TOOL_1(END_MILL),
     START "L Y0 RL\nL X20\nL Y20 RR\nL X0 R0\n"},

    {"The tool inclined by LN without a normal: c = (0, 0.8, -0.6) along X. At the corner the tool direction of the "
     "junction is used.",
     TOOL_1(END_MILL "DL = 0.5\n"),
     START "LN X0 Y0 Z0 TX0 TY0.6 TZ0.8 RL\nLN X20 Y0 Z0 TX0 TY0.6 TZ0.8\nLN X20 Y12 Z9 TX0 TY0 TZ1\nL X0\nL Z50 R0\n"},
    {"The tool inclined by rotary words, A 30 and B 90. L continues with the tool direction of LN.", TOOL_1(END_MILL),
     START "L Y0 A30 RL\nL X20\nL Y20 B90 A0\nLN X0 Y20 Z0 TX0.6 TY0 TZ0.8\nL X-20\nL Z50 R0\n"},
    {"A tool vector of any length: W_NOT_NORMALIZED and the same direction.", TOOL_1(END_MILL),
     START "LN X0 Y0 Z0 TX0 TY3 TZ4 RL\nLN X20 Y0 Z0 TX0 TY3 TZ4\n"},
    {"The delta of the former block is used at the corner. A call without a tool keeps RL.", TOOL_1(END_MILL),
     START "L Y0 RL\nL X20\nTOOL CALL DR-0.3\nL Y20\nL X0 R0\n"},
    {"Another DL acts along the tool from the next block on. DR2 has no effect on the direction.",
     TOOL_1("R = 6\nR2 = 1\nDR = -0.1\nDR2 = -0.5\nL = 75\n"), START "L Y0 RL\nTOOL CALL DL+2\nL X20\nL Y20 R0\n"},
    {"Under CNT-CNT the tip starts from P - R2 t.", TOOL_1("R = 6\nR2 = 1\nDR = -0.1\n"),
     CALL TCPM_CENTER "L X0 Y-10 R0\nL Y0 RL\nL X20\n"},
    {"A program in inches: -2.54 mm are -0.1 inch.", TOOL_1("R = 254\nDR = -2.54\n"),
     "BEGIN PGM A INCH\n" START "L Y0 RL\nL X20\nL Y20 R0\n"},

    {"DR 0.1 without M107: E_OVERSIZE_DR in a compensated block, not in L with R0.", TOOL_1("R = 6\nDR = 0.1\n"),
     START "L Y0 RL\nL X20\n"},
    {"DR 0.1 under M107: the tool is on the left. DR 0 is no oversize.", TOOL_1("R = 6\nDR = 0.1\n"),
     START "L Y0 RL M107\nL X20\nL Y20 R0\nTOOL CALL DR-0.1\nL Y30 RL M108\nL X0\n"},
    {"R -1 in the table: E_TOOL in a compensated block.", TOOL_1("R = -1\n"), START "L Y0 RL\n"},
    {"No tool: L with R0 runs, a compensated block raises E_NO_TOOL.", TOOL_1(END_MILL), "L X5 M128\nL Y0 RL\n"},
    {"RL before a tool call with a tool: R0 after it.", TOOL_1(END_MILL),
     START "L Y0 RL\nL X20 M129\n" CALL "L X30 M128\nL Y5\n"},

    {"RL without TCPM: out of scope, and the run continues. The block after it is neither start-up nor cancel.",
     TOOL_1(END_MILL), CALL "L X10 RL\nL Y10 R0\n"},
    {"LN without a normal under RL and without TCPM: the warnings, then out of scope.", TOOL_1(END_MILL),
     CALL "LN X10 Y0 Z0 TX0 TY0 TZ1 RR\nL Y10 R0\n"},
    {"TCPM ends under RL: the block before is the last compensated one. The out-of-scope block takes the place of the "
     "cancel.",
     TOOL_1(END_MILL), START "L Y0 RL\nL X20 M129\nL Y20\nL X0 R0\n"},
    {"RL before TCPM: the first block under TCPM is the first compensated one.", TOOL_1(END_MILL),
     CALL "L X10 RL\nL Y10 M128\nL X20\nL Y0 R0\n"},
    {"DR 0.1: LN without a normal under RL is checked even if it is out of scope, L is not.",
     TOOL_1("R = 6\nDR = 0.1\n"), CALL "L X10 RL\nLN X10 Y0 Z0 TX0 TY0 TZ1\n"},
    {"LN without a normal under R0: W_NO_LATERAL comes after W_T_IGNORED without TCPM, and after W_NOT_NORMALIZED "
     "under TCPM.",
     TOOL_1(END_MILL "DL = 0.5\n"), CALL "LN X10.000001 Y0 Z0 TX0 TY3 TZ4\nLN X10 Y0 Z0 TX0 TY3 TZ4 M128\n"},
    {"A block with a normal between: the contour ends before it and starts again after it.", TOOL_1(END_MILL),
     START "L Y0 RL\nL X20\nLN X20 Y20 Z0 NX0 NY0.6 NZ0.8 TX0 TY0 TZ1 R0\nL X0 RL\nL Y40\n"},
    {"A normal at right angles to T: D_tip = dR n - dR2 t = (0, -0.1, 0.02).",
     TOOL_1("R = 6\nR2 = 1\nDR = -0.1\nDR2 = "
            "-0.02\n"),
     CALL "LN X20 Y0 Z0 NX0 NY1 NZ0 TX0 TY0 TZ1 M128\n"},
    {"B90 before M128: the tool is along X, and the left of a travel along Y is Z, so the tip is at Z -0.1.",
     TOOL_1(END_MILL), CALL "L X0 Y-10 Z0 B90 R0\nM128\nL Y0 RL\nL Y20\nL Y40 R0\n",
     "2 programmed tip=0,-10,0 B=90\n4 start-up tip=0,0,-0.1 shift=0,0,-0.1 axis=1,0,0\n"
     "5 programmed tip=0,20,-0.1 shift=0,0,-0.1 axis=1,0,0\n6 cancel tip=0,40,0 axis=1,0,0\n"},
};

#undef CALL
#undef START

}  // namespace

std::span<const Example> peripheral_milling_rules() { return kRules; }

}  // namespace toolcomp::corpus
