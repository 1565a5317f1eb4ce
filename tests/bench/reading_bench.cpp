// SPDX-License-Identifier: Apache-2.0
// Programs from text in memory to blocks: bytes per second of the readers, one thread.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>

#include "spec/language/fanuc/program_reader.h"
#include "spec/language/heidenhain/klartext_reader.h"

namespace {

using namespace toolcomp;

// Far more than fits in a cache.
constexpr int kLines = 200'000;

// Digits of one number after another, all different.
class Numbers {
 public:
  // Such as +12.3456, with so many digits before and behind the point.
  std::string next(int before, int behind) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    std::uint64_t bits = state_ >> 13U;
    std::string text = (bits & 1U) != 0 ? "+" : "-";
    for (int i = 0; i < before + behind; ++i, bits /= 10) {
      if (i == before) text += '.';
      text += static_cast<char>('0' + bits % 10);
    }
    return text;
  }

 private:
  std::uint64_t state_ = 1;
};

// What CAM writes for five axes: lines of about 110 bytes.
std::string lines_with_vectors() {
  Numbers numbers;
  std::string text;
  for (int i = 1; i <= kLines; ++i) {
    text += std::to_string(i) + " LN";
    for (const char* key : {" X", " Y", " Z"}) text += key + numbers.next(2, 4);
    for (const char* key : {" NX", " NY", " NZ", " TX", " TY", " TZ"}) text += key + numbers.next(1, 7);
    text += '\n';
  }
  return text;
}

std::string lines() {
  Numbers numbers;
  std::string text;
  for (int i = 1; i <= kLines; ++i) {
    text += std::to_string(i) + " L";
    for (const char* key : {" X", " Y", " Z"}) text += key + numbers.next(2, 4);
    text += '\n';
  }
  return text;
}

std::string fanuc_lines() {
  Numbers numbers;
  std::string text;
  for (int i = 1; i <= kLines; ++i) {
    text += 'N' + std::to_string(i);
    for (const char* key : {" X", " Y", " Z", " B", " C"}) text += key + numbers.next(2, 4);
    text += '\n';
  }
  return text;
}

void count(benchmark::State& state, const std::string& text) {
  state.SetBytesProcessed(static_cast<std::int64_t>(text.size()) * state.iterations());
  state.SetItemsProcessed(kLines * state.iterations());
}

void read_klartext(benchmark::State& state, const std::string& text) {
  spec::Setup setup;
  setup.control = spec::Control::heidenhain;
  for (auto _ : state) {
    spec::klartext::Reader reader(spec::text_source(text), setup);
    for (spec::klartext::Block block; reader.next(block);) {
      if (block.alarm) state.SkipWithError("alarm");
      benchmark::DoNotOptimize(block.axis);
    }
  }
  count(state, text);
}

void read_line_with_vectors(benchmark::State& state) { read_klartext(state, lines_with_vectors()); }
BENCHMARK(read_line_with_vectors)->Unit(benchmark::kMillisecond);

void read_line(benchmark::State& state) { read_klartext(state, lines()); }
BENCHMARK(read_line)->Unit(benchmark::kMillisecond);

void read_fanuc_line(benchmark::State& state) {
  const std::string text = fanuc_lines();
  for (auto _ : state) {
    spec::ProgramReader reader(spec::text_source(text), spec::Axes("XYZBC"));
    for (spec::Block block; reader.next(block);) {
      if (block.alarm) state.SkipWithError("alarm");
      benchmark::DoNotOptimize(block.word);
    }
  }
  count(state, text);
}
BENCHMARK(read_fanuc_line)->Unit(benchmark::kMillisecond);

// The same as columns.
void read_fanuc_columns(benchmark::State& state) {
  const std::string text = fanuc_lines();
  const auto columns = std::make_unique<spec::LineColumns>();
  for (auto _ : state) {
    spec::ProgramReader reader(spec::text_source(text), spec::Axes("XYZBC"));
    std::size_t lines = 0;
    for (spec::Block block; reader.next(block); ++lines)
      for (reader.lines(*columns, spec::LineColumns::kMost); columns->size > 0;
           reader.lines(*columns, spec::LineColumns::kMost)) {
        reader.pass_lines(columns->size);
        lines += columns->size;
        benchmark::DoNotOptimize(columns->columns);
      }
    if (lines != kLines) state.SkipWithError("lines are missing");
  }
  count(state, text);
}
BENCHMARK(read_fanuc_columns)->Unit(benchmark::kMillisecond);

// What no reader can be faster than: the ends of the lines, by the C library.
void scan_line_ends(benchmark::State& state) {
  const std::string text = fanuc_lines();
  for (auto _ : state) {
    std::int64_t lines = 0;
    const char* const end = text.data() + text.size();
    for (const void* at = text.data(); at != end; ++lines)
      at = static_cast<const char*>(
               std::memchr(at, '\n', static_cast<std::size_t>(end - static_cast<const char*>(at)))) +
           1;
    if (lines != kLines) state.SkipWithError("lines are missing");
  }
  count(state, text);
}
BENCHMARK(scan_line_ends)->Unit(benchmark::kMillisecond);

}  // namespace
