// What one block means to cutter compensation C: on which side the tool runs, how far away, and along which path.
#pragma once

#include "model/geometry/offset_path.h"
#include "model/program/step.h"
#include "model/recorder.h"

namespace toolcomp::model {

// The offset that a block asks for.
struct CutterOffset {
  int side = 1;  // 1 left of the path, -1 right
  Rational distance;
  Rational value;  // as the memory has it, with its sign

  [[nodiscard]] Rational left() const { return side * distance; }
};

// Of a block in which G41 or G42 is in force. A value of 0 has the side of a positive one. Clause: fanuc.cutter.side.
CutterOffset offset_of(Recorder& recorder, const CutterBlock& block);

// The path of a moving block: at its start with the distance in force before it, each on the block's own side.
OffsetPath path_of(const CutterBlock& block, const CutterOffset& own, const Rational& distance_before);

}  // namespace toolcomp::model
