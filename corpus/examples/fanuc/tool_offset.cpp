// SPDX-License-Identifier: Apache-2.0
// Tool offset G45 to G48: the table and the examples of chapter 14, 14.3.
#include "corpus/examples.h"

namespace toolcomp::corpus {
namespace {

#define SETUP(values) "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[offsets.D]\n" values "\n"
#define TABLE(code) "G91 G01 F100\n" code " X1000. D1\n" code " X1000. D2\n" code " X-1000. D1\n" code " X-1000. D2\n"
#define ZERO(code) "G91 G01 F100\n" code " X0 D1\n" code " X-0 D1\n"

constexpr Example kExamples[] = {
    {"Table 14.1, G45, travel 1000 and -1000 with offsets 10 and -10: 1010, 990, -1010, -990.",
     SETUP("1 = 10\n2 = -10"), TABLE("G45")},
    {"Table 14.1, G46: 990, 1010, -990, -1010.", SETUP("1 = 10\n2 = -10"), TABLE("G46")},
    {"Table 14.1, G47: 1020, 980, -1020, -980.", SETUP("1 = 10\n2 = -10"), TABLE("G47")},
    {"Table 14.1, G48: 980, 1020, -980, -1020.", SETUP("1 = 10\n2 = -10"), TABLE("G48")},
    {"Travel 0 under G91, offset 12.34, G45: X0 moves 12.34, X-0 moves -12.34.", SETUP("1 = \"12.34\""), ZERO("G45")},
    {"Travel 0 under G91, offset 12.34, G46: X0 moves -12.34, X-0 moves 12.34.", SETUP("1 = \"12.34\""), ZERO("G46")},
    {"Travel 0 under G91, offset 12.34, G47: 24.68 and -24.68.", SETUP("1 = \"12.34\""), ZERO("G47")},
    {"Travel 0 under G91, offset 12.34, G48: -24.68 and 24.68.", SETUP("1 = \"12.34\""), ZERO("G48")},
    {"14.3, G45 X1000 Y500 with an offset of 200: X1200 Y700.", SETUP("4 = 200"),
     "G91 G45 G01 X1000. Y500. D04 F100\n"},
    {"14.3, G45 X220 Y60 with an offset of 50: (270, 110).", SETUP("20 = 50"), "G91 G45 X220. Y60. D20\n"},
    {"14.3, G45 X100 Y40 with an offset of 30: (130, 70).", SETUP("1 = 30"), "G91 G45 G1 X100. Y40. D1 F100\n"},
    {"14.3, the manual's figure with a cutter of diameter 20, D01 = 10: the tool goes (70,40) (140,40) (140,80) "
     "(160,80) (160,40) (200,40), arc to (240,80) about (200,80), (240,110) (230,110), arc to (210,130) about "
     "(230,130), (210,140) (70,140) (70,40) (0,0).",
     SETUP("1 = 10"),
     "N1 G91 G46 G00 X80.0 Y50.0 D01\nN2 G47 G01 X50.0 F120.0\nN3 Y40.0\nN4 G48 X40.0\nN5 Y-40.0\nN6 G45 X30.0\n"
     "N7 G45 G03 X30.0 Y30.0 J30.0\nN8 G45 G01 Y20.0\nN9 G46 X0\nN10 G46 G02 X-30.0 Y30.0 J30.0\nN11 G45 G01 Y0\n"
     "N12 G47 X-120.0\nN13 G47 Y-80.0\nN14 G46 G00 X-80.0 Y-50.0\n"},
    {"14.3, the shift stays, from (100, 0), D1 = 10: G45 X150 goes to 160, X200 to 210, G46 X250 to 250; G46 X250 "
     "again has no travel under G90 and stays at 250.",
     SETUP("1 = 10") "[position]\nX = 100\n", "G90 G45 X150. D1\nX200.\nG46 X250.\nG46 X250.\n"},
    {"14.3, three quarters of a circle, G45 G02 X30 Y-30 I30 with an offset of 10: to (40, -40) about (40, 0).",
     SETUP("1 = 10"), "G91 G45 G02 X30. Y-30. I30. D1 F100\n"},
    {"14.3, an offset greater than the travel reverses the move: G46 X2.5 with 3.7 goes to -1.2.", SETUP("1 = \"3.7\""),
     "G91 G46 X2.5 D1\n"},
    {"14.3, G48 X20 with an offset of 15 goes to -10.", SETUP("1 = 15"), "G91 G48 X20. D1\n"},
    {"14.3, D0 has no offset: G45 X50 D0 goes to 50.", SETUP("1 = 15"), "G91 G45 X50. D0\n"},
    {"14.3, G45 under G41: PS0042.", SETUP("1 = 10"), "G01 F100 G41 X50. D1\nG45 X100.\n"},
};

#undef SETUP
#undef TABLE
#undef ZERO

}  // namespace

std::span<const Example> tool_offset_examples() { return kExamples; }

}  // namespace toolcomp::corpus
