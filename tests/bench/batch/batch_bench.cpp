// SPDX-License-Identifier: Apache-2.0
// Lines as arrays (fast/batch): nanoseconds a block, one thread, the memory of the moves used again; by the best
// instructions this processor has, and by those every one has.
#include "fast/batch/batch.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "spec/language/setup_format.h"
#include "tests/bench/rows.h"

namespace {

using toolcomp::fast::Instructions;
using toolcomp::fast::WordColumn;

constexpr std::size_t kLines = 4096;

struct Column {
  std::string_view word;
  unsigned decimals;
  std::vector<double> values;
};
struct Work {
  std::string setup;
  std::string head;
  std::vector<Column> columns;
};

// A wavy ring with a tool that leans; a normal beside it.
double turn(std::size_t i) { return 2 * std::numbers::pi * static_cast<double>(i) / kLines; }
template <class Value>
Column column(std::string_view word, unsigned decimals, Value value) {
  Column made{word, decimals, {}};
  const double power = std::pow(10.0, decimals);
  for (std::size_t i = 0; i < kLines; ++i) made.values.push_back(std::round(value(turn(i)) * power) / power);
  return made;
}
constexpr double kRadius = 0.5 * kLines / (2 * std::numbers::pi);
std::vector<Column> places(unsigned decimals) {
  return {column("X", decimals, [](double a) { return (kRadius + std::sin(7 * a)) * std::cos(a); }),
          column("Y", decimals, [](double a) { return (kRadius + std::sin(7 * a)) * std::sin(a); }),
          column("Z", decimals, [](double a) { return 5 * std::sin(3 * a); })};
}
std::vector<Column> with(std::vector<Column> columns, std::vector<Column> more) {
  for (Column& each : more) columns.push_back(std::move(each));
  return columns;
}
double lean(double a) { return 0.2 + 0.1 * std::sin(5 * a); }
double slope(double a) { return 0.4 + 0.1 * std::sin(4 * a); }
std::vector<Column> vectors(const std::vector<std::string_view>& words, unsigned decimals, double (*angle)(double)) {
  return {column(words[0], decimals, [=](double a) { return std::sin(angle(a)) * std::cos(a); }),
          column(words[1], decimals, [=](double a) { return std::sin(angle(a)) * std::sin(a); }),
          column(words[2], decimals, [=](double a) { return std::cos(angle(a)); })};
}

constexpr std::string_view kFanuc = R"(
control = "fanuc"
axes = ["X", "Y", "Z", "B", "C"]
[parameters]
19680 = 2
19681 = 5
19682 = 3
19686 = 4
19687 = 2
[offsets.H]
1 = 100
[offsets.D]
1 = "4.95"
)";
constexpr std::string_view kThreeAxes = R"(
control = "fanuc"
axes = ["X", "Y", "Z"]
[offsets.D]
1 = "4.95"
)";
constexpr std::string_view kKlartext = R"(
control = "heidenhain"
[[tool]]
number = 1
R = 6
R2 = 1
DL = "0.05"
DR = "-0.1"
DR2 = "-0.02"
)";

Work cutter_c_lines() {
  std::vector<Column> plane = places(3);
  plane.pop_back();
  return {std::string(kThreeAxes), "G90 G17 G01 F1000 X320. Y-2.\nG42 D1 X326. Y-1.\n", std::move(plane)};
}
Work length_offset() { return {std::string(kFanuc), "G90 G01 F1000\nG43 H1 Z0\n", places(3)}; }
Work tool_side_lines() {
  return {std::string(kFanuc), "G90 G01 F1000 B10. C20.\nX320. Y-2.\nG41.2 D1 X326. Y-1.\n", places(3)};
}
Work tool_side_ijk() {
  return {std::string(kThreeAxes), "G43.5 H0 I0 J0 K1\nG90 G01 F1000 X320. Y-2. Z0\nG41.6 D1 X326. Y-1. I0.2 J0 K1\n",
          with(places(3), vectors({"I", "J", "K"}, 5, lean))};
}
Work face_milling() {
  return {std::string(kKlartext), "TOOL CALL 1 Z S12000 F1000\nL X0 Y0 Z0 R0 F1000 M128\n",
          with(places(4), with(vectors({"NX", "NY", "NZ"}, 7, slope), vectors({"TX", "TY", "TZ"}, 7, lean)))};
}
Work face_milling_without_tcpm() {
  return {std::string(kKlartext), "TOOL CALL 1 Z S12000 F1000\nL X0 Y0 Z0 R0 F1000\n",
          with(places(4), vectors({"NX", "NY", "NZ"}, 7, slope))};
}

void row(benchmark::State& state, const Work& work, Instructions instructions) {
  const toolcomp::spec::Setup setup = toolcomp::spec::read_setup_toml(work.setup, "setup");
  toolcomp::fast::Batch batch(setup, nullptr, instructions);
  batch.run(work.head);
  std::vector<WordColumn> columns;
  for (const Column& each : work.columns) columns.push_back({each.word, each.values, each.decimals});
  for (auto _ : state) {
    batch.moves().clear();
    batch.lines(columns);
    benchmark::DoNotOptimize(batch.moves().axis(0).data());
    benchmark::ClobberMemory();
  }
  if (batch.stopped()) state.SkipWithError("alarm");
  state.counters["as arrays"] = static_cast<double>(batch.blocks_as_arrays()) / static_cast<double>(batch.blocks());
  toolcomp::bench::count_blocks(state, kLines);
}

// NOLINTBEGIN(cppcoreguidelines-macro-usage)
#define TOOLCOMP_BATCH_ROW(work)                                                                         \
  void work##_best(benchmark::State& state) { row(state, work(), toolcomp::fast::best_instructions()); } \
  BENCHMARK(work##_best)->Name("batch/" #work);                                                          \
  void work##_baseline(benchmark::State& state) { row(state, work(), Instructions::baseline); }          \
  BENCHMARK(work##_baseline)->Name("batch_baseline/" #work)
// NOLINTEND(cppcoreguidelines-macro-usage)
TOOLCOMP_BATCH_ROW(length_offset);
TOOLCOMP_BATCH_ROW(cutter_c_lines);
TOOLCOMP_BATCH_ROW(tool_side_lines);
TOOLCOMP_BATCH_ROW(tool_side_ijk);
TOOLCOMP_BATCH_ROW(face_milling);
TOOLCOMP_BATCH_ROW(face_milling_without_tcpm);

}  // namespace
