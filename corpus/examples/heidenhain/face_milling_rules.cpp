// SPDX-License-Identifier: Apache-2.0
// Face milling: one program for each rule of the effective tool, of normals and tool vectors, and of their warnings.
#include "corpus/examples/heidenhain/tools.h"

namespace toolcomp::corpus {
namespace {

#define SHARP "R = 5\n"
#define TOROID "R = 5\nR2 = 2\n"
// A block without tool vector, at X1 Y2 Z3.
#define LN(n) "LN X1 Y2 Z3 " n
#define N_345 "NX0.6 NY0 NZ0.8"
#define CALL "TOOL CALL 1 Z\n"
// A ball of 3 mm with a table of deviations.
#define DEVIATIONS(values, points) \
  TOOL_1(BALL_6 "DR2TABLE = \"T\"\n" values) "[[dr2table]]\nname = \"T\"\npoints = [" points "]\n"

constexpr Example kRules[] = {
    // Effective tool
    {"LN before any TOOL CALL: E_NO_TOOL.", TOOL_1(BALL_6), "L X5\n" LN(N_345) "\n"},
    {"TOOL CALL 0 is a tool of zeros: nothing moves.", TOOL_1(BALL_6), "TOOL CALL 0 Z\n" LN(N_345) "\n"},
    {"R -1 in the table: E_TOOL in the block that uses the tool.", TOOL_1("R = -1\n"), CALL "L X5\n" LN(N_345) "\n"},
    {"R2 -1 in the table: E_TOOL.", TOOL_1("R = 3\nR2 = -1\n"), CALL LN(N_345) "\n"},
    {"R2 beyond R in the table: E_TOOL, whatever the deltas.", TOOL_1("R = 3\nR2 = 3.5\nDR2 = -1\n"),
     CALL LN(N_345) "\n"},
    {"An effective radius below 0: E_TOOL_EFF, also under M107 and before E_R2_NEG.",
     TOOL_1("R = 1\nDR = -1.1\nDR2 = "
            "-1\n"),
     CALL LN(N_345) " M107\n"},
    {"An effective radius of 0: D_tip = (-1, 0, 0).", TOOL_1("R = 1\nDR = -1\n"), CALL LN(N_345) "\n"},
    {"An effective corner radius of 0: a sharp end mill, D_tip = -(n - t) + u = (0.4, 0, 0.2).",
     TOOL_1("R = 6\nR2 = 1\nDR2 = -1\n"), CALL LN(N_345) "\n"},
    {"An oversize from a call without a tool is checked as well: E_OVERSIZE_DR.", TOOL_1(TOROID),
     CALL LN(N_345) "\nTOOL CALL DR+0.01\n" LN(N_345) "\n"},
    {"DL 5 is never oversize.", TOOL_1(TOROID "L = 100\n"), "TOOL CALL 1 Z DL+5\n" LN(N_345) "\n"},
    {"M107 takes effect in its own block, M108 after its own block: E_OVERSIZE_DR in line 4.",
     TOOL_1(TOROID "DR = 0.1\n"), CALL LN(N_345) " M107\n" LN(N_345) " M108\n" LN(N_345) "\n"},

    // Deviations by the contact angle
    {"Deviations: exactly at the first support point, 0 degrees, and at the last, 90.",
     DEVIATIONS("", "[0, 0.02], [90, -0.04]"), CALL LN("NX0 NY0 NZ1") "\n" LN("NX1 NY0 NZ0") "\n"},
    {"Deviations: below the first support point: E_3DTC_RANGE.", DEVIATIONS("", "[40, 0.02], [90, -0.04]"),
     CALL LN(N_345) "\n"},
    {"Deviations: above the last support point: E_3DTC_RANGE.", DEVIATIONS("", "[0, 0.02], [30, -0.04]"),
     CALL LN(N_345) "\n"},
    {"Deviations: three segments, a contact angle in the second and exactly at its ends, 45 and 90 degrees. DR2 of the "
     "tool table is ignored.",
     DEVIATIONS("DR2 = -0.5\n", "[0, 0], [45, 0.03], [90, -0.06], [180, -0.06]"),
     CALL LN("NX0.9 NY0 NZ0.3") "\n" LN("NX0.7071068 NY0 NZ0.7071068") "\n" LN("NX0 NY1 NZ0") "\n"},
    {"Deviations: a single support point is valid only at its own angle, E_3DTC_RANGE at any other.",
     DEVIATIONS("", "[90, 0.1]"), CALL LN("NX1 NY0 NZ0") "\n" LN("NX1 NY0 NZ-0.0000001") "\n"},
    {"Deviations: DR2 of TOOL CALL is added, -0.1 + 0.04; a value of the table needs no M107.",
     DEVIATIONS("", "[0, 0.04], [180, 0.04]"), "TOOL CALL 1 Z DR2-0.1\n" LN(N_345) "\n"},
    {"Deviations: the sum of DR2 from TOOL CALL and from the compensation table raises E_OVERSIZE_DR2.",
     DEVIATIONS("", "[0, -0.5], [180, -0.5]") "[[correction.tcs]]\nnumber = 1\nDR2 = 0.2\n",
     "TOOL CALL 1 Z DR2-0.1\nFUNCTION CORRDATA TCS #1\n" LN(N_345) "\n"},
    {"Deviations: DR 0.1 needs M107 as usual: E_OVERSIZE_DR.", DEVIATIONS("DR = 0.1\n", "[0, 0], [180, 0]"),
     CALL LN(N_345) "\n"},
    {"Deviations: with DR -1 the corner radius is beyond the radius, which is not checked.",
     DEVIATIONS("DR = -1\n", "[0, -0.1], [180, -0.1]"), CALL LN(N_345) "\n"},
    {"Deviations: R2 other than R: E_3DTC_SHAPE, before the radius is checked.",
     TOOL_1("R = 3\nR2 = 2\nDR = -4\nDR2TABLE = \"T\"\n") "[[dr2table]]\nname = \"T\"\npoints = [[0, 0]]\n",
     CALL LN(N_345) "\n"},
    {"Deviations: the corner radius is 0 exactly at 45 degrees: permitted.", DEVIATIONS("", "[40, 0], [50, -6]"),
     CALL LN("NX0.7071068 NY0 NZ0.7071068") "\n"},
    {"Deviations: at a slightly larger angle than 45 degrees the corner radius is negative: E_R2_NEG, also under M107.",
     DEVIATIONS("", "[40, 0], [50, -6]"), CALL LN("NX0.7071069 NY0 NZ0.7071068") " M107\n"},
    {"Deviations: a negative corner radius at a support point: E_R2_NEG.", DEVIATIONS("", "[0, 0], [90, -3.1]"),
     CALL LN("NX1 NY0 NZ0") "\n"},
    {"Deviations apply only in blocks with a normal. L, and LN without a normal, use DR2 of the tool table.",
     DEVIATIONS("DR2 = -0.5\n", "[90, 0.1]"), CALL "L X1 R0 M128\nLN X2 Y0 Z0 TX0 TY0.6 TZ0.8\n"},

    // Normal and tool vector
    {"Without T the tool is along the normal under TCPM, and stays so in L blocks. M129 puts it upright again.",
     TOOL_1(REWORKED), CALL LN(N_345) " M128\nL X5 R0\nL Z5 M129\nL Z6\n"},
    {"T is ignored without TCPM, however long it is: W_T_IGNORED.", TOOL_1(REWORKED),
     CALL LN(N_345 " TX0 TY3 TZ4") "\n"},
    {"RL in a block with a normal: E_RC_WITH_N.", TOOL_1(REWORKED), CALL LN(N_345) " RL\n"},
    {"RR from a block before, under TCPM: E_RC_WITH_N.", TOOL_1(REWORKED),
     CALL "L X5 RR M128\n" LN(N_345 " TX0 TY0 TZ1") "\n"},
    {"E_NO_TOOL comes before E_RC_WITH_N, and that before E_TOOL.", TOOL_1("R = -1\n"), LN(N_345) " RL\n"},
    {"Before E_TOOL comes E_RC_WITH_N.", TOOL_1("R = -1\n"), CALL LN(N_345) " RL\n"},
    {"Vectors off by exactly 0.0002, 0.99^2 + 0.14^2 + 0.01^2 = 0.9998, give no warning.", TOOL_1(REWORKED),
     CALL "M128\n" LN("NX0.99 NY0.14 NZ0.01 TX-0.01 TY0.14 TZ0.99") "\n"},
    {"A normal off by a little more: W_NOT_NORMALIZED.", TOOL_1(REWORKED), CALL LN("NX0.99 NY0.13 NZ0.01") "\n"},
    {"Normal and tool vector of any length: twice W_NOT_NORMALIZED, and the values of E16.", TOOL_1(TOROID_E16),
     CALL "LN X0 Y0 Z0 NX3 NY0 NZ4 TX0 TY0 TZ7 M107 M128\n"},
    {"A normal at right angles to the tool: D_tip = -0.1 n + 0.02 t.", TOOL_1(TOROID "DR = -0.1\nDR2 = -0.02\n"),
     CALL LN("NX1 NY0 NZ0") "\n"},
    {"A normal below by rounding only, n.t = -0.0001, gives no warning. A normal further below gives W_N_BELOW.",
     TOOL_1(TOROID), CALL LN("NX1 NY0 NZ-0.0001") "\n" LN("NX1 NY0 NZ-0.0003") "\n"},
    {"A normal opposite to the tool: u = 0 and W_N_BELOW; D_tip = dR2 (n - t) = (0, 0, 0.2).", TOOL_1(REWORKED),
     CALL LN("NX0 NY0 NZ-1") "\n"},
    {"The contact moves by a quarter turn: no warning. W_CONTACT_JUMP if it moves to the other half, to the flat, or "
     "off the flat. No warning between two contacts on the flat. An L block clears the contact, so there is no warning "
     "after it.",
     TOOL_1(TOROID),
     CALL LN(N_345) "\n" LN("NX0 NY0.6 NZ0.8") "\n" LN("NX0 NY-0.6 NZ0.8") "\n" LN("NX0 NY0 NZ1") "\n" LN(
         "NX0 NY0 NZ1") "\n" LN("NX0 NY-0.6 NZ0.8") "\nL X5\n" LN("NX0 NY0.6 NZ0.8") "\n"},
    {"TOOL CALL clears the contact, also without a tool. Other blocks that move nothing do not.", TOOL_1(TOROID),
     CALL LN(N_345) "\nTOOL CALL S5000\n" LN("NX-0.6 NY0 NZ0.8") "\nQ1 = 1\nM5\n" LN(N_345) "\n"},
    {"LN without a normal clears the contact too.", TOOL_1(TOROID),
     CALL LN(N_345 " TX0 TY0 TZ1") " M128\nLN X1 Y2 Z3 TX0 TY0 TZ1\n" LN("NX-0.6 NY0 NZ0.8 TX0 TY0 TZ1") "\n"},
    {"A ball has no flat, so no contact jumps.", TOOL_1(REWORKED), CALL LN(N_345) "\n" LN("NX-0.6 NY0 NZ0.8") "\n"},
    {"A ball that has a flat by its deltas: the contact jumps.", TOOL_1(BALL_6 "DR2 = -0.1\n"),
     CALL LN(N_345) "\n" LN("NX-0.6 NY0 NZ0.8") "\n"},
    {"All warnings of a block without TCPM in their order.", TOOL_1(TOROID),
     CALL LN(N_345) "\nLN X1.123456 Y2 Z3 NX-3 NY0 NZ-4 TX0 TY0 TZ2\n"},
    {"All warnings of a block under TCPM in their order.", TOOL_1(TOROID),
     CALL LN(N_345 " TX0 TY0 TZ1") " M128\nLN X1 Y2 Z123456 NX-3 NY0 NZ-4 TX0 TY0 TZ2\n"},
    {"A block with an alarm gives no warnings.", TOOL_1(TOROID "DR = 0.1\n"),
     CALL "LN X1.123456 Y2 Z3 NX-3 NY0 NZ-4 TX0 TY0 TZ2\n"},
    {"An end mill: D_tip = dR u.", TOOL_1(SHARP "DR = -0.1\n"), CALL LN(N_345) "\n"},
    {"The tool along X: t = (1, 0, 0), u = (0, 0, 1).", TOOL_1(TOROID "DL = 0.5\nDR2 = -0.1\n"),
     "TOOL CALL 1 X\n" LN(N_345) "\n"},
    {"The tool along Y, and back to Z by a call without a tool.", TOOL_1(TOROID "DL = 0.5\nDR2 = -0.1\n"),
     "TOOL CALL 1 Y\n" LN("NX0 NY0.8 NZ0.6") "\nTOOL CALL Z\n" LN("NX0 NY0.6 NZ0.8") "\n"},
};

#undef SHARP
#undef TOROID
#undef LN
#undef N_345
#undef CALL
#undef DEVIATIONS

}  // namespace

std::span<const Example> face_milling_rules() { return kRules; }

}  // namespace toolcomp::corpus
