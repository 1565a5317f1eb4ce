// SPDX-License-Identifier: Apache-2.0
// Canned cycles: every rule, worked out by hand. The row of a hole gives its position, point R (r), the bottom (b), the
// level of return (t), and the axes after the hole.
#include "corpus/examples.h"

namespace toolcomp::corpus {
namespace {

#define XYZ "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n"
#define AT_50 "[position]\nZ = 50\n"
#define BY_PLANE "[parameters]\n\"5101#0\" = 1\n"

constexpr Example kExamples[] = {
    {"G81 under G98: point R is 3, the bottom is -15, and the tool returns to the initial level 50, where it stood "
     "before. A second block with X alone keeps R and Z. After G80, G00 moves on from there.",
     XYZ AT_50, "G90 G98 G81 X10. Y20. Z-15. R3. F100\nX30.\nG80\nG00 Y0\n",
     "1 hole 10 20 r 3 b -15 t 50 X10 Y20 Z50\n"
     "2 hole 30 20 r 3 b -15 t 50 X30 Y20 Z50\n"
     "4 p G0 30 0 50\n"},
    {"G99 returns to point R. G98 in a later block returns to the initial level 50, which G99 has not changed.",
     XYZ AT_50, "G90 G99 G81 X10. Z-15. R3. F100\nX20.\nG98 X30.\nG80 X40.\n",
     "1 hole 10 0 r 3 b -15 t 3 X10 Y0 Z3\n"
     "2 hole 20 0 r 3 b -15 t 3 X20 Y0 Z3\n"
     "3 hole 30 0 r 3 b -15 t 50 X30 Y0 Z50\n"
     "4 p G0 40 0 50\n"},
    {"Under G91, R is measured from the initial level and Z from point R: 50 - 47 = 3, 3 - 18 = -15. X and Y are "
     "distances.",
     XYZ AT_50, "G91 G99 G81 X10. Y5. Z-18. R-47. F100\nX10. Y5.\nG80 Z1.\n",
     "1 hole 10 5 r 3 b -15 t 3 X10 Y5 Z3\n"
     "2 hole 20 10 r 3 b -15 t 3 X20 Y10 Z3\n"
     "3 p G0 20 10 4\n"},
    {"R and Z given under G90 keep their levels under G91: one hole, then a row of three more by G91 K3.", XYZ AT_50,
     "G90 G99 G81 X0 Y0 Z-20. R2. F100\nG91 X14. K3\n",
     "1 hole 0 0 r 2 b -20 t 2 X0 Y0 Z2\n"
     "2 hole 14 0 r 2 b -20 t 2 X14 Y0 Z2\n"
     "2 hole 28 0 r 2 b -20 t 2 X28 Y0 Z2\n"
     "2 hole 42 0 r 2 b -20 t 2 X42 Y0 Z2\n"},
    {"R and Z given under G91 remain distances: R-45 from the initial level 50 and Z-10 from point R. A new R40 under "
     "G90 therefore moves the bottom to 30.",
     XYZ AT_50, "G91 G98 G82 X1. Z-10. R-45. F100\nG90 R40.\n",
     "1 hole 1 0 r 5 b -5 t 50 X1 Y0 Z50\n"
     "2 hole 1 0 r 40 b 30 t 50 X1 Y0 Z50\n"},
    {"K under G90 drills several times at one place. L is used as K in a block without K. K is valid in its own block "
     "only.",
     XYZ AT_50, "G90 G81 X10. Z-5. R2. K2 F100\nX20. L2\nX30.\n",
     "1 hole 10 0 r 2 b -5 t 50 X10 Y0 Z50\n"
     "1 hole 10 0 r 2 b -5 t 50 X10 Y0 Z50\n"
     "2 hole 20 0 r 2 b -5 t 50 X20 Y0 Z50\n"
     "2 hole 20 0 r 2 b -5 t 50 X20 Y0 Z50\n"
     "3 hole 30 0 r 2 b -5 t 50 X30 Y0 Z50\n"},
    {"K0 stores the cycle data and moves nothing. The next hole uses the data, and its G91 X4 is measured from where "
     "the tool stands.",
     XYZ AT_50, "G90 G81 X10. Z-5. R2. K0 F100\nG91 X4.\n", "2 hole 4 0 r 2 b -5 t 50 X4 Y0 Z50\n"},
    {"Without R, point R is the initial level. Without Z, the bottom is point R.", XYZ AT_50,
     "G90 G81 X10. F100\nR20.\nZ5.\n",
     "1 hole 10 0 r 50 b 50 t 50 X10 Y0 Z50\n"
     "2 hole 10 0 r 20 b 20 t 50 X10 Y0 Z50\n"
     "3 hole 10 0 r 20 b 5 t 50 X10 Y0 Z50\n"},
    {"The length offset: H1 = 100 is in force, then H2 = 120 in the block of a hole. The change makes no move of its "
     "own.",
     XYZ "[offsets.H]\n1 = 100\n2 = 120\n", "G90 G00 G43 H1 Z50.\nG99 G81 X10. Z-5. R2. F100\nG43 H2 X20.\nG80 Z60.\n",
     "1 p G0 X0 Y0 Z150\n"
     "2 hole 10 0 r 2 b -5 t 2 X10 Y0 Z102\n"
     "3 hole 20 0 r 2 b -5 t 2 X20 Y0 Z122\n"
     "4 p G0 X20 Y0 Z180\n"},
    {"A block in the drilling mode that drills no hole moves only by the change of its length offset.",
     XYZ "[offsets.H]\n1 = 100\n2 = 120\n", "G90 G00 G43 H1 Z50.\nG98 G81 X10. Z-5. R2. F100\nG43 H2\n",
     "1 p G0 X0 Y0 Z150\n"
     "2 hole 10 0 r 2 b -5 t 50 X10 Y0 Z150\n"
     "3 p G0 X10 Y0 Z170\n"},
    {"Length offset type C acts on the drilling axis, although the block also has X and Y: no PS0027.",
     XYZ "[parameters]\n\"5001#0\" = 1\n[offsets.H]\n1 = 100\n", "G90 G43 H1 G81 X10. Y5. Z-5. R2. F100\n",
     "1 hole 10 5 r 2 b -5 t 0 X10 Y5 Z100\n"},
    {"FXY (5101#0) = 1: the drilling axis is Y in G18 and X in G19. The position of the hole is Z and X in G18, Y and "
     "Z in G19.",
     XYZ BY_PLANE "[position]\nX = 30\nY = 40\n",
     "G90 G18 G81 Z5. X6. Y-8. R1. F100\nG80\nG19 G99 G85 X-9. Y7. Z2. R4.\n",
     "1 hole 6 5 r 1 b -8 t 40 X6 Y40 Z5\n"
     "3 hole 7 2 r 4 b -9 t 4 X4 Y7 Z2\n"},
    {"FXY = 0: the drilling axis is Z in G18 too.", XYZ AT_50, "G90 G18 G81 X6. Y-8. Z-1. R1. F100\n",
     "1 hole 6 -8 r 1 b -1 t 50 X6 Y-8 Z50\n"},
    {"Another cycle code in the drilling mode keeps the data and the initial level: G99 leaves the tool at 3 after the "
     "first hole, G98 raises it to 50 after the second.",
     XYZ AT_50, "G90 G99 G81 X10. Z-15. R3. F100\nG98 G85 X20.\n",
     "1 hole 10 0 r 3 b -15 t 3 X10 Y0 Z3\n"
     "2 hole 20 0 r 3 b -15 t 50 X20 Y0 Z50\n"},
    {"A code of group 01 ends the drilling mode and clears its data. The next initial level is where the tool then "
     "stands, at 3.",
     XYZ AT_50, "G90 G99 G81 X10. Z-15. R3. F100\nG00 X20.\nG98 G81 X30. Z-4.\n",
     "1 hole 10 0 r 3 b -15 t 3 X10 Y0 Z3\n"
     "2 p G0 20 0 3\n"
     "3 hole 30 0 r 3 b -4 t 3 X30 Y0 Z3\n"},
    {"A cycle code in a block with a code of group 01 is cancelled, in either order. Of G80 and G81 in one block, the "
     "last is valid.",
     XYZ AT_50, "G90 G81 G01 X10. Z40. R3. F100\nG00 G82 X20.\nG81 G80 X30.\nG80 G81 X40. Z1. R2.\n",
     "1 p G1 10 0 40\n"
     "2 p G0 20 0 40\n"
     "3 p G0 30 0 40\n"
     "4 hole 40 0 r 2 b 1 t 40 X40 Y0 Z40\n"},
    {"Another work coordinate system changes the coordinates of the position and of the initial level: the zero of G55 "
     "is 10 higher, so 50 becomes 40.",
     XYZ AT_50 "[workpiece.G55]\nZ = 10\n", "G90 G99 G81 X1. Z-5. R2. F100\nG55\nG98 X2.\n",
     "1 hole 1 0 r 2 b -5 t 2 X1 Y0 Z2\n"
     "3 hole 2 0 r 2 b -5 t 40 X2 Y0 Z40\n"},
    {"G52 and G04 in the drilling mode: their axis words drill no hole. After G52 X5 the X coordinate of the position "
     "is 5 less.",
     XYZ AT_50, "G90 G81 X10. Z-5. R2. F100\nG52 X5.\nG04 X2.\nX10.\n",
     "1 hole 10 0 r 2 b -5 t 50 X10 Y0 Z50\n"
     "4 hole 10 0 r 2 b -5 t 50 X10 Y0 Z50\n"},
    {"G45 does nothing in the drilling mode. The shift of 4 in X that it made before also applies to the holes.",
     XYZ AT_50 "[offsets.D]\n1 = 4\n", "G91 G45 G00 X10. D1\nG90 G81 X20. Z-5. R2. F100\nG45 X30.\n",
     "1 p G0 14 0 50\n"
     "2 hole 24 0 r 2 b -5 t 50 X24 Y0 Z50\n"
     "3 hole 34 0 r 2 b -5 t 50 X34 Y0 Z50\n"},
    {"G02 was in force before the drilling mode: R and I J make no arc in the mode. A block with R alone drills, a "
     "block with I J alone does not.",
     XYZ AT_50, "G90 G02 X10. Y0 R5. F100\nG81 Z-5. R2.\nI1. J1.\nR1.\n",
     "1 p G2 10 0 50 O 5 0 w 180\n"
     "2 hole 10 0 r 2 b -5 t 50 X10 Y0 Z50\n"
     "4 hole 10 0 r 1 b -5 t 50 X10 Y0 Z50\n"},
    {"The Q of G83 is kept, and G73 after it needs no Q. Q0 raises PS0045.", XYZ AT_50,
     "G90 G83 X1. Z-5. R2. Q3. F100\nG73 X2.\nX3. Q0\n",
     "1 hole 1 0 r 2 b -5 t 50 X1 Y0 Z50\n"
     "2 hole 2 0 r 2 b -5 t 50 X2 Y0 Z50\n"
     "3 PS0045\n"},
    {"G83 without Q raises PS0045. With K0 the cycle is only stored, and the next hole raises the alarm. The Q of a "
     "block that drills no hole is not kept.",
     XYZ AT_50, "G90 G83 X1. Z-5. R2. K0 F100\nQ3.\nX2.\n", "3 PS0045\n"},
    {"A hole without F raises PS0011. K0 and a block that drills no hole raise no alarm.",
     XYZ AT_50 "[parameters]\n1411 = 0\n", "G90 G81 Z-5. R2. K0\nG98\nX1.\n", "3 PS0011\n"},
    {"G28 in the drilling mode, with or without axis words: PS0044.", XYZ AT_50, "G90 G81 X1. Z-5. R2. F100\nG28\n",
     "1 hole 1 0 r 2 b -5 t 50 X1 Y0 Z50\n"
     "2 PS0044\n"},
    {"A cycle under G41: the contour before it runs to the end of its last block, then comes the alarm.",
     XYZ "[offsets.D]\n1 = 2\n", "G90 G01 G41 X10. D1 F100\nY20.\nG81 X5. Z-5. R2.\n",
     "1 s G1 8 0 0\n"
     "2 p G1 8 20 0\n"
     "3 FORBIDDEN_IN_CUTTER_COMPENSATION\n"},
    {"G40 with its move, then a cycle: allowed.", XYZ "[offsets.D]\n1 = 2\n",
     "G90 G01 G41 X10. D1 F100\nY20.\nG40 X0\nG81 X5. Z-5. R2.\n",
     "1 s G1 8 0 0\n"
     "2 p G1 8 20 0\n"
     "3 e G1 0 20 0\n"
     "4 hole 5 20 r 2 b -5 t 0 X5 Y20 Z0\n"},
    {"G40 in the block of a cycle: the manual does not say how the compensation vector is removed.",
     XYZ "[offsets.D]\n1 = 2\n", "G90 G01 G41 X10. D1 F100\nY20.\nG40 G81 X5. Z-5. R2.\n",
     "1 s G1 8 0 0\n"
     "2 p G1 8 20 0\n"
     "3 fanuc.canned-cycle.not-said\n"},
    {"A cycle under G41.3, whose vector of length 2 points backward: FORBIDDEN_IN_3D_COMPENSATION.",
     XYZ "[offsets.D]\n1 = 2\n", "G90 G01 F100\nG41.3 D1\nX10.\nG81 X5. Z-5. R2.\n",
     "2 s G1 -2 0\n"
     "3 p G1 8 0\n"
     "4 FORBIDDEN_IN_3D_COMPENSATION\n"},
    {"A change of plane in the drilling mode, to a plane with another drilling axis: the manual does not say what "
     "happens.",
     XYZ BY_PLANE, "G90 G17 G81 X1. Z-5. R2. F100\nG18 X2.\n",
     "1 hole 1 0 r 2 b -5 t 0 X1 Y0 Z0\n"
     "2 fanuc.canned-cycle.not-said\n"},
    {"K1.5 is not a whole number of repeats: the manual does not say what happens.", XYZ,
     "G90 G81 X1. Z-5. R2. K1.5 F100\n", "1 fanuc.canned-cycle.not-said\n"},
    {"G87 returns to the initial level. The manual does not say what G87 with G99 does.", XYZ AT_50,
     "G90 G98 G87 X1. Z15. R-8. Q4. F30\nG99 X2.\n",
     "1 hole 1 0 r -8 b 15 t 50 X1 Y0 Z50\n"
     "2 fanuc.canned-cycle.not-said\n"},
};

#undef XYZ
#undef AT_50
#undef BY_PLANE

}  // namespace

std::span<const Example> canned_cycle_examples() { return kExamples; }

}  // namespace toolcomp::corpus
