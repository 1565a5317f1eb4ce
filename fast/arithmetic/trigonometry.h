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
using DoublePair [[gnu::vector_size(16)]] = double;
SineCosine<DoublePair> sine_cosine(std::int64_t first, std::int64_t second);
inline constexpr double kTrigonometryError = 6 * 0x1p-53;

// The same in double-double, relative error at most kFineTrigonometryError.
SineCosine<DoubleDouble> fine_sine_cosine(const Count& degrees);
inline constexpr double kFineTrigonometryError = 0x1p-100;

// Of an angle in double, reduced exactly, |degrees| below 2^40; the same relative error.
SineCosine<double> sine_cosine(double degrees);

// The angle of (cosine, sine) of any length in degrees, in (-180, 180]; exact at multiples of 90, 0 where both are 0.
// Relative error at most kArctangentError; uses no libm.
double arctangent(double sine, double cosine);
inline constexpr double kArctangentError = 6 * 0x1p-53;

// The same as a count, within 2 units (1.6e-20 degrees, 2^-72 rad) given the exact vector.
Count fine_arctangent(const DoubleDouble& sine, const DoubleDouble& cosine);

}  // namespace toolcomp::fast
