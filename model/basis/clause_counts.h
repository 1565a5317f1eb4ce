// SPDX-License-Identifier: Apache-2.0
// Sums of the clause counts of several runs.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/basis/recorder.h"

namespace toolcomp::model {

// Adds one run. Both lists have all clauses.
inline void add(std::vector<ClauseCount>& sum, std::span<const ClauseCount> counts) {
  for (std::size_t i = 0; i < sum.size(); ++i) {
    sum[i].reached += counts[i].reached;
    sum[i].positive += counts[i].positive;
    sum[i].negative += counts[i].negative;
    sum[i].tie += counts[i].tie;
  }
}

}  // namespace toolcomp::model
