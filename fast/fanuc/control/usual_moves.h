// SPDX-License-Identifier: Apache-2.0
// The words of a usual move in the selected plane, a line or an arc: positions, I J K or R, F and the codes G01 G02
// G03, all of few digits and places. For the short cuts that take lines and arcs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fast/fanuc/control/control.h"
#include "fast/fanuc/control/usual_words.h"
#include "fast/geometry/whole_pair.h"
#include "spec/language/fanuc/block.h"

namespace toolcomp::fast {

// Of a block: what its words say, 10^-6.
struct UsualMove {
  Code motion = kG01;  // G01 G02 G03, in tenths
  bool has_feed = false;
  WholePair to{};
  WholePair to_center{};    // of an arc, from its start
  std::int64_t radius = 0;  // R; 0: it is about a centre
};

class UsualMoveWords {
 public:
  explicit UsualMoveWords(Control& control) : control_(control) {}

  // Such moves may come: the letters are those of the plane that is selected now.
  [[nodiscard]] bool begin();
  // False, and nothing is done: the words of any other block. `at`: where it starts.
  [[nodiscard, gnu::always_inline]] bool read(const spec::Block& block, const WholePair& at, UsualMove& move) {
    return read_in_order(block, move) || read_any(block, at, move);
  }
  // The F of the block that has been read last.
  [[nodiscard]] double feed() const { return words_.feed(); }

 private:
  // Of the most usual ones, X Y or X Y I J with a code before or without. False: any other.
  [[nodiscard]] bool read_in_order(const spec::Block& block, UsualMove& move) const;
  [[nodiscard]] bool read_any(const spec::Block& block, const WholePair& at, UsualMove& move);

  Control& control_;
  std::array<std::size_t, 2> letter_{};         // of positions
  std::array<std::size_t, 2> center_letter_{};  // I J K
  std::array<std::size_t, 4> arc_letter_{};     // both
  UsualWords words_;
};

inline bool UsualMoveWords::begin() {
  const ModalState& modal = control_.modal;
  const std::array<std::size_t, 2>& axis = modal.plane_axis();
  if (modal.motion() < kG01 || modal.by_vector() || axis[0] == spec::Axes::kNone || axis[1] == spec::Axes::kNone ||
      !usual_words_may_come(control_) || control_.limits_radii())
    return false;
  std::uint32_t letters = UsualWords::set_of("FGR");
  for (std::size_t i = 0; i < 2; ++i) {
    letter_[i] = std::size_t{control_.axes.letters.index[axis[i]]} + 1U;
    center_letter_[i] = UsualWords::at(direction_letter(modal.plane(), i));
    letters |= std::uint32_t{1} << letter_[i] | std::uint32_t{1} << center_letter_[i];
  }
  words_.permit(letters);
  arc_letter_ = {letter_[0], letter_[1], center_letter_[0], center_letter_[1]};
  return true;
}

[[gnu::always_inline]] inline bool UsualMoveWords::read_in_order(const spec::Block& block, UsualMove& move) const {
  const spec::Word& first = block.word[0];
  const std::size_t codes = first.address == 'G' ? 1 : 0;
  const spec::Word* const words = &first + codes;
  Code motion = control_.modal.motion();
  if (codes != 0) {
    if (Count::shape(first.value) != 0 || first.value.digits > 3) return false;
    motion = static_cast<Code>(10 * first.value.digits);
  }
  if (control_.modal.incremental()) return false;
  if (motion == kG01) {
    move.motion = motion;
    return block.size == 2 + codes && UsualWords::are_in_order(words, letter_) &&
           UsualWords::read_short(words, move.to);
  }
  std::array<std::int64_t, 4> values{};
  if (block.size != 4 + codes || motion < kG01 || !UsualWords::are_in_order(words, arc_letter_) ||
      !UsualWords::read_short(words, values))
    return false;
  move.motion = motion;
  move.to = {values[0], values[1]};
  move.to_center = {values[2], values[3]};
  return true;
}

[[gnu::always_inline]] inline bool UsualMoveWords::read_any(const spec::Block& block, const WholePair& at,
                                                            UsualMove& move) {
  const bool incremental = control_.modal.incremental();
  for (std::size_t i = 0; i < 2; ++i) {
    words_[letter_[i]] = incremental ? 0 : at[i];
    words_[center_letter_[i]] = 0;
  }
  std::uint32_t letters = 0;
  if (!words_.read(block, letters)) return false;
  move.motion = control_.modal.motion();
  if ((letters & UsualWords::set('G')) != 0) {
    const std::int64_t code = words_[UsualWords::at('G')];
    constexpr std::int64_t kOne = Count::kSmallPerOne;
    if (code != kOne && code != 2 * kOne && code != 3 * kOne) return false;
    move.motion = static_cast<Code>(code / (kOne / 10));
  }
  for (std::size_t i = 0; i < 2; ++i) {
    move.to[i] = words_[letter_[i]] + (incremental ? at[i] : 0);
    move.to_center[i] = words_[center_letter_[i]];
  }
  move.has_feed = (letters & UsualWords::set('F')) != 0;
  const bool centers = (letters >> center_letter_[0] & 1U) != 0 || (letters >> center_letter_[1] & 1U) != 0;
  const bool by_radius = (letters & UsualWords::set('R')) != 0;
  if (by_radius) move.radius = words_[UsualWords::at('R')];
  // R 0 is none.
  if (by_radius && (centers || move.radius == 0)) return false;
  return (centers || by_radius) == (move.motion > kG01);
}

}  // namespace toolcomp::fast
