// SPDX-License-Identifier: Apache-2.0
// Whether a test runs under AddressSanitizer, where memory is reserved otherwise and exact numbers
// are slow.
#pragma once

#include <cstdint>

namespace toolcomp::test {

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TOOLCOMP_UNDER_SANITIZER
#endif
#endif

#ifdef TOOLCOMP_UNDER_SANITIZER
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

// Of so many random cases, those that are run here: under sanitizers, which look at how code runs and not at what it
// computes, a tenth.
constexpr std::uint64_t random_cases(std::uint64_t count) { return kSanitized ? (count + 9) / 10 : count; }

}  // namespace toolcomp::test
