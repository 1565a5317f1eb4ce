// SPDX-License-Identifier: Apache-2.0
// The exact path of a run as straight pieces, made as they are asked for.
#pragma once

#include <cstdint>
#include <optional>

#include "certify/trace/space.h"

namespace toolcomp::certify {

// From `begin` to `end`, all axes evenly. Behind a change of coordinates a piece leads from the old name of the
// position to the new one.
struct PathPiece {
  AxisPoint begin{};
  AxisPoint end{};
  // The exact path between begin and end runs within this distance of the piece, in the same order (a bound of their
  // Fréchet distance); both are 0 for what is straight.
  Distance error;
  bool corner = true;   // a move ends here; false: inside a curve
  bool curved = false;  // a chord of a curve
  bool free = false;    // rapid traverse axis by axis: only that each axis stays between its ends is judged
  bool jump = false;    // the same position by another name; no move
  std::uint64_t line = 0;
  std::optional<std::uint64_t> n;
};

// The pieces in their order. A move that moves no recorded axis has none.
class PathSource {
 public:
  virtual ~PathSource() = default;
  // The next piece; false at the end of the path.
  virtual bool next(PathPiece& piece) = 0;
};

}  // namespace toolcomp::certify
