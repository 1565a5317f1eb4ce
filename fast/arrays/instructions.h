// SPDX-License-Identifier: Apache-2.0
// Loops over arrays, compiled for several kinds of processors from one text. Nothing is reordered or fused: all of them
// give the same bits.
#pragma once

#include <cstdint>

namespace toolcomp::fast {

enum class Instructions : std::uint8_t {
  baseline,  // of every processor the library runs on
  avx2,
};
// The best this processor has.
[[nodiscard]] Instructions best_instructions();

// `Loop::run`, an always inlined static function, by these instructions.
// NOLINTBEGIN(bugprone-easily-swappable-parameters)
#if defined(__x86_64__)
template <class Loop, class... Arguments>
[[gnu::target("avx2"), gnu::noinline]] auto run_by_avx2(Arguments... arguments) {
  return Loop::run(arguments...);
}
#endif
template <class Loop, class... Arguments>
[[gnu::noinline]] auto run_by_baseline(Arguments... arguments) {
  return Loop::run(arguments...);
}
// NOLINTEND(bugprone-easily-swappable-parameters)

template <class Loop, class... Arguments>
auto run_by([[maybe_unused]] Instructions instructions, Arguments... arguments) {
#if defined(__x86_64__)
  if (instructions == Instructions::avx2) return run_by_avx2<Loop>(arguments...);
#endif
  return run_by_baseline<Loop>(arguments...);
}

}  // namespace toolcomp::fast
