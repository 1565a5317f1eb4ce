// SPDX-License-Identifier: Apache-2.0
#include "fast/arithmetic/count.h"

#include <array>
#include <bit>
#include <cmath>

namespace toolcomp::fast {
namespace {

constexpr auto kPowers = [] {
  std::array<std::uint64_t, 20> power{};
  power[0] = 1;
  for (std::size_t i = 1; i < power.size(); ++i) power[i] = power[i - 1] * 10;
  return power;
}();
constexpr int kPlaces = 18;

int bit_length(UInt128 x) {
  const auto high = static_cast<std::uint64_t>(x >> 64);
  return high != 0 ? 128 - std::countl_zero(high) : 64 - std::countl_zero(static_cast<std::uint64_t>(x));
}

}  // namespace

bool fits_count(const spec::Decimal& value) {
  // digits < 10^18 (kMaxDigits), so only the numbers with few decimals can be too large.
  return value.decimals > 0 || value.digits < kPowers[17];
}

Count Count::of_units(const spec::Decimal& value, Factor factor, int places) {
  // Whole in 10^-6 after all: 25.4 adds one place and 254 to the digits.
  const bool inch = factor == Factor::inch_to_mm;
  if (factor != Factor::mm_to_inch && places <= kSmallPlaces - (inch ? 1 : 0) && value.digits <= kSmallDigits / 254) {
    const spec::Decimal whole{value.digits * (inch ? 254U : 1U), static_cast<std::uint8_t>(places + (inch ? 1 : 0)),
                              value.negative, true};
    if (const std::int64_t small = small_of(whole); small != kNotSmall) return {small, 0};
  }
  // digits * 10^(18 - places) * 127 * factor; 25.4 * 127 = 2 * 127^2 / 10, 127 / 25.4 = 5.
  auto units = static_cast<Int128>(value.digits);
  switch (factor) {
    case Factor::one:
      units *= static_cast<Int128>(kPowers[static_cast<std::size_t>(kPlaces - places)]) * 127;
      break;
    case Factor::inch_to_mm:
      units *= static_cast<Int128>(kPowers[static_cast<std::size_t>(kPlaces - 1 - places)]) * (Int128{2} * 127 * 127);
      break;
    case Factor::mm_to_inch:
      units *= static_cast<Int128>(kPowers[static_cast<std::size_t>(kPlaces - places)]) * 5;
      break;
  }
  return {0, value.negative ? -units : units};
}

// Division with a sticky bit: at least 59 bits of the quotient are kept, then rounded once.
double Count::nearest_of_units() const {
  const Int128 value = units();
  if (value == 0) return 0;
  const UInt128 magnitude = value < 0 ? -static_cast<UInt128>(value) : static_cast<UInt128>(value);
  const int shift = 127 - bit_length(magnitude);
  const UInt128 shifted = magnitude << shift;
  const auto divisor = static_cast<UInt128>(kRestPerOne);  // 67 bits
  UInt128 quotient = shifted / divisor;                    // 60 or 61 bits
  if (shifted % divisor != 0) quotient |= 1U;
  const double rounded = std::ldexp(static_cast<double>(static_cast<std::uint64_t>(quotient)), -shift);
  return value < 0 ? -rounded : rounded;
}

}  // namespace toolcomp::fast
