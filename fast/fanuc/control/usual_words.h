// SPDX-License-Identifier: Apache-2.0
// The words of a usual line, without a detour: positions, F and the code of group 01 in force again, all of few digits
// and places. For the short cuts that take blocks as they are read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fast/arithmetic/count.h"
#include "fast/fanuc/control/control.h"
#include "fast/fanuc/program/words.h"
#include "spec/language/fanuc/block.h"

namespace toolcomp::fast {

// Words count as they are written, the positions of the linear axes are theirs, and no value waits to come into force.
inline bool usual_positions_may_come(const Control& control) {
  const AxisPositions& positions = control.positions;
  return !control.refuses_repeats && !control.modal.lacks_feed() && !control.cutter_value.takes_edited() &&
         !positions.length().pending() && control.units.plain() && positions.rounded() == 0 &&
         positions.tool_offset().live() == 0 && positions.stale() == 0;
}
// Nothing else of the modal state needs a look before such a block.
inline bool usual_words_may_come(const Control& control) {
  return usual_positions_may_come(control) && !control.attitude.plans_tool();
}
inline bool usual_lines_may_come(const Control& control) {
  return control.modal.motion() <= kG01 && usual_words_may_come(control);
}

// A short cut takes blocks in place of others, and hands them back to those.
class Handover {
 public:
  explicit Handover(Control& control) : control_(control) {}
  void take(BlockTaker& taker) {
    others_ = control_.taker;
    control_.taker = &taker;
  }
  // Who takes the next block now.
  BlockTaker& back() {
    control_.taker = others_;
    return *others_;
  }

 private:
  Control& control_;
  BlockTaker* others_ = nullptr;
};

// The letters of the axes behind the first three, as UsualWords has them.
inline std::uint32_t letters_of_further_axes(const Control& control) {
  std::uint32_t letters = 0;
  for (std::size_t axis = 3; axis < control.axes.count; ++axis)
    letters |= std::uint32_t{2} << control.axes.letters.index[axis];
  return letters;
}

// In 10^-6, by letter; a letter that is absent keeps what it had.
class UsualWords {
 public:
  // Where a letter is, A: 1; sets of them have that bit.
  static constexpr std::size_t at(char letter) { return static_cast<std::size_t>(letter - 'A') + 1; }
  static constexpr std::uint32_t set(char letter) { return std::uint32_t{1} << at(letter); }
  static constexpr std::uint32_t set_of(const char* letters) { return Words::set_of(letters) << 1U; }

  [[nodiscard]] std::int64_t& operator[](std::size_t letter) { return word_[letter]; }
  [[nodiscard]] const std::int64_t& operator[](std::size_t letter) const { return word_[letter]; }
  // F as what stays in force.
  [[nodiscard]] double feed() const { return Count::nearest_small(word_[at('F')]); }
  // The letters that may come.
  void permit(std::uint32_t letters) { permitted_ = letters; }
  [[nodiscard]] bool permits(std::uint32_t letters) const { return (letters & ~permitted_) == 0; }

  // False: not the words of a usual line. `letters`: those of the block; `motion`: the code of group 01 in force.
  [[nodiscard, gnu::always_inline]] bool read(const spec::Block& block, Code motion, std::uint32_t& letters) {
    // The code in force again, and no other.
    return read(block, letters) && ((letters & set('G')) == 0 || 10 * word_[at('G')] == motion * Count::kSmallPerOne);
  }
  // The same, whatever the code says; no other code stands beside it.
  [[nodiscard, gnu::always_inline]] bool read(const spec::Block& block, std::uint32_t& letters) {
    letters = 0;
    std::uint64_t sum = 0;
    std::uint64_t digits = 0;
    unsigned shapes = 0;
    for (const spec::Word& word : block.words()) {
      const std::size_t letter = static_cast<unsigned char>(word.address) & 31U;
      letters |= std::uint32_t{1} << letter;
      sum += std::uint32_t{1} << letter;
      digits |= word.value.digits;
      shapes |= Count::shape(word.value) + 1U;
      word_[letter] = Count::small_of_short(word.value);
    }
    const bool each_once = sum == letters;
    // F 0 is none.
    if ((letters & set('F')) != 0 && word_[at('F')] == 0) [[unlikely]]
      return false;
    return (letters & ~permitted_) == 0 && Count::are_short(digits, shapes) && letters != 0 &&
           ((letters & set('G')) == 0 || each_once);
  }

  // Blocks of two words, of these letters in this order: the most usual ones. False: any other, and nothing is done.
  [[nodiscard, gnu::always_inline]] static bool read_two(const spec::Block& block,
                                                         const std::array<std::size_t, 2>& letters,
                                                         std::array<std::int64_t, 2>& to) {
    return block.size == 2 && are_in_order(block.word.data(), letters) && read_short(block.word.data(), to);
  }
  // Words of these letters in this order.
  template <std::size_t kSize>
  [[gnu::always_inline]] static bool are_in_order(const spec::Word* words,
                                                  const std::array<std::size_t, kSize>& letters) {
    std::size_t differ = 0;
    for (std::size_t i = 0; i < kSize; ++i) differ |= (static_cast<unsigned char>(words[i].address) & 31U) ^ letters[i];
    return differ == 0;
  }
  // False: they are not all of few digits.
  template <std::size_t kSize>
  [[nodiscard, gnu::always_inline]] static bool read_short(const spec::Word* words,
                                                           std::array<std::int64_t, kSize>& to) {
    std::uint64_t digits = 0;
    unsigned shapes = 0;
    for (std::size_t i = 0; i < kSize; ++i) {
      digits |= words[i].value.digits;
      shapes |= Count::shape(words[i].value) + 1U;
      to[i] = Count::small_of_short(words[i].value);
    }
    return Count::are_short(digits, shapes);
  }

 private:
  std::uint32_t permitted_ = 0;
  std::array<std::int64_t, 32> word_{};
};

}  // namespace toolcomp::fast
