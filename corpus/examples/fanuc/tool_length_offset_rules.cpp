// SPDX-License-Identifier: Apache-2.0
// Tool length offset: one program for each rule that generated programs seldom meet.
#include "corpus/examples.h"

namespace toolcomp::corpus {
namespace {

#define SETUP "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n"

constexpr Example kRules[] = {
    {"5006#6 = 1: G43, H, G49 alone move nothing. After G43 H1 the axis at 100 has the coordinate 90. G91 Z-10 moves "
     "the axis to 90, G90 Z50 to 60. After H2 its coordinate is 56, after G49 60. G91 G43 Z-5 moves it 5 down, to 55, "
     "and G90 G44 Z0 to -10.",
     SETUP "[parameters]\n\"5006#6\" = 1\n[offsets.H]\n1 = 10\n2 = 4\n",
     "G90 G00 Z100.\nG43 H1\nG91 Z-10.\nG90 Z50.\nH2\nG91 Z0\nG49\nZ0\nG43 Z-5. H1\nG90 G44 Z0 H1\n",
     "1 X0 Y0 Z100\n"
     "3 X0 Y0 Z90\n"
     "4 X0 Y0 Z60\n"
     "6 X0 Y0 Z60\n"
     "8 X0 Y0 Z60\n"
     "9 X0 Y0 Z55\n"
     "10 X0 Y0 Z-10\n"},
    {"Arcs by I J about (0, 0) under an offset of 20: a quarter of a circle of radius 10; a spiral from radius 10 to "
     "20 (sweep 90); a spiral from 20 back to 10 (sweep 180); an arc that ends at its centre has no sweep. Z is always "
     "20.",
     SETUP "[offsets.H]\n1 = 20\n", "G43 H1\nG00 X10\nG17 G03 X0 Y10 I-10 F100\nX-20 Y0 J-10\nX10 Y0 I20\nX0 I-10\n",
     "1 X0 Y0 Z20\n"
     "2 X10 Y0 Z20\n"
     "3 X0 Y10 Z20 O 0 0 w 90\n"
     "4 X-20 Y0 Z20 O 0 0 r 10 20 w 90\n"
     "5 X10 Y0 Z20 O 0 0 r 20 10 w 180\n"
     "6 X0 Y0 Z20 O 0 0 r 10 0 w 0\n"},
    {"Arcs by R: R10 over a chord of 20 is a half circle about (10, 0). R-10 over a chord of 10, clockwise, is the "
     "larger arc of 300 degrees about (15, -5 sqrt 3) = (15, -8.660254037844386). R4 is too short for a chord of 10: "
     "PS0020.",
     SETUP "[offsets.H]\n1 = 20\n", "G17 G02 X20 R10 F100\nX10 R-10\nX0 R4\n",
     "1 X20 Y0 Z0 O 10 0 w 180\n"
     "2 X10 Y0 Z0 O 15 -8.660254037844386 w 300\n"
     "3 PS0020\n"},
    {"After G52 X2 machine 5 is X3, and X5 is machine 7. G54.1 P2 (X100) with G52: X0 is machine 102. After G52 X0 "
     "this point is X2, and machine 0 is X-100.",
     SETUP "[workpiece.P2]\nX = 100\n[workpiece.external]\nY = 1\n",
     "G00 X5\nG52 X2\nX5\nG54.1 P2 X0\nG52 X0\nG53 X0\n",
     "1 X5 Y0 Z0\n"
     "3 X5 Y0 Z0\n"
     "4 X0 Y0 Z0\n"
     "6 X-100 Y0 Z0\n"},
    {"G92 ends the local system of its axis: after G92 machine 0 is X7, so X7 is machine 0 and G53 X0 does not move.",
     SETUP, "G52 X2\nG92 X7\nG00 X7\nG53 X0\n",
     "3 X7 Y0 Z0\n"
     "4 X7 Y0 Z0\n"},
    {"G10 L2 P1 sets G54 to 10, and under G91 to 15. P0 adds 1 to all. G10 L20 P3 sets G54.1 P3 to 50, where machine 0 "
     "is X-51. L20 has no P49: PS0031.",
     SETUP,
     "G10 L2 P1 X10\nG00 X0\nG91 G10 L2 P1 X5\nG90 X0\nG10 L2 P0 X1\nG10 L20 P3 X50\nG54.1 P3 X0\nG53 X0\nG10 L20 P49 "
     "X0\n",
     "2 X0 Y0 Z0\n"
     "4 X0 Y0 Z0\n"
     "7 X0 Y0 Z0\n"
     "8 X-51 Y0 Z0\n"
     "9 PS0031\n"},
    {"G54.1 without P is P1 (X5), where machine 0 is X-5. There is no P49: PS0030.", SETUP "[workpiece.P1]\nX = 5\n",
     "G54.1\nG53 X0\nG54.1 P49\n",
     "2 X-5 Y0 Z0\n"
     "3 PS0030\n"},
    {"Modes without effect: the X9 of G05.1 moves nothing, and the F3 of G93 is not a feed per minute.", SETUP,
     "G21 G80 G64 G05.1 Q1 X9\nG01 X1 F100\nG93\nX2 F3\nG94\nX3 F100\n",
     "2 X1 Y0 Z0\n"
     "4 X2 Y0 Z0\n"
     "6 X3 Y0 Z0\n"},
    {"M98 P7 L2 runs O7 twice, 10 each time, and continues after the call.", SETUP,
     "G00 X1\nM98 P7 L2\nX0\nM30\nO7\nG91 X10\nG90 M99\n",
     "1 X1 Y0 Z0\n"
     "6 X11 Y0 Z0\n"
     "6 X21 Y0 Z0\n"
     "3 X0 Y0 Z0\n"},
    {"M99 P20 continues at N20.", SETUP, "M98 P7\nG00 X1\nN20 X2\nM30\nO7\nX3 M99 P20\n",
     "6 X3 Y0 Z0\n"
     "3 X2 Y0 Z0\n"},
    {"No program O8: PS0076.", SETUP, "G00 X1\nM98 P8\n",
     "1 X1 Y0 Z0\n"
     "2 PS0076\n"},
    {"There is no block N5 after the call: PS0078.", SETUP, "M98 P7\nM30\nO7\nM99 P5\n", "4 PS0078\n"},
    {"There is no G77.7: PS0010.", SETUP, "G00 X1\nG77.7\n",
     "1 X1 Y0 Z0\n"
     "2 PS0010\n"},
    {"G68 is not supported: no alarm.", SETUP, "G00 X1\nG69\nG90 G68 X0 Y0 R30.\n",
     "1 X1 Y0 Z0\n"
     "3 not_supported G68\n"},
    {"Variables set at the head of the program give the numbers of its words.", SETUP,
     "G90\n#100=5.\n#101=[#100+2.]*2\nG00 X#100 Y[#101-1.5] Z-#100\n", "4 X5 Y12.5 Z-5\n"},
    {"An R block whose end is its start is an arc of 0 degrees (B-64114EN p.43): no move, and the program continues to "
     "X5.",
     SETUP, "G90 G00 X0 Y0\nG02 X0 Y0 R10. F100\nG01 X5.\n",
     "1 X0 Y0 Z0\n"
     "2 X0 Y0 Z0\n"
     "3 X5 Y0 Z0\n"},
    {"R0 with an end that is not the start: there is no such circle, PS0020.", SETUP, "G02 X5 R0 F100\n", "1 PS0020\n"},
    {"An arc without centre: PS0022.", SETUP "[offsets.H]\n1 = 20\n", "G17 G02 X10 F100\n", "1 PS0022\n"},
    {"With CIR = 0 an arc without centre runs as a line to (10, 10).", SETUP "[parameters]\n\"3403#5\" = 0\n",
     "G02 X10. Y10. F100\n", "1 X10 Y10 Z0\n"},
    {"Radii 5 and 3 about (5, 0) differ by 2: with 3410 = 2 the arc is a spiral, with 3410 = 1.999 it raises PS0020.",
     SETUP "[parameters]\n3410 = 2\n", "G03 X8 Y0 I5 F100\n", "1 X8 Y0 Z0 O 5 0 r 5 3 w 180\n"},
    {"The same, with 3410 = 1.999.", SETUP "[parameters]\n3410 = \"1.999\"\n", "G03 X8 Y0 I5 F100\n", "1 PS0020\n"},
    {"No F: PS0011.", SETUP "[parameters]\n1411 = 0\n", "G00 X1\nG01 X5\n",
     "1 X1 Y0 Z0\n"
     "2 PS0011\n"},
    {"F0 counts as no F: PS0011.", SETUP, "G01 X1 F100\nX5 F0\n",
     "1 X1 Y0 Z0\n"
     "2 PS0011\n"},
    {"With AD2 = 1 an address twice is PS5074, and so are two codes of one group.",
     SETUP "[parameters]\n\"3403#6\" = 1\n", "G01 X1 X2\n", "1 PS5074\n"},
    {"G90 and G91 in one block, AD2 = 1: PS5074.", SETUP "[parameters]\n\"3403#6\" = 1\n", "G90 G91 X1\n",
     "1 PS5074\n"},
    {"G54 P2 is G54.1 P2, with its origin at 500: machine 0 is X-500 there.",
     SETUP "[workpiece.G54]\nX = 100\n[workpiece.P2]\nX = 500\n", "G90 G54 P2\nG53 X0\n", "2 X-500 Y0 Z0\n"},
    {"On the 30i G29 without an intermediate point is PS0305.", "series = \"30i\"\n" SETUP, "G29 X1\n", "1 PS0305\n"},
    {"On the 30i G10 without R is PS0031.", "series = \"30i\"\n" SETUP "[offsets.H]\n1 = 20\n", "G10 L11 P1\n",
     "1 PS0031\n"},
    {"Geometry 999.999 and wear 0.001 make 1000, beyond the geometry range of IS-B: PS0029 when G43 applies it.",
     SETUP "[offsets.H]\n1 = { geometry = \"999.999\", wear = \"0.001\" }\n", "G43 H1\n", "1 PS0029\n"},
    {"G10 without R writes nothing, with R it does: Z20, then Z7.", SETUP "[offsets.H]\n1 = 20\n",
     "G10 L11 P1\nG43 Z0 H1\nG10 L11 P1 R7\nH1\n",
     "2 X0 Y0 Z20\n"
     "3 H1=7\n"
     "4 X0 Y0 Z7\n"},
    {"After G53, an H in a block with G40 only stores its number: Z70, Z-10, no move, Z50. The lone H2 then applies "
     "its 7: Z57.",
     SETUP "[offsets.H]\n1 = 20\n2 = 7\n", "G43 Z50 H1\nG53 Z-10\nG40 H2\nZ50\nH2\n",
     "1 X0 Y0 Z70\n"
     "2 X0 Y0 Z-10\n"
     "4 X0 Y0 Z50\n"
     "5 X0 Y0 Z57\n"},
    {"G49 while three axes have an offset (type B): PS0015, X4 Y7 Z20 stay.",
     SETUP "[parameters]\n\"5001#1\" = 1\n[offsets.H]\n1 = 20\n2 = 7\n4 = 4\n",
     "G19 G43 X0 H4\nG18 G43 Y0 H2\nG17 G43 Z0 H1\nG49\n",
     "1 X4 Y0 Z0\n"
     "2 X4 Y7 Z0\n"
     "3 X4 Y7 Z20\n"
     "4 PS0015\n"},
    {"EVO = 1: X5 restores the offset of 5 that G28 cancelled, Z105. The 7 that G10 then writes takes effect in the "
     "block with G40: Z107.",
     SETUP "[parameters]\n\"5001#6\" = 1\n[offsets.H]\n1 = 5\n[reference.1]\nZ = 100\n",
     "G90 G01 F100 G43 Z10. H1\nG28 Z20.\nX5.\nG10 L11 P1 R7.\nG40 X6.\nX7.\n",
     "1 X0 Y0 Z15\n"
     "2 X0 Y0 Z25\n"
     "2 X0 Y0 Z100\n"
     "3 X5 Y0 Z105\n"
     "4 H1=7\n"
     "5 X6 Y0 Z107\n"
     "6 X7 Y0 Z107\n"},
    {"Type C without an axis: PS0027.", SETUP "[parameters]\n\"5001#0\" = 1\n[offsets.H]\n1 = 20\n", "G43 H1\n",
     "1 PS0027\n"},
    {"An H beyond the number of offsets (400): PS0030.", SETUP "[offsets.H]\n1 = 20\n", "H401\n", "1 PS0030\n"},
    {"G53 under G91 is ignored together with its words: Z20 twice, no move between.", SETUP "[offsets.H]\n1 = 20\n",
     "G43 Z0 H1\nG91 G53 Z-10\nG90 Z0\n",
     "1 X0 Y0 Z20\n"
     "3 X0 Y0 Z20\n"},
    {"OFH = 1, the first G43 without H uses H0, a later one keeps the number: Z5, Z25, Z26.",
     SETUP "[parameters]\n\"5001#2\" = 1\n[offsets.H]\n1 = 20\n", "H1\nG43 Z5\nG43 Z5 H1\nG43 Z6\n",
     "2 X0 Y0 Z5\n"
     "3 X0 Y0 Z25\n"
     "4 X0 Y0 Z26\n"},
    {"G49 keeps the number: G43 Z5 without H applies the 20 of H1 again, Z25.", SETUP "[offsets.H]\n1 = 20\n",
     "G43 Z0 H1\nG49 Z0\nG43 Z5\n",
     "1 X0 Y0 Z20\n"
     "2 X0 Y0 Z0\n"
     "3 X0 Y0 Z25\n"},
    {"g49_sets_h0, G49 without H: G43 Z5 without H applies no offset, Z5. H1 then applies the 20, Z25.",
     "g49_sets_h0 = true\n" SETUP "[offsets.H]\n1 = 20\n", "G43 Z0 H1\nG49 Z0\nG43 Z5\nH1\n",
     "1 X0 Y0 Z20\n"
     "2 X0 Y0 Z0\n"
     "3 X0 Y0 Z5\n"
     "4 X0 Y0 Z25\n"},
    {"g49_sets_h0, G49 H2: the H in the block of G49 sets the number, so G43 Z5 without H applies its 7, Z12.",
     "g49_sets_h0 = true\n" SETUP "[offsets.H]\n1 = 20\n2 = 7\n", "G43 Z0 H1\nG49 Z0 H2\nG43 Z5\n",
     "1 X0 Y0 Z20\n"
     "2 X0 Y0 Z0\n"
     "3 X0 Y0 Z12\n"},
};

#undef SETUP

}  // namespace

std::span<const Example> tool_length_offset_rules() { return kRules; }

}  // namespace toolcomp::corpus
