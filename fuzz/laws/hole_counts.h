// SPDX-License-Identifier: Apache-2.0
// How many holes a block drills: of both dialects.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "fuzz/laws/holding.h"

namespace toolcomp::fuzz::laws {

struct HolesOfBlock {
  std::size_t event = 0;  // one that is near it
  std::uint64_t holes = 0;
  std::uint64_t most = 0;   // by its words
  std::uint64_t least = 0;  // the same, but where the run may have ended before
};

inline void hold_counts(std::span<const HolesOfBlock> blocks, Holding& holding) {
  for (const HolesOfBlock& block : blocks) {
    holding.holds(block.holes <= block.most, block.event, "no more holes than the block says");
    holding.holds(block.holes >= block.least, block.event, "as many holes as the block says");
  }
}

}  // namespace toolcomp::fuzz::laws
