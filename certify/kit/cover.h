// SPDX-License-Identifier: Apache-2.0
// The least that shows the most: a greedy cover.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace toolcomp::certify::kit {

// Outcomes by index, each once, ascending.
using OutcomeSet = std::vector<std::size_t>;

// The members of `set` that are in `wanted`.
std::size_t count_common(const OutcomeSet& set, const OutcomeSet& wanted);
// `from` without `what`.
OutcomeSet without(const OutcomeSet& from, const OutcomeSet& what);
OutcomeSet common(const OutcomeSet& a, const OutcomeSet& b);
OutcomeSet united(const OutcomeSet& a, const OutcomeSet& b);

// Takes one set after another, always one with the most wanted outcomes that none before it has, of several the first,
// until none brings anything new; the order of the list is the order of preference. A set is a claim: before it is
// taken, `prove` is given its index and what it would bring, and says what of that is true. Where that is less, the set
// waits with the rest until its turn comes again. Gives what was taken, in that order; `wanted` keeps what no set has.
// `take` may still refuse it.
std::vector<std::size_t> greedy_cover(std::vector<OutcomeSet> sets, OutcomeSet& wanted,
                                      const std::function<OutcomeSet(std::size_t, const OutcomeSet&)>& prove,
                                      const std::function<bool(std::size_t)>& take);

}  // namespace toolcomp::certify::kit
