// SPDX-License-Identifier: Apache-2.0
// G37, G45 to G48 and cutter compensation B and C: nanoseconds a block under the fast engine and the exact model, one
// thread, streaming. Blocks are read once beforehand, except in text_to_path.
#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/fanuc/rings.h"

namespace {

using namespace toolcomp::bench;

constexpr std::string_view kSetup = R"(
control = "fanuc"
axes = ["X", "Y", "Z"]
[parameters]
6241 = 1000
6251 = 20
6254 = 5
[measurement]
Z = "198.0"
[offsets.H]
1 = 15
[offsets.D]
1 = "4.95"
)";
std::string with_b() { return "cutter_compensation = \"B\"\n" + std::string(kSetup); }

Program measurement() {
  Program program{std::string(kSetup), "G90 G00 H01 Z760.\n", ""};
  for (int i = 0; i < kBlocks / 2; ++i) program.body += "G37 Z200.\nG00 Z760.\n";
  return program;
}
Program tool_offset() {
  Program program{std::string(kSetup), "G91 G01 F1000 D1\n", ""};
  for (int i = 0; i < kBlocks / 2; ++i)
    program.body += fmt::format("G4{} X10.5 Y7.25\nG4{} X-10.5 Y-7.25\n", 5 + i % 4, 5 + i % 4);
  return program;
}
Program canned_cycle() {
  Program program{std::string(kSetup), "G90 G00 G43 H1 Z50.\nG99 G81 X0 Y0 Z-20. R2. F1000\n", ""};
  for (int i = 0; i < kBlocks; ++i) program.body += fmt::format("X{}.5 Y{}.25\n", i % 90, i % 70);
  return program;
}
Program cutter_b() { return around(ring(kBlocks, 60, 3, 5), 0, with_b()); }
Program cutter_b_arcs() { return around(ring(kBlocks, 60, 3, 5), 2, with_b()); }
// Corners of one intersection, inner and outer.
Program cutter_c_lines() { return around(ring(kBlocks, 60, 3, 5), 0, std::string(kSetup)); }
// A star: inner corners and acute outer ones of two vectors in turn.
Program cutter_c_acute() {
  std::vector<Point> points;
  const std::vector<Point> inner = ring(kBlocks / 2, 400, 0, 1);
  const std::vector<Point> outer = ring(kBlocks, 600, 0, 1);
  for (std::size_t i = 0; i < inner.size(); ++i) {
    points.push_back(inner[i]);
    points.push_back(outer[2 * i + 1]);
  }
  return around(points, 0, std::string(kSetup));
}
Program cutter_c_line_and_arc() { return around(ring(kBlocks, 60, 3, 5), 2, std::string(kSetup)); }
Program cutter_c_arcs() { return around(ring(kBlocks, 60, 3, 5), 1, std::string(kSetup)); }

TOOLCOMP_ROW(measurement);
TOOLCOMP_ROW(tool_offset);
TOOLCOMP_ROW(canned_cycle);
TOOLCOMP_ROW(cutter_b);
TOOLCOMP_ROW(cutter_b_arcs);
TOOLCOMP_ROW(cutter_c_lines);
TOOLCOMP_ROW(cutter_c_acute);
TOOLCOMP_ROW(cutter_c_line_and_arc);
TOOLCOMP_ROW(cutter_c_arcs);

}  // namespace
