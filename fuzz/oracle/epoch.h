// SPDX-License-Identifier: Apache-2.0
// How long decisions of a streamed run are kept.
#pragma once

#include <cstdint>

namespace toolcomp::fuzz {

// Blocks between two fresh recorders, so that the decisions kept stay bounded.
inline constexpr std::uint64_t kBlocksInEpoch = 256;

}  // namespace toolcomp::fuzz
