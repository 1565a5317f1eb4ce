// SPDX-License-Identifier: Apache-2.0
// Words into exact counts. Most are of at most six places and in the units of the setup, and are whole in 10^-6.
#pragma once

#include "fast/fanuc/control/axis_positions.h"
#include "fast/fanuc/control/modal_state.h"
#include "fast/fanuc/control/tool_attitude.h"
#include "fast/fanuc/control/word_units.h"

namespace toolcomp::fast {

inline void WordUnits::read(Count& to, const spec::Decimal& word) const {
  if (plain_) [[likely]]
    if (Count::is_usual(word)) [[likely]] {
      to.set_small(Count::small_of_usual(word));
      return;
    }
  to = value(word, true);
}

template <class Arc>
void ModalState::read_arc(const Words& words, const WordUnits& units, Arc& arc) const {
  arc.clockwise = motion_ == kG02;
  arc.by_radius = words.has('R');
  for (std::size_t i = 0; i < 2; ++i) {
    const char letter = plane_letter_[i];
    if (words.has(letter))
      units.read(arc.to_center[i], words[letter]);
    else
      arc.to_center[i].set_small(0);
  }
  if (arc.by_radius) units.read(arc.radius, words['R']);
}

// A position of at most six places, as it is written.
[[gnu::always_inline]] inline bool AxisPositions::place_usual(const spec::Decimal& word, std::size_t axis) {
  if (!Count::is_usual(word)) [[unlikely]]
    return false;
  place_small(axis, Count::small_of_usual(word));
  return true;
}

// The length offset of an axis placed.
[[gnu::always_inline]] inline void AxisPositions::add_offset(std::size_t axis) {
  const std::int64_t sum = programmed_[axis].small() + length_[axis].small();
  if ((tool_offset_.live() & bit(axis)) == 0 && length_[axis].is_small() && Count::is_small(sum)) [[likely]]
    axes_value_[axis] = Count::nearest_small(sum);
  else
    stale_ = static_cast<Mask>(stale_ | bit(axis));
}

// Those of few places as they are written; the first three axes, X Y Z on most machines, not in a loop.
[[gnu::always_inline]] inline Alarm AxisPositions::place_words(const Words& words, Mask axes, const WordUnits& units,
                                                               bool incremental) {
  unsigned rest = axes;
  if (units.plain() && !incremental) [[likely]] {
    const auto placed = [&](std::size_t axis) __attribute__((always_inline)) {
      if ((rest & bit(axis)) == 0) [[unlikely]]
        return true;
      if (!place_usual(words.axis(axis), axis)) [[unlikely]]
        return false;
      rest &= ~static_cast<unsigned>(bit(axis));
      return true;
    };
    if (placed(0) && placed(1) && placed(2)) [[likely]]
      for (; rest != 0; rest &= rest - 1) {
        const auto axis = static_cast<std::size_t>(__builtin_ctz(rest));
        if (!place_usual(words.axis(axis), axis)) [[unlikely]]
          break;
      }
    const unsigned offset = axes & ~rest & static_cast<unsigned>(length_.live() | tool_offset_.live());
    for (unsigned some = offset; some != 0; some &= some - 1) add_offset(static_cast<std::size_t>(__builtin_ctz(some)));
  }
  if (rest != 0) [[unlikely]]
    if (const Alarm a = for_each_axis(static_cast<Mask>(rest), [&](std::size_t axis) {
          return place(axis, target(words, axis, units, incremental));
        }))
      return a;
  if (rounded_ != 0 && !incremental) clear_rounded(axes);
  return AlarmCause::none;
}

[[gnu::always_inline]] inline bool ToolAttitude::read_usual_direction(const Words& words, Direction& direction) const {
  static constexpr spec::Decimal kNothing;
  const auto component = [&](char letter) -> const spec::Decimal& {
    if (words.has(letter)) [[likely]]
      return words[letter];
    return kNothing;
  };
  const spec::Decimal& i = component('I');
  const spec::Decimal& j = component('J');
  const spec::Decimal& k = component('K');
  if (!units_.plain() || !Count::is_usual(i) || !Count::is_usual(j) || !Count::is_usual(k)) [[unlikely]]
    return false;
  set_small_direction(direction, Count::small_of_usual(i), Count::small_of_usual(j), Count::small_of_usual(k));
  return true;
}

}  // namespace toolcomp::fast
