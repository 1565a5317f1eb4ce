// SPDX-License-Identifier: Apache-2.0
// Lines as arrays. Where no stage is on, the axes go to their words, with their offsets.
#include <cstdlib>

#include "fast/arrays/line_moves.h"
#include "fast/arrays/position_arrays.h"
#include "fast/fanuc/control/read_words.h"
#include "fast/fanuc/interpreter/interpreter.h"

namespace toolcomp::fast {

std::size_t Interpreter::lines(const LineChunk& chunk) {
  if (control_.stopped || cycle_.on() || !control_.awaits_lines()) return 0;
  return on_ != nullptr && on_->on() ? on_->lines(chunk) : uncompensated_lines(chunk);
}

Mask Interpreter::axes_of(const LineChunk& chunk) const {
  // The sum of a word and such an offset is whole.
  constexpr std::int64_t kMostOffset = std::int64_t{1} << 50U;
  Mask axes = 0;
  std::uint32_t rest = chunk.words;
  for (std::size_t axis = 0; axis < control_.axes.count; ++axis) {
    const std::uint32_t word = place_bit(word_place(control_.axes.names.letter(axis)));
    if ((rest & word) == 0) continue;
    rest &= ~word;
    const Count& offset = control_.positions.length()[axis];
    if (!offset.is_small() || std::abs(offset.small()) > kMostOffset) return 0;
    axes = static_cast<Mask>(axes | bit(axis));
  }
  return rest == 0 ? axes : Mask{0};
}

std::size_t Interpreter::uncompensated_lines(const LineChunk& chunk) {
  AxisPositions& positions = control_.positions;
  const bool through_tip = positions.along_tool() || control_.attitude.completes_moves();
  const Mask axes = through_tip ? Mask{0} : axes_of(chunk);
  if (axes == 0) return 0;
  if (chunk.made != nullptr) {
    // Rotary words turn the tool that events show.
    if ((axes & control_.axes.turning) != 0 && control_.kinematics.defined()) return 0;
    control_.fill(chunk.made->event, control_.modal.straight(), spec::Cause::programmed);
    chunk.made->of_held = chunk.made->by_vector = false;
    chunk.made->moving = axes;
  }
  Moves& moves = *chunk.moves;
  for (std::size_t axis = 0; axis < control_.axes.count; ++axis) {
    if ((axes & bit(axis)) == 0) {
      moves.set_axis(axis, chunk.size, positions.sent_to(axis));
      continue;
    }
    const double* const word = chunk.word(word_place(control_.axes.names.letter(axis)));
    const bool offset = (positions.length().live() & bit(axis)) != 0;
    write_positions(chunk.instructions, word, offset ? static_cast<double>(positions.length()[axis].small()) : 0.0,
                    moves.next_of(axis), chunk.size);
    positions.place_small(axis, static_cast<std::int64_t>(word[chunk.size - 1]));
    if (offset) positions.add_offset(axis);
  }
  moves.append_lines(chunk.size, chunk.line);
  if ((axes & control_.axes.turning) != 0) control_.attitude.turn();
  return chunk.size;
}

}  // namespace toolcomp::fast
