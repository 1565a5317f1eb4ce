// SPDX-License-Identifier: Apache-2.0
// What many findings have in common: the mistake that, made all along, explains them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "certify/finding.h"

namespace toolcomp::certify {

struct SharedCause {
  std::string words;                  // "axes.X is off by 1e-06"
  std::vector<std::size_t> findings;  // which it explains, by index
  std::uint64_t cases = 0;            // with one of them
};

// The mistakes, as few as will do, each with the findings that it explains whole: with it the model's events are those
// that came. Tried are faults of one kind, one word in place of another, events left out, numbers off by a constant or
// a factor, rounded, axes exchanged, a block late, and the mistakes of mistakes.h. A finding stands with the first
// cause that explains most. What is named is a hint: another mistake may look the
// same. What nothing explains stands together by what differs: "not explained: coordinate of axes". `findings` have the
// events as they were seen.
std::vector<SharedCause> shared_causes(const std::vector<Finding>& findings);

}  // namespace toolcomp::certify
