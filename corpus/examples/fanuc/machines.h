// SPDX-License-Identifier: Apache-2.0
// Setups of five-axis machines for examples. `more` holds further parameters, `rest` further tables. H is a head, T a
// table, M a mixed machine. The letters name the first and the second rotary axis; 45 is an axis inclined from Y to Z.
#pragma once

#include "corpus/examples.h"

#define MACHINE(letters, parameters, more, rest) \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", " letters "]\n[parameters]\n" parameters more rest
#define AC "\"A\", \"C\""
#define BC "\"B\", \"C\""
#define AB "\"A\", \"B\""

#define HC(more, rest) MACHINE(BC, "19680 = 2\n19681 = 5\n19682 = 3\n19686 = 4\n19687 = 2\n", more, rest)
#define HCA(more, rest) MACHINE(AC, "19680 = 2\n19681 = 5\n19682 = 3\n19686 = 4\n19687 = 1\n", more, rest)
#define HAB(more, rest) MACHINE(AB, "19680 = 2\n19681 = 4\n19682 = 1\n19686 = 5\n19687 = 2\n", more, rest)
#define N45(more, rest) MACHINE(BC, "19680 = 2\n19681 = 5\n19682 = 3\n19686 = 4\n19687 = 5\n19688 = 45\n", more, rest)
#define TAC(more, rest) \
  MACHINE(AC, "19680 = 12\n19681 = 4\n19682 = 1\n19684 = 1\n19686 = 5\n19687 = 3\n19689 = 1\n", more, rest)
#define TBC(more, rest) \
  MACHINE(BC, "19680 = 12\n19681 = 4\n19682 = 2\n19684 = 1\n19686 = 5\n19687 = 3\n19689 = 1\n", more, rest)
#define TAB(more, rest) \
  MACHINE(AB, "19680 = 12\n19681 = 4\n19682 = 1\n19684 = 1\n19686 = 5\n19687 = 2\n19689 = 1\n", more, rest)
#define T45(more, rest) \
  MACHINE(BC, "19680 = 12\n19681 = 4\n19682 = 5\n19683 = 45\n19684 = 1\n19686 = 5\n19687 = 3\n19689 = 1\n", more, rest)
#define MBC(more, rest) MACHINE(BC, "19680 = 21\n19681 = 4\n19682 = 2\n19686 = 5\n19687 = 3\n19689 = 1\n", more, rest)
#define M45(more, rest) \
  MACHINE(BC, "19680 = 21\n19681 = 4\n19682 = 5\n19683 = 45\n19686 = 5\n19687 = 3\n19689 = 1\n", more, rest)
#define MAC(more, rest) MACHINE(AC, "19680 = 21\n19681 = 4\n19682 = 1\n19686 = 5\n19687 = 3\n19689 = 1\n", more, rest)
#define MAB(more, rest) MACHINE(AB, "19680 = 21\n19681 = 4\n19682 = 1\n19686 = 5\n19687 = 2\n19689 = 1\n", more, rest)

// Upper and lower limit of the first rotary axis, then of the second.
#define RANGES(upper_1, lower_1, upper_2, lower_2) \
  "19741 = " upper_1 "\n19742 = " lower_1 "\n19743 = " upper_2 "\n19744 = " lower_2 "\n"

// The table of example 9: A = (0, 0, -100), d = (0, 30, 50), workpiece origin (5, 10, 20).
#define TABLE_OFFSETS "19702 = -100\n19704 = 30\n19705 = 50\n"
#define TABLE_ORIGIN "[workpiece.G54]\nX = 5\nY = 10\nZ = 20\n"

// Directions of poses, to fifteen digits.
#define TO_B30_C170 "I-492403876506104 J86824088833465 K866025403784439"
#define TO_A30_C0 "I0 J-1 K1.73205080756888"
#define TO_A30_C170 "I86824088833465 J492403876506104 K866025403784439"
