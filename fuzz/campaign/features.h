// SPDX-License-Identifier: Apache-2.0
// What a run of the model reached, as small numbers: clause × outcome × margin bin.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/basis/recorder.h"

namespace toolcomp::fuzz {

// Counters of one clause: reached, true or positive, false or negative, tie; then the margins of positive and of
// negative decisions in bins of 2^-8 down to 2^-56 and below.
inline constexpr std::size_t kMarginBins = 8;
inline constexpr std::size_t kOutcomeSlots = 4;
inline constexpr std::size_t kClauseSlots = kOutcomeSlots + 2 * kMarginBins;
inline constexpr std::size_t kFeatures = kClauseSlots * spec::kClauseCount;

// 0 for margins over 2^-8, …, 7 for those below 2^-56.
std::size_t margin_bin(double margin);

struct FeatureCount {
  std::uint32_t feature = 0;
  std::uint64_t count = 0;
};

// The features of a run with how often each was reached; that of a margin once for each decision.
std::vector<FeatureCount> counted_features(const model::Recorder& recorder);
// The features of a run, each once.
std::vector<std::uint32_t> features(const model::Recorder& recorder);

}  // namespace toolcomp::fuzz
