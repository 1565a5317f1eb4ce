// SPDX-License-Identifier: Apache-2.0
// Rules of all Klartext programs, shown in face milling: one program for each rule of reading, tool call, deltas, TCPM
// and positions, and for each fault that LN can have.
#include "corpus/examples/heidenhain/tools.h"

namespace toolcomp::corpus {
namespace {

#define CALL "TOOL CALL 1 Z\n"
#define LN "LN X1 Y2 Z3 NX0.6 NY0 NZ0.8"
#define FAULT(words) TOOL_1(REWORKED), CALL "L X1\n" words "\nL X2\n"
#define FIVE "[[tool]]\nnumber = \"5.1\"\nname = \"BALL\"\nR = 2\nR2 = 2\n"
#define TCO "[[correction.tcs]]\nnumber = 1\nDL = 1\nDR = -0.2\nDR2 = -0.2\n"

constexpr Example kKlartext[] = {
    // Faults
    {"LN without Z: E_LN_COORD.", FAULT("LN X+1 Y+2 NX0 NY0 NZ1")},
    {"LN with Y before X: E_LN_ORDER.", FAULT("LN Y+1 X+2 Z+3 NX0 NY0 NZ1")},
    {"LN without NY: E_VEC_INCOMPLETE.", FAULT("LN X+1 Y+2 Z+3 NX0 NZ1")},
    {"LN with TX alone: E_VEC_INCOMPLETE.", FAULT("LN X+1 Y+2 Z+3 TX1")},
    {"LN with T before N: E_LN_ORDER.", FAULT("LN X+1 Y+2 Z+3 TX0 TY0 TZ1 NX0 NY0 NZ1")},
    {"LN with NX twice: E_LN_ORDER.", FAULT("LN X+1 Y+2 Z+3 NX0 NX0 NY0 NZ1")},
    {"LN with a normal of zeros: E_VEC_ZERO.", FAULT("LN X+1 Y+2 Z+3 NX0 NY0 NZ0")},
    {"LN with a tool vector of zeros, which would be ignored: E_VEC_ZERO.",
     FAULT("LN X+1 Y+2 Z+3 NX0 NY0 NZ1 TX0 TY0 TZ0")},
    {"LN with NX+10: E_VEC_RANGE.", FAULT("LN X+1 Y+2 Z+3 NX+10 NY0 NZ0")},
    {"LN with NX 9.99999999, the largest permitted component: W_NOT_NORMALIZED.",
     FAULT("LN X+1 Y+2 Z+3 NX+9.99999999 NY0 NZ0")},
    {"LN with a normal under RL: E_RC_WITH_N.", FAULT("LN X+1 Y+2 Z+3 NX0 NY0 NZ1 RL")},
    {"Five M functions: E_TOO_MANY_M.", FAULT("LN X+1 Y+2 Z+3 NX0 NY0 NZ1 M3 M8 M107 M128 M126")},
    {"Four M functions are permitted.", FAULT("LN X+1 Y+2 Z+3 NX0 NY0 NZ1 M3 M8 M107 M128")},
    {"Five M functions and Y before X: E_TOO_MANY_M comes first.",
     FAULT("LN Y+1 X+2 Z+3 NX0 NY0 NZ1 M3 M8 M107 M128 M126")},
    {"A parameter in a tool vector: E_SYNTAX.", FAULT("LN X+1 Y+2 Z+3 NX0 NY0 NZ1 TX+Q1 TY0 TZ1")},
    {"LN without any vector: E_SYNTAX.", FAULT("LN X+1 Y+2 Z+3")},
    {"LN with an incremental word: E_SYNTAX.", FAULT("LN IX+1 Y+2 Z+3 NX0 NY0 NZ1")},
    {"LN with a rotary word: E_SYNTAX.", FAULT("LN X+1 Y+2 Z+3 B10 NX0 NY0 NZ1")},
    {"A word of another dialect: E_SYNTAX.", FAULT("G01 X+1")},
    {"BEGIN PGM after the first block: E_SYNTAX.", FAULT("BEGIN PGM AGAIN MM")},
    {"An axis that the setup does not have: E_SYNTAX.", FAULT("L V+1")},
    {"TOOL CALL under TCPM: E_TCPM_TOOLCALL.", FAULT("M128\nTOOL CALL 1 Z")},
    {"An unknown tool: E_NO_TOOL.", FAULT("TOOL CALL 2 Z")},
    {"A tool called by a string parameter: E_NO_TOOL.", FAULT("TOOL CALL QS1 Z")},
    {"Under TCPM an unknown tool is E_TCPM_TOOLCALL.", FAULT("M128\nTOOL CALL 2 Z")},
    {"M91 under TCPM: E_TCPM_M91, also if M128 or M129 is in the same block.", FAULT("L X5 M91 M128")},
    {"M92 under TCPM with M129: E_TCPM_M91.", FAULT("M128\nL X5 M92 M129")},
    {"E_TCPM_M91 is raised before the tool is checked.", TOOL_1(REWORKED), LN " M128 M91\n"},

    // Reading
    {"Decimal commas, minus as a dash or the sign, small letters, more blanks, comments, structure, skipped blocks, "
     "continuation.",
     HEIDENHAIN "block_skip = true\n" TOOL("1", REWORKED),
     "0 begin pgm anything mm\n1 * - Roughing\n2 ; a comment\n3 tool  call 1 z\n/4 L X100\n5 L X+1,5 Y–2.5 Z−3 ; "
     "dashes\n6 "
     "LN X1 Y2 ~\n   Z3 ~\n   NX,6 NY-.0 NZ0.8\n7 END PGM anything MM\nL X9\n"},
    {"Blocks with / run if the setup does not skip them.", TOOL_1(REWORKED), "/1 L X100\n2 / L X200\n"},
    {"Six decimals, a position beyond 99999.99999 and a component of nine decimals: W_DIGITS each.", TOOL_1(REWORKED),
     CALL "L X1.123456\nL X123456\nLN X1 Y2 Z3 NX0.600000000 NY0 NZ0.8\nL X1.12345 Y-99999.99999\n"},
    {"M30 ends the program after its block.", TOOL_1(REWORKED), CALL LN " M30\nL X9\n"},
    {"END PGM ends the program; the setup is in inches, BEGIN PGM says MM.",
     "control = \"heidenhain\"\nunits = "
     "\"inch\"\n" TOOL("1", REWORKED),
     "BEGIN PGM A MM\n" CALL LN "\nEND PGM A MM\nL X9\n"},
    {"Without BEGIN PGM the units are those of the setup, inches.",
     "control = \"heidenhain\"\nunits = \"inch\"\n" TOOL("1", "R = 254\nDL = 2.54\nDR = -2.54\n"), CALL LN " F100\n"},
    {"Parameters: Q1 = -6, Q2 = Q1, a parameter that was never assigned is 0, QL and QR; -Q1 is 6.", TOOL_1(REWORKED),
     CALL "Q1 = -6\nFN 0: Q2 = +Q1\nQL3 = 2.5\nQR4 = -QL3\nL X+Q2 Y-Q1 Z+Q3\nL X+QL3 Y+QR4 FQ5\nL IZ-Q1\n"},
    {"A parameter as DR in TOOL CALL.", TOOL_1(BALL_6), "Q1 = -0.1\nTOOL CALL 1 Z DR+Q1 DR2:+Q1\n" LN "\n"},
    {"Feeds: that of TOOL CALL, F, FMAX in its own block only, F AUTO, F MAX; under FZ and FU there is no feed.",
     TOOL_1(REWORKED),
     "L X1\nTOOL CALL 1 Z F500\nL X2\nL X3 F200\nL X4 FMAX\nL X5\nL X6 F AUTO\nL X7 FZ0.1\nL X8\nL X9 FAUTO\nL X10 "
     "FU0.2\nL X11 F MAX\nL X12 F300 M128 F1000\n"},

    // Positions
    {"Incremental words are measured from the programmed position. The run starts at the position of the setup.",
     TOOL_1(REWORKED) "[position]\nX = 100\nZ = 7\n", CALL "L IX5 Y2\nL IX-2.5 IY1\n" LN "\nL IX1 IZ1\n"},
    {"Cycle 7 shifts the datum of the axes that it names, and I adds to the shift. The next block is measured from the "
     "new datum, events from the preset.",
     TOOL_1(REWORKED),
     CALL "L X10 Y10\nCYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+100\nCYCL DEF 7.2 Y-5\nL X1\nL IY1\nCYCL DEF 7.1 IX+11\n"
          "L X1\n" LN "\n"},
    {"M91 and M92: the datum shift has no effect in their block.", TOOL_1(REWORKED),
     CALL "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+100 Z+20\nL X1 Z1\nL X1 M91\nL Y1\nL Z2 M92\n" LN " M91\n" LN "\n"},
    {"Other cycles, PLANE, BLK FORM, TOOL DEF, STOP and other M functions move nothing.", TOOL_1(REWORKED),
     CALL
     "BLK FORM 0.1 Z X0 Y0 Z-10\nBLK FORM 0.2 X10 Y10 Z0\nTOOL DEF 2 L+10 R+5\nCYCL DEF 32.0 TOLERANCE\nCYCL DEF "
     "32.1 T0.01\nCYCL DEF 32.2 HSC-MODE:0 TA0.5\nCYCL DEF 247 PRESETTING ~\n   Q339=+1 ;PRESET NUMBER\nPLANE RESET "
     "STAY\nPLANE SPATIAL SPA+0 SPB+0 SPC+0 TURN FMAX\nSTOP M1\nM138 \n" LN "\n"},

    // Tool call and deltas
    {"Tools called by number with index and by name. A tool can be called again after another one.",
     TOOL_1(REWORKED) FIVE, "TOOL CALL 5.1 Z\n" LN "\n" CALL LN "\nTOOL CALL \"BALL\" Z DL+1\n" LN "\n"},
    {"Deltas of a call with a tool replace all deltas of the previous call. Deltas of a call without a tool replace "
     "only the ones that they name.",
     TOOL_1(BALL_6), "TOOL CALL 1 Z DL+1 DR-0.2 DR2-0.2\n" LN "\nTOOL CALL DL+2\n" LN "\n" CALL LN "\n"},
    {"A row of the compensation table is in force from its block on. A call of a tool cancels it, a call without a "
     "tool does not.",
     TOOL_1(BALL_6) TCO, CALL "FUNCTION CORRDATA TCS #1\n" LN "\nTOOL CALL S1000\n" LN "\n" CALL LN "\n"},
    {"FUNCTION CORRDATA RESET cancels the row. FUNCTION CORRDATA WPL, for the workpiece, changes nothing.",
     TOOL_1(BALL_6) TCO,
     CALL "SEL CORR-TABLE TCS \"A.tco\"\nFUNCTION CORRDATA TCS #1\nFUNCTION CORRDATA WPL #9\n" LN
          "\nFUNCTION CORRDATA RESET WPL\n" LN "\nFUNCTION CORRDATA RESET TCS\n" LN
          "\nFUNCTION CORRDATA TCS #1\nFUNCTION CORRDATA RESET\n" LN "\n"},
    {"TOOL CALL 0 cancels the row too. Deltas of a call without a tool apply even before any tool is called.",
     TOOL_1(BALL_6) TCO, "TOOL CALL DL+0.5\nL X1\nFUNCTION CORRDATA TCS #1\nL X2\nTOOL CALL 0 Z\nL X3\n"},

    // TCPM
    {"M128 takes effect in its own block, M129 after its own block: the tool turns, and is then upright again.",
     TOOL_1(REWORKED),
     CALL LN " TX0 TY0.6 TZ0.8\n" LN " TX0 TY0.6 TZ0.8 M128\nL X5\n" LN " TX0 TY0.6 TZ0.8 M129\nL X6\n"},
    {"FUNCTION TCPM switches TCPM on without M128. FUNCTION RESET TCPM and FUNCTION TCPM OFF switch it off.",
     TOOL_1(REWORKED),
     CALL TCPM "\n" LN "\nFUNCTION RESET TCPM\nL X5\n" TCPM " REFPNT CNT-CNT F1000\n" LN "\nFUNCTION TCPM OFF\nL X6\n"},
    {"Under CNT-CNT the programmed point is the centre, in L blocks too; the tip is R2 of the tool table away from it.",
     TOOL_1(REWORKED "L = 50\n"), CALL TCPM_CENTER "L X5 Y0 Z0 B90\nL X6 R0\n"},
    {"M128 sets the reference point to the tip. FUNCTION TCPM without REFPNT and FUNCTION TCPM with TIP-CNT do so too.",
     TOOL_1(REWORKED),
     CALL TCPM_CENTER "L X5 Y0 Z0\nL X6 M128\n" TCPM " REFPNT CENTER-CENTER\nL X7\n" TCPM "\nL X8\n" TCPM_CENTER
                      "L X9\n" TCPM " REFPNT TIP-CNT\nL X10\n" TCPM " REFPNT TIP-CENTER\nL X11\n"},
    {"CNT-CNT is lost when TCPM ends.", TOOL_1(REWORKED),
     CALL TCPM_CENTER "L X5 Y0 Z0\nFUNCTION RESET TCPM\nL X6\nL X7 M128\n"},
    {"Rotary words turn the tool by A, B, C in this order. Axes without a word keep their value.", TOOL_1(REWORKED),
     CALL "M128\nL X0 A90\nL X0 B90\nL X0 C180\nL X0 A0\n"},
    {"Rotary words without TCPM do not turn the tool but are stored, incremental ones too. LN does not change the "
     "stored values.",
     TOOL_1(REWORKED), CALL "L B60\nL IB30\nL X1 M128\nL X2 C90\n" LN " TX0 TY0 TZ1\nL X3\nL X4 C180\n"},
    {"With the tool axis Y the rotary words turn Y.", TOOL_1(REWORKED "DL = 1\n"),
     "TOOL CALL 1 Y\nL A90 M128\nL C90\n"},
    {"A call without a tool may change the tool axis under TCPM: the tool keeps its direction until it turns again.",
     TOOL_1(REWORKED), CALL "L X1 M128\nTOOL CALL X\nL X2\nL C90\n"},
    {"M128 after rotary words that positioned the axes: the tool has the direction of the axes, DL acts along it, and "
     "the same word again turns nothing.",
     HEIDENHAIN TOOL("4", BALL_6),
     "TOOL CALL 4 Z S5000 DL+1\nL B+90 C+0 R0 FMAX\nL M128\nL X+20 Y+0 Z+10 F1000\nL X+30 Y+0 Z+10 B+90\n",
     "2 rapid programmed tip=0,0,0 tool=0,0,1 axes=0,0,1 axis=0,0,1 B=90 C=0\n"
     "4 programmed tip=20,0,10 tool=1,0,0 axes=21,0,10 axis=1,0,0 feed=1000\n"
     "5 programmed tip=30,0,10 tool=1,0,0 axes=31,0,10 axis=1,0,0 B=90 feed=1000\n"},
    {"A tool vector has turned the tool last: TCPM off and on again keeps this direction. After a rotary word, also "
     "one without TCPM, the rotary words decide: B90 and C90 turn Z to Y.",
     TOOL_1(REWORKED), CALL "LN X0 Y0 Z0 TX0.6 TY0 TZ0.8 M128\nM129\nL X1\nM128\nL X2\nL B90 M129\nL C90\nL X3 M128\n",
     "2 W_NO_LATERAL\n2 programmed tip=0,0,0 axis=0.6,0,0.8\n4 programmed tip=1,0,0 axis=0,0,1\n"
     "6 programmed tip=2,0,0 axis=0.6,0,0.8\n7 programmed tip=2,0,0 axis=1,0,0 B=90\n"
     "8 programmed tip=2,0,0 axis=0,0,1 C=90\n9 programmed tip=3,0,0 axis=0,1,0\n"},
    {"m128_reference = center: under M128 the programmed point is the centre, R2 above the tip. FUNCTION TCPM sets its "
     "own reference point.",
     HEIDENHAIN "m128_reference = \"center\"\n" TOOL("1", "R = 6\nR2 = 1\n"),
     CALL "L X5 Y0 Z0 M128\nL X6 B90\n" TCPM "\nL X7\nM129\nL X8\n",
     "2 programmed tip=5,0,-1 axis=0,0,1\n3 programmed tip=5,0,0 axis=1,0,0 B=90\n5 programmed tip=7,0,0 axis=1,0,0\n"
     "7 programmed tip=8,0,0 axis=0,0,1\n"},
};

#undef CALL
#undef LN
#undef FAULT
#undef FIVE
#undef TCO

}  // namespace

std::span<const Example> klartext_examples() { return kKlartext; }

}  // namespace toolcomp::corpus
