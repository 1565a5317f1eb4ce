// SPDX-License-Identifier: Apache-2.0
// Tool posture control: examples 2 (with posture control), 3 to 5, 7 to 9 and 11, worked out by hand. The
// pyramid of 3 and 8 has the edges from (20,-20,0) and (20,20,0) to (0,0,40); its face between them is 2x + z = 40.
#include "corpus/examples/fanuc/machines.h"

namespace toolcomp::corpus {
namespace {

#define LENGTH_100 "[offsets.H]\n1 = 100\n"
#define NEAR(limit, veto, refuse) "19738 = " limit "\n19739 = " veto "\n\"19696#3\" = " refuse "\n"
// On a table or mixed machine the mode starts at the zero pose; the first block leads to the edge.
#define EDGE "G90 G43.5 H1 P1\nG01 X20. Y-20. I-1 J1 K2 F100\nY20. I-1 J-1 K2\n"
#define TO_POLAR_12 "I-207405228388532 J14503186401626 K978147600733806"
#define SWING "G90 G43.5 H1 P1\nG01 X50. " TO_POLAR_12 " F100\n"
#define O0010                                                                                     \
  "N10 G90 G00 X30. Y-30. Z0\nN20 G43.5 H1 P1\nN30 G42.6 D2\nN40 G01 X20. Y-20. I-1 J1 K2 F500\n" \
  "N50 X20. Y20. I-1 J-1 K2\nN60 X-20. Y20. I1 J-1 K2\nN70 X-20. Y-20. I1 J1 K2\n"                \
  "N80 X20. Y-20. I-1 J1 K2\nN90 G40 X30. Y-30.\nN100 G49\n"
#define OFFSETS "[offsets.H]\n1 = 100\n[offsets.D]\n2 = 5\n"

constexpr Example kExamples[] = {
    // Halfway between (B 30, C 0) and (B 30, C 170) V is along their sum: C 85, tan B = sin 30 cos 85 / cos 30.
    {"2 with P1: C-B head at C 0, B 30, to the direction of (170,30): C 170, B 30 on the branch of the start, not "
     "C -10, B -30; C 85, B 2.88065908640527 in the middle.",
     HC("", "[position]\nB = 30\n"), "G90 G43.5 H0 P1\nG01 X50. " TO_B30_C170 " F100\n", "", 2},
    {"2 with P1: B tool at 30, C table at 0, to the direction of (30,170): B 30, C 170 on the branch of the start, not "
     "B -30, C -10; B 2.88065908640527, C 85 in the middle.",
     MBC("", "[position]\nB = 30\n"), "G90 G43.5 H0 P1\nG01 X50. " TO_B30_C170 " F100\n", "", 2},

    {"3: the edge of the pyramid, C-B head, L 100: in the middle V = (-1, 0, 2)/sqrt 5 at C 180, B 26.565051177078, "
     "control point (-24.7213595499958, 0, 89.4427190999916).",
     HC("", LENGTH_100 "[position]\nC = 130\nB = 30\n"),
     "G90 G43.5 H1 P1 X20. Y-20. I-1 J1 K2\nG01 Y20. I-1 J-1 K2 F100\n", "", 4},
    {"3: the same arc on an A-C table: A 26.565051177078, C 270 in the middle.",
     TAC(RANGES("90", "0", "400", "0"), LENGTH_100), EDGE, "", 4},
    {"3: the same arc with B tool and C table: B 26.565051177078, C 180 in the middle.",
     MBC(RANGES("90", "0", "400", "0"), LENGTH_100), EDGE, "", 4},
    {"3: the same arc with a nutating B: C 166.345415254024, B 37.921419763845 in the middle.",
     N45("", LENGTH_100 "[position]\nC = 116\nB = 50\n"),
     "G90 G43.5 H1 P1 X20. Y-20. I-1 J1 K2\nG01 Y20. I-1 J-1 K2 F100\n", "", 4},

    {"4: type 1, C 0 B 20 to C 90 B 40, L 150: in the middle C 61.9830533459686, B 23.1158568832211, length vector "
     "(27.6619712970299, 51.9875006084212, 137.956932136271).",
     HC("", "[offsets.H]\n1 = 150\n[position]\nB = 20\n"), "G90 G43.4 H1 P1\nG01 C90. B40. F100\n", "", 4},
    {"4 with P0: length vector (53.0330085889911, 53.0330085889911, 129.903810567666) in the middle.",
     HC("", "[offsets.H]\n1 = 150\n[position]\nB = 20\n"), "G90 G43.4 H1 P0\nG01 C90. B40. F100\n", "", 4},
    {"4: type 1, C 0 to 200 at B 20 swings by more than 180: conventional control with the warning posture-branch.",
     HC("", "[position]\nB = 20\n"), "G90 G43.4 H0 P1\nG01 C200. F100\n", "", 4},

    {"5: near the singular posture, 19738 = 1, 19739 = 3: not changed, C swings to 176, B ends at 12.",
     HC(NEAR("1", "3", "0"), "[position]\nB = 10\n"), "G90 G43.5 H0 P1\nG01 X50. " TO_POLAR_12 " F100\n", "", 10},
    {"5 with NPC = 1: PS5421.", HC(NEAR("1", "3", "1"), "[position]\nB = 10\n"),
     "G90 G43.5 H0 P1\nG01 X50. " TO_POLAR_12 " F100\n"},
    {"5 with 19739 = 5: changed, C 0, B -12; L 80. The next block, to polar 30 and azimuth 200, ends at C 20, B -30.",
     HC(NEAR("1", "5", "0"), "[offsets.H]\n1 = 80\n[position]\nB = 10\n"),
     SWING "X60. I-469846310392954 J-171010071662834 K866025403784439\n", "", 4},
    {"5 on an A-C table: changed, A -12, C 0; V = (0, 0.0174524064372835, 0.999847695156391) in the middle.",
     TAC(NEAR("1", "5", "0"), "[offsets.H]\n1 = 80\n"),
     "G90 G43.5 H1 P1\nG01 I0 J-173648177666930 K984807753012208 F100\n"
     "X50. I14503186401626 J207405228388532 K978147600733806\n",
     "", 4},
    {"5 around -Z: from C 0, B 172 to polar 170, azimuth 177: changed, C 0, B 190.",
     HC(NEAR("1", "5", "0"), "[position]\nB = 172\n"),
     "G90 G43.5 H0 P1\nG01 X50. I-173410198874506 J9088043428043 K-984807753012208 F100\n"},

    {"7: from (1,0,5) to (-1,0.1,5), d = 0.572223911907299, 19738 = 1, 19739 = 6: changed.",
     HC(NEAR("1", "6", "0"), ""), "G90 G43.5 H0 P1\nG01 I1 J0 K5 F100\nX10. I-1 J0.1 K5\n"},
    {"7: the same with 19739 = 5, below 5.71059313749964: not changed.", HC(NEAR("1", "5", "0"), ""),
     "G90 G43.5 H0 P1\nG01 I1 J0 K5 F100\nX10. I-1 J0.1 K5\n"},
    {"7: the same with 19738 = 0.57, below d: not near.", HC(NEAR("\"0.57\"", "6", "0"), ""),
     "G90 G43.5 H0 P1\nG01 I1 J0 K5 F100\nX10. I-1 J0.1 K5\n"},
    {"7: exactly through the singular posture, (1,0,2) to (-2,0,3): B 26.565051177078 to -33.6900675259798, C stays.",
     HC(NEAR("1", "180", "1"), ""), "G90 G43.5 H0 P1\nG01 I1 J0 K2 F100\nX10. I-2 J0 K3\n", "", 4},

    {"8: O0010 on a C-B head, H1 = 100, D2 = 5.", HC("", OFFSETS), O0010, "", 4},
    {"8: O0010 on an A-C table.", TAC("", OFFSETS), O0010, "", 2},
    {"8: O0010 with B tool and C table.", MBC("", OFFSETS), O0010, "", 2},

    {"9: A-C table with offsets A = (0,0,-100), d = (0,30,50), workpiece origin (5,10,20), L 100, start at A 0 C 0.",
     TAC(TABLE_OFFSETS, LENGTH_100 TABLE_ORIGIN),
     "G90 G43.5 H1 P1 X30. Y-30. Z0\nG01 X20. Y-20. I-1 J1 K2 F100\nY20. I-1 J-1 K2\n", "", 4},

    {"11: opposite directions, type 1, C 0 B 30 to C 180 B 150: conventional control, (45, 60) and (90, 90) on the "
     "way.",
     HC("", "[position]\nB = 30\n"), "G90 G43.4 H0 P1\nG01 C180. B150. F100\n", "", 4},
};

#undef LENGTH_100
#undef NEAR
#undef EDGE
#undef TO_POLAR_12
#undef SWING
#undef O0010
#undef OFFSETS

}  // namespace

std::span<const Example> tool_posture_control_examples() { return kExamples; }

}  // namespace toolcomp::corpus
