// SPDX-License-Identifier: Apache-2.0
// Heidenhain 3D tool compensation: nanoseconds a block under the fast engine and the exact model, one thread,
// streaming.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "spec/language/event_gcode.h"
#include "tests/bench/heidenhain/klartext_rows.h"

namespace {

using namespace toolcomp::bench;

constexpr std::string_view kSetup = R"(
control = "heidenhain"
[[tool]]
number = 1
R = 6
R2 = 1
L = 100
DL = "0.05"
DR = "-0.1"
DR2 = "-0.02"
[[tool]]
number = 2
R = 3
R2 = 3
DR2TABLE = "BALL"
[[dr2table]]
name = "BALL"
points = [[0, 0], [20, "0.005"], [40, "0.01"], [60, "-0.005"], [90, "-0.02"]]
)";

// A place of a ring over a free-form surface, as a CAM system prints it: the surface normal, and the tool beside it.
struct Place {
  double x, y, z;
  double nx, ny, nz;
  double tx, ty, tz;
};
Place place(int i, int count) {
  const double a = 2 * std::numbers::pi * i / count;
  Place p{};
  p.x = 40 * std::cos(a);
  p.y = 40 * std::sin(a);
  p.z = 2 * std::sin(3 * a);
  p.nx = 0.3 * std::sin(a);
  p.ny = 0.2 * std::cos(2 * a);
  p.nz = std::sqrt(1 - p.nx * p.nx - p.ny * p.ny);
  p.tx = 0.5 * p.nx + 0.1;
  p.ty = 0.5 * p.ny - 0.1;
  p.tz = std::sqrt(1 - p.tx * p.tx - p.ty * p.ty);
  return p;
}

enum class Vectors { normal, tool, both };
std::string blocks(Vectors vectors, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const Place p = place(i, count);
    text += fmt::format("LN X{:+.4f} Y{:+.4f} Z{:+.4f}", p.x, p.y, p.z);
    if (vectors != Vectors::tool) text += fmt::format(" NX{:+.7f} NY{:+.7f} NZ{:+.7f}", p.nx, p.ny, p.nz);
    if (vectors != Vectors::normal) text += fmt::format(" TX{:+.7f} TY{:+.7f} TZ{:+.7f}", p.tx, p.ty, p.tz);
    text += '\n';
  }
  return text;
}

Program program(std::string_view head, Vectors vectors, int count = kBlocks) {
  return {std::string(kSetup), "TOOL CALL 1 Z S12000 F1000\n" + std::string(head), blocks(vectors, count)};
}

Program face_milling() { return program("M128\n", Vectors::both); }
Program face_milling_without_tcpm() { return program("", Vectors::normal); }
Program face_milling_with_deviations() {
  return {std::string(kSetup), "TOOL CALL 2 Z\nM128\n", blocks(Vectors::both, kBlocks)};
}
Program programmed_contour() { return program("M128\nFUNCTION PROG PATH IS CONTOUR\n", Vectors::both); }
// The start-up runs to the last place, so that the ring closes there.
Program peripheral_milling_vectors() { return program("M128\nL X39.9 Y-1 RL\n", Vectors::tool); }
Program peripheral_milling_rotary_words() {
  Program rotary = program("M128\nL X39.9 Y-1 RL\n", Vectors::tool);
  rotary.body.clear();
  for (int i = 0; i < kBlocks; ++i) {
    const Place p = place(i, kBlocks);
    rotary.body += fmt::format("L X{:+.4f} Y{:+.4f} Z{:+.4f} B{:+.4f} C{:+.4f}\n", p.x, p.y, p.z, 20 * p.nx, 90 * p.ny);
  }
  return rotary;
}
Program line_without_compensation() {
  Program plain = program("", Vectors::normal);
  plain.body.clear();
  for (int i = 0; i < kBlocks; ++i) {
    const Place p = place(i, kBlocks);
    plain.body += fmt::format("L X{:+.4f} Y{:+.4f} Z{:+.4f}\n", p.x, p.y, p.z);
  }
  return plain;
}

TOOLCOMP_KLARTEXT_ROW(face_milling);
TOOLCOMP_KLARTEXT_ROW(face_milling_without_tcpm);
TOOLCOMP_KLARTEXT_ROW(face_milling_with_deviations);
TOOLCOMP_KLARTEXT_ROW(programmed_contour);
TOOLCOMP_KLARTEXT_ROW(peripheral_milling_vectors);
TOOLCOMP_KLARTEXT_ROW(peripheral_milling_rotary_words);
TOOLCOMP_KLARTEXT_ROW(line_without_compensation);

// From text to events, and on to their text.
void face_milling_from_text(benchmark::State& state) {
  Path<double> path;
  klartext::from_text(state, program("M128\n", Vectors::both, kTextBlocks), kTextBlocks, path);
}
BENCHMARK(face_milling_from_text);
void face_milling_text_to_text(benchmark::State& state) {
  const toolcomp::spec::Axes axes("XYZABC");
  Printer printer(axes);
  klartext::from_text(state, program("M128\n", Vectors::both, kTextBlocks), kTextBlocks, printer);
}
BENCHMARK(face_milling_text_to_text);

}  // namespace
