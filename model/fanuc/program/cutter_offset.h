// SPDX-License-Identifier: Apache-2.0
// The offset that a code and a value ask for, in every compensation that runs beside the path.
#pragma once

#include <cstdint>

#include "model/basis/number.h"
#include "model/basis/recorder.h"

namespace toolcomp::model {

// G40, G41, G42: where the tool runs, seen in the direction of travel.
enum class CutterSide : std::uint8_t { none, left, right };

struct CutterOffset {
  int side = 1;  // 1 left of the path, -1 right
  Rational distance;
  Rational value;  // as the memory has it, with its sign

  [[nodiscard]] Rational left() const { return side * distance; }
};

// Where a side is in force. A value of 0 has the side of a positive one. Clause: fanuc.cutter.side.
CutterOffset offset_of(Recorder& recorder, CutterSide side, const Rational& value);

}  // namespace toolcomp::model
