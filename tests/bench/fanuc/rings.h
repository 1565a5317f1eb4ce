// SPDX-License-Identifier: Apache-2.0
// Programs that run around a wavy ring again and again.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/bench/rows.h"

namespace toolcomp::bench {

// Points around a wavy ring, counter-clockwise, in thousandths.
struct Point {
  std::int64_t x = 0;
  std::int64_t y = 0;
};
inline std::vector<Point> ring(int count, double radius, double wave, int waves) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    const double r = radius + wave * std::sin(waves * angle);
    points.push_back({std::llround(1000 * r * std::cos(angle)), std::llround(1000 * r * std::sin(angle))});
  }
  return points;
}

inline std::string number(std::int64_t thousandths) {
  const std::int64_t magnitude = thousandths < 0 ? -thousandths : thousandths;
  return fmt::format("{}{}.{:03}", thousandths < 0 ? "-" : "", magnitude / 1000, magnitude % 1000);
}
inline std::string words(Point p) { return fmt::format("X{} Y{}", number(p.x), number(p.y)); }

// The start-up runs to the last point, so that the ring closes there. Every `arcs`-th block is an arc (0: none), whose
// centre lies `flatness` chords from its middle, to the left and to the right in turn.
inline Program around(const std::vector<Point>& points, int arcs, std::string setup, std::string_view code_on = "G41") {
  constexpr std::int64_t kFlatness = 8;
  Program program;
  program.setup = std::move(setup);
  const Point last = points.back();
  program.head = "G90 G17 G01 F1000 " + words({last.x - 20'000, last.y - 1'000}) + "\n" + std::string(code_on) +
                 " D1 " + words(last) + "\n";
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

}  // namespace toolcomp::bench
