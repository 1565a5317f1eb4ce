// SPDX-License-Identifier: Apache-2.0
// Looks for mistakes that explain many findings, if they were made throughout.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "certify/finding.h"

namespace toolcomp::certify {

struct SharedCause {
  std::string words;                  // "axes.X is off by 1e-06"
  std::vector<std::size_t> findings;  // indices of the findings that it explains
  std::uint64_t cases = 0;            // number of cases with one of these findings
};

// A small number of mistakes, each with the findings that it explains completely: with the mistake, the model gives the
// actual events. It tries faults of one kind, one word in place of another, missing events, numbers that are off by a
// constant or a factor or rounded, exchanged axes, positions one block late, and the mistakes of mistakes.h. A finding
// belongs to the first cause that explains the largest number of findings. The result is a hint: another mistake may
// look the same. Findings that no mistake explains are grouped by what differs: "not explained: coordinate of axes".
// `findings` must have their actual events.
std::vector<SharedCause> shared_causes(const std::vector<Finding>& findings);

}  // namespace toolcomp::certify
