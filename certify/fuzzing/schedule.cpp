// SPDX-License-Identifier: Apache-2.0
#include "certify/fuzzing/schedule.h"

#include <algorithm>

namespace toolcomp::certify::fuzzing {

std::size_t next_target(std::span<const std::uint64_t> milliseconds, std::size_t first) {
  std::size_t best = first % milliseconds.size();
  for (std::size_t i = 1; i < milliseconds.size(); ++i) {
    const std::size_t at = (first + i) % milliseconds.size();
    if (milliseconds[at] < milliseconds[best]) best = at;
  }
  return best;
}

std::uint64_t slice_seconds(std::optional<std::uint64_t> left, std::uint64_t jobs, std::uint64_t targets) {
  constexpr std::uint64_t kLongest = 120;
  if (!left) return kLongest;
  const std::uint64_t share = *left * jobs / targets;
  if (share == 0) return 1;
  return share / ((share + kLongest - 1) / kLongest);
}

std::uint64_t slice_seed(std::uint64_t campaign_seed, const Shard& shard, std::uint64_t slice) {
  constexpr std::uint64_t kSeeds = (std::uint64_t{1} << 32U) - 1;
  constexpr std::uint64_t kStride = 1'000'003;
  const std::uint64_t number = (slice - 1) * shard.count + shard.index - 1;
  return 1 + (campaign_seed % kSeeds * kStride + number) % kSeeds;
}

}  // namespace toolcomp::certify::fuzzing
