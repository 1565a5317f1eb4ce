// SPDX-License-Identifier: Apache-2.0
// What no compensation of many corners at once can undercut on the machine at hand: the same corners as
// floor_bench.cpp, an array for each component, by vector code. The yardstick of the batch/ rows.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "fast/arrays/instructions.h"
#include "tests/bench/rows.h"

namespace {

constexpr std::size_t kCorners = 4096;
constexpr double kRadius = 5;
constexpr double kLength = kCorners * 0.5;
double angle(std::size_t i) { return 2 * std::numbers::pi * static_cast<double>(i) / kCorners; }

using Column = std::vector<double>;
struct Plane {
  Column x = Column(kCorners + 1), y = x, normal_x = x, normal_y = x, to_x = x, to_y = x;
};
struct PlaneCorners {
  [[gnu::always_inline]] static void run(const double* x, const double* y, double* normal_x, double* normal_y,
                                         double* to_x, double* to_y) {
    // A piece at a time, which stays near the processor.
    constexpr std::size_t kPiece = 512;
    for (std::size_t from = 0; from < kCorners; from += kPiece) {
      for (std::size_t i = from; i < from + kPiece; ++i) {
        const double dx = x[i + 1] - x[i];
        const double dy = y[i + 1] - y[i];
        const double scale = 1 / std::sqrt(dx * dx + dy * dy);
        normal_x[i + 1] = -dy * scale;
        normal_y[i + 1] = dx * scale;
      }
      for (std::size_t i = from; i < from + kPiece; ++i) {
        const double share = kRadius / (1 + normal_x[i] * normal_x[i + 1] + normal_y[i] * normal_y[i + 1]);
        to_x[i] = x[i] + (normal_x[i] + normal_x[i + 1]) * share;
        to_y[i] = y[i] + (normal_y[i] + normal_y[i + 1]) * share;
      }
    }
  }
};

void plane_arrays(benchmark::State& state) {
  Plane p;
  for (std::size_t i = 0; i <= kCorners; ++i) {
    p.x[i] = kLength * std::cos(angle(i));
    p.y[i] = kLength * std::sin(angle(i));
  }
  for (auto _ : state) {
    toolcomp::fast::run_by<PlaneCorners>(toolcomp::fast::best_instructions(), p.x.data(), p.y.data(), p.normal_x.data(),
                                         p.normal_y.data(), p.to_x.data(), p.to_y.data());
    benchmark::DoNotOptimize(p.to_x.data());
    benchmark::ClobberMemory();
  }
  toolcomp::bench::count_blocks(state, kCorners);
}
BENCHMARK(plane_arrays)->Name("floor/arrays_in_the_plane");

struct SpaceCorners {
  [[gnu::always_inline]] static void run(const double* x, const double* y, const double* z, const double* i,
                                         const double* j, const double* k, double* to_x, double* to_y, double* to_z) {
#ifndef __clang__
#pragma GCC ivdep
#endif
    for (std::size_t n = 1; n < kCorners; ++n) {
      const double ax = x[n] - x[n - 1], ay = y[n] - y[n - 1], az = z[n] - z[n - 1];
      const double bx = x[n + 1] - x[n], by = y[n + 1] - y[n], bz = z[n + 1] - z[n];
      const double mx = j[n] * az - k[n] * ay, my = k[n] * ax - i[n] * az, mz = i[n] * ay - j[n] * ax;
      const double nx = j[n] * bz - k[n] * by, ny = k[n] * bx - i[n] * bz, nz = i[n] * by - j[n] * bx;
      const double first = 1 / std::sqrt(mx * mx + my * my + mz * mz);
      const double second = 1 / std::sqrt(nx * nx + ny * ny + nz * nz);
      const double share = kRadius / (1 + (mx * nx + my * ny + mz * nz) * (first * second));
      to_x[n] = x[n] + (mx * first + nx * second) * share;
      to_y[n] = y[n] + (my * first + ny * second) * share;
      to_z[n] = z[n] + (mz * first + nz * second) * share;
    }
  }
};

void space_arrays(benchmark::State& state) {
  std::array<Column, 9> columns;
  columns.fill(Column(kCorners + 1));
  for (std::size_t n = 0; n <= kCorners; ++n) {
    columns[0][n] = kLength * std::cos(angle(n));
    columns[1][n] = kLength * std::sin(angle(n));
    columns[2][n] = 5 * std::sin(3 * angle(n));
    const double lean = 0.2 * std::sin(5 * angle(n));
    columns[3][n] = std::sin(lean);
    columns[5][n] = std::cos(lean);
  }
  const auto at = [&](std::size_t i) { return columns[i].data(); };
  for (auto _ : state) {
    toolcomp::fast::run_by<SpaceCorners>(toolcomp::fast::best_instructions(), at(0), at(1), at(2), at(3), at(4), at(5),
                                         at(6), at(7), at(8));
    benchmark::DoNotOptimize(at(6));
    benchmark::ClobberMemory();
  }
  toolcomp::bench::count_blocks(state, kCorners);
}
BENCHMARK(space_arrays)->Name("floor/arrays_in_space");

}  // namespace
