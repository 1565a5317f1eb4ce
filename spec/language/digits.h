// SPDX-License-Identifier: Apache-2.0
// Reads decimal digits of a text, eight bytes at once. Internal to the readers of programs.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace toolcomp::spec {

inline constexpr std::size_t kDigitsRead = 8;
inline constexpr std::array<std::uint64_t, 19> kPowersOfTen = [] {
  std::array<std::uint64_t, 19> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = powers[i - 1] * 10;
  return powers;
}();

// At most seven digits at one place, read as one word whose lowest byte is the first character.
static_assert(std::endian::native == std::endian::little);
struct Digits {
  unsigned count = 0;  // 8 means eight digits or more: then there is no number
  std::uint64_t number = 0;
};

// The number of eight digits, given as the bytes 0 to 9.
inline std::uint64_t number_of(std::uint64_t digits) {
  // Add the digits in pairs, and the pairs with their powers of 100.
  digits = digits * 10 + (digits >> 8U);
  constexpr std::uint64_t kPair = 0x0000'00FF'0000'00FF;
  return ((digits & kPair) * 0x000F'4240'0000'0064 + (digits >> 16U & kPair) * 0x0000'2710'0000'0001) >> 32U;
}
// Bit 7 of the bytes that are no digits, of eight bytes less '0'. Exact up to the first byte beyond ASCII.
inline std::uint64_t others_of(std::uint64_t bytes) {
  return ((bytes + 0x7676'7676'7676'7676) | bytes) & 0x8080'8080'8080'8080;
}
inline std::uint64_t bytes_at(const char* at) {
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, at, sizeof bytes);
  return bytes ^ 0x3030'3030'3030'3030;
}

// Reads kDigitsRead bytes.
[[gnu::always_inline]] inline Digits digits_at(const char* at) {
  const std::uint64_t bytes = bytes_at(at);
  const auto count = static_cast<unsigned>(std::countr_zero(others_of(bytes))) / 8;
  if (count > 7) [[unlikely]]
    return {8, 0};
  // Zeros before the number.
  return {count, number_of(bytes << (56 - 8 * count) << 8U)};
}

// A number with a point, of at most seven characters: one look finds the point and the end.
struct ShortDecimal {
  unsigned size = 0;  // characters; 0: it is longer, or has no point or no digit
  unsigned decimals = 0;
  std::uint64_t digits = 0;
};

// Reads kDigitsRead bytes.
[[gnu::always_inline]] inline ShortDecimal short_decimal_at(const char* at) {
  constexpr std::uint64_t kPoint = '.' ^ '0';
  const std::uint64_t bytes = bytes_at(at);
  const std::uint64_t others = others_of(bytes);
  const std::uint64_t behind = others & (others - 1);  // without the first one
  if (behind == 0) [[unlikely]]
    return {};
  const auto point = static_cast<unsigned>(std::countr_zero(others)) & ~7U;  // bits
  const auto end = static_cast<unsigned>(std::countr_zero(behind)) & ~7U;
  if ((bytes >> point & 0xFFU) != kPoint || end == 8) [[unlikely]]
    return {};
  const std::uint64_t before = (std::uint64_t{1} << point) - 1;
  const std::uint64_t joined = (bytes & before) | (bytes >> 8U & ~before);
  return {end / 8, (end - point) / 8 - 1, number_of(joined << (72 - end))};
}

}  // namespace toolcomp::spec
