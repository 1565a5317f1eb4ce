// SPDX-License-Identifier: Apache-2.0
// The exact path of a run as straight pieces, which are made on request.
#pragma once

#include <cstdint>
#include <optional>

#include "certify/trace/space.h"

namespace toolcomp::certify {

// A piece from `begin` to `end`, on which all axes move evenly. At a change of coordinates a piece leads from the old
// coordinates of the position to the new ones.
struct PathPiece {
  AxisPoint begin{};
  AxisPoint end{};
  // The exact path between begin and end runs within this distance of the piece, in the same order (a bound of their
  // Fréchet distance); both are 0 for straight moves.
  Distance error;
  bool corner = true;   // a move ends here; false: inside a curve
  bool curved = false;  // a chord of a curve
  bool free = false;    // rapid traverse axis by axis: it is only judged whether each axis stays between its ends
  bool jump = false;    // the same position in other coordinates; not a move
  std::uint64_t line = 0;
  std::optional<std::uint64_t> n;
};

// Gives the pieces in order. A move without motion of a recorded axis has no piece.
class PathSource {
 public:
  virtual ~PathSource() = default;
  // The next piece; false at the end of the path.
  virtual bool next(PathPiece& piece) = 0;
};

}  // namespace toolcomp::certify
