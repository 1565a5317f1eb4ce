// SPDX-License-Identifier: Apache-2.0
// Face milling: the manual's situations and its syntax example, examples worked out by hand, and verdicts on tools with
// oversize (heidenhain.tool.oversize-radius, -corner, heidenhain.tool.corner-beyond-radius).
#include "corpus/examples/heidenhain/tools.h"

namespace toolcomp::corpus {
namespace {

#define CALL "TOOL CALL 1 Z S12000 F1000\n"
#define OVERSIZE "TOOL CALL 1 Z S12000 F1000 DL+0.2 DR+0.2 DR2+0.2\nM107\n"
#define ROW(r, r2, dr, dr2) TOOL_1("R = " r "\nR2 = " r2 "\nDR = " dr "\nDR2 = " dr2 "\n")
#define NORMAL(z) "LN X1 Y2 Z" z " NX0.6 NY0 NZ0.8 TX0 TY0 TZ1\n"
#define PERMITTED "TOOL CALL 1 Z\nM128\nM107\n" NORMAL("3") "M108\n"
#define WITHOUT_NORMAL "LN X1 Y2 Z4 TX0 TY0 TZ1 R0\n"
#define CHECKED "TOOL CALL 1 Z\nM128\n"

constexpr Example kExamples[] = {
    {"E1: a ball of 6 mm re-worked to 5.8 mm, output at the tip, block 13: the centre moves by -0.1 n, the contact "
     "stays.",
     TOOL_1(REWORKED), "0 BEGIN PGM E1 MM\n1 " CALL "2 LN " FACE_P " " FACE_N " " FACE_T " R0 M128\n3 END PGM E1 MM\n"},
    {"E2: the same tool, output at the centre, REFPNT CNT-CNT: the centre is P - 0.1 n. The overall length of 80 mm is "
     "known.",
     TOOL_1(REWORKED "L = 80\n"), CALL TCPM_CENTER "LN " FACE_P " " FACE_N " " FACE_T " R0\n"},
    {"E3: an oversize of 0.2 mm, output at the tip: the real tool moves by 0.2 n.", TOOL_1(BALL_6),
     OVERSIZE "LN " FACE_P " " FACE_N " " FACE_T " R0 M128\n"},
    {"E3 without M107: E_OVERSIZE_DR.", TOOL_1(BALL_6),
     "TOOL CALL 1 Z DL+0.2 DR+0.2 DR2+0.2\nLN " FACE_P " " FACE_N " " FACE_T " R0 M128\n"},
    {"E4: the same oversize, output at the centre, REFPNT CNT-CNT: the real centre is P + 0.2 n.", TOOL_1(BALL_6),
     OVERSIZE TCPM_CENTER "LN " FACE_P " " FACE_N " " FACE_T " R0\n"},
    {"E5: block 12, without TCPM the tool is along Z; re-worked.", TOOL_1(REWORKED),
     CALL "LN " FACE_P " " FACE_N " R0\n"},
    {"E5 with the oversize.", TOOL_1(BALL_6), OVERSIZE "LN " FACE_P " " FACE_N " R0\n"},
    {"E6: block 14, under TCPM the tool is along the normal; re-worked: nothing moves.", TOOL_1(REWORKED),
     CALL "LN " FACE_P " " FACE_N " R0 M128\n"},
    {"E6 with the oversize: the tip stays, the real tool moves by 0.2 n.", TOOL_1(BALL_6),
     OVERSIZE "LN " FACE_P " " FACE_N " R0 M128\n"},
    {"E7: block 11, a straight line L is not compensated whatever the deltas, and no check looks at them.",
     TOOL_1(BALL_6), "TOOL CALL 1 Z F1000 DL+0.2 DR+0.2 DR2+0.2\nL " FACE_P " R0\n"},
    {"5.10 without a normal: TCP' = P + R2' t with R2' = 0.98, (1,2,3.98), also with a tool vector, (1,2.588,3.784).",
     TOOL_1(TOROID_E11), "TOOL CALL 1 Z\nL X1 Y2 Z3 R0\nLN X1 Y2 Z3 TX0 TY0.6 TZ0.8 R0 M128\n"},
    {"5.10 without a normal under CNT-CNT: the tip P - R2 t, (1,2,2), TCP' = P + dR2 t, (1,2,2.98).",
     TOOL_1(TOROID_E11), "TOOL CALL 1 Z\n" TCPM_CENTER "L X1 Y2 Z3 R0\n"},
    {"E7, E5, E1 and E6 one after another.", TOOL_1(REWORKED),
     "0 BEGIN PGM HHFACE MM\n1 BLK FORM 0.1 Z X-50 Y-50 Z-20\n2 BLK FORM 0.2 X+50 Y+50 Z+0\n3 TOOL CALL 1 Z S12000 "
     "F1000\n4 L Z+100 R0 FMAX M3\n5 L " FACE_P " R0\n6 LN " FACE_P " " FACE_N " R0\n7 LN " FACE_P " " FACE_N " " FACE_T
     " R0 M128\n8 LN " FACE_P " " FACE_N " R0\n9 L Z+100 R0 FMAX M129\n10 M30\n11 END PGM HHFACE MM\n"},

    {"E11: a toroid cutter, 6/1 with DL 0.05, DR -0.1, DR2 -0.02, block 13.", TOOL_1(TOROID_E11),
     CALL "LN " FACE_P " " FACE_N " " FACE_T " R0 M128\n"},
    {"E11 under CNT-CNT.", TOOL_1(TOROID_E11), CALL TCPM_CENTER "LN " FACE_P " " FACE_N " " FACE_T " R0\n"},
    {"E11 without TCPM: u = (-1, 0, 0).", TOOL_1(TOROID_E11), CALL "LN " FACE_P " " FACE_N " R0\n"},
    {"E11 in block 14: the tip stays, the real tool moves by 0.05 n.", TOOL_1(TOROID_E11),
     CALL "LN " FACE_P " " FACE_N " R0 M128\n"},
    {"E13: normal and tool along Z: u = 0, the tip stays at P, and the delta of the length acts.", TOOL_1(TOROID_E11),
     "TOOL CALL 1 Z\nM128\nLN X10 Y20 Z5 NX0 NY0 NZ1 TX0 TY0 TZ1\n"},
    {"E13 with a normal nearly along Z: the ring touches, 0.08 to the side. Both blocks are in one program, so the "
     "contact jumps.",
     TOOL_1(TOROID_E11),
     "TOOL CALL 1 Z\nM128\nLN X10 Y20 Z5 NX0 NY0 NZ1 TX0 TY0 TZ1\nLN X10 Y20 Z5 NX0.0000001 NY0 NZ1 TX0 TY0 TZ1\n"},
    {"E16: rational, 5/2 with DL 0.25, DR 0.3, DR2 0.1, N = (0.6, 0, 0.8): u = (1, 0, 0), D_tip = (13/50, 0, -1/50).",
     TOOL_1(TOROID_E16), "TOOL CALL 1 Z\nLN X0 Y0 Z0 NX0.6 NY0 NZ0.8 M107\n"},
    {"E21: DR2 0.3 alone, under M107 the tool is a ball of 3.3 mm radius.", TOOL_1(BALL_6),
     "TOOL CALL 1 Z S5000 DR2:+0.3\nM107\nLN " FACE_P " " FACE_N " " FACE_T " R0 M128\n"},
    {"E23: sums of three deltas: DL 0.165, DR = DR2 = 0.11.",
     TOOL_1(BALL_6 "DL = -0.03\nDR = -0.1\nDR2 = -0.1\n") "[[correction.tcs]]\nnumber = 7\nDL = -0.005\nDR = "
                                                          "0.01\nDR2 = 0.01\n",
     "TOOL CALL 1 Z DL+0.2 DR+0.2 DR2+0.2\nSEL CORR-TABLE TCS \"TNC:\\table\\corr.tco\"\nFUNCTION CORRDATA TCS #7\n"
     "M107\nLN " FACE_P " " FACE_N " " FACE_T " R0 M128\n"},
    {"E25: an undercut, N = (0.6, 0, -0.8): the same formula and W_N_BELOW.", TOOL_1(REWORKED),
     "TOOL CALL 1 Z\nLN X0 Y0 Z0 NX0.6 NY0 NZ-0.8\n"},
    {"E27: a program in inches, the tool table in millimetres; F in tenths of an inch.", TOOL_1(REWORKED),
     "0 BEGIN PGM E27 INCH\n1 TOOL CALL 1 Z F400\n2 LN X+1.4176535 Y+0.2431890 Z-0.0756260 " FACE_N " " FACE_T
     " R0 M128\n3 END PGM E27 INCH\n"},
    {"E28: output at the centre without CNT-CNT, the ball radius as negative DL: the axes go to the same positions as "
     "in E2.",
     TOOL_1(REWORKED), "TOOL CALL 1 Z DL-3\nLN " FACE_P " " FACE_N " " FACE_T " R0 M128\n"},
    {"The manual's syntax example, with dashes as minus signs: both vectors are far from normalised, and N.T < 0.",
     TOOL_1(REWORKED),
     "TOOL CALL 1 Z\nLN X+31.737 Y+21.954 Z+33.165 NX+0.2637581 NY+0.0078922 NZ–0.8764339 TX+0.0078922 TY–0.8764339 "
     "TZ+0.2590319 R0 F1000 M128\n"},
    {"The manual's table of deviations: 0.03 at 40 and -0.02 at 50 degrees give 0.005 at 45 degrees.",
     TOOL_1(BALL_6 "DR2TABLE = \"MANUAL\"\n") "[[dr2table]]\nname = \"MANUAL\"\npoints = [[40, 0.03], [50, -0.02]]\n",
     "TOOL CALL 1 Z\nLN X0 Y0 Z0 NX0.7071068 NY0 NZ0.7071068\n"},

    {"Oversize 3/3, DR -0.1, DR2 -0.1: permitted everywhere.", ROW("3", "3", "-0.1", "-0.1"),
     PERMITTED WITHOUT_NORMAL NORMAL("5")},
    {"Oversize 3/3, DR 0.2, DR2 0.2: permitted only under M107. After M108 a block without a normal raises "
     "E_OVERSIZE_DR.",
     ROW("3", "3", "0.2", "0.2"), PERMITTED WITHOUT_NORMAL},
    {"Oversize 3/3, DR 0.2, DR2 0.2 with a normal: E_OVERSIZE_DR.", ROW("3", "3", "0.2", "0.2"), CHECKED NORMAL("5")},
    {"Oversize 3/3, DR2 0.3: under M107 the tool is a ball of 3.3. After M108 only a block with a normal raises "
     "E_OVERSIZE_DR2.",
     ROW("3", "3", "0", "0.3"), PERMITTED WITHOUT_NORMAL NORMAL("5")},
    {"Oversize 3/3, DR -0.1: under M107 the ball of 3 stays. After M108 only a block with a normal raises E_R2_GT_R.",
     ROW("3", "3", "-0.1", "0"), PERMITTED WITHOUT_NORMAL NORMAL("5")},
    {"Oversize 3/3, DR2 -0.1: a toroid cutter with a flat of 0.1, permitted.", ROW("3", "3", "0", "-0.1"),
     PERMITTED WITHOUT_NORMAL NORMAL("5")},
    {"Oversize 6/0, DR -0.1: permitted.", ROW("6", "0", "-0.1", "0"), PERMITTED WITHOUT_NORMAL NORMAL("5")},
    {"Oversize 6/1, DR2 -1.1 under M107: E_R2_NEG.", ROW("6", "1", "0", "-1.1"), PERMITTED},
    {"Oversize 6/1, DR2 -1.1 with a normal: E_R2_NEG.", ROW("6", "1", "0", "-1.1"), CHECKED NORMAL("5")},
    {"Oversize 6/1, DR2 -1.1 without a normal: E_R2_NEG.", ROW("6", "1", "0", "-1.1"), CHECKED WITHOUT_NORMAL},
    {"Oversize 6/1, DR -5.5: under M107 the tool is a ball of 1. After M108 only a block with a normal raises "
     "E_R2_GT_R.",
     ROW("6", "1", "-5.5", "0"), PERMITTED WITHOUT_NORMAL NORMAL("5")},
    {"Oversize 6/0, DR 0.2, DR2 0.2: under M107 the tool is a toroid cutter 6.2/0.2. After M108 a block without a "
     "normal raises E_OVERSIZE_DR.",
     ROW("6", "0", "0.2", "0.2"), PERMITTED WITHOUT_NORMAL},
    {"Oversize 6/0, DR 0.2, DR2 0.2 with a normal: E_OVERSIZE_DR.", ROW("6", "0", "0.2", "0.2"), CHECKED NORMAL("5")},
};

#undef CALL
#undef OVERSIZE
#undef ROW
#undef NORMAL
#undef PERMITTED
#undef WITHOUT_NORMAL
#undef CHECKED

}  // namespace

std::span<const Example> face_milling_examples() { return kExamples; }

}  // namespace toolcomp::corpus
