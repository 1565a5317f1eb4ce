// SPDX-License-Identifier: Apache-2.0
// Decides which target gets the next slice of time, and how long a slice is.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace toolcomp::certify::fuzzing {

// One of N campaigns that share the work: they have the same targets and different seeds.
struct Shard {
  std::uint64_t index = 1;  // from 1
  std::uint64_t count = 1;
};

// The target that has had the least time. If there are several, the first one from `first` on, so that shards begin
// with different targets.
std::size_t next_target(std::span<const std::uint64_t> milliseconds, std::size_t first);

// The seconds of a slice if `left` seconds (std::nullopt: no limit) of `jobs` workers are divided among this number of
// targets. Each target gets its share in as few slices as possible, each of one second to two minutes.
std::uint64_t slice_seconds(std::optional<std::uint64_t> left, std::uint64_t jobs, std::uint64_t targets);

// The seed of a slice: no two slices of a campaign, and no two shards of it, have the same. Fits the 32 bits of
// libFuzzer and is never 0, which would mean a random seed.
std::uint64_t slice_seed(std::uint64_t campaign_seed, const Shard& shard, std::uint64_t slice);

}  // namespace toolcomp::certify::fuzzing
