// SPDX-License-Identifier: Apache-2.0
// Setups and words of Klartext examples.
#pragma once

#include "corpus/examples.h"

#define HEIDENHAIN "control = \"heidenhain\"\n"
#define TOOL(number, values) "[[tool]]\nnumber = " number "\n" values
// A tool table of tool 1 alone.
#define TOOL_1(values) HEIDENHAIN TOOL("1", values)

// The manual's ball of 6 mm as it is in the tool table, and re-worked to 5.8 mm.
#define BALL_6 "R = 3\nR2 = 3\n"
#define REWORKED BALL_6 "DR = -0.1\nDR2 = -0.1\n"
// Tools of the worked examples: E11 and E16; the end mill of 12 mm re-worked to 11.8 mm.
#define TOROID_E11 "R = 6\nR2 = 1\nDL = 0.05\nDR = -0.1\nDR2 = -0.02\n"
#define TOROID_E16 "R = 5\nR2 = 2\nDL = 0.25\nDR = 0.3\nDR2 = 0.1\n"
#define END_MILL "R = 6\nR2 = 0\nDR = -0.1\n"

// Blocks 12 to 14 of the manual's example of face milling.
#define FACE_P "X+36.0084 Y+6.177 Z-1.9209"
#define FACE_N "NX-0.4658107 NY+0 NZ+0.8848844"
#define FACE_T "TX+0.0000000 TY+0.6558846 TZ+0.7548612"

// Blocks 11 and 12 of its example of peripheral milling.
#define FLANK_P_11 "X+48.4074 Y+102.4717 Z-7.1088"
#define FLANK_P_12 "X+60.6593 Y+102.4690 Z-7.1012"
#define FLANK_N "NX+0.0000 NY+0.9397 NZ+0.3420"
#define FLANK_T "TX-0.0807 TY-0.3409 TZ+0.9366"

#define TCPM "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS"
#define TCPM_CENTER TCPM " REFPNT CNT-CNT\n"
#define CONTOUR "FUNCTION PROG PATH IS CONTOUR\n"
