// SPDX-License-Identifier: Apache-2.0
// Moves of lines as the text of a plain program, many at once.
#pragma once

#include <array>
#include <cstddef>

#include "fast/arrays/line_moves.h"
#include "fast/basis/print.h"
#include "spec/language/axes.h"
#include "spec/language/event_gcode.h"
#include "spec/language/text_buffer.h"

namespace toolcomp::fast {

class LineText {
 public:
  // `axes` must outlive it.
  explicit LineText(const spec::Axes& axes) : axes_(axes) {}

  // Appends what spec::append_event_gcode() writes of the events of these moves, with numbers as write_number() writes
  // them, and leaves the state that it leaves.
  void append(spec::TextBuffer& out, LineMoves& moves, spec::GcodeState<double>& state);

 private:
  // Long enough for the numbers of all axes and the feed.
  struct Text {
    std::array<char, (spec::kMaxAxes + 1) * (kNumberText + 2) + 4> bytes;
    char* end = nullptr;

    void begin() { end = bytes.data(); }
    void add(char c) { *end++ = c; }
    void add(double value) { end = write_number(end, value); }
    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(end - bytes.data()); }
  };
  struct Column {
    const double* value = nullptr;
    Text after;  // its number
  };
  // What all lines have, around the numbers of the axes that move.
  void set_texts(const LineMoves& moves);
  [[nodiscard]] std::size_t longest_line() const;
  [[nodiscard]] static char* write(char* to, const Text& text);
  char* write(char* to, const LineMoves& moves) const;

  const spec::Axes& axes_;
  Text head_;
  std::array<Column, spec::kMaxAxes> column_;
  std::size_t columns_ = 0;
};

}  // namespace toolcomp::fast
