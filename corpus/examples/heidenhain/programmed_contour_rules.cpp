// SPDX-License-Identifier: Apache-2.0
// The programmed contour: one program for each rule of FUNCTION PROG PATH and of the points that it gives.
#include "corpus/examples/heidenhain/tools.h"

namespace toolcomp::corpus {
namespace {

#define CALL "TOOL CALL 1 Z\n"
#define LN "LN X1 Y2 Z3 NX0.6 NY0 NZ0.8"
#define TOROID "R = 5\nR2 = 2\nDR = -0.3\nDR2 = -0.1\n"

constexpr Example kRules[] = {
    {"From IS CONTOUR to OFF, across a tool call; L without RL and RR keeps the programmed point.", TOOL_1(TOROID),
     CALL LN "\n" CONTOUR LN "\nL X5\n" CALL LN "\nFUNCTION PROG PATH OFF\n" LN "\n"},
    {"CNT-CNT has no effect in a compensated block under IS CONTOUR, but it has in an L block.", TOOL_1(TOROID),
     CALL TCPM_CENTER CONTOUR LN " TX0 TY0 TZ1\nL X5\n" LN "\n"},
    {"Round a square under RL: the tip is 4.7 beside it, also under CNT-CNT.", TOOL_1(TOROID),
     CALL CONTOUR TCPM_CENTER "L X0 Y-10 R0\nL Y0 RL\nL X20\nL Y20\nL X0\nL Y-10 R0\n"},
    {"Outside it under RR, with the tip as the reference point.", TOOL_1(TOROID),
     CALL CONTOUR "L X0 Y-10 R0 M128\nL Y0 RR\nL X20\nL Y20\nL X0\nL Y-10 R0\n"},
    {"IS CONTOUR begins and ends between compensated blocks: the delta of the former block is used at the corner.",
     TOOL_1("R = 6\nDR = -0.1\n"),
     CALL "L X0 Y-10 R0 M128\nL Y0 RL\nL X20\n" CONTOUR "L Y20\nFUNCTION PROG PATH OFF\nL X0\nL Y40 R0\n"},
    {"The nominal radius without deltas.", TOOL_1("R = 6\n"),
     CALL CONTOUR "L X0 Y-10 R0 M128\nL Y0 RL\nL X20\nL Y20 R0\n"},
    {"A corner radius beyond the radius under M107: a ball of the corner radius touches.", TOOL_1(BALL_6 "DR2 = 0.3\n"),
     CALL CONTOUR LN " M107\n"},
    {"The flat touches: the tip is the programmed point.", TOOL_1(TOROID), CALL CONTOUR "LN X1 Y2 Z3 NX0 NY0 NZ5\n"},
    {"An undercut.", TOOL_1(TOROID), CALL CONTOUR "LN X1 Y2 Z3 NX0.6 NY0 NZ-0.8\n"},
    {"A table of deviations: at 90 degrees the corner radius is 2.96.",
     TOOL_1(BALL_6 "DR2TABLE = \"T\"\n") "[[dr2table]]\nname = \"T\"\npoints = [[0, 0.02], [90, -0.04]]\n",
     CALL CONTOUR "LN X1 Y2 Z3 NX1 NY0 NZ0\n"},
    {"A program in inches: the full radius of 127 mm is 5 inches.", TOOL_1("R = 127\nR2 = 50.8\nDR2 = -2.54\n"),
     "BEGIN PGM A INCH\n" CALL CONTOUR LN "\nL X0 Y-10 M128\nL Y0 RL\nL X20\n"},
    {"LN without a normal under R0 keeps the programmed point.", TOOL_1(TOROID),
     CALL CONTOUR "LN X1 Y2 Z3 TX0 TY0 TZ1 M128\n"},
    {"RL without TCPM stays out of scope.", TOOL_1(TOROID), CALL CONTOUR "L X1 RL\nL X2 R0\n"},
};

#undef CALL
#undef LN
#undef TOROID

}  // namespace

std::span<const Example> programmed_contour_rules() { return kRules; }

}  // namespace toolcomp::corpus
