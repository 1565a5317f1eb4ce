// Sine and cosine of angles in degrees, reduced exactly: multiples of 90 degrees are exact.
#pragma once

#include <cstdint>

#include "fast/arithmetic/count.h"
#include "fast/arithmetic/double_double.h"

namespace toolcomp::fast {

template <class Number>
struct SineCosine {
  Number sine;
  Number cosine;
};

// Relative error of each at most kTrigonometryError (the polynomials 2u, the angle in radians 3u); zero exactly where
// the true value is zero. No libm: the result is the same everywhere.
SineCosine<double> sine_cosine(const Count& degrees);
// Of a plain count of 10^-6 degrees, |small| <= Count::kSmallLimit.
SineCosine<double> sine_cosine(std::int64_t small);
// Of two of them side by side, in the lanes of one register.
using Pair [[gnu::vector_size(16)]] = double;
SineCosine<Pair> sine_cosine(std::int64_t first, std::int64_t second);
inline constexpr double kTrigonometryError = 6 * 0x1p-53;

// The same in double-double, relative error at most kFineTrigonometryError.
SineCosine<DoubleDouble> fine_sine_cosine(const Count& degrees);
inline constexpr double kFineTrigonometryError = 0x1p-100;

}  // namespace toolcomp::fast
