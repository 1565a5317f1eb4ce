// SPDX-License-Identifier: Apache-2.0
// Leading edge offset: the worked examples LE1 to LE10, and runs of blocks near 0, 90 and 180 degrees.
#include "corpus/examples.h"

namespace toolcomp::corpus {
namespace {

#define EDGE(radius, fluctuation)                                                           \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[parameters]\n19631 = \"" fluctuation \
  "\"\n[offsets.D]\n1 = " radius "\n"
#define HEAD                                                                                                         \
  "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[parameters]\n19680 = 2\n19681 = 5\n19682 = 3\n" \
  "19686 = 4\n19687 = 2\n19631 = 1\n[offsets.D]\n1 = 6\n"

constexpr Example kExamples[] = {
    {"LE1: VT (3/5, 0, 4/5), VM (100, 0, 0), R 10: the tool leans forward, VC = (-8, 0, 6).", EDGE("10", "1.0"),
     "G43.5 I3 J0 K4\nG41.3 D1\nG01 X100\nG40\n"},
    {"LE2: VT (-3/5, 0, 4/5), VM (100, 0, 0), R 10: the tool leans back, VC = (8, 0, 6).", EDGE("10", "1.0"),
     "G43.5 I-3 J0 K4\nG41.3 D1\nG01 X100\nG40\n"},
    {"LE5: B 15, C 30, R 6, VM (40, -10, 5): VT = (0.224143868042013381, 0.129409522551260381, 0.965925826289068287), "
     "VC "
     "= (-5.635045313286906622, 1.759957600658339579, 1.071827206730734610).",
     HEAD, "G00 B15. C30.\nG41.3 D1\nG91 G01 X40 Y-10 Z5\nG40\n"},
    {"LE5 the other way: VM (-40, 10, -5) gives the same VC.", HEAD,
     "G00 B15. C30.\nG41.3 D1\nG91 G01 X-40 Y10 Z-5\nG40\n"},
    {"LE7: VT along (400, 0, 39999), VM (100, 0, 0), R 10, 19631 = 1, VC forward before: at line 3 VC = (399990/40001, "
     "0, -4000/40001) = (9.99950001249969, 0, -0.0999975000624984).",
     EDGE("10", "1.0"), "G43.5 I-3 J0 K4\nG41.3 D1\nG01 X100 I400 J0 K39999\nX200\nG40\n"},
    {"LE7 with VC backward before: at line 3 VC = (-399990/40001, 0, 4000/40001).", EDGE("10", "1.0"),
     "G43.5 I3 J0 K4\nG41.3 D1\nG01 X100 I400 J0 K39999\nX200\nG40\n"},
    {"LE7 with 19631 = 0.5: the angle does not count as 90 any more, so VC points backward although it pointed forward "
     "before: VC = (-399990/40001, 0, 4000/40001).",
     EDGE("10", "0.5"), "G43.5 I-3 J0 K4\nG41.3 D1\nG01 X100 I400 J0 K39999\nX200\nG40\n"},
    {"LE9: exactly 90 twice, VT = Z, VM (100, 0, 0), R 10, VC backward before: VC = (-10, 0, 0) at lines 3 and 4.",
     EDGE("10", "1.0"), "G43.5 I3 J0 K4\nG41.3 D1\nG01 X100 I0 J0 K1\nX200\nX300\nG40\n"},
    {"LE9 with VC forward before: VC = (10, 0, 0) at lines 3 and 4.", EDGE("10", "1.0"),
     "G43.5 I-3 J0 K4\nG41.3 D1\nG01 X100 I0 J0 K1\nX200\nX300\nG40\n"},
    {"LE10: VM (60, 0, 80) along VT at the start: PS5408 at line 2.", EDGE("10", "1.0"),
     "G43.5 I3 J0 K4\nG41.3 D1\nG01 X60 Z80\n"},
    {"LE10: VM (-60, 0, -80) against VT at the start: PS5408 at line 2.", EDGE("10", "1.0"),
     "G43.5 I3 J0 K4\nG41.3 D1\nG01 X-60 Z-80\n"},
    {"A block without movement between: the vector of line 3 is computed from the movement of line 5. Line 4, which "
     "turns the tool, keeps this vector. VT (3/5, 0, 4/5), then VM (0, 100, 0), exactly 90, and VC backward before: VC "
     "= (0, -10, 0).",
     EDGE("10", "1.0"), "G43.5 I3 J0 K4\nG41.3 D1\nG01 X100\nI0 J0 K1\nY100\nG40\n"},
    {"A movement along the tool keeps the vector: VT (3/5, 0, 4/5). VC = (-8, 0, 6) of X100 is kept at line 3, because "
     "the next block moves along the tool, and at line 4, because the next block moves against the tool.",
     EDGE("10", "1.0"), "G43.5 I3 J0 K4\nG41.3 D1\nG01 X100\nX160 Z80\nX100 Z0\nX0\nG40\n"},
    {"A negative offset value reverses the vector: LE1 with R -10 gives VC = (8, 0, -6).", EDGE("-10", "1.0"),
     "G43.5 I3 J0 K4\nG41.3 D1\nG01 X100\nG40\n"},
};

#undef EDGE
#undef HEAD

}  // namespace

std::span<const Example> leading_edge_offset_examples() { return kExamples; }

}  // namespace toolcomp::corpus
