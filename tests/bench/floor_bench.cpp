// What no compensation can undercut on the machine at hand, from plain arrays in the cache: the yardstick of the other
// rows, and of figures from another machine.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "tests/bench/rows.h"

namespace {

constexpr std::size_t kCorners = 4096;
constexpr double kRadius = 5;
constexpr double kChord = 0.5;

struct Point {
  double x, y;
};
struct SpacePoint {
  double x, y, z;
};

double angle(std::size_t i) { return 2 * std::numbers::pi * static_cast<double>(i) / kCorners; }
constexpr double kLength = kCorners * kChord;

// Cutter compensation's corner of two lines: one root, one division, (n1 + n2) r / (1 + n1·n2).
void plane_corner(benchmark::State& state) {
  std::vector<Point> path;
  for (std::size_t i = 0; i <= kCorners; ++i)
    path.push_back({kLength * std::cos(angle(i)), kLength * std::sin(angle(i))});
  std::vector<Point> heads(kCorners);
  for (auto _ : state) {
    Point normal{0, 1};
    for (std::size_t i = 0; i < kCorners; ++i) {
      const double x = path[i + 1].x - path[i].x;
      const double y = path[i + 1].y - path[i].y;
      const double scale = 1 / std::sqrt(x * x + y * y);
      const Point next{-y * scale, x * scale};
      const double share = kRadius / (1 + normal.x * next.x + normal.y * next.y);
      heads[i] = {path[i].x + (normal.x + next.x) * share, path[i].y + (normal.y + next.y) * share};
      normal = next;
    }
    benchmark::DoNotOptimize(heads.data());
    benchmark::ClobberMemory();
  }
  toolcomp::bench::count_blocks(state, kCorners);
}
BENCHMARK(plane_corner)->Name("floor/corner_in_the_plane");

// Tool side compensation's: both side normals across the tool at the corner, two cross products and two roots.
void space_corner(benchmark::State& state) {
  std::vector<SpacePoint> path;
  std::vector<SpacePoint> tools;
  for (std::size_t i = 0; i <= kCorners; ++i) {
    path.push_back({kLength * std::cos(angle(i)), kLength * std::sin(angle(i)), 5 * std::sin(3 * angle(i))});
    const double lean = 0.2 * std::sin(5 * angle(i));
    tools.push_back({std::sin(lean), 0, std::cos(lean)});
  }
  std::vector<SpacePoint> heads(kCorners);
  const auto across = [](const SpacePoint& v, const SpacePoint& d) {
    const SpacePoint n{v.y * d.z - v.z * d.y, v.z * d.x - v.x * d.z, v.x * d.y - v.y * d.x};
    const double scale = 1 / std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    return SpacePoint{n.x * scale, n.y * scale, n.z * scale};
  };
  for (auto _ : state) {
    SpacePoint before{1, 0, 0};
    for (std::size_t i = 0; i < kCorners; ++i) {
      const SpacePoint next{path[i + 1].x - path[i].x, path[i + 1].y - path[i].y, path[i + 1].z - path[i].z};
      const SpacePoint a = across(tools[i], before);
      const SpacePoint b = across(tools[i], next);
      const double share = kRadius / (1 + a.x * b.x + a.y * b.y + a.z * b.z);
      heads[i] = {path[i].x + (a.x + b.x) * share, path[i].y + (a.y + b.y) * share, path[i].z + (a.z + b.z) * share};
      before = next;
    }
    benchmark::DoNotOptimize(heads.data());
    benchmark::ClobberMemory();
  }
  toolcomp::bench::count_blocks(state, kCorners);
}
BENCHMARK(space_corner)->Name("floor/corner_in_space");

void sine_and_cosine(benchmark::State& state) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < kCorners; ++i) angles.push_back(angle(i));
  for (auto _ : state)
    for (const double a : angles) {
      benchmark::DoNotOptimize(std::sin(a));
      benchmark::DoNotOptimize(std::cos(a));
    }
  toolcomp::bench::count_blocks(state, kCorners);
}
BENCHMARK(sine_and_cosine)->Name("floor/sine_and_cosine");

}  // namespace
