// SPDX-License-Identifier: Apache-2.0
// Signed whole numbers of 512 bits, for predicates that must be exact: no allocation, no loop over unknown lengths.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "fast/arithmetic/double_double.h"
#include "fast/arithmetic/int128.h"

namespace toolcomp::fast {

// Two's complement, least limb first. Results are exact while they stay below 2^511 in magnitude: displacements have at
// most 127 bits and directions 122, so |VM x VT|^2 and 4 |VM|^2 |VT|^2 have at most 504.
class Wide {
 public:
  constexpr Wide() = default;
  constexpr Wide(Int128 value) {  // NOLINT(google-explicit-constructor): a whole number is a wide one
    limb_.fill(value < 0 ? ~std::uint64_t{0} : 0);
    limb_[0] = static_cast<std::uint64_t>(value);
    limb_[1] = static_cast<std::uint64_t>(value >> 64);
  }

  // -1, 0, 1.
  [[nodiscard]] constexpr int sign() const {
    if (negative()) return -1;
    for (const std::uint64_t limb : limb_)
      if (limb != 0) return 1;
    return 0;
  }

  friend constexpr Wide operator+(const Wide& a, const Wide& b) {
    Wide sum;
    UInt128 carry = 0;
    for (std::size_t i = 0; i < kLimbs; ++i) {
      carry += static_cast<UInt128>(a.limb_[i]) + b.limb_[i];
      sum.limb_[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return sum;
  }
  friend constexpr Wide operator-(const Wide& a) {
    Wide complement;
    for (std::size_t i = 0; i < kLimbs; ++i) complement.limb_[i] = ~a.limb_[i];
    return complement + Wide(1);
  }
  friend constexpr Wide operator-(const Wide& a, const Wide& b) { return a + -b; }
  friend constexpr Wide operator*(const Wide& a, const Wide& b) {
    Wide product;
    for (std::size_t i = 0; i < kLimbs; ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; i + j < kLimbs; ++j) {
        const UInt128 t = static_cast<UInt128>(a.limb_[i]) * b.limb_[j] + product.limb_[i + j] + carry;
        product.limb_[i + j] = static_cast<std::uint64_t>(t);
        carry = static_cast<std::uint64_t>(t >> 64);
      }
    }
    return product;
  }

  // The two doubles nearest to the value, relative error at most 2^-105.
  [[nodiscard]] DoubleDouble to_double_double() const {
    const Wide magnitude = negative() ? -*this : *this;
    DoubleDouble sum;
    for (std::size_t i = kLimbs; i-- > 0;) {
      // A limb as two exact doubles of 32 bits.
      const auto high = static_cast<double>(magnitude.limb_[i] >> 32);
      const auto low = static_cast<double>(magnitude.limb_[i] & 0xFFFFFFFFU);
      const int exponent = static_cast<int>(64 * i);
      if (high != 0) sum = sum + DoubleDouble{std::ldexp(high, exponent + 32), 0};
      if (low != 0) sum = sum + DoubleDouble{std::ldexp(low, exponent), 0};
    }
    return negative() ? -sum : sum;
  }
  [[nodiscard]] double to_double() const { return to_double_double().hi; }

 private:
  static constexpr std::size_t kLimbs = 8;
  [[nodiscard]] constexpr bool negative() const { return (limb_[kLimbs - 1] >> 63) != 0; }
  std::array<std::uint64_t, kLimbs> limb_{};
};

}  // namespace toolcomp::fast
