// SPDX-License-Identifier: Apache-2.0
// What the words of a block say to the canned cycles.
#pragma once

#include <cstddef>
#include <cstdint>

#include "fast/basis/axis_mask.h"
#include "fast/fanuc/program/words.h"
#include "spec/language/axes.h"

namespace toolcomp::fast {

// What a block is to the canned cycles, by its words and the state before it.
struct CycleCommand {
  static constexpr std::uint32_t kMostRepeats = 9999;

  Code cycle = kNone;       // the one in force after the block; kNone: no drilling mode
  bool begins = false;      // the drilling mode does, with this block
  bool to_point_r = false;  // G99 is in force after the block
  // The rest of a block in the drilling mode.
  std::size_t axis = spec::Axes::kNone;  // the drilling axis; spec::Axes::kNone: the machine does not have it
  bool drills = false;                   // clause fanuc.canned-cycle.drills; of a block with K0 too
  Mask named = 0;                        // the axes whose words are the hole's, the drilling axis among them
  std::uint32_t repeats = 1;             // holes of a block that drills; above kMostRepeats: no number of holes

  [[nodiscard]] bool on() const { return cycle != kNone; }
  [[nodiscard]] bool makes_holes() const { return drills && repeats != 0; }
};

}  // namespace toolcomp::fast
