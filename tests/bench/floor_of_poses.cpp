// SPDX-License-Identifier: Apache-2.0
// The floors of tool center point control: from a tool direction to the pair of rotary positions nearest to the one
// before, and from rotary positions to the control point; by hand, for one machine each, in doubles alone.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "tests/bench/rows.h"

namespace {

constexpr std::size_t kPoses = 1000;
constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kLength = 100;

struct Vector {
  double x, y, z;
};
// Of the axis about Y or inclined, and of the one about Z that carries it: degrees, sines and cosines.
struct Pair {
  double tool, work;
  double tool_sine, tool_cosine;
  double work_sine, work_cosine;
};

double around(std::size_t i) { return 2 * std::numbers::pi * static_cast<double>(i) / kPoses; }

// Once around Z, at 10 to 60 degrees from it: I J K as whole numbers of 10^-6.
std::vector<Vector> directions() {
  std::vector<Vector> list;
  for (std::size_t i = 0; i < kPoses; ++i) {
    const double slope = std::tan((35 + 25 * std::sin(7 * around(i))) / kDegrees);
    list.push_back({std::round(1e6 * slope * std::cos(around(i))), std::round(1e6 * slope * std::sin(around(i))), 1e6});
  }
  return list;
}

Vector unit(const Vector& v) {
  const double scale = 1 / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return {v.x * scale, v.y * scale, v.z * scale};
}

double nearest_turn(double degrees, double to) { return degrees + 360 * std::nearbyint((to - degrees) / 360); }

// Of two pairs the one whose work-side axis moves by less, at the turns nearest to the last positions.
Pair chosen(const Pair& one, const Pair& other, const Pair& last) {
  const auto nearness = [&](const Pair& p) { return p.work_sine * last.work_sine + p.work_cosine * last.work_cosine; };
  Pair pair = nearness(one) >= nearness(other) ? one : other;
  pair.tool = nearest_turn(kDegrees * std::atan2(pair.tool_sine, pair.tool_cosine), last.tool);
  pair.work = nearest_turn(kDegrees * std::atan2(pair.work_sine, pair.work_cosine), last.work);
  return pair;
}

// B about Y, C about Z.
Pair upright(const Vector& direction, const Pair& last) {
  const Vector v = unit(direction);
  const double width = std::sqrt(v.x * v.x + v.y * v.y);
  const double sine = v.y / width;
  const double cosine = v.x / width;
  return chosen({0, 0, width, v.z, sine, cosine}, {0, 0, -width, v.z, -sine, -cosine}, last);
}

// The tool-side axis at 45 degrees between Y and Z: a quarter turn of it lays the tool down by 60 degrees. It brings
// the tool to (x, y) beside Z, or to (x, -y), and the other one turns that to V.
Pair inclined(const Vector& direction, const Pair& last) {
  const Vector v = unit(direction);
  const double cosine = 2 * v.z - 1;
  const double sine = 2 * std::sqrt((1 - v.z) * v.z);
  const double scale = 1 / (v.x * v.x + v.y * v.y);
  const double x = (1 - cosine) / 2 * scale;
  const double y = -std::numbers::sqrt2 / 2 * sine * scale;
  return chosen({0, 0, sine, cosine, v.y * x - v.x * y, v.x * x + v.y * y},
                {0, 0, -sine, cosine, v.y * x + v.x * y, v.x * x - v.y * y}, last);
}

template <Pair (*inverse)(const Vector&, const Pair&)>
void from_directions(benchmark::State& state) {
  const std::vector<Vector> list = directions();
  std::vector<Pair> pairs(kPoses);
  Pair last{0, 0, 0, 1, 0, 1};
  for (auto _ : state) {
    for (std::size_t i = 0; i < kPoses; ++i) pairs[i] = last = inverse(list[i], last);
    benchmark::DoNotOptimize(pairs.data());
    benchmark::ClobberMemory();
  }
  toolcomp::bench::count_blocks(state, kPoses);
}
BENCHMARK(from_directions<upright>)->Name("floor/inverse");
BENCHMARK(from_directions<inclined>)->Name("floor/inverse_inclined");

// Both sines and cosines, the direction of the tool, and the control point behind it.
void from_positions(benchmark::State& state) {
  std::vector<Vector> tips;
  std::vector<double> b;
  std::vector<double> c;
  for (std::size_t i = 0; i < kPoses; ++i) {
    tips.push_back({60 * std::cos(around(i)), 60 * std::sin(around(i)), 4 * std::sin(3 * around(i))});
    b.push_back(20 + 10 * std::sin(2 * around(i)));
    c.push_back(40 * std::cos(around(i)));
  }
  std::vector<Vector> tools(kPoses);
  std::vector<Vector> control(kPoses);
  for (auto _ : state) {
    for (std::size_t i = 0; i < kPoses; ++i) {
      const double lean = std::sin(b[i] / kDegrees);
      tools[i] = {lean * std::cos(c[i] / kDegrees), lean * std::sin(c[i] / kDegrees), std::cos(b[i] / kDegrees)};
      control[i] = {tips[i].x + kLength * tools[i].x, tips[i].y + kLength * tools[i].y,
                    tips[i].z + kLength * tools[i].z};
    }
    benchmark::DoNotOptimize(tools.data());
    benchmark::DoNotOptimize(control.data());
    benchmark::ClobberMemory();
  }
  toolcomp::bench::count_blocks(state, kPoses);
}
BENCHMARK(from_positions)->Name("floor/forward");

}  // namespace
