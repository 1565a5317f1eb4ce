// SPDX-License-Identifier: Apache-2.0
// Tool side compensation: nanoseconds a block under the fast engine and the exact model, one thread, streaming, around
// a wavy ring.
#include "tests/bench/fanuc/leaning_tool.h"

namespace {

using namespace toolcomp::bench;

// C-B tool rotation head: C (about Z) carries B (about Y).
constexpr std::string_view kHead = R"(
control = "fanuc"
axes = ["X", "Y", "Z", "B", "C"]
[parameters]
19680 = 2
19681 = 5
19682 = 3
19686 = 4
19687 = 2
[offsets.D]
1 = "4.95"
)";
constexpr std::string_view kVector = R"(
control = "fanuc"
axes = ["X", "Y", "Z"]
[offsets.D]
1 = "4.95"
)";

// The start-up runs to the last place, so that the ring closes there. `tool` gives the words of the tool direction.
template <class Tool>
Program turning(std::string_view setup, std::string head, std::string_view code, const Tool& tool) {
  const std::vector<Place> list = places();
  Program program{std::string(setup), std::move(head), ""};
  program.head += "G90 G01 F1000 X40. Y-1." + tool(list.back()) + "\n";
  program.head += std::string(code) + " D1 " + list.back().position + tool(list.back()) + "\n";
  for (const Place& place : list) program.body += place.position + tool(place) + "\n";
  return program;
}

Program tool_side_rotary_words() { return turning(kHead, "", "G41.2", rotary_words); }
Program tool_side_ijk() { return turning(kVector, "G43.5 H0 I0 J0 K1\n", "G41.6", vector_words); }
// One direction of the tool.
Program tool_side_fixed_tool() {
  return turning(kHead, "", "G41.2", [](const Place& /*place*/) { return std::string(" B30. C20."); });
}
Program tool_side_lines() { return around(ring(kBlocks, 60, 3, 5), 0, std::string(kHead), "G41.2"); }
Program tool_side_arcs() { return around(ring(kBlocks, 60, 3, 5), 1, std::string(kHead), "G41.2"); }

TOOLCOMP_ROW(tool_side_rotary_words);
TOOLCOMP_ROW(tool_side_ijk);
TOOLCOMP_ROW(tool_side_fixed_tool);
TOOLCOMP_ROW(tool_side_lines);
TOOLCOMP_ROW(tool_side_arcs);

}  // namespace
