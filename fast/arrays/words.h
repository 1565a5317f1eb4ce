// SPDX-License-Identifier: Apache-2.0
// Words given as doubles, as the decimals of a program.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fast/arrays/instructions.h"
#include "spec/language/decimal.h"

namespace toolcomp::fast {

inline constexpr unsigned kMostPlaces = 9;
inline constexpr double kMostWord = 1e9;
// Of a vector: below 10 as it is written (E_VEC_RANGE).
[[nodiscard]] double most_component(unsigned decimals);

// Writes value * 10^decimals, rounded to a whole number (ties to even), times 10^(places - decimals), for `size` words.
// decimals <= places, and the results are below 2^51. Never -0. False: one of them is above `most`, or no number.
[[nodiscard]] bool scale_words(Instructions by, const double* value, std::size_t size, unsigned decimals,
                               unsigned places, double most, double* whole);
// Whether all of them are numbers, and none above `most`.
[[nodiscard]] bool are_within(Instructions by, const double* value, std::size_t size, double most);
// The first row of three components that are all 0 as words of so many decimals; `size`: none.
[[nodiscard]] std::size_t find_zero_vector(Instructions by, const std::array<const double*, 3>& component,
                                           std::size_t size, unsigned decimals);
// One of them as a word. At most kMostWord.
[[nodiscard]] spec::Decimal word_of(double value, unsigned decimals);

}  // namespace toolcomp::fast
