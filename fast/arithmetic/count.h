// SPDX-License-Identifier: Apache-2.0
// Exact numbers of a program: whole counts of a unit in which every word and every setup value is whole.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "fast/arithmetic/int128.h"
#include "spec/language/decimal.h"

namespace toolcomp::fast {

// What one unit of a word is worth in setup units.
enum class Factor : std::uint8_t {
  one,
  inch_to_mm,  // 127/5
  mm_to_inch,  // 5/127
};

// A length in setup units or an angle in degrees, exactly: small / 10^6 + rest / (127 * 10^18).
// 127 * 10^18 makes every decimal of 18 places whole, in both systems: a word of 15 places times 25.4 needs 16 places,
// divided by 25.4 = 127/5 it needs 15 and the factor 127. `small` carries the usual program (six places, up to 9e9), so
// that the nearest double is one division; `rest` carries everything else. The pair is not unique: compare with ==.
// Range: |value| <= 2^125 / (127 * 10^18), about 3.3e17. The engine tests in_range() whenever a position is made;
// sums of a few terms in range cannot wrap around in 128 bits.
class Count {
 public:
  static constexpr std::int64_t kSmallPerOne = 1'000'000;
  static constexpr std::int64_t kRestPerSmall = 127'000'000'000'000;
  static constexpr Int128 kRestPerOne = static_cast<Int128>(kRestPerSmall) * kSmallPerOne;
  static constexpr std::int64_t kSmallLimit = std::int64_t{1} << 53;  // beyond it `small` would not be a double
  static constexpr Int128 kLimit = static_cast<Int128>(1) << 125;

