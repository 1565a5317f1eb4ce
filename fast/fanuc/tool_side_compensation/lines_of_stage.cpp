// SPDX-License-Identifier: Apache-2.0
// Usual lines of tool side compensation as arrays: from the words of the blocks to what the stage holds.
#include <algorithm>
#include <cmath>

#include "fast/arrays/line_moves.h"
#include "fast/fanuc/control/read_words.h"
#include "fast/fanuc/program/words.h"
#include "fast/fanuc/tool_side_compensation/side_line_arrays.h"
#include "fast/fanuc/tool_side_compensation/tool_side_stage.h"

namespace toolcomp::fast {
namespace {

constexpr std::uint32_t kXyz = Words::set_of("XYZ");
constexpr std::uint32_t kIjk = Words::set_of("IJK");
constexpr Mask kXyzAxes = 0b111;

std::array<std::int64_t, 3> whole_words(const LineChunk& chunk, std::string_view letters, std::size_t i) {
  const auto word = [&](std::size_t k) { return static_cast<std::int64_t>(chunk.word(word_place(letters[k]))[i]); };
  return {word(0), word(1), word(2)};
}

// Up to the first line whose I J K are all 0.
std::size_t directed_lines(const LineChunk& chunk) {
  if ((chunk.words & kIjk) == 0) return chunk.size;
  for (std::size_t i = 0; i < chunk.size; ++i)
    if (whole_words(chunk, "IJK", i) == std::array<std::int64_t, 3>{}) return i;
  return chunk.size;
}

}  // namespace

// X Y Z are the first three axes, no other is linear, and they are sent to the programmed position.
bool ToolSideStage::may_be_lines(const LineChunk& chunk, Vector3<double>& at) const {
  constexpr double kMostPosition = 0x1p52;
  const AxisPositions& positions = control_.positions;
  const ToolAttitude& attitude = control_.attitude;
  const std::uint32_t ijk = chunk.words & kIjk;
  const bool along = positions.along_tool();
  if ((chunk.words & ~(kXyz | kIjk)) != 0 || (ijk != 0 && (ijk != kIjk || !along || !control_.modal.by_vector())) ||
      !control_.axes.letters.xyz_first || control_.axes.linear != kXyzAxes || positions.length().live() != 0 ||
      attitude.tip().active() ||
      (along && (attitude.tip().samples() || positions.displaced() != 0 || attitude.along_length() != 0)))
    return false;
  std::array<double, 3> xyz{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Count& position = positions.programmed()[i];
    xyz[i] = static_cast<double>(position.small());
    if (!position.is_small() || std::abs(xyz[i]) > kMostPosition) return false;
  }
  at = {xyz[0], xyz[1], xyz[2]};
  return true;
}

std::size_t ToolSideStage::lines(const LineChunk& chunk) {
  Vector3<double> at;
  if (!may_be_lines(chunk, at) || !compensation_.awaits_lines()) return 0;
  const std::size_t size = directed_lines(chunk);
  if (size == 0) return 0;
  SideLineStart start = compensation_.lines_start();
  start.at = at;
  const SideLineEnd end = take_side_lines(chunk.part(0, size), start);
  if (end.taken == 0) return 0;
  // The event that is held has what is the same for all of them.
  const Event& held = compensation_.held_event();
  if (chunk.made != nullptr) chunk.made->set_held(held, kXyzAxes);
  Moves& moves = *chunk.moves;
  for (std::size_t axis = 3; axis < moves.axes(); ++axis) moves.set_axis(axis, end.taken, held.axes.value[axis]);
  *moves.next_block() = held.line;
  moves.append(1);
  moves.append_lines(end.taken - 1, chunk.line);
  hold_last(chunk, end, at);
  return end.taken;
}

void ToolSideStage::hold_last(const LineChunk& chunk, const SideLineEnd& end, const Vector3<double>& at) {
  const std::size_t last = end.taken - 1;
  const auto line_end = [&](std::size_t i) {
    const auto word = [&](char letter, double stays) {
      const double* const words = chunk.word(word_place(letter));
      return words == nullptr ? stays : words[i];
    };
    return Vector3<double>{word('X', at.x), word('Y', at.y), word('Z', at.z)};
  };
  ToolDirections& directions = control_.attitude.directions();
  const auto turn_tool = [&](std::size_t i) {
    if ((chunk.words & kIjk) == 0) return;
    const std::array<std::int64_t, 3> ijk = whole_words(chunk, "IJK", i);
    set_small_direction(directions.next(), ijk[0], ijk[1], ijk[2]);
  };
  const Vector3<double> to = line_end(last);
  const Vector3<double> from = last == 0 ? at : line_end(last - 1);
  ToolSideCompensation::TakenLine before_last{compensation_.held_path().travel.value, *compensation_.held_path().tool};
  if (last > 0) {
    turn_tool(last - 1);
    before_last = {from - (last == 1 ? at : line_end(last - 2)), directions.now()};
  }
  turn_tool(last);
  compensation_.hold_last(before_last, {to - from, directions.now()}, end.vector);
  for (std::size_t i = 0; i < 3; ++i) control_.positions.place_small(i, static_cast<std::int64_t>(to[i]));
  control_.line = chunk.line + last;
  control_.n = chunk.number(last);
  control_.fill(compensation_.held_event(), control_.modal.straight(), spec::Cause::programmed);
}

}  // namespace toolcomp::fast
