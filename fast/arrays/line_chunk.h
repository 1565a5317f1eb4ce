// SPDX-License-Identifier: Apache-2.0
// Lines as arrays, as a stage of compensation sees them: a few hundred blocks whose words are whole numbers already.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "fast/arrays/instructions.h"
#include "fast/arrays/moves.h"
#include "spec/language/line_columns.h"

namespace toolcomp::fast {

using spec::kNormalPlace;
using spec::kToolVectorPlace;
using spec::kWordPlaces;
using spec::place_bit;
using spec::word_place;

struct LineMoves;

// Every block has the same words. Lengths and angles are whole numbers of 10^-6, below 2^50; of vectors in Klartext
// programs, of 10^-8, below 10^9.
struct LineChunk {
  static constexpr std::size_t kMost = spec::LineColumns::kMost;
  using Columns = spec::LineColumns::Columns;
  // Of a block held before them, and of them.
  using Column = std::array<double, kMost + 1>;

  std::size_t size = 0;
  std::uint32_t words = 0;  // place_bit() of those that there are
  const Columns* columns = nullptr;
  std::size_t first = 0;   // of the columns
  std::uint64_t line = 0;  // of the first block
  Instructions instructions = Instructions::baseline;
  Moves* moves = nullptr;            // with room for as many as there are blocks
  const std::uint64_t* n = nullptr;  // their sequence numbers, or nothing
  LineMoves* made = nullptr;         // where more than their axes is wanted

  // The words of the blocks; nullptr: they have none of these.
  [[nodiscard]] const double* word(std::size_t place) const {
    return (words & place_bit(place)) == 0 ? nullptr : (*columns)[place].data() + first;
  }
  // Puts them behind the one of the block before; where there are none, that one stays.
  void go_on(std::size_t place, Column& column) const {
    if (const double* const words_of = word(place))
      std::copy_n(words_of, size, column.begin() + 1);
    else
      std::fill_n(column.begin() + 1, size, column[0]);
  }
  // `count` of them, without the first `from`.
  [[nodiscard]] LineChunk part(std::size_t from, std::size_t count) const {
    LineChunk some = *this;
    some.size = count;
    some.first += from;
    some.line += from;
    if (n != nullptr) some.n += from;
    return some;
  }
  [[nodiscard]] std::optional<std::uint64_t> number(std::size_t i) const {
    return n == nullptr ? std::nullopt : std::optional(n[i]);
  }
};

}  // namespace toolcomp::fast
