// G37, G45 to G48 and cutter compensation B and C: nanoseconds a block under the fast engine and the exact model, one
// thread, streaming. Blocks are read once beforehand, except in text_to_path.
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/rows.h"

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
constexpr std::string_view kB = "cutter_compensation = \"B\"\n";

// Points around a wavy ring, counter-clockwise, in thousandths.
struct Point {
  std::int64_t x = 0;
  std::int64_t y = 0;
};
std::vector<Point> ring(int count, double radius, double wave, int waves) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    const double r = radius + wave * std::sin(waves * angle);
    points.push_back({std::llround(1000 * r * std::cos(angle)), std::llround(1000 * r * std::sin(angle))});
  }
  return points;
}

std::string number(std::int64_t thousandths) {
  const std::int64_t magnitude = thousandths < 0 ? -thousandths : thousandths;
  return fmt::format("{}{}.{:03}", thousandths < 0 ? "-" : "", magnitude / 1000, magnitude % 1000);
}
std::string words(Point p) { return fmt::format("X{} Y{}", number(p.x), number(p.y)); }

// The start-up runs to the last point, so that the ring closes there. Every `arcs`-th block is an arc (0: none), whose
// centre lies `flatness` chords from its middle, to the left and to the right in turn.
Program around(const std::vector<Point>& points, int arcs, bool type_b = false) {
  constexpr std::int64_t kFlatness = 8;
  Program program;
  program.setup = (type_b ? std::string(kB) : std::string()) + std::string(kSetup);
  const Point last = points.back();
  program.head = "G90 G17 G01 F1000 " + words({last.x - 20'000, last.y - 1'000}) + "\nG41 D1 " + words(last) + "\n";
  Point from = last;
  int n = 0;
  std::string modal = "G01";
  // A code of group 01 only where it changes, as programs have it; the first block of the body says it.
  const auto code = [&](const std::string& wanted) {
    const bool says = n == 1 || wanted != modal;
    modal = wanted;
    return says ? wanted + " " : std::string();
  };
  for (const Point to : points) {
    ++n;
    if (arcs == 0 || n % arcs != 0) {
      program.body += code("G01") + words(to) + "\n";
    } else {
      const bool left = n / arcs % 2 == 0;
      const std::int64_t k = left ? 2 * kFlatness : -2 * kFlatness;
      // Twice the way to the centre is whole; one more decimal halves it.
      const Point twice{to.x - from.x - k * (to.y - from.y), to.y - from.y + k * (to.x - from.x)};
      const auto half = [](std::int64_t v) { return number(v / 2) + (v % 2 == 0 ? "" : "5"); };
      const auto sign = [](std::int64_t v) { return v == -1 ? "-" : ""; };
      program.body += fmt::format("{}{} I{}{} J{}{}\n", code(left ? "G03" : "G02"), words(to), sign(twice.x),
                                  half(twice.x), sign(twice.y), half(twice.y));
    }
    from = to;
  }
  return program;
}

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
Program cutter_b() { return around(ring(kBlocks, 60, 3, 5), 0, true); }
Program cutter_b_arcs() { return around(ring(kBlocks, 60, 3, 5), 2, true); }
// Corners of one intersection, inner and outer.
Program cutter_c_lines() { return around(ring(kBlocks, 60, 3, 5), 0); }
// A star: inner corners and acute outer ones of two vectors in turn.
Program cutter_c_acute() {
  std::vector<Point> points;
  const std::vector<Point> inner = ring(kBlocks / 2, 400, 0, 1);
  const std::vector<Point> outer = ring(kBlocks, 600, 0, 1);
  for (std::size_t i = 0; i < inner.size(); ++i) {
    points.push_back(inner[i]);
    points.push_back(outer[2 * i + 1]);
  }
  return around(points, 0);
}
Program cutter_c_line_and_arc() { return around(ring(kBlocks, 60, 3, 5), 2); }
Program cutter_c_arcs() { return around(ring(kBlocks, 60, 3, 5), 1); }

TOOLCOMP_ROW(measurement);
TOOLCOMP_ROW(tool_offset);
TOOLCOMP_ROW(cutter_b);
TOOLCOMP_ROW(cutter_b_arcs);
TOOLCOMP_ROW(cutter_c_lines);
TOOLCOMP_ROW(cutter_c_acute);
TOOLCOMP_ROW(cutter_c_line_and_arc);
TOOLCOMP_ROW(cutter_c_arcs);
TOOLCOMP_TEXT_ROW(text_to_path_cutter_c, around(ring(kTextBlocks, 600, 10, 20), 0));

}  // namespace
