// Tool side compensation: nanoseconds a block under the fast engine and the exact model, one thread, streaming, around
// a wavy ring.
#include "tests/bench/rings.h"

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

// A point of the ring, its height, and a tool that leans out of it by 10 to 30 degrees.
struct Place {
  std::string position;
  std::int64_t b = 0;  // thousandths of a degree
  std::int64_t c = 0;
};
std::vector<Place> places() {
  std::vector<Place> list;
  for (const Point p : ring(kBlocks, 60, 3, 5)) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(list.size()) / kBlocks;
    list.push_back({words(p) + " Z" + number(std::llround(4000 * std::sin(3 * angle))),
                    std::llround(20'000 + 10'000 * std::sin(2 * angle)), std::llround(40'000 * std::cos(angle))});
  }
  return list;
}

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

Program tool_side_rotary_words() {
  return turning(kHead, "", "G41.2",
                 [](const Place& place) { return fmt::format(" B{} C{}", number(place.b), number(place.c)); });
}
Program tool_side_ijk() {
  return turning(kVector, "G43.5 H0 I0 J0 K1\n", "G41.6", [](const Place& place) {
    const double b = static_cast<double>(place.b) * std::numbers::pi / 180'000;
    const double c = static_cast<double>(place.c) * std::numbers::pi / 180'000;
    return fmt::format(" I{} J{} K1.", number(std::llround(1000 * std::tan(b) * std::cos(c))),
                       number(std::llround(1000 * std::tan(b) * std::sin(c))));
  });
}
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
