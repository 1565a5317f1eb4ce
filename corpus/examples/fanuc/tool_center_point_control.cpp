// SPDX-License-Identifier: Apache-2.0
// Tool center point control: examples 1, 2, 9 and 11, worked out by hand, and the part of 3 with conventional control.
// The name of a machine gives its first rotary axis (19681), then its second (19686).
#include "corpus/examples/fanuc/machines.h"

namespace toolcomp::corpus {
namespace {

#define TO(ijk) "G90 G43.5 H0 P0\nG01 " ijk " F100\n"
#define BOTH(name, pair_1, pair_2, machine, ijk, range_1, range_2)                              \
  {"1: " name ", pair 1, the only one in range: " pair_1 ".", machine(range_1, ""), TO(ijk)}, { \
    "1: " name ", pair 2, the only one in range: " pair_2 ".", machine(range_2, ""), TO(ijk)    \
  }
#define LENGTH_100 "[offsets.H]\n1 = 100\n"

constexpr Example kExamples[] = {
    BOTH("C-B head, -1 1 2", "C 135, B 35.2643896827547", "C 315, B 324.735610317245", HC, "I-1 J1 K2",
         RANGES("136", "134", "36", "35"), RANGES("316", "314", "325", "324")),
    BOTH("C-A head, -1 1 2", "C 225, A 35.2643896827547", "C 45, A 324.735610317245", HCA, "I-1 J1 K2",
         RANGES("226", "224", "36", "35"), RANGES("46", "44", "325", "324")),
    BOTH("A-C table, 1 2 3", "A 36.6992252004899, C 153.434948822922", "A 323.30077479951, C 333.434948822922", TAC,
         "I1 J2 K3", RANGES("37", "36", "154", "153"), RANGES("324", "323", "334", "333")),
    BOTH("B-C table, 1 2 3", "B 36.6992252004899, C 63.434948822922", "B 323.30077479951, C 243.434948822922", TBC,
         "I1 J2 K3", RANGES("37", "36", "64", "63"), RANGES("324", "323", "244", "243")),
    BOTH("B tool, C table, 1 2 3", "B 36.6992252004899, C 63.434948822922", "B 323.30077479951, C 243.434948822922",
         MBC, "I1 J2 K3", RANGES("37", "36", "64", "63"), RANGES("324", "323", "244", "243")),
    BOTH("A tool, C table, 1 2 3", "A 36.6992252004899, C 153.434948822922", "A 323.30077479951, C 333.434948822922",
         MAC, "I1 J2 K3", RANGES("37", "36", "154", "153"), RANGES("324", "323", "334", "333")),
    BOTH("A-B head, 1 2 3", "A 146.30993247402, B 164.498640433063", "A 326.30993247402, B 15.501359566937", HAB,
         "I1 J2 K3", RANGES("147", "146", "165", "164"), RANGES("327", "326", "16", "15")),
    BOTH("A-B table, 1 2 3", "A 327.688466762576, B 18.434948822922", "A 212.311533237424, B 198.434948822922", TAB,
         "I1 J2 K3", RANGES("328", "327", "19", "18"), RANGES("213", "212", "199", "198")),
    BOTH("A tool, B table, 1 2 3", "A 327.688466762576, B 18.434948822922", "A 212.311533237424, B 198.434948822922",
         MAB, "I1 J2 K3", RANGES("328", "327", "19", "18"), RANGES("213", "212", "199", "198")),
    BOTH("C-B head, B nutating, 1 1 1", "C 13.8260478038529, B 81.1005711201888",
         "C 256.173952196147, B 278.899428879811", N45, "I1 J1 K1", RANGES("14", "13", "82", "81"),
         RANGES("257", "256", "279", "278")),
    BOTH("B-C table, B nutating, 1 2 3", "B 52.8741729167231, C 44.0642169567833",
         "B 307.125827083277, C 262.805680689061", T45, "I1 J2 K3", RANGES("53", "52", "45", "44"),
         RANGES("308", "307", "263", "262")),
    {"1: C-B head, B nutating, 1 0 0, the edge of reach: C 270, B 180.", N45(RANGES("271", "269", "181", "179"), ""),
     TO("I1 J0 K0")},
    {"1: C-B head, B nutating, 0 0 -1 cannot be reached: PS5459.", N45("", ""), TO("I0 J0 K-1")},
    {"1: C-B head, 0 0 1 is singular: B 0, C stays at 30.", HC("", "[position]\nC = 30\nB = 20\n"), TO("I0 J0 K1")},
    {"1: C-B head tilted by RA 5, 0 0 1 cannot be reached: PS5459.", HC("19698 = 5\n", ""), TO("I0 J0 K1")},

    {"2: C-B head at (0,0), -1 1 2: C -45, B -35.2643896827547.", HC("", ""), TO("I-1 J1 K2")},
    {"2: C-B head at (100,0), -1 1 2: C 135, B 35.2643896827547.", HC("", "[position]\nC = 100\n"), TO("I-1 J1 K2")},
    {"2: C-B head at (350,0), -1 1 2: C 315, B -35.2643896827547.", HC("", "[position]\nC = 350\n"), TO("I-1 J1 K2")},
    {"2: C-B head at (45,0), -1 1 2, both pairs move equally far: C -45, B -35.2643896827547, because C is nearer to "
     "0.",
     HC("", "[position]\nC = 45\n"), TO("I-1 J1 K2")},
    {"2: C-B head at (0,0), 0 1 1, a complete tie: C 90, B 45.", HC("", ""), TO("I0 J1 K1")},
    {"2: A-C table at (0,0), -1 1 2: A -35.2643896827547, C 45.", TAC("", ""), TO("I-1 J1 K2")},
    {"2: A-C table at (0,0) with A from -30 to 30, -1 1 2: PS5459.", TAC(RANGES("30", "-30", "0", "0"), ""),
     TO("I-1 J1 K2")},
    {"2: B tool at 30, C table at 0, to the direction of (30,170): B -30, C -10, because the table then moves less.",
     MBC("", "[position]\nB = 30\n"), TO(TO_B30_C170)},
    {"2: B tool at 30, C table at 0, to the direction of (30,170) with PRI = 1: B 30, C 170.",
     MBC("\"19608#5\" = 1\n", "[position]\nB = 30\n"), TO(TO_B30_C170)},
    {"2: A-C table at (30,0), to the direction of (30,170): A 30, C 170, because the first axis then does not move.",
     TAC("", ""), TO(TO_A30_C0) TO_A30_C170 "\n"},
    {"2: A-C table at (30,0), to the direction of (30,170) with PRI = 1: A -30, C -10.", TAC("\"19608#5\" = 1\n", ""),
     TO(TO_A30_C0) TO_A30_C170 "\n"},

    {"3 with P0: the edge of the pyramid. C turns evenly while B does not move, and the tool leaves the plane: V = "
     "(-0.577350269189626, 0, 0.816496580927726) in the middle.",
     HC("", LENGTH_100 "[position]\nC = 130\nB = 30\n"),
     "G90 G43.5 H1 P0 X20. Y-20. I-1 J1 K2\nG01 Y20. I-1 J-1 K2 F100\n", "", 4},

    {"9: A-C table with offsets, the frame fixed at A 20 C 45, then A -35 C 10: the tip is at (67.5977865158401, "
     "-84.213831437203, -19.7483455042551) of the machine, V = (0.328989928337166, 0.72167761037298, "
     "0.609054228898422).",
     TAC(TABLE_OFFSETS, LENGTH_100 TABLE_ORIGIN "[position]\nA = 20\nC = 45\n"),
     "G90 G43.4 H1 P0\nG01 X20. Y-20. Z5. A-35. C10. F100\n"},

    {"11: Q2, V = Z, toward +X: (0.034899496702501, 0, 0.999390827019096).", HC("", ""),
     "G90 G43.5 H0 P0 Q2\nG01 X10. I0 J0 K1 F100\n"},
    {"11: Q3, V along -1 1 2, toward +Y: (-0.398133605769323, 0.45546477337505, 0.796267211538646), C "
     "131.157551336705, B 37.2248886695106.",
     HC("", "[position]\nC = 130\nB = 30\n"), "G90 G43.5 H0 P0 Q3\nG01 Y10. I-1 J1 K2 F100\n"},
    {"11: Q3 from the other pair: C 311.157551336705, B 322.775111330489.", HC("", "[position]\nC = 310\nB = 320\n"),
     "G90 G43.5 H0 P0 Q3\nG01 Y10. I-1 J1 K2 F100\n"},
    {"11: C-B head with offsets, length 100 + 30: control point F (-31.724539849193, 31.724539849193, "
     "198.804418757713).",
     HC("19666 = 30\n19711 = 40\n19712 = 25\n19714 = 60\n", LENGTH_100), "G90 G43.5 H1 P0 X20. Y-20. I-1 J1 K2\n"},
};

#undef TO
#undef BOTH
#undef LENGTH_100

}  // namespace

std::span<const Example> tool_center_point_control_examples() { return kExamples; }

}  // namespace toolcomp::corpus
