// SPDX-License-Identifier: Apache-2.0
// Numbers to text: ours beside std::to_chars and fmt, the same numbers. fast/basis/print.cpp stays while its rows are
// ahead.
#include <benchmark/benchmark.h>
#include <fmt/compile.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "fast/basis/print.h"

namespace {

using namespace toolcomp;

// They stay in the cache, and are too many for the processor to foresee.
constexpr std::size_t kNumbers = 4096;

// As programmed: up to a metre, whole micrometres.
std::vector<double> short_decimals() {
  std::mt19937_64 random(1);
  std::vector<double> numbers(kNumbers);
  for (double& number : numbers)
    number = static_cast<double>(static_cast<std::int64_t>(random() % 2'000'000) - 1'000'000) / 1000;
  return numbers;
}

// As compensated: all places of a double.
std::vector<double> full_doubles() {
  std::vector<double> numbers = short_decimals();
  for (double& number : numbers) number += 10 * std::sin(number);
  return numbers;
}

// As a path has them: an axis that moves with all places, one that moves in short decimals, one that stays, the feed.
std::vector<double> path_numbers() {
  const std::vector<double> decimals = short_decimals();
  const std::vector<double> doubles = full_doubles();
  std::vector<double> numbers;
  for (std::size_t i = 0; i < kNumbers / 4; ++i) numbers.insert(numbers.end(), {doubles[i], decimals[i], -12.5, 800});
  return numbers;
}

// The text write_number() gives, by the library alone.
char* write_by_library(char* to, double value) {
  const double magnitude = std::abs(value);
  if (magnitude == 0) value = 0;
  const bool plain = magnitude == 0 || (magnitude >= 1e-7 && magnitude < 1e21);
  const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
  return std::to_chars(to, to + fast::kNumberText, value, format).ptr;
}

// The shortest digits by the other library at hand, as it lays them out.
char* write_by_fmt(char* to, double value) { return fmt::format_to(to, FMT_COMPILE("{}"), value); }

using Numbers = std::vector<double> (*)();

template <class Write>
void write(benchmark::State& state, Numbers make, Write write) {
  const std::vector<double> numbers = make();
  std::array<char, fast::kNumberText> text{};
  for (auto _ : state) {
    for (const double number : numbers) {
      benchmark::DoNotOptimize(write(text.data(), number));
      benchmark::ClobberMemory();
    }
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(kNumbers) * state.iterations());
}

void print_to_chars(benchmark::State& state, Numbers make) { write(state, make, write_by_library); }
void print_fmt(benchmark::State& state, Numbers make) { write(state, make, write_by_fmt); }
void print_ours(benchmark::State& state, Numbers make) { write(state, make, fast::write_number); }
void print_number_writer(benchmark::State& state, Numbers make) {
  fast::NumberWriter writer;
  write(state, make, [&writer](char* to, double value) { return writer.write(to, value); });
}

BENCHMARK_CAPTURE(print_to_chars, short_decimals, short_decimals);
BENCHMARK_CAPTURE(print_fmt, short_decimals, short_decimals);
BENCHMARK_CAPTURE(print_ours, short_decimals, short_decimals);
BENCHMARK_CAPTURE(print_to_chars, full_doubles, full_doubles);
BENCHMARK_CAPTURE(print_fmt, full_doubles, full_doubles);
BENCHMARK_CAPTURE(print_ours, full_doubles, full_doubles);
BENCHMARK_CAPTURE(print_to_chars, path, path_numbers);
BENCHMARK_CAPTURE(print_fmt, path, path_numbers);
BENCHMARK_CAPTURE(print_ours, path, path_numbers);
BENCHMARK_CAPTURE(print_number_writer, path, path_numbers);

}  // namespace
