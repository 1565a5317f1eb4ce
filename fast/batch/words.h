// Words given as doubles, as the decimals of a program.
#pragma once

#include <cstddef>
#include <cstdint>

#include "fast/batch/instructions.h"
#include "spec/language/decimal.h"

namespace toolcomp::fast {

inline constexpr unsigned kMostPlaces = 9;
inline constexpr double kMostWord = 1e9;

// Writes value * 10^decimals, rounded to a whole number (ties to even), times 10^(places - decimals), for `size` words.
// decimals <= places, and the results are below 2^51. Never -0. False: one of them is above `most`, or no number.
[[nodiscard]] bool scale_words(Instructions by, const double* value, std::size_t size, unsigned decimals,
                               unsigned places, double most, double* whole);
// One of them as a word. At most kMostWord.
[[nodiscard]] spec::Decimal word_of(double value, unsigned decimals);

}  // namespace toolcomp::fast
