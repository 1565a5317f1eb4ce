// SPDX-License-Identifier: Apache-2.0
// The number of holes that a block drills, for both dialects.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "judge/laws/holding.h"

namespace toolcomp::judge::laws {

struct HolesOfBlock {
  std::size_t event = 0;  // an event near the block
  std::uint64_t holes = 0;
  std::uint64_t most = 0;   // largest number, by its words
  std::uint64_t least = 0;  // smallest number, less than `most` if the run may have ended before
};

inline void hold_counts(std::span<const HolesOfBlock> blocks, Holding& holding) {
  for (const HolesOfBlock& block : blocks) {
    holding.holds(block.holes <= block.most, block.event, "no more holes than the block says");
    holding.holds(block.holes >= block.least, block.event, "as many holes as the block says");
  }
}

}  // namespace toolcomp::judge::laws
