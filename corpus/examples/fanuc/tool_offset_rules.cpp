// SPDX-License-Identifier: Apache-2.0
// Tool offset G45 to G48: one program for each rule that generated programs seldom meet.
#include "corpus/examples.h"

namespace toolcomp::corpus {
namespace {

#define SETUP(parameters)                                                        \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[parameters]\n" parameters \
  "[offsets.D]\n1 = 10\n[offsets.H]\n1 = 4\n"

constexpr Example kRules[] = {
    {"TPH = 1: the offset number comes from H, with the value 4: X50 goes to 54.", SETUP("\"5001#5\" = 1\n"),
     "G91 G45 X50. H1\n", "1 p G0 54 0\n"},
    {"G53 removes the shift of the axis that it names: 60, then 0, then 20 without a shift.", SETUP(""),
     "G90 G45 X50. D1\nG53 X0\nX20.\n",
     "1 p G0 60 0\n"
     "2 p G0 0 0\n"
     "3 p G0 20 0\n"},
    {"G53 of another axis keeps the shift: 60, then 60 at Z5, then 80 for X70.", SETUP(""),
     "G90 G45 X50. D1\nG53 Z5.\nX70.\n",
     "1 p G0 60 0 0\n"
     "2 p G0 60 0 5\n"
     "3 p G0 80 0 5\n"},
    {"A quarter of a circle whose radius becomes 0: the tool stays at (0, 0).", SETUP(""),
     "G91 G46 G03 X10. Y10. J10. D1 F100\n", "1 p G3 0 0 O 0 0\n"},
    {"A radius below 0: PS0038.", SETUP(""), "G91 G48 G03 X10. Y10. J10. D1 F100\n", "1 PS0038\n"},
    {"A half circle, which G45 does not allow: G45_ARC.", SETUP(""), "G91 G45 G03 X20. Y0 I10. D1 F100\n",
     "1 G45_ARC\n"},
    {"An offset number beyond the memory: PS0030.", SETUP(""), "G91 G45 X50. D401\n", "1 PS0030\n"},
};

#undef SETUP

}  // namespace

std::span<const Example> tool_offset_rules() { return kRules; }

}  // namespace toolcomp::corpus
