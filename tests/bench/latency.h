// SPDX-License-Identifier: Apache-2.0
// How long single blocks take, beside the rate of a row: p50, p99 and the slowest block, from a pass of its own.
#pragma once

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <string>
#include <string_view>
#include <vector>

namespace toolcomp::bench {

// Of this thread's own time: what else runs on the machine is not the block's.
inline double thread_microseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

// The block of this number, from 0, of a text.
inline std::string_view line_of(std::string_view text, std::size_t number) {
  for (; number > 0; --number) text.remove_prefix(text.find('\n') + 1);
  return text.substr(0, text.find('\n'));
}

// Runs the blocks of a body a few times more by `run(i)`, for the counters p50_us and p99_us and the label. A block
// with samples counts as many, as it does in the rate. TOOLCOMP_BENCH_LATENCY=off leaves the pass out: it would be
// counted among instructions.
template <class Run>
void show_latency(benchmark::State& state, std::size_t blocks, std::uint32_t samples, std::string_view body, Run run) {
  const char* const wish = std::getenv("TOOLCOMP_BENCH_LATENCY");
  if (wish != nullptr && std::string_view(wish) == "off") return;
  const int rounds = samples > 1 ? 1 : 5;
  struct Reading {
    double us;
    std::size_t block;
  };
  std::vector<Reading> readings;
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < blocks; ++i) {
      const double begin = thread_microseconds();
      run(i);
      readings.push_back({(thread_microseconds() - begin) / std::max(samples, 1U), i});
    }
  std::ranges::sort(readings, {}, &Reading::us);
  const auto share = [&](std::size_t percent) { return readings[(readings.size() - 1) * percent / 100].us; };
  state.counters["p50_us"] = share(50);
  state.counters["p99_us"] = share(99);
  const Reading& slowest = readings.back();
  state.SetLabel(
      fmt::format("slowest: block {}, {:.0f} us: {}", slowest.block + 1, slowest.us, line_of(body, slowest.block)));
}

}  // namespace toolcomp::bench
