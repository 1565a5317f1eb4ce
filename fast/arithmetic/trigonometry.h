// SPDX-License-Identifier: Apache-2.0
// Sine and cosine of angles in degrees, reduced exactly: multiples of 90 degrees are exact.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

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
inline DoublePair load_pair(const double* from) {
  DoublePair pair;
  std::memcpy(&pair, from, sizeof pair);
  return pair;
}
inline void store_pair(double* to, DoublePair pair) { std::memcpy(to, &pair, sizeof pair); }
SineCosine<DoublePair> sine_cosine(std::int64_t first, std::int64_t second);
inline constexpr double kTrigonometryError = 6 * 0x1p-53;

// The whole number nearest to a value below 2^51, of two the even one: by additions, where std::nearbyint may be a
// call.
constexpr double nearest_whole(double value) {
  constexpr double kShift = 0x1.8p52;
  return (value + kShift) - kShift;
}

// The same in double-double, relative error at most kFineTrigonometryError.
SineCosine<DoubleDouble> fine_sine_cosine(const Count& degrees);
inline constexpr double kFineTrigonometryError = 0x1p-100;

// Of two angles.
std::array<SineCosine<double>, 2> sine_cosine(const Count& first, const Count& second);
// Of each lane.
inline std::array<SineCosine<double>, 2> apart(const SineCosine<DoublePair>& pair) {
  return {SineCosine<double>{pair.sine[0], pair.cosine[0]}, SineCosine<double>{pair.sine[1], pair.cosine[1]}};
}

// Of an angle in double, reduced exactly, |degrees| below 2^36; the same relative error.
SineCosine<double> sine_cosine(double degrees);
SineCosine<DoublePair> sine_cosine(DoublePair degrees);

// The angle of (cosine, sine) of any length in degrees, in (-180, 180]; exact at multiples of 90, 0 where both are 0.
// Relative error at most kArctangentError; uses no libm.
double arctangent(double sine, double cosine);
DoublePair arctangent(DoublePair sine, DoublePair cosine);
inline constexpr double kArctangentError = 6 * 0x1p-53;

// The same as a count, within 2 units (1.6e-20 degrees, 2^-72 rad) given the exact vector.
Count fine_arctangent(const DoubleDouble& sine, const DoubleDouble& cosine);

}  // namespace toolcomp::fast
