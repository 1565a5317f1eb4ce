// SPDX-License-Identifier: Apache-2.0
// M140, departures without coordinates, and positions that are then unknown: one program for each rule, with figures
// worked out by hand.
#include "corpus/examples/heidenhain/tools.h"

namespace toolcomp::corpus {
namespace {

constexpr Example kRetractions[] = {
    {"M140 MB+50 moves up by 50 along the tool axis, in rapid if the block has no F. Increments are measured from "
     "there.",
     TOOL_1(REWORKED), "TOOL CALL 1 Z\nL X1 Y2 Z3 F100\nM140 MB+50\nL IX1\n",
     "2 programmed tip=1,2,3 feed=100\n3 rapid programmed tip=1,2,53\n4 programmed tip=2,2,53 feed=100\n"},
    {"After M140 MB MAX the position of Z is unknown until a Z word gives it.", TOOL_1(REWORKED),
     "L X1 Y2 Z3\nL M140 MB MAX\nL X5 R0\nL Z9\nL IZ1\n",
     "1 programmed tip=1,2,3\n2 rapid programmed X=1 Y=2 unknown\n3 programmed X=5 Y=2 unknown\n"
     "4 programmed tip=5,2,9\n5 programmed tip=5,2,10\n"},
    {"Under TCPM with B90 the tool is along X: M140 MB5 moves to X6. After M140 MB MAX only X is unknown.",
     TOOL_1(REWORKED), "M128\nL X1 Y2 Z3 B90\nM140 MB5 F200\nM140 MB MAX\nL IY1\nL X7\nL IX1\n",
     "2 programmed tip=1,2,3 B=90\n3 programmed tip=6,2,3 feed=200\n4 rapid programmed Y=2 Z=3 unknown\n"
     "5 programmed Y=3 Z=3 unknown feed=200\n6 programmed tip=7,3,3 feed=200\n7 programmed tip=8,3,3 feed=200\n"},
    {"The tool is along (0.6, 0, 0.8): MB10 moves by (6, 0, 8). After MB MAX X and Z are unknown.", TOOL_1(REWORKED),
     "TOOL CALL 1 Z\nM128\nLN X0 Y0 Z0 TX0.6 TY0 TZ0.8\nM140 MB10\nM140 MB MAX\nL X1 Z2\n",
     "3 W_NO_LATERAL\n3 programmed tip=0,0,0\n4 rapid programmed tip=6,0,8\n5 rapid programmed Y=0 unknown\n"
     "6 programmed tip=1,0,2\n"},
    {"Without TCPM the tool is along the tool axis, whatever the positions of the rotary axes.", TOOL_1(REWORKED),
     "L X1 B90\nM140 MB2\n", "1 programmed tip=1,0,0 B=90\n2 rapid programmed tip=1,0,2\n"},
    {"An increment of an axis whose position is unknown is not judged.", TOOL_1(REWORKED),
     "L M140 MB MAX\nL IZ1\nL Z5\n", "1 rapid programmed X=0 Y=0 unknown\n2 not_judged an unknown position\n"},
    {"M140 MB5 along an axis whose position is unknown leaves it unknown.", TOOL_1(REWORKED),
     "L M140 MB MAX\nM140 MB5\nL Z5\n",
     "1 rapid programmed X=0 Y=0 unknown\n2 rapid programmed X=0 Y=0 unknown\n3 programmed tip=0,0,5\n"},
    {"After DEP LT under RL the positions of X and Y are unknown, and Z is known.", TOOL_1(REWORKED),
     "L X1 Y2 RL\nDEP LT LEN5\nL Z9 R0\nL X3 Y4\n",
     "1 OUT_OF_SCOPE\n2 OUT_OF_SCOPE\n3 programmed Z=9 unknown\n4 programmed tip=3,4,9\n"},
    {"Under RL and TCPM a block to an unknown position is not judged. The block before it ends in its own direction.",
     TOOL_1(REWORKED), "TOOL CALL 1 Z\nM128\nL X1 RL F100\nM140 MB MAX\n",
     "3 start-up tip=1,-0.1,0 feed=100\n4 not_judged an unknown position\n"},
};

}  // namespace

std::span<const Example> klartext_retractions() { return kRetractions; }

}  // namespace toolcomp::corpus
