// SPDX-License-Identifier: Apache-2.0
// How much a test does: a sample, everything (`./dev test --all`), or less, under AddressSanitizer or ThreadSanitizer,
// where memory is reserved otherwise and exact numbers are slow.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace toolcomp::test {

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TOOLCOMP_UNDER_SANITIZER
#endif
#endif

#ifdef TOOLCOMP_UNDER_SANITIZER
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

// Whether every case is wanted; otherwise a sample by seed is enough.
inline bool whole() {
  static const bool asked = std::getenv("TOOLCOMP_TESTS_WHOLE") != nullptr;  // NOLINT(concurrency-mt-unsafe)
  return asked && !kSanitized;
}

// The first for a sample, the second for all.
template <class T>
T effort(T sample, T all) {
  return whole() ? all : sample;
}

// Of so many random cases, those that are run: a tenth, or all.
inline std::uint64_t random_cases(std::uint64_t count) { return effort((count + 9) / 10, count); }

}  // namespace toolcomp::test
