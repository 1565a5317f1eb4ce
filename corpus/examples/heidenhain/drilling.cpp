// SPDX-License-Identifier: Apache-2.0
// Calls of drilling cycles: one program for each rule, with figures worked out by hand.
#include "corpus/examples/heidenhain/tools.h"

namespace toolcomp::corpus {
namespace {

#define LONGER BALL_6 "DL = 0.5\n"
#define CYCLE_200 "CYCL DEF 200 DRILLING Q200=+2 Q201=-15 Q206=+150 Q202=+5 Q210=+0 Q203=+1 Q204=+50\n"

constexpr Example kDrilling[] = {
    {"M99 drills at the end of its block: from 1 + 2 down to 1 - 15, and back to 1 + 50. The next block starts from "
     "there.",
     TOOL_1(REWORKED), "TOOL CALL 1 Z\n" CYCLE_200 "L X10 Y20 R0 FMAX M99\nL X30\n",
     "3 rapid programmed tip=10,20,0\n3 hole X=10 Y=20 r=3 bottom=-14 return=51 axes=10,20,51\n"
     "4 programmed tip=30,20,51\n"},
    {"CYCL CALL drills where the axes stand, once for each call.", TOOL_1(REWORKED),
     CYCLE_200 "L X1 Y2 Z60\nCYCL CALL M3\nL X5\nCYCL CALL\n",
     "2 programmed tip=1,2,60\n3 hole X=1 Y=2 r=3 bottom=-14 return=51 axes=1,2,51\n4 programmed tip=5,2,51\n"
     "5 hole X=5 Y=2 r=3 bottom=-14 return=51 axes=5,2,51\n"},
    {"A second set-up clearance that is not greater than the set-up clearance is ignored.", TOOL_1(REWORKED),
     "CYCL DEF 201 REAMING Q200=2 Q201=-5 Q203=0 Q204=1\nCYCL CALL\nQ204 = 2\nCYCL CALL\n",
     "2 hole X=0 Y=0 r=2 bottom=-5 return=2 axes=0,0,2\n4 hole X=0 Y=0 r=2 bottom=-5 return=2 axes=0,0,2\n"},
    {"A value assigned between definition and call is used. A parameter in the definition has the value that it had "
     "there.",
     TOOL_1(REWORKED), "Q1 = 3\nCYCL DEF 203 Q200=Q1 Q201=-Q1 Q203=+0 Q204=+9\nQ1 = 7\nQ203 = 0.5\nCYCL CALL\n",
     "5 hole X=0 Y=0 r=3.5 bottom=-2.5 return=9.5 axes=0,0,9.5\n"},
    {"With Q201 = 0 the cycle does nothing.", TOOL_1(REWORKED),
     "CYCL DEF 207 Q200=2 Q201=0 Q203=0 Q204=50\nL X5 Z9 M99\nL X6\n",
     "2 programmed tip=5,0,9\n3 programmed tip=6,0,9\n"},
    {"The surface is measured from the shifted datum; events are measured from the preset.", TOOL_1(REWORKED),
     CYCLE_200 "CYCL DEF 7.0 DATUM\nCYCL DEF 7.1 X100\nCYCL DEF 7.2 Z-30\nL X1 Y2 M99\n",
     "5 programmed tip=101,2,0\n5 hole X=101 Y=2 r=-27 bottom=-44 return=21 axes=101,2,21\n"},
    {"DL lengthens the tool: the axes stand above the level of return by the sum of the DL.", TOOL_1(LONGER),
     "TOOL CALL 1 Z DL+0.25\n" CYCLE_200 "L X1 M99\n",
     "3 programmed tip=1,0,0 axes=1,0,0.75\n3 hole X=1 Y=0 r=3 bottom=-14 return=51 axes=1,0,51.75\n"},
    {"Tool axis X: the hole goes along X, at Y and Z.", TOOL_1(LONGER),
     "TOOL CALL 1 X\n" CYCLE_200 "L X80 Y2 Z3 M99\nL IX1\n",
     "3 programmed tip=80,2,3 axes=80.5,2,3\n3 hole Y=2 Z=3 r=3 bottom=-14 return=51 axes=51.5,2,3\n"
     "4 programmed tip=52,2,3\n"},
    {"After M140 MB MAX the position of Z is unknown. The hole makes it known.", TOOL_1(REWORKED),
     CYCLE_200 "M140 MB MAX\nL X5 M99\nL IZ1\n",
     "2 rapid programmed X=0 Y=0 unknown\n3 programmed X=5 Y=0 unknown\n"
     "3 hole X=5 Y=0 r=3 bottom=-14 return=51 axes=5,0,51\n4 programmed tip=5,0,52\n"},
    {"A hole at an unknown position is not judged, and neither is the move of its block.", TOOL_1(REWORKED),
     CYCLE_200 "TOOL CALL 1 Z\nL X1 RL\nDEP LT LEN5\nL Z9 R0\nL X3 M99\n",
     "3 OUT_OF_SCOPE\n4 OUT_OF_SCOPE\n5 programmed Z=9 unknown\n6 not_judged an unknown position\n"},
    {"Before a CYCL CALL the last block of peripheral milling ends as before a motion under R0. The move after the "
     "hole is not a cancel.",
     TOOL_1(REWORKED), CYCLE_200 "TOOL CALL 1 Z\nM128\nL X0 Y0 Z0\nL X10 RL\nL X20\nM129\nL R0\nCYCL CALL\nL X30\n",
     "4 programmed tip=0,0,0\n5 start-up tip=10,-0.1,0\n6 programmed tip=20,-0.1,0\n"
     "9 hole X=20 Y=0 r=3 bottom=-14 return=51 axes=20,0,51\n10 programmed tip=30,0,51\n"},
    {"Inches: the parameters of the cycle are lengths in the unit of the program.",
     HEIDENHAIN "units = \"inch\"\n" TOOL("1", REWORKED), "CYCL DEF 200 Q200=0.1 Q201=-0.5 Q203=0 Q204=2\nL X1 M99\n",
     "2 programmed tip=1,0,0\n2 hole X=1 Y=0 r=0.1 bottom=-0.5 return=2 axes=1,0,2\n"},
    {"A set-up clearance without a second one: parameters that are not set are 0.", TOOL_1(REWORKED),
     "CYCL DEF 240 Q200=2 Q343=+0 Q201=-3\nCYCL CALL\n", "2 hole X=0 Y=0 r=2 bottom=-3 return=2 axes=0,0,2\n"},
};

}  // namespace

std::span<const Example> klartext_drilling() { return kDrilling; }

}  // namespace toolcomp::corpus
