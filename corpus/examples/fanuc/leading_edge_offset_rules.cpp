// SPDX-License-Identifier: Apache-2.0
// Leading edge offset: one program for each rule that generated programs seldom meet, mostly alarms.
#include "corpus/examples.h"

namespace toolcomp::corpus {
namespace {

#define AXES(axes, parameters) \
  "control = \"fanuc\"\naxes = [" axes "]\n[parameters]\n" parameters "[offsets.D]\n1 = 10\n2 = -5\n"
#define EDGE(parameters) AXES("\"X\", \"Y\", \"Z\"", parameters)

constexpr Example kRules[] = {
    {"19631 = 30, VT (1, 1, 0), VM (-10, 0, -10): (VM . VT)^2 / (|VM|^2 |VT|^2) = 100/400 = sin^2 30. The angle is "
     "exactly 90 + 30 and counts as 90, so VC points backward as before: VC = 10 (1, -1, 2)/sqrt 6 = "
     "(4.08248290463863, -4.08248290463863, 8.16496580927726) at line 3. At the start VC = 10 (-1, 1, 0)/sqrt 2.",
     EDGE("19631 = 30\n"), "G43.5 I1 J1 K0\nG41.3 D1\nX100\nG91 X-10 Z-10\nG40\n"},
    {"19631 = 45, VT (1, 0, 1), VM (100, 0, 0): exactly 45 counts as 0: PS5408 at line 2.", EDGE("19631 = 45\n"),
     "G43.5 I1 K1\nG41.3 D1\nX100\n"},
    {"19631 = 45, VT (1, 0, 1), VM (-100, 0, 0): exactly 135 counts as 180: PS5408 at line 2.", EDGE("19631 = 45\n"),
     "G43.5 I1 K1\nG41.3 D1\nX-100\n"},
    {"19631 = 0: only exact angles count. VT (3/5, 0, 4/5), VM (100, 0, 0): VC = (-8, 0, 6) at line 2.",
     EDGE("19631 = 0\n"), "G43.5 I3 K4\nG41.3 D1\nX100\nG40\n"},
    {"VT nearly at right angles at the start, leaning back by less than 1: VC points forward, x > 0, at line 2.",
     EDGE(""), "G43.5 I-1 K1000\nG41.3 D1\nG01 X100\nG40\n"},
    {"Two blocks without movement keep the previous vector: (-8, 0, 6) at lines 2 to 5, although the tool turns to Z.",
     EDGE(""), "G43.5 I3 K4\nG41.3 D1\nG01 X100\nI0 J0 K1\nM08\nX200\nG40\n"},
    {"M00 stops the look-ahead: the vector (-8, 0, 6) of the start is kept at line 3 although the next movement is Y.",
     EDGE(""), "G43.5 I3 K4\nG41.3 D1\nG01 X100\nM00\nY100\nG40\n"},
    {"Another D takes effect in the vector at the end of its block: R -5 reverses and halves (-8, 0, 6) to (4, 0, -3) "
     "at line 3.",
     EDGE(""), "G43.5 I3 K4\nG41.3 D1\nG01 X100 D2\nX200\nG40\n"},
    {"D0 cancels as G40 does, at X100 Z0. G41.3 with D0 starts nothing.", EDGE(""),
     "G43.5 I3 K4\nG41.3 D1\nG01 X100\nD0\nG41.3 D0\nX150\n"},
    {"An axis word in the block of G41.3: PS5406 at line 1.", EDGE(""), "G41.3 D1 X1\n"},
    {"G41.3 under G02: PS5408 at line 2.", EDGE(""), "G02\nG41.3 D1\n"},
    {"No movement after G41.3: PS5407 at line 1.", EDGE(""), "G41.3 D1\nM08\n"},
    {"G41.3 again: PS5407 at line 3.", EDGE(""), "G41.3 D1\nX1\nG41.3\n"},
    {"G02 in the mode: PS5407 at line 3.", EDGE(""), "G41.3 D1\nX1\nG02\n"},
    {"G54 in the mode: FORBIDDEN_IN_3D_COMPENSATION at line 3.", EDGE(""), "G41.3 D1\nX1\nG54\n"},
    {"An axis word in the block of G40: PS5406 at line 3.", EDGE(""), "G41.3 D1\nX1\nG40 X2\n"},
    {"I J K all zero: PS5421 at line 1.", EDGE(""), "G43.5 I0 J0 K0\n"},
    {"A rotary word under G43.5: PS5421 at line 1.", AXES("\"X\", \"Y\", \"Z\", \"B\"", ""), "G43.5 B1\n"},
    {"G43.5 under G02: TOOL_DIRECTION_FORMAT at line 1.", EDGE(""), "G02 G43.5\n"},
    {"G28 under G43.5: FORBIDDEN_UNDER_TOOL_DIRECTION at line 2.", EDGE(""), "G43.5\nG28 X0\n"},
    {"G43 under G43.5: LENGTH_OFFSET_EXCLUSION at line 2.", EDGE(""), "G43.5\nG43\n"},
};

#undef EDGE
#undef AXES

}  // namespace

std::span<const Example> leading_edge_offset_rules() { return kRules; }

}  // namespace toolcomp::corpus
