// SPDX-License-Identifier: Apache-2.0
// Usual lines of tool side compensation by arrays.
#pragma once

#include <array>
#include <cstddef>

#include "fast/arrays/line_chunk.h"
#include "fast/geometry/vector3.h"

namespace toolcomp::fast {

// The line that is held, and what stays the same.
struct SideLineStart {
  Vector3<double> at;      // its end, 10^-6
  Vector3<double> travel;  // 10^-6
  double square = 0;       // |travel|^2
  Vector3<double> tool;    // at its end, unit
  Vector3<double> vector;  // at its start
  double radius = 0;       // positive to the left
  double shortest = 0;     // longer travels move for certain, 10^-6
};

// Where the usual lines end.
struct SideLineEnd {
  std::size_t taken = 0;   // so many lines
  Vector3<double> vector;  // at the start of the last of them
};

// Takes lines of X Y Z and, in `chunk`, perhaps I J K, until one is not usual. The moves of the line that is held and
// of those taken, but for the last one, go to the first three axes.
SideLineEnd take_side_lines(const LineChunk& chunk, const SideLineStart& start);

}  // namespace toolcomp::fast
