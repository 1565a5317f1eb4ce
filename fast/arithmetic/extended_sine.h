// SPDX-License-Identifier: Apache-2.0
// Sine and cosine to more digits than a double has, in less time than fine_sine_cosine() takes.
#pragma once

#include <cstdint>

#include "fast/arithmetic/double_double.h"
#include "fast/arithmetic/trigonometry.h"

namespace toolcomp::fast {

// Of 10^-6 degrees, at most kMostExtendedAngle of them; absolute error at most kExtendedSineError.
SineCosine<DoubleDouble> extended_sine_cosine(std::int64_t small);
inline constexpr std::int64_t kMostExtendedAngle = std::int64_t{1} << 50U;
inline constexpr double kExtendedSineError = 0x1p-70;

}  // namespace toolcomp::fast
