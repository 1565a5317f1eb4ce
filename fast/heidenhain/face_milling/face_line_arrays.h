// SPDX-License-Identifier: Apache-2.0
// LN blocks with a surface normal by arrays: what face_milling.h does with one, for many at once.
#pragma once

#include <array>
#include <cstddef>

#include "fast/arrays/line_chunk.h"
#include "fast/heidenhain/program/effective_tool.h"
#include "fast/heidenhain/program/vector.h"

namespace toolcomp::fast::klartext {

// The contact of the block before, and what stays the same.
struct FaceLineStart {
  bool flat = false;
  Vector u{0, 0, 0};
  Vector tool{0, 0, 1};        // unit, where the blocks have no tool vector
  Vector whole_tool{0, 0, 0};  // the same as whole numbers of 10^-8
  bool along = false;          // without a tool vector: the tool stands along the normal
  bool contour = false;
  double tip_below = 0;
  const ToolValues* values = nullptr;
};

struct FaceLineEnd {
  std::size_t taken = 0;  // so many blocks
  // Of the last one.
  bool flat = false;
  Vector u{0, 0, 0};
};

// Takes blocks of X Y Z, NX NY NZ and perhaps TX TY TZ until one is not usual: a vector that is not normalized, a
// normal that points below, a jump of the contact. Their moves go to `axes`.
FaceLineEnd take_face_lines(const LineChunk& chunk, const FaceLineStart& start, const std::array<std::size_t, 3>& axes);

}  // namespace toolcomp::fast::klartext
