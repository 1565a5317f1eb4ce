// SPDX-License-Identifier: Apache-2.0
// Called programs, and what is not supported: one program for each rule. The tool is along Z and L blocks are not
// compensated, so the tip is at the programmed point.
#include "corpus/examples/heidenhain/tools.h"

namespace toolcomp::corpus {
namespace {

#define FAULT(words, figures) TOOL_1(REWORKED), "L X1\n" words "L X2\n", "1 programmed tip=1,0,0\n" figures
#define IN_EACH_OTHER(outer, inner) "LBL " outer "\nCALL LBL " inner "\n"
#define NINE_IN_EACH_OTHER \
  IN_EACH_OTHER("1", "2")  \
  IN_EACH_OTHER("2", "3")  \
  IN_EACH_OTHER("3", "4")  \
  IN_EACH_OTHER("4", "5")  \
  IN_EACH_OTHER("5", "6") IN_EACH_OTHER("6", "7") IN_EACH_OTHER("7", "8") IN_EACH_OTHER("8", "9")
#define EIGHTEEN_IN_EACH_OTHER                                                                                \
  NINE_IN_EACH_OTHER IN_EACH_OTHER("9", "10") IN_EACH_OTHER("10", "11") IN_EACH_OTHER("11", "12")             \
      IN_EACH_OTHER("12", "13") IN_EACH_OTHER("13", "14") IN_EACH_OTHER("14", "15") IN_EACH_OTHER("15", "16") \
          IN_EACH_OTHER("16", "17") IN_EACH_OTHER("17", "18") IN_EACH_OTHER("18", "19")

constexpr Example kCalls[] = {
    {"CALL LBL runs the blocks after the label up to LBL 0 and continues after the call, here twice.", TOOL_1(REWORKED),
     "TOOL CALL 1 Z\nL X1\nCALL LBL 5\nL X2\nCALL LBL 5\nM30\nLBL 5\nL IY1\nLBL 0\n",
     "2 programmed tip=1,0,0\n8 programmed tip=1,1,0\n4 programmed tip=2,1,0\n8 programmed tip=2,2,0\n"},
    {"A program that reaches a subprogram without a call runs through it. LBL 0 without a call has no effect.",
     TOOL_1(REWORKED), "L X1\nLBL 1\nL IX1\nLBL 0\nL IY1\nCALL LBL 1\nL IZ1\n",
     "1 programmed tip=1,0,0\n3 programmed tip=2,0,0\n5 programmed tip=2,1,0\n3 programmed tip=3,1,0\n"
     "7 programmed tip=3,1,1\n"},
    {"REP 2 runs a section three times in all. The REP 1 in it starts again each time.", TOOL_1(REWORKED),
     "LBL 1\nL IX1\nLBL \"IN\"\nL IY1\nCALL LBL \"IN\" REP 1\nCALL LBL 1 REP 2\nL IZ1\n",
     "2 programmed tip=1,0,0\n4 programmed tip=1,1,0\n4 programmed tip=1,2,0\n2 programmed tip=2,2,0\n"
     "4 programmed tip=2,3,0\n4 programmed tip=2,4,0\n2 programmed tip=3,4,0\n4 programmed tip=3,5,0\n"
     "4 programmed tip=3,6,0\n7 programmed tip=3,6,1\n"},
    {"CALL PGM runs a program that follows the main program in the text. Its END PGM returns to the caller, also from "
     "its subprogram.",
     TOOL_1(REWORKED),
     "BEGIN PGM MAIN MM\nL X1\nCALL PGM sub.h\nCALL PGM \"SUB\"\nEND PGM MAIN MM\nBEGIN PGM SUB MM\nL IY1\nCALL LBL "
     "1\nLBL 1\nL IZ1\nEND PGM SUB MM\n",
     "2 programmed tip=1,0,0\n7 programmed tip=1,1,0\n10 programmed tip=1,1,1\n7 programmed tip=1,2,1\n"
     "10 programmed tip=1,2,2\n"},
    {"CALL PGM under RL sets R0, with the tool 0.1 beside the contour: the block before ends in its own direction, "
     "(20,-0.1). The called program and the blocks after the call run to their programmed points, (20,20) (40,20).",
     TOOL_1(END_MILL),
     "BEGIN PGM MAIN MM\nTOOL CALL 1 Z\nL X0 Y-10 R0 M128\nL Y0 RL\nL X20\nCALL PGM SUB\nL X40\nEND PGM MAIN "
     "MM\nBEGIN PGM SUB MM\nL Y20\nEND PGM SUB MM\n",
     "3 programmed tip=0,-10,0\n4 start-up tip=0,-0.1,0\n5 programmed tip=20,-0.1,0\n10 cancel tip=20,20,0\n"
     "7 programmed tip=40,20,0\n"},
    {"Modal words of a subprogram stay in force after the return, here the feed.", TOOL_1(REWORKED),
     "L X1 F100\nCALL LBL 1\nL X3\nM30\nLBL 1\nL X2 F200\nLBL 0\n",
     "1 programmed tip=1,0,0 feed=100\n6 programmed tip=2,0,0 feed=200\n3 programmed tip=3,0,0 feed=200\n"},
    {"M30 in a subprogram ends the run.", TOOL_1(REWORKED), "L X1\nCALL LBL 1\nL X3\nLBL 1\nL X2 M30\nLBL 0\n",
     "1 programmed tip=1,0,0\n5 programmed tip=2,0,0\n"},
    {"TRANS DATUM shifts the datum as cycle 7 does, and TRANS DATUM RESET cancels the whole shift.", TOOL_1(REWORKED),
     "L X1\nTRANS DATUM AXIS X+10 IY+2\nL X1 Y1\nTRANS DATUM RESET\nL X1 Y1\n",
     "1 programmed tip=1,0,0\n3 programmed tip=11,3,0\n5 programmed tip=1,1,0\n"},

    // Faults
    {"A label that does not exist: E_LABEL_MISSING.", FAULT("CALL LBL 7\n", "2 E_LABEL_MISSING\n")},
    {"A label belongs to its program. A call of a label of another program raises E_LABEL_MISSING.", TOOL_1(REWORKED),
     "L X1\nCALL PGM SUB\nLBL 7\nEND PGM MAIN MM\nBEGIN PGM SUB MM\nCALL LBL 7 REP 1\nEND PGM SUB MM\n",
     "1 programmed tip=1,0,0\n6 E_LABEL_MISSING\n"},
    {"A label that exists twice: E_LABEL_TWICE.", FAULT("CALL LBL 7\nLBL 7\nLBL 07\n", "2 E_LABEL_TWICE\n")},
    {"A subprogram that calls itself through another one: E_LABEL_RECURSION.",
     FAULT("CALL LBL 1\nLBL 1\nCALL LBL 2\nLBL 2\nCALL LBL 1\n", "6 E_LABEL_RECURSION\n")},
    {"A program that calls itself: E_PROGRAM_RECURSION.", TOOL_1(REWORKED),
     "BEGIN PGM MAIN MM\nL X1\nCALL PGM MAIN\nEND PGM MAIN MM\n", "2 programmed tip=1,0,0\n3 E_PROGRAM_RECURSION\n"},
    {"Subprograms nested 19 deep.",
     FAULT("CALL LBL 1\n" EIGHTEEN_IN_EACH_OTHER "LBL 19\n", "40 programmed tip=2,0,0\n")},
    {"Subprograms nested 20 deep: E_NESTING.",
     FAULT("CALL LBL 1\n" EIGHTEEN_IN_EACH_OTHER IN_EACH_OTHER("19", "20") "LBL 20\n", "40 E_NESTING\n")},
    {"A program that does not exist: E_NO_PROGRAM.", FAULT("CALL PGM SUB.H\n", "2 E_NO_PROGRAM\n")},
    {"A program with a path: E_NO_PROGRAM.", FAULT("CALL PGM TNC:\\PARTS\\SUB.H\n", "2 E_NO_PROGRAM\n")},
    {"A program without END PGM: E_NO_PROGRAM.", TOOL_1(REWORKED),
     "L X1\nCALL PGM SUB\nEND PGM MAIN MM\nBEGIN PGM SUB MM\nL X2\n", "1 programmed tip=1,0,0\n2 E_NO_PROGRAM\n"},
    {"A circle is not supported.", FAULT("CC X+0 Y+0\nC X+2 Y+0 DR+\n", "3 not_supported C\n")},
    {"A pocket is defined and then called: the call is not supported.",
     FAULT("CYCL DEF 251 RECTANGULAR POCKET ~\n  Q201=-5 ;DEPTH\nCYCL CALL\n", "4 not_supported CYCL CALL\n")},
    {"A rotation by zero changes nothing, one by an angle is not supported.",
     FAULT("CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+0\nL Y1\nCYCL DEF 10.1 ROT+30\n",
           "4 programmed tip=1,1,0\n5 not_supported CYCL DEF 10\n")},
    {"M140 in a block with an axis word is not supported.", FAULT("L Y1 M140 MB MAX\n", "2 not_supported M140\n")},
    {"PLANE SPATIAL without an angle does nothing; with one, nothing after it is judged.",
     FAULT("PLANE SPATIAL SPA+0 SPB+0 SPC+0 STAY\nL Y1\nPLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN FMAX\nL Y2\n",
           "3 programmed tip=1,1,0\n4 not_judged PLANE SPATIAL\n")},
    {"Cycle 19 without an angle does nothing; with one, nothing after it is judged.",
     FAULT("CYCL DEF 19.0 WORKING PLANE\nCYCL DEF 19.1\nL Y1\nCYCL DEF 19.1 B+45\nL Y2\n",
           "4 programmed tip=1,1,0\n5 not_judged CYCL DEF 19\n")},
    {"A preset other than the first: nothing after it is judged.",
     FAULT("CYCL DEF 247 DATUM ~\n Q339=+1\nL Y1\nCYCL DEF 247 DATUM ~\n Q339=+2\nL Y2\n",
           "4 programmed tip=1,1,0\n5 not_judged CYCL DEF 247\n")},
};

#undef FAULT
#undef IN_EACH_OTHER
#undef NINE_IN_EACH_OTHER
#undef EIGHTEEN_IN_EACH_OTHER

}  // namespace

std::span<const Example> klartext_calls() { return kCalls; }

}  // namespace toolcomp::corpus
