// SPDX-License-Identifier: Apache-2.0
// The order of decimals by value: 1.50 equals 1.5, and -0 equals 0.
#pragma once

#include <compare>
#include <cstdint>
#include <utility>

#include "spec/language/decimal.h"

namespace toolcomp::spec {

inline std::strong_ordering compare(const Decimal& a, const Decimal& b) {
  // The digits before the point, then the digits after it.
  const auto magnitude = [](const Decimal& value) {
    const auto power = [](int exponent) {
      std::uint64_t result = 1;
      for (; exponent > 0; --exponent) result *= 10;
      return result;
    };
    const std::uint64_t one = power(value.decimals);
    return std::pair{value.digits / one, value.digits % one * power(Decimal::kMaxDigits - value.decimals)};
  };
  const bool a_below = a.negative && !a.is_zero();
  const bool b_below = b.negative && !b.is_zero();
  if (a_below != b_below) return a_below ? std::strong_ordering::less : std::strong_ordering::greater;
  return a_below ? magnitude(b) <=> magnitude(a) : magnitude(a) <=> magnitude(b);
}

}  // namespace toolcomp::spec
