// SPDX-License-Identifier: Apache-2.0
// Automatic tool length measurement: the examples of chapter 14, 14.2.
#include "corpus/examples.h"

namespace toolcomp::corpus {
namespace {

// Deceleration distance 20, permitted half range 5; the approach-end signal of Z comes on at `touch`.
#define MEASURE(touch)                                                                                  \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[parameters]\n6241 = 1000\n6251 = 20\n6254 = 5\n" \
  "[position]\nX = 1100\nZ = 760\n[measurement]\nZ = \"" touch "\"\n"
#define NO_SIGNAL                                                                                       \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[parameters]\n6241 = 1000\n6251 = 20\n6254 = 5\n" \
  "[position]\nX = 1100\nZ = 760\n"
#define H15 "[offsets.H]\n1 = 15\n"
#define PROGRAM "G92 Z760. X1100.\nG00 G90 X850.\nH01\nG37 Z200.\nG00 Z204.\n"

constexpr Example kExamples[] = {
    {"14.2, G37 Z200 touched at 198: rapid to 220, measuring feed to 198, H1 becomes 15 - 2 = 13; then G00 Z204.",
     MEASURE("198") H15, PROGRAM},
    {"14.2, touched at 205, the near end of the permitted range: + 5, H1 = 20.", MEASURE("205") H15, PROGRAM},
    {"14.2, touched at 195, the far end of the permitted range: - 5, H1 = 10.", MEASURE("195") H15, PROGRAM},
    {"14.2, touched at 206, too early: the measuring move ends there, PS0080, the offset is not changed.",
     MEASURE("206") H15, PROGRAM},
    {"14.2, touched at 205.001, a thousandth too early: PS0080.", MEASURE("205.001") H15, PROGRAM},
    {"14.2, no signal: the measuring move ends at 195, PS0080.", NO_SIGNAL H15, PROGRAM},
    {"14.2, memory B, geometry 15, wear 0: the wear becomes -2.",
     MEASURE("198") "[offsets]\nmemory = \"B\"\n[offsets.H]\n1 = { geometry = 15, wear = 0 }\n", PROGRAM},
    {"14.2, memory C, geometry 15, wear 0.5: the wear of H becomes -1.5, D stays as it is.",
     MEASURE("198") "[offsets]\nmemory = \"C\"\n[offsets.H]\n1 = { geometry = 15, wear = \"0.5\" }\n[offsets.D]\n"
                    "1 = { geometry = 3, wear = 0 }\n",
     PROGRAM},
    {"14.2, H in the block of G37: PS0082.", MEASURE("198") H15, "H01\nG37 Z200. H01\n"},
    {"14.2, no H number: PS0081.", MEASURE("198") H15, "G37 Z200.\n"},
    {"14.2, G37 under G91: PS0083.", MEASURE("198") H15, "H01\nG91 G37 Z-5.\n"},
    {"14.2, G37 with two axes: PS0083.", MEASURE("198") H15, "H01\nG37 X1. Z1.\n"},
};

#undef MEASURE
#undef NO_SIGNAL
#undef H15
#undef PROGRAM

}  // namespace

std::span<const Example> tool_length_measurement_examples() { return kExamples; }

}  // namespace toolcomp::corpus
