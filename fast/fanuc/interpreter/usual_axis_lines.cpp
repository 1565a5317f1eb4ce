// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/interpreter/usual_axis_lines.h"

#include <cstdlib>

#include "fast/basis/short_cut.h"
#include "fast/fanuc/control/read_words.h"

namespace toolcomp::fast {
namespace {

// The sum of such a count and a word of few digits is one that a double holds.
constexpr std::int64_t kMostOffset = std::int64_t{1} << 50U;

}  // namespace

void UsualAxisLines::await(Event& move, EventSink& sink) {
  if (!is_open(ShortCut::axis_line)) return;
  const ControlAxes& axes = control_.axes;
  std::uint32_t letters = UsualWords::set_of("FG");
  for (std::size_t axis = 0; axis < axes.count; ++axis) {
    const std::size_t letter = std::size_t{axes.letters.index[axis]} + 1U;
    const Count& offset = control_.positions.length()[axis];
    if (axis < letter_.size()) letter_[axis] = letter;
    if ((axes.turning & bit(axis)) != 0 || !offset.is_small() || std::abs(offset.small()) > kMostOffset) continue;
    letters |= std::uint32_t{1} << letter;
    offset_[axis] = offset.small();
  }
  words_.permit(letters);
  permits_first_ = axes.count >= letter_.size();
  for (const std::size_t letter : letter_) permits_first_ &= words_.permits(std::uint32_t{1} << letter);
  move_ = &move;
  sink_ = &sink;
  handover_.take(*this);
}

void UsualAxisLines::block(const spec::Block& block) {
  if (take(block)) [[likely]]
    return;
  handover_.back().block(block);
}

[[gnu::always_inline]] inline void UsualAxisLines::place(std::size_t axis, std::int64_t to, std::int64_t offset) {
  AxisPositions& positions = control_.positions;
  positions.place_small(axis, to);
  if (offset != 0) positions.add_small_offset(axis, offset);
  const double programmed = positions.programmed_value(axis);
  move_->programmed.value[axis] = programmed;
  move_->point.value[axis] = programmed;
  move_->axes.value[axis] = positions.sent_to(axis);
}

void UsualAxisLines::set_feed() {
  control_.modal.set_feed(words_.feed());
  if (move_->type != spec::MoveType::rapid) move_->feed = control_.modal.feed();
}

[[gnu::always_inline]] inline bool UsualAxisLines::take(const spec::Block& block) {
  if (block.alarm) [[unlikely]]
    return false;
  std::array<std::int64_t, 3> to{};
  if (block.size == to.size() && UsualWords::are_in_order(block.word.data(), letter_) && permits_first_ &&
      UsualWords::read_short(block.word.data(), to)) {
    for (std::size_t axis = 0; axis < to.size(); ++axis) place(axis, to[axis], offset_[axis]);
  } else {
    std::uint32_t letters = 0;
    if (!words_.read(block, control_.modal.motion(), letters)) return false;
    unsigned named = control_.axes.letters.positions(letters >> 1U);
    if (named == 0) return false;
    for (; named != 0; named &= named - 1) {
      const auto axis = static_cast<std::size_t>(__builtin_ctz(named));
      place(axis, words_[std::size_t{control_.axes.letters.index[axis]} + 1U], offset_[axis]);
    }
    if ((letters & UsualWords::set('F')) != 0) [[unlikely]]
      set_feed();
  }
  move_->line = block.line;
  move_->n = block.n;
  sink_->on(*move_);
  return true;
}

}  // namespace toolcomp::fast
