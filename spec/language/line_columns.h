// SPDX-License-Identifier: Apache-2.0
// Consecutive lines of a program that have the same usual words, as columns of numbers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace toolcomp::spec {

// The place of a word among the columns. FANUC: of the letter (A: 0). Klartext: X Y Z by their letters, then the
// components of normal and tool vector.
constexpr std::size_t word_place(char letter) { return static_cast<std::size_t>(letter - 'A'); }
inline constexpr std::size_t kNormalPlace = 26;      // NX, NY, NZ
inline constexpr std::size_t kToolVectorPlace = 29;  // TX, TY, TZ
inline constexpr std::size_t kWordPlaces = 32;
constexpr std::uint32_t place_bit(std::size_t place) { return std::uint32_t{1} << place; }

struct LineColumns {
  static constexpr std::size_t kMost = 256;
  static constexpr int kNoCode = -1;
  using Columns = std::array<std::array<double, kMost>, kWordPlaces>;

  std::size_t size = 0;     // lines
  std::uint32_t words = 0;  // place_bit() of those that there are; a line that lacks one has that of the line before
  Columns columns{};        // whole numbers of 10^-6
  int code = kNoCode;       // the number of the G word of all lines that have one
  std::uint64_t line = 0;   // of the first one, in the text
  bool numbered = false;    // each has a sequence number
  std::array<std::uint64_t, kMost> n{};
  std::array<std::uint8_t, kMost> column{};  // of the first of its words, in the text
};

}  // namespace toolcomp::spec
