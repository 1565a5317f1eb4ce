// SPDX-License-Identifier: Apache-2.0
// Positions and ways in a plane as whole 10^-6, of few digits: what the short cuts compute with.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "fast/arithmetic/count.h"
#include "fast/arithmetic/trigonometry.h"
#include "fast/geometry/vector2.h"

namespace toolcomp::fast {

inline constexpr auto kWholePerOne = static_cast<double>(Count::kSmallPerOne);
// In the plane, 10^-6.
using WholePair = std::array<std::int64_t, 2>;

inline DoublePair to_doubles(const WholePair& whole) {
  return DoublePair{static_cast<double>(whole[0]), static_cast<double>(whole[1])};
}
inline DoublePair left_of(DoublePair v) { return DoublePair{-v[1], v[0]}; }
// At least the length, at most twice of it.
inline double extent(DoublePair v) { return std::abs(v[0]) + std::abs(v[1]); }
inline Vector2<double> to_vector(DoublePair v) { return {v[0], v[1]}; }

// Products of ways below 2^30, and sums of two of them, fit into 64 bits.
inline bool is_usual_way(const WholePair& way) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 30U;
  return ((static_cast<std::uint64_t>(way[0]) + kMost) | (static_cast<std::uint64_t>(way[1]) + kMost)) >> 31U == 0;
}

// Positions below 2^52, with a way added, are counts that a double holds.
inline bool is_usual_position(const WholePair& at) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 52U;
  return ((static_cast<std::uint64_t>(at[0]) + kMost) | (static_cast<std::uint64_t>(at[1]) + kMost)) >> 53U == 0;
}

}  // namespace toolcomp::fast
