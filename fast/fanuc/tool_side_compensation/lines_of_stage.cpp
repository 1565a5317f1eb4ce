// SPDX-License-Identifier: Apache-2.0
// Usual lines of tool side compensation as arrays: from the words of the blocks to the stage.

#include "fast/fanuc/program/words.h"
#include "fast/fanuc/tool_side_compensation/side_line_arrays.h"
#include "fast/fanuc/tool_side_compensation/tool_side_stage.h"

namespace toolcomp::fast {
namespace {

constexpr std::uint32_t kXyz = Words::set_of("XYZ");
constexpr std::uint32_t kIjk = Words::set_of("IJK");

}  // namespace

bool ToolSideStage::may_be_lines(const LineChunk& chunk) const {
  const std::uint32_t ijk = chunk.words & kIjk;
  return lines_.permits(chunk.words << 1U) && (chunk.words & ~(kXyz | kIjk)) == 0 && (ijk == 0 || ijk == kIjk) &&
         !control_.modal.incremental();
}

std::size_t ToolSideStage::lines(const LineChunk& chunk) {
  if (!may_be_lines(chunk) || !compensation_.holds_plain_line()) return 0;
  SideLineStart start = compensation_.lines_start();
  start.at = lines_.at();
  const SideLineEnd end = take_side_lines(chunk, start);
  if (end.taken == 0) return 0;
  // The event that is held has what is the same for all of them.
  const Event& held = compensation_.held_event();
  Moves& moves = *chunk.moves;
  for (std::size_t axis = 3; axis < moves.axes(); ++axis) moves.set_axis(axis, end.taken, held.axes.value[axis]);
  *moves.next_block() = held.line;
  moves.append(1);
  moves.append_lines(end.taken - 1, chunk.line);

  // The end of the last line but one, and of the one before it.
  const std::size_t last = end.taken - 1;
  const Vector3<double> from = last == 0 ? lines_.at() : line_end(chunk, last - 1);
  if (last == 0) {
    turn_tool(chunk, last);
    finish_lines(chunk, end, from, nullptr);
    return end.taken;
  }
  turn_tool(chunk, last - 1);
  const Vector3<double> before = last == 1 ? lines_.at() : line_end(chunk, last - 2);
  const ToolSideCompensation::TakenLine before_last{from - before, control_.attitude.directions().now()};
  turn_tool(chunk, last);
  finish_lines(chunk, end, from, &before_last);
  return end.taken;
}

Vector3<double> ToolSideStage::line_end(const LineChunk& chunk, std::size_t i) const {
  const auto word = [&](char letter, double stays) {
    const double* const words = chunk.word(word_place(letter));
    return words == nullptr ? stays : words[i];
  };
  return {word('X', lines_.at().x), word('Y', lines_.at().y), word('Z', lines_.at().z)};
}

void ToolSideStage::turn_tool(const LineChunk& chunk, std::size_t i) {
  if ((chunk.words & kIjk) == 0) return;
  const auto word = [&](char letter) { return static_cast<std::int64_t>(chunk.word(word_place(letter))[i]); };
  set_small_direction(control_.attitude.directions().next(), word('I'), word('J'), word('K'));
}

void ToolSideStage::finish_lines(const LineChunk& chunk, const SideLineEnd& end, const Vector3<double>& from,
                                 const ToolSideCompensation::TakenLine* before_last) {
  const std::size_t last = end.taken - 1;
  const Vector3<double> at = line_end(chunk, last);
  fill_last_line(chunk.line + last, at);
  compensation_.set_lines(before_last, {at - from, control_.attitude.directions().now()}, end.vector);
  lines_.set_at(at);
}

}  // namespace toolcomp::fast
