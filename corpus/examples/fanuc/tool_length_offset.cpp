// SPDX-License-Identifier: Apache-2.0
// Tool length offset: the examples of chapter 14, 14.1.1, 14.1.2 and 14.8.
#include "corpus/examples.h"

namespace toolcomp::corpus {
namespace {

#define SETUP "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n"
#define ZERO "[workpiece.G54]\nZ = -300\n"

constexpr Example kExamples[] = {
    {"14.1.1, three holes bored with H1 = -4. Z axis: N2 -36, N3 -57, N5 -36, N7 -77, N8 -36, N10 -61, N12 0 (a move "
     "of +61). X and Y: N6 150 30, N9 200 60, N13 0 0.",
     SETUP "[offsets.H]\n1 = \"-4.0\"\n",
     "N1 G91 G00 X120.0 Y80.0\nN2 G43 Z-32.0 H1\nN3 G01 Z-21.0 F1000\nN4 G04 P2000\nN5 G00 Z21.0\n"
     "N6 X30.0 Y-50.0\nN7 G01 Z-41.0\nN8 G00 Z41.0\nN9 X50.0 Y30.0\nN10 G01 Z-25.0\nN11 G04 P2000\n"
     "N12 G00 Z57.0 H0\nN13 X-200.0 Y-60.0\nN14 M2\n",
     "1 G0 X120 Y80 Z0\n"
     "2 G0 X120 Y80 Z-36\n"
     "3 G1 X120 Y80 Z-57\n"
     "5 G0 X120 Y80 Z-36\n"
     "6 G0 X150 Y30 Z-36\n"
     "7 G1 X150 Y30 Z-77\n"
     "8 G0 X150 Y30 Z-36\n"
     "9 G0 X200 Y60 Z-36\n"
     "10 G1 X200 Y60 Z-61\n"
     "12 G0 X200 Y60 Z0\n"
     "13 G0 X0 Y0 Z0\n"},
    {"14.1.1, H1 = 20, then H2 = 30 at the same height: 120, then 130, which is a move of 10 and not a move to 150.",
     SETUP "[offsets.H]\n1 = 20\n2 = 30\n", "G90 G43 Z100 H1\nG90 G43 Z100 H2\n",
     "1 X0 Y0 Z120\n"
     "2 X0 Y0 Z130\n"},
    {"14.1.1, OFH = 0: H1 = 10 alone moves nothing; G43 Z-20 goes to -10, G44 Z-30 H02 (7) to -37, the lone H03 (3) to "
     "-33.",
     SETUP "[offsets.H]\n1 = 10\n2 = 7\n3 = 3\n", "H01\nG90 G43 Z-20\nG44 Z-30 H02\nH03\n",
     "2 X0 Y0 Z-10\n"
     "3 X0 Y0 Z-37\n"
     "4 X0 Y0 Z-33\n"},
    {"14.1.1, OFH = 1, the same program: the lone H01 has no effect, G43 Z-20 goes to -20, G44 Z-30 H02 to -37; the "
     "lone H03 makes no move.",
     SETUP "[parameters]\n\"5001#2\" = 1\n[offsets.H]\n1 = 10\n2 = 7\n3 = 3\n",
     "H01\nG90 G43 Z-20\nG44 Z-30 H02\nH03\n",
     "2 X0 Y0 Z-20\n"
     "3 X0 Y0 Z-37\n"},
    {"14.1.1, G91 with H1 = 5, H2 = 8: Z-10 goes to -5, the next Z-10 to -12 (a move of -7).",
     SETUP "[offsets.H]\n1 = 5\n2 = 8\n", "G91\nG43 Z-10 H1\nZ-10 H2\n",
     "2 X0 Y0 Z-5\n"
     "3 X0 Y0 Z-12\n"},
    {"14.1.1, type C, TAL = 0, H1 = 4, H2 = 6, H3 = 2: X14, lone H2 X16, then G43 on a second axis raises PS0027.",
     SETUP "[parameters]\n\"5001#0\" = 1\n[offsets.H]\n1 = 4\n2 = 6\n3 = 2\n", "G90 G43 X10 H1\nH2\nG43 Y0 H3\nH1\n",
     "1 X14 Y0 Z0\n"
     "2 X16 Y0 Z0\n"
     "3 PS0027\n"},
    {"14.1.1, type C, TAL = 1, the same program: X14, X16, then Y2 with X16 kept, then lone H1 acts on Y: Y4, X16.",
     SETUP "[parameters]\n\"5001#0\" = 1\n\"5001#3\" = 1\n[offsets.H]\n1 = 4\n2 = 6\n3 = 2\n",
     "G90 G43 X10 H1\nH2\nG43 Y0 H3\nH1\n",
     "1 X14 Y0 Z0\n"
     "2 X16 Y0 Z0\n"
     "3 X16 Y2 Z0\n"
     "4 X16 Y4 Z0\n"},
    {"14.1.1, G49 alone at programmed Z100 with H = 20: from 120 to 100.", SETUP "[offsets.H]\n1 = 20\n",
     "G43 Z100 H1\nG49\n",
     "1 X0 Y0 Z120\n"
     "2 X0 Y0 Z100\n"},
    {"14.1.2, work zero at machine Z-300, H1 = 20. In workpiece coordinates: H1 goes to 20, Z50 to 70, G53 Z-10 to 290 "
     "(machine -10). With EVO = 0 the next Z50 goes to 50 (machine -250), and H1 to 70 (machine -230).",
     SETUP "[offsets.H]\n1 = 20\n" ZERO, "G43 H1\nG90 G00 Z50\nG53 Z-10\nZ50\nH1\n",
     // Work zero at machine Z-300: a machine position of the comment plus 300.
     "1 X0 Y0 Z20\n"
     "2 X0 Y0 Z70\n"
     "3 X0 Y0 Z290\n"
     "4 X0 Y0 Z50\n"
     "5 X0 Y0 Z70\n"},
    {"14.1.2, the same with EVO = 1: after G53, Z50 goes to 70 (machine -230) at once, and the H1 after it moves "
     "nothing.",
     SETUP "[parameters]\n\"5001#6\" = 1\n[offsets.H]\n1 = 20\n" ZERO, "G43 H1\nG90 G00 Z50\nG53 Z-10\nZ50\nH1\n",
     "1 X0 Y0 Z20\n"
     "2 X0 Y0 Z70\n"
     "3 X0 Y0 Z290\n"
     "4 X0 Y0 Z70\n"},
    {"14.1.2, G53 X0 keeps the vector of Z: Z stays at 70, and so does the Z50 after it (machine -230).",
     SETUP "[offsets.H]\n1 = 20\n" ZERO, "G43 H1\nG90 G00 Z50\nG53 X0\nZ50\n",
     "1 X0 Y0 Z20\n"
     "2 X0 Y0 Z70\n"
     "3 X0 Y0 Z70\n"
     "4 X0 Y0 Z70\n"},
    {"14.1.2, G28 Z80: first the intermediate point with the vector, 100 (machine -200), then the reference position "
     "without it, 300 (machine 0). With EVO = 0 the next Z50 goes to 50.",
     SETUP "[offsets.H]\n1 = 20\n" ZERO, "G43 Z50 H1\nG28 Z80\nZ50\n",
     "1 X0 Y0 Z70\n"
     "2 X0 Y0 Z100\n"
     "2 X0 Y0 Z300\n"
     "3 X0 Y0 Z50\n"},
    {"14.1.2, G49 G28 Z80: first the intermediate point without the vector, 80 (machine -220), then 300 (machine 0). "
     "G49 stays in force, so neither Z50 nor H1 restores the vector: 50, then no move.",
     SETUP "[parameters]\n\"5001#6\" = 1\n[offsets.H]\n1 = 20\n" ZERO, "G43 Z50 H1\nG49 G28 Z80\nZ50\nH1\n",
     "1 X0 Y0 Z70\n"
     "2 X0 Y0 Z80\n"
     "2 X0 Y0 Z300\n"
     "3 X0 Y0 Z50\n"},
    {"14.1.2, type B, first an X offset of 4, then a Z offset of 20: G28 X0 Z80 cancels both (intermediate X4 Z100, "
     "then 0 0). The next H1 restores only that of Z: X5 Z25.",
     SETUP "[parameters]\n\"5001#1\" = 1\n[offsets.H]\n1 = 20\n4 = 4\n",
     "G19 G43 X0 H4\nG17 G43 Z0 H1\nG28 X0 Z80\nG00 X5 Z5\nH1\n",
     "1 p G0 X4 Y0 Z0\n"
     "2 p G0 X4 Y0 Z20\n"
     "3 r G0 X4 Y0 Z100\n"
     "3 r G0 X0 Y0 Z0\n"
     "4 p G0 X5 Y0 Z5\n"
     "5 p G0 X5 Y0 Z25\n"},
    {"14.1.2, EVO = 1: a block with G40 does not restore the vector (Z stays at 290, machine -10). The X50 after it "
     "does: Z310, a move of the offset alone (machine 10).",
     SETUP "[parameters]\n\"5001#6\" = 1\n[offsets.H]\n1 = 20\n" ZERO, "G43 Z50 H1\nG53 Z-10\nG40 X10\nX50\n",
     "1 X0 Y0 Z70\n"
     "2 X0 Y0 Z290\n"
     "3 X10 Y0 Z290\n"
     "4 X50 Y0 Z310\n"},
    {"14.8, memory C: H5 has geometry 100.5 and wear -0.25: 100.25. G91 G10 L11 R0.05 changes the wear to -0.2, and "
     "the next H5 goes to 100.3.",
     SETUP "[offsets.H]\n5 = { geometry = \"100.5\", wear = \"-0.25\" }\n", "G43 Z0 H5\nG91 G10 L11 P5 R0.05\nG90 H5\n",
     "1 X0 Y0 Z100.25\n"
     "2 H5.wear=-0.2\n"
     "3 X0 Y0 Z100.3\n"},
    {"14.8, memory A: G10 L11 P3 R12 sets H3: 12.", SETUP "[offsets.H]\n3 = 1\n", "G10 L11 P3 R12\nG43 Z0 H3\n",
     "1 H3=12\n"
     "2 X0 Y0 Z12\n"},
    {"14.8, a wear of 100 mm is beyond the range of IS-B: PS0032.",
     SETUP "[offsets.H]\n5 = { geometry = \"100.5\", wear = \"-0.25\" }\n", "G10 L11 P5 R100\n", "1 PS0032\n"},
    {"14.8, offset number 1000 in a memory of 999: PS0031.", SETUP "[offsets]\ncount = 999\n[offsets.H]\n1 = 1\n",
     "G10 L11 P1000 R1\n", "1 PS0031\n"},
};

#undef SETUP
#undef ZERO

}  // namespace

std::span<const Example> tool_length_offset_examples() { return kExamples; }

}  // namespace toolcomp::corpus
