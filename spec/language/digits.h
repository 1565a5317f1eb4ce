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

// Reads kDigitsRead bytes.
[[gnu::always_inline]] inline Digits digits_at(const char* at) {
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, at, sizeof bytes);
  bytes ^= 0x3030'3030'3030'3030;
  // The first byte above 9 carries into the next bytes, which do not matter.
  const std::uint64_t others = ((bytes + 0x7676'7676'7676'7676) | bytes) & 0x8080'8080'8080'8080;
  const auto count = static_cast<unsigned>(std::countr_zero(others)) / 8;
  if (count > 7) [[unlikely]]
    return {8, 0};
  // Put zeros before the number; then add the digits in pairs, and the pairs with their powers of 100.
  bytes = bytes << (56 - 8 * count) << 8U;
  bytes = bytes * 10 + (bytes >> 8U);
  constexpr std::uint64_t kPair = 0x0000'00FF'0000'00FF;
  const std::uint64_t number =
      ((bytes & kPair) * 0x000F'4240'0000'0064 + (bytes >> 16U & kPair) * 0x0000'2710'0000'0001) >> 32U;
  return {count, number};
}

}  // namespace toolcomp::spec
