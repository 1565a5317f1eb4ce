// SPDX-License-Identifier: Apache-2.0
#include "fuzz/campaign/features.h"

#include <algorithm>
#include <cmath>

#include "judge/oracle/verdict.h"

namespace toolcomp::fuzz {

std::size_t margin_bin(double margin) {
  constexpr int bits_per_bin = 8;
  const int exponent = margin > 0 ? -std::ilogb(margin) : bits_per_bin * static_cast<int>(kMarginBins);
  return std::min(static_cast<std::size_t>(std::max(exponent, 0) / bits_per_bin), kMarginBins - 1);
}

std::vector<FeatureCount> counted_features(const model::Recorder& recorder) {
  std::vector<FeatureCount> result;
  const auto take = [&](std::size_t feature, std::uint64_t count) {
    result.push_back({static_cast<std::uint32_t>(feature), count});
  };
  const auto& counts = recorder.counts();
  for (std::size_t clause = 0; clause < counts.size(); ++clause) {
    const std::uint64_t slots[kOutcomeSlots] = {counts[clause].reached, counts[clause].positive,
                                                counts[clause].negative, counts[clause].tie};
    for (std::size_t i = 0; i < kOutcomeSlots; ++i)
      if (slots[i] != 0) take(clause * kClauseSlots + i, slots[i]);
  }
  for (const model::Decision& d : recorder.decisions()) {
    const double m = judge::margin(d);
    if (m == 0) continue;  // a tie, counted above
    const std::size_t side = d.outcome == exact::Sign::positive ? 0 : kMarginBins;
    take(static_cast<std::size_t>(d.clause) * kClauseSlots + kOutcomeSlots + side + margin_bin(m), 1);
  }
  return result;
}

std::vector<std::uint32_t> features(const model::Recorder& recorder) {
  std::vector<std::uint32_t> result;
  for (const FeatureCount& reached : counted_features(recorder)) result.push_back(reached.feature);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace toolcomp::fuzz
