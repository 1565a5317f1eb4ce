// SPDX-License-Identifier: Apache-2.0
// The moves of lines that went together, before they are events.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "fast/arrays/line_chunk.h"
#include "fast/basis/axis_mask.h"
#include "fast/basis/event.h"
#include "spec/language/axes.h"

namespace toolcomp::fast {

// Valid until the engine takes more. They differ in their lines and numbers, in the axes that move, and in the tool.
struct LineMoves {
  Event event;             // of the first move
  bool of_held = false;    // that is the move of the block held before the lines
  bool by_vector = false;  // point is where the axes are sent; otherwise it is the programmed position
  Mask moving = 0;         // axes that are sent somewhere else by each move
  std::size_t size = 0;
  // Of axes that move: where each move sends them.
  std::array<const double*, spec::kMaxAxes> sent{};
  // Of lines, in 10^-6; nullptr: the axis stays where it is programmed.
  std::array<const double*, spec::kMaxAxes> word{};
  std::array<const double*, 3> tool{};  // I J K of lines
  LineChunk chunk;

  // The first one is that of the block held before the lines; vectors say where `axes` are sent.
  void set_held(const Event& held, Mask axes) {
    event = held;
    of_held = by_vector = true;
    moving = axes;
  }
  // The lines before move i; move 0 has none where it is of the block held.
  [[nodiscard]] std::size_t line_of(std::size_t i) const { return i - (of_held ? 1 : 0); }
  [[nodiscard]] bool is_of_held(std::size_t i) const { return i == 0 && of_held; }
  [[nodiscard]] std::uint64_t line(std::size_t i) const { return is_of_held(i) ? event.line : chunk.line + line_of(i); }
  [[nodiscard]] std::optional<std::uint64_t> number(std::size_t i) const {
    return is_of_held(i) ? event.n : chunk.number(line_of(i));
  }
  // The event of move i. Each call writes over the one before, and i must not fall.
  const Event& at(std::size_t i);
};

// From lines as they are read to their moves: a stage of compensation takes the chunk in between.
class LineMaker {
 public:
  explicit LineMaker(const spec::Axes& axes);

  // Valid until the next call.
  [[nodiscard]] LineChunk begin(const spec::LineColumns& lines);
  // The moves of the first `count` lines of the chunk have been made.
  [[nodiscard]] LineMoves& end(const LineChunk& chunk, std::size_t count);

 private:
  const spec::Axes axes_;
  const Instructions instructions_ = best_instructions();
  Moves moves_;
  LineMoves made_;
};

// Takes the moves of lines together.
class LineSink {
 public:
  virtual ~LineSink() = default;
  virtual void lines(LineMoves& moves) = 0;
};

}  // namespace toolcomp::fast
