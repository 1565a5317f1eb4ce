// SPDX-License-Identifier: Apache-2.0
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

// Around the same ring with arcs: centres at eight chords from the middle, to the left and to the right in turn. An arc
// is known by its end and by the way from its start to its centre, as in a block.
struct ArcRing {
  std::vector<Point> path;
  std::vector<Point> to_center;
  std::vector<double> turn;  // +1: counterclockwise
};
ArcRing arc_ring() {
  ArcRing ring;
  for (std::size_t i = 0; i <= kCorners; ++i)
    ring.path.push_back({kLength * std::cos(angle(i)), kLength * std::sin(angle(i))});
  for (std::size_t i = 0; i < kCorners; ++i) {
    const Point chord{ring.path[i + 1].x - ring.path[i].x, ring.path[i + 1].y - ring.path[i].y};
    const double turn = i / 2 % 2 == 0 ? 1 : -1;
    ring.turn.push_back(turn);
    ring.to_center.push_back({chord.x / 2 - 8 * turn * chord.y, chord.y / 2 + 8 * turn * chord.x});
  }
  return ring;
}

// The tool is left of the path: an arc to the left has a circle that is smaller by the radius of the cutter.
struct Circle {
  Point center;
  double turn;
  double radius;  // of the cutter's circle
  Point first;    // the arc's unit tangents at its ends
  Point last;
};
Circle circle(const ArcRing& ring, std::size_t i) {
  const Point& to = ring.to_center[i];
  const Point center{ring.path[i].x + to.x, ring.path[i].y + to.y};
  const Point end{ring.path[i + 1].x - center.x, ring.path[i + 1].y - center.y};
  const double radius = std::sqrt(to.x * to.x + to.y * to.y);
  const double scale = ring.turn[i] / radius;
  return {center,
          ring.turn[i],
          radius - ring.turn[i] * kRadius,
          {to.y * scale, -to.x * scale},
          {-end.y * scale, end.x * scale}};
}

// Cutter compensation's corners of a line and an arc: the foot of the centre on the line beside the path, half of the
// circle's chord in it. One root and one division a line, one of both an arc, a root a corner.
void line_arc_corner(benchmark::State& state) {
  const ArcRing ring = arc_ring();
  std::vector<Point> heads(kCorners);
  std::vector<Point> tangents(kCorners);
  for (auto _ : state) {
    for (std::size_t i = 0; i + 1 < kCorners; i += 2) {
      const Circle c = circle(ring, i);
      const Point& from = ring.path[i + 1];
      const double x = ring.path[i + 2].x - from.x;
      const double y = ring.path[i + 2].y - from.y;
      const double scale = 1 / std::sqrt(x * x + y * y);
      const Point along{x * scale, y * scale};
      const auto meet = [&](const Point& tangent) {
        // From the centre, across the line and along it: of two points the one on the side of the corner.
        const double across = (from.x - c.center.x) * -along.y + (from.y - c.center.y) * along.x + kRadius;
        const double half = std::sqrt(std::abs(c.radius * c.radius - across * across));
        const double side = c.turn * (along.x * tangent.y - along.y * tangent.x) > 0 ? half : -half;
        return Point{c.center.x - along.y * across + along.x * side, c.center.y + along.x * across + along.y * side};
      };
      heads[i] = meet(c.first);
      heads[i + 1] = meet(c.last);
      tangents[i] = c.first;
      tangents[i + 1] = c.last;
    }
    benchmark::DoNotOptimize(heads.data());
    benchmark::DoNotOptimize(tangents.data());
    benchmark::ClobberMemory();
  }
  toolcomp::bench::count_blocks(state, kCorners);
}
BENCHMARK(line_arc_corner)->Name("floor/corner_of_line_and_arc");

// Of two arcs: where the two circles meet. A root and a division an arc, the same a corner.
void arc_arc_corner(benchmark::State& state) {
  const ArcRing ring = arc_ring();
  std::vector<Point> heads(kCorners);
  std::vector<Point> tangents(2 * kCorners);
  for (auto _ : state) {
    Circle c = circle(ring, kCorners - 1);
    for (std::size_t i = 0; i < kCorners; ++i) {
      const Circle next = circle(ring, i);
      const Point between{next.center.x - c.center.x, next.center.y - c.center.y};
      const double scale = 1 / (between.x * between.x + between.y * between.y);
      const double square = c.radius * c.radius;
      const double along = (1 + (square - next.radius * next.radius) * scale) / 2;
      const double half = std::sqrt(std::abs(square * scale - along * along));
      const double turned = c.last.x * next.first.y - c.last.y * next.first.x;
      const double side = c.turn * next.turn * turned > 0 ? half : -half;
      heads[i] = {c.center.x + between.x * along - between.y * side, c.center.y + between.y * along + between.x * side};
      tangents[2 * i] = next.first;
      tangents[2 * i + 1] = next.last;
      c = next;
    }
    benchmark::DoNotOptimize(heads.data());
    benchmark::DoNotOptimize(tangents.data());
    benchmark::ClobberMemory();
  }
  toolcomp::bench::count_blocks(state, kCorners);
}
BENCHMARK(arc_arc_corner)->Name("floor/corner_of_arcs");

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

// Of the sweep that the event of an arc has.
void arc_tangent(benchmark::State& state) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < kCorners; ++i) points.push_back({std::cos(angle(i)), std::sin(angle(i))});
  for (auto _ : state)
    for (const Point& p : points) benchmark::DoNotOptimize(std::atan2(p.y, p.x));
  toolcomp::bench::count_blocks(state, kCorners);
}
BENCHMARK(arc_tangent)->Name("floor/arc_tangent");

}  // namespace
