// SPDX-License-Identifier: Apache-2.0
// The places where blocks of a FANUC program end, with the vectors there.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "judge/laws/certainty.h"
#include "judge/laws/fanuc/fanuc_program.h"
#include "model/basis/event.h"

namespace toolcomp::judge::laws {

// A vector from the programmed point to the compensated one, and the event that makes it.
struct Head {
  Vector vector;
  std::size_t event = 0;
};

// The end of one own move of a block, and the corner moves made there.
struct Stop {
  const model::Event* own = nullptr;
  std::size_t event = 0;  // index of own
  std::size_t block = 0;  // index in the program
  Vector programmed;
  // From the stop before, in the same coordinates; nothing where there is none, or coordinates were renamed or holes
  // drilled between.
  std::optional<Vector> displacement;
  std::vector<Head> heads;  // of own, then of corner moves, in order
};

// Moves whose points are not all three linear axes, or whose line is no block, end the list. Holes are no stops.
std::vector<Stop> stops_of(const spec::Axes& axes, const FanucProgram& program, std::span<const model::Event> events);

}  // namespace toolcomp::judge::laws
