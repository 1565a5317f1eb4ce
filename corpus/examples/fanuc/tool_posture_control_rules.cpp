// SPDX-License-Identifier: Apache-2.0
// Tool posture control: one program for each rule that generated programs seldom meet, worked out by hand.
#include "corpus/examples/fanuc/machines.h"

namespace toolcomp::corpus {
namespace {

#define NEAR(limit, veto, refuse) "19738 = " limit "\n19739 = " veto "\n\"19696#3\" = " refuse "\n"
#define B_30 "[position]\nB = 30\n"
#define LENGTH_AT(b) "[offsets.H]\n1 = 100\n[position]\nB = " b "\n"
#define TO_POLE "G90 G43.5 H1 P1\nG01 X10. I0 J0 K1 F100\n"
#define WORKPIECE "\"19696#5\" = 1\n"
#define TILTED_45 "19698 = 45\n"
#define ARC(from, to) "G90 G43.5 H0 P1\nG01 " from " F100\nX10. " to "\n"

constexpr Example kRules[] = {
    {"P2: PS5421 at line 1.", HC("", ""), "G43.5 H0 P2\n"},
    {"Without P, TPC = 1: posture control, (1, 1, 0)/sqrt 2 in the middle of X and Y.", HC("\"19604#0\" = 1\n", ""),
     "G90 G43.5 H0\nG01 I1 J0 K0 F100\nX10. I0 J1 K0\n", "", 2},
    {"Without P, TPC = 0: conventional control.", HC("", ""), "G90 G43.5 H0\nG01 I1 J0 K2 F100\nX10. I0 J1 K2\n", "",
     2},
    {"The same direction again: nothing turns.", HC("", ""), ARC("I1 J0 K2", "I2 J0 K4"), "", 2},

    {"From upright to -1 1 2 with C at -45 already: no turn before the block.", HC("", "[position]\nC = -45\n"),
     "G90 G43.5 H0 P1\nG01 X10. I-1 J1 K2 F100\n"},
    {"From upright to -1 1 2: C turns to -45 before the block.", HC("", ""),
     "G90 G43.5 H0 P1\nG01 X10. I-1 J1 K2 F100\n", "", 2},
    {"From upright to 1 1 2: C turns to 45 before the block. With length 10 and a head 5 to the side of the tool, the "
     "linear axes follow.",
     HC("19712 = 5\n", "[offsets.H]\n1 = 10\n"), "G90 G43.5 H1 P1\nG01 X10. I1 J1 K2 F100\n", "", 2},
    {"A tilt of 1e-19 from upright toward Y, with C at -1350, which is the same as 90: the table does not turn, X2.5, "
     "X5, X7.5 and X10.",
     TAC("", "[offsets.H]\n1 = 60\n[position]\nA = 360\nC = -1350\n"),
     "G90 G43.5 H1 P1\nG01 X10. I0 J.0000000000001 K984808 F100\n", "", 4},
    {"Type 2 to upright: C stays.", HC("", B_30), "G90 G43.5 H0 P1\nG01 X10. I0 J0 K1 F100\n"},
    {"Type 1 to upright at C 90: the block ends at C 0, then C turns to 90.", HC("", B_30),
     "G90 G43.4 H0 P1\nG01 X10. B0 C90. F100\n", "", 2},
    {"Type 1 to upright at C -90: then C turns to -90.", HC("", B_30), "G90 G43.4 H0 P1\nG01 X10. B0 C-90. F100\n"},
    {"Type 1 to upright at C 0: no turn after the block.", HC("", B_30), "G90 G43.4 H0 P1\nG01 X10. B0 F100\n"},
    {"Type 1 to upright at B 360: the great circle leads B to 0 instead, so conventional control with the warning "
     "posture-branch.",
     HC("", B_30), "G90 G43.4 H0 P1\nG01 X10. B360. F100\n"},
    {"Type 1 from upright to B 200: followed back from the end, B comes to 360 at the start, so conventional control "
     "with the warning posture-branch.",
     HC("", ""), "G90 G43.4 H0 P1\nG01 X10. B200. F100\n"},
    {"Type 1 from B 30 to B -30 and C 90, on the other branch: conventional control with the warning posture-branch.",
     HC("", B_30), "G90 G43.4 H0 P1\nG01 X10. B-30. C90. F100\n"},
    {"Type 1 across the singular posture: B goes through 0 to -30, C does not turn.", HC("", B_30),
     "G90 G43.4 H0 P1\nG01 X10. B-30. F100\n", "", 2},

    {"A nutating B on its edge of reach, from Y to X along the equator: B stays at 180, C goes to -90.",
     N45("", "[position]\nB = 180\n"), "G90 G43.5 H0 P1\nG01 X10. I1 J0 K0 F100\n", "", 2},
    {"A nutating B from its edge of reach, 180, to upright: the branch is the one toward the pair chosen, B 360, so C "
     "goes to -90.",
     N45("", LENGTH_AT("180")), TO_POLE, "", 2},
    {"A nutating B from -180 to upright: the pair chosen is that of B 0, C -90.", N45("", LENGTH_AT("-180")), TO_POLE},
    {"A nutating B from 540 to upright: the pair chosen is that of B 720, C -90.", N45("", LENGTH_AT("540")), TO_POLE},
    {"The same on a mixed machine, B on the tool, C on the table: from 180 to B 360, C -90; the tip goes to (0, 10).",
     M45("", LENGTH_AT("180")), TO_POLE, "", 2},
    {"The same on a mixed machine from -180: B 0, C -90.", M45("", LENGTH_AT("-180")), TO_POLE},
    {"The same on a mixed machine from 540: B 720, C -90.", M45("", LENGTH_AT("540")), TO_POLE},
    {"The same on a table. Its frame is fixed at B 180, and the pole is along Y of the frame: B 360, C -90; the tip "
     "goes to (0, -10).",
     T45("", LENGTH_AT("180")), "G90 G43.5 H1 P1\nG01 X10. I0 J1 K0 F100\n"},
    {"Type 1 from the edge of reach to B 360, C -90: the great circle leads there.", N45("", LENGTH_AT("180")),
     "G90 G43.4 H1 P1\nG01 X10. B360. C-90. F100\n"},
    {"Type 1 from the edge of reach to B 0, C 90: on the other branch the great circle leads there too.",
     N45("", LENGTH_AT("180")), "G90 G43.4 H1 P1\nG01 X10. B0 C90. F100\n"},

    {"WKP = 1: the table C turns before the block and takes the tip from (10, 0) to (0, -10). B goes to 30 in the "
     "block.",
     MBC(WORKPIECE, ""), "G90 G43.4 H0 P1 X10.\nG01 X0 Y-10. B30. C90. F100\n"},
    {"WKP = 1: C turns after the block. Before this turn the programmed end, (10, 0), is at (0, -10).",
     MBC(WORKPIECE, ""), "G90 G43.4 H0 P1 B30. C90.\nG01 X10. B0 C0 F100\n"},

    {"C and B with their zeros at 20 and 7: from B 3, the angle 10, the end is changed to the angle -12: B -19, C -20.",
     HC(NEAR("1", "5", "0"), "[workpiece.G54]\nC = 20\nB = 7\n[position]\nC = -20\nB = 3\n"),
     "G90 G43.5 H0 P1\nG01 X50. I-207405228388532 J14503186401626 K978147600733806 F100\n"},

    {"Tilted by RA 45, from (0,-1,1) on the edge of reach, B 0, to (1,-1,0): the branch is that of the pair chosen.",
     HC(TILTED_45, ""), "G90 G43.5 H0 P1\nG01 X10. I1 J-1 K0 F100\n", "", 2},
    {"Tilted by RA 45, a great circle over the pole: PS5459 at line 3.", HC(TILTED_45, ""),
     ARC("I1 J-7 K5", "I-1 J6 K5")},
    {"Tilted by RA 45, from (1,-7,5) to (-7,-1,5) the edge of reach is touched in the middle, at (-3,-4,5)/sqrt 50.",
     HC(TILTED_45, ""), ARC("I1 J-7 K5", "I-7 J-1 K5")},
    {"Tilted by RA 45, from (1,-7,1) to (-7,-1,1): within reach.", HC(TILTED_45, ""), ARC("I1 J-7 K1", "I-7 J-1 K1"),
     "", 2},
    {"Tilted by RA 45, from (1,-7,-5) to (-7,-1,-5) the other edge is touched.", HC(TILTED_45, ""),
     ARC("I1 J-7 K-5", "I-7 J-1 K-5")},
    {"Tilted by RA 45, a great circle over -Z: PS5459 at line 3.", HC(TILTED_45, ""), ARC("I1 J-7 K-5", "I-1 J6 K-5")},

    {"A great circle in a plane with Z that does not pass through Z.", HC("", ""), ARC("I1 J0 K2", "I2 J0 K1"), "", 2},
    {"Along the equator: Z is normal to the plane, and both poles are 90 degrees away. That is near for 19738 = 91, "
     "but 19739 = 0 vetoes a change.",
     HC(NEAR("91", "0", "0"), ""), ARC("I1 J0 K0", "I0 J1 K0"), "", 2},
    {"Along the equator with 19738 = 90: not near.", HC(NEAR("90", "180", "1"), ""), ARC("I1 J0 K0", "I0 J1 K0")},
    {"From (1,-7,5) to (-7,-1,5) the great circle comes to 45 degrees from Z: not near for 19738 = 45.",
     HC(NEAR("45", "180", "1"), ""), ARC("I1 J-7 K5", "I-7 J-1 K5")},
    {"The same with 19738 = 45.001: near; 19739 = 180 never vetoes, so the end is changed.",
     HC(NEAR("\"45.001\"", "180", "1"), ""), ARC("I1 J-7 K5", "I-7 J-1 K5")},
    {"The same around -Z.", HC(NEAR("\"45.001\"", "180", "1"), ""), ARC("I1 J-7 K-5", "I-7 J-1 K-5")},
    {"From (1,0,1) to (-1,1,1) delta is 45: with 19739 = 45 the end is changed, C stays at 0.",
     HC(NEAR("60", "45", "1"), ""), ARC("I1 J0 K1", "I-1 J1 K1"), "", 3},
    {"The same with 19739 = 44.999: PS5421 at line 3.", HC(NEAR("60", "\"44.999\"", "1"), ""),
     ARC("I1 J0 K1", "I-1 J1 K1")},
    {"The same with 19739 = 45 and a range of B from -10 to 90: the changed end is out of range: PS5421 at line 3.",
     HC(RANGES("0", "0", "90", "-10") NEAR("60", "45", "1"), ""), ARC("I1 J0 K1", "I-1 J1 K1")},
    {"The same with NPC = 0: C goes to 135.", HC(RANGES("0", "0", "90", "-10") NEAR("60", "45", "0"), ""),
     ARC("I1 J0 K1", "I-1 J1 K1")},
    {"The same with a range of C from -100 to 100: the end is out of range: PS5459 at line 3.",
     HC(RANGES("100", "-100", "90", "-10") NEAR("60", "45", "0"), ""), ARC("I1 J0 K1", "I-1 J1 K1")},
    {"Away from a start that is near: the point of the great circle nearest to Z is before the start; d = 45 is below "
     "46; delta 180 is vetoed.",
     HC(NEAR("46", "10", "0"), ""), ARC("I1 J0 K1", "I3 J1 K1"), "", 2},
    {"Away from a start at 45 degrees with 19738 = 45: not near.", HC(NEAR("45", "10", "1"), ""),
     ARC("I1 J0 K1", "I3 J1 K1")},
    {"Toward an end at 45 degrees with 19738 = 44: not near.", HC(NEAR("44", "10", "1"), ""),
     ARC("I3 J1 K1", "I1 J0 K1")},

    {"The tool leans by Q1 from Z toward (3,4), then goes to -Y: the end is changed to B -90 at C 53.13, with the tool "
     "along (-3,-4)/5. A movement exactly along the tool makes no vector.",
     HC(NEAR("10", "90", "0"), "[offsets.D]\n1 = 1\n"),
     "G90 G43.5 H0 P1 Q1\nG01 X3. Y4. K1 F100\nJ-1\nG42.6 D1 X0 Y0\n"},
    {"The same helix twice. By Q5 the tool leans toward the travel at the end of the helix, so it does not turn in the "
     "second one.",
     HC("", ""), "G91 G43.5 H0 P1 Q5 I1 J2 K5\nG03 X-48. Y-24. Z-20. R-30. F100\nX-48. Y-24. Z-20. R-30.\n", "", 2},

    {"An arc of XY about (0,10) with P1, the tool from X to Y: in the middle the tool is at azimuth 45.",
     HC("", "[offsets.H]\n1 = 10\n"), "G90 G17 G43.5 H1 P1 I1 J0 K0\nG03 X10. Y10. R10. I0 J1 K0 F100\n", "", 2},
    {"G00 goes the same way as G01.", HC("", ""), "G90 G43.5 H0 P1 I1 J0 K2\nG00 X10. I0 J1 K2\n", "", 2},
};

#undef NEAR
#undef B_30
#undef LENGTH_AT
#undef TO_POLE
#undef WORKPIECE
#undef TILTED_45
#undef ARC

}  // namespace

std::span<const Example> tool_posture_control_rules() { return kRules; }

}  // namespace toolcomp::corpus
