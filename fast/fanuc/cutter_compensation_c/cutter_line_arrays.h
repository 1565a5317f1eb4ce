// SPDX-License-Identifier: Apache-2.0
// Usual lines of cutter compensation C by arrays.
#pragma once

#include <array>
#include <cstddef>

#include "fast/arithmetic/trigonometry.h"
#include "fast/arrays/line_chunk.h"

namespace toolcomp::fast {

// A line in the plane.
struct ArrayLine {
  DoublePair way{};  // 10^-6
  DoublePair unit{};
  double norm = 0;  // |way|
};

// The line that is held, and what stays the same.
struct CutterLineStart {
  DoublePair at{};  // its end, 10^-6
  ArrayLine line;
  DoublePair vector{};  // at its start
  double offset = 0;    // positive to the left
  // Of the words of a chunk and of the axes of the moves.
  std::array<std::size_t, 2> word{}, axis{};
};

// Where the usual lines end.
struct CutterLineEnd {
  std::size_t taken = 0;  // so many lines
  ArrayLine last;
  DoublePair before{};  // the way of the line before it
  DoublePair vector{};  // at its start
};

// Takes lines until one is not usual, or its corner is acute. The moves of the line that is held and of those taken,
// but for the last one, go to the axes of the plane.
CutterLineEnd take_cutter_lines(const LineChunk& chunk, const CutterLineStart& start);

}  // namespace toolcomp::fast