  static constexpr int kSmallPlaces = 6;
  // What the last digit of a word is worth in `small`: by its decimals, from the 8th on of negative words.
  static constexpr std::array<std::int64_t, 16> kSmallWorth{1'000'000,  100'000,  10'000,  1'000,  100,  10,  1,  0,  //
                                                            -1'000'000, -100'000, -10'000, -1'000, -100, -10, -1, 0};
  // The same by shape(), 0 where the word is not usual; modulo 2^64.
  static constexpr std::array<std::uint64_t, 512> kWorthOfShape = [] {
    std::array<std::uint64_t, 512> worth{};
    for (std::size_t i = 0; i <= kSmallPlaces; ++i) {
      worth[i] = static_cast<std::uint64_t>(kSmallWorth[i]);
      worth[256 + i] = 0 - worth[i];
    }
    return worth;
  }();
  static constexpr std::uint64_t kSmallDigits = 9'000'000'000'000;  // times 10^6 below 2^63
  // Up to which a word of so many decimals is at most kSmallLimit.
  static constexpr std::array<std::uint64_t, 7> kMostDigits{
      kSmallLimit / 1'000'000, kSmallLimit / 100'000, kSmallLimit / 10'000, kSmallLimit / 1'000,
      kSmallLimit / 100,       kSmallLimit / 10,      kSmallLimit};

  constexpr Count() = default;
  // By parts: a processor that copies all bytes at once waits where one part has just been written.
  // NOLINTBEGIN(modernize-use-equals-default,cert-oop54-cpp): the default copies at once.
  constexpr Count(const Count& other) : small_(other.small_), rest_(other.rest_) {}
  constexpr Count& operator=(const Count& other) {
    small_ = other.small_;
    rest_ = other.rest_;
    return *this;
  }
  // NOLINTEND(modernize-use-equals-default,cert-oop54-cpp)
  // `value` with `shift` further decimals (least input increments), times `factor`. |value| must be below 1e17.
  static Count of(const spec::Decimal& value, Factor factor = Factor::one, int shift = 0) {
    if (factor == Factor::one && shift == 0) [[likely]]
      if (const std::int64_t small = small_of(value); small != kNotSmall) [[likely]]
        return {small, 0};
    return of_units(value, factor, value.decimals + shift);
  }
  // The count nearest to units / (127 * 10^18).
  static constexpr Count of_units(Int128 units) { return {0, units}; }

  // The value in units of 1 / (127 * 10^18).
  [[nodiscard]] constexpr Int128 units() const { return rest_ + static_cast<Int128>(small_) * kRestPerSmall; }
  // The value in units of 10^-6, if is_small().
  [[nodiscard]] constexpr std::int64_t small() const { return small_; }
  [[nodiscard]] constexpr bool is_small() const { return rest_ == 0; }
  [[nodiscard]] constexpr bool is_zero() const { return is_small() ? small_ == 0 : units() == 0; }
  [[nodiscard]] constexpr bool in_range() const { return is_small() || (units() <= kLimit && units() >= -kLimit); }
  // The double nearest to the value (ties to even).
  [[nodiscard]] double nearest() const {
    // Both operands are whole doubles, so the one rounding of the quotient is the nearest double.
    if (is_small()) [[likely]]
      return nearest_small(small_);
    return nearest_of_units();
  }

  // The same for plain counts of 10^-6.
  static constexpr bool is_small(std::int64_t small) { return small <= kSmallLimit && small >= -kSmallLimit; }
  static constexpr double nearest_small(std::int64_t small) {
    return static_cast<double>(small) / static_cast<double>(kSmallPerOne);
  }
  // The double nearest to a + b.
  [[nodiscard]] static double nearest_sum(const Count& a, const Count& b) {
    const std::int64_t sum = a.small_ + b.small_;
    if (a.is_small() && b.is_small() && is_small(sum)) [[likely]]
      return nearest_small(sum);
    return (a + b).nearest();
  }
  // *this = small / 10^6, |small| <= kSmallLimit. Writing the parts apart keeps the processor from waiting for them
  // when they are read back at once.
  constexpr void set_small(std::int64_t small) {
    small_ = small;
    rest_ = 0;
  }
  // The word as units of 10^-6, if it is a usual one; otherwise kNotSmall.
  static constexpr std::int64_t small_of(const spec::Decimal& value) {
    if (!is_usual(value)) [[unlikely]]
      return kNotSmall;
    return small_of_usual(value);
  }
  // A word of few places and digits.
  static constexpr bool is_usual(const spec::Decimal& value) {
    return value.decimals <= kSmallPlaces && value.digits <= kMostDigits[value.decimals];
  }
  // Only where is_usual. Without a branch: signs follow no pattern.
  static constexpr std::int64_t small_of_usual(const spec::Decimal& value) {
    return static_cast<std::int64_t>(value.digits) * kSmallWorth[value.decimals + 8U * value.negative];
  }
  // The words of a block at once: `digits` holds the bits of all their digits, `shapes` those of all their shapes, each
  // and one more. All of them are usual, and times 10^6 below kSmallLimit; only then small_of_short() is the word.
  static constexpr bool are_short(std::uint64_t digits, unsigned shapes) {
    return digits >> 33U == 0 && (shapes & 255U) <= kSmallPlaces + 1;
  }
  static std::int64_t small_of_short(const spec::Decimal& value) {
    return static_cast<std::int64_t>(value.digits * kWorthOfShape[shape(value)]);
  }
  // Decimals and sign of a word at once: decimals + 256 * negative.
  static unsigned shape(const spec::Decimal& value) {
    static_assert(std::endian::native == std::endian::little);
    static_assert(offsetof(spec::Decimal, negative) == offsetof(spec::Decimal, decimals) + 1);
    std::uint16_t both = 0;
    std::memcpy(&both, reinterpret_cast<const char*>(&value) + offsetof(spec::Decimal, decimals), sizeof both);
    return both;
  }
  static constexpr std::int64_t kNotSmall = INT64_MIN;

  constexpr Count operator-() const { return {-small_, -rest_}; }
  constexpr Count& operator+=(const Count& other) {
    small_ += other.small_;
    rest_ += other.rest_;
    if (small_ > kSmallLimit || small_ < -kSmallLimit) [[unlikely]] {
      rest_ += static_cast<Int128>(small_) * kRestPerSmall;
      small_ = 0;
    }
    return *this;
  }
  constexpr Count& operator-=(const Count& other) { return *this += -other; }
  friend constexpr Count operator+(Count a, const Count& b) { return a += b; }
  friend constexpr Count operator-(Count a, const Count& b) { return a -= b; }
  friend constexpr bool operator==(const Count& a, const Count& b) {
    return a.is_small() && b.is_small() ? a.small_ == b.small_ : a.units() == b.units();
  }
  friend constexpr bool operator<(const Count& a, const Count& b) {
    return a.is_small() && b.is_small() ? a.small_ < b.small_ : a.units() < b.units();
  }

 private:
  constexpr Count(std::int64_t small, Int128 rest) : small_(small), rest_(rest) {}
  [[nodiscard]] double nearest_of_units() const;
  static Count of_units(const spec::Decimal& value, Factor factor, int places);

  std::int64_t small_ = 0;
  Int128 rest_ = 0;
};

// True if |value| < 1e17, so that Count::of can hold it.
bool fits_count(const spec::Decimal& value);

}  // namespace toolcomp::fast
