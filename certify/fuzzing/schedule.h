// SPDX-License-Identifier: Apache-2.0
// Which target gets the next slice of time, and how long a slice is.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace toolcomp::certify::fuzzing {

// One campaign of N that share the work: the same targets, other seeds.
struct Shard {
  std::uint64_t index = 1;  // from 1
  std::uint64_t count = 1;
};

// The target that has had the least time; of several the first behind `first`, so that shards begin with different
// ones.
std::size_t next_target(std::span<const std::uint64_t> milliseconds, std::size_t first);

// Seconds of a slice where `left` seconds (none: without end) of `jobs` workers are dealt to so many targets: each
// target gets its share in as few slices of at most two minutes as there may be, of at least one second.
std::uint64_t slice_seconds(std::optional<std::uint64_t> left, std::uint64_t jobs, std::uint64_t targets);

// The seed of a slice: no two slices of a campaign, and no two shards of it, have the same. Fits libFuzzer's 32 bits
// and is never 0, which would mean any.
std::uint64_t slice_seed(std::uint64_t campaign_seed, const Shard& shard, std::uint64_t slice);

}  // namespace toolcomp::certify::fuzzing
