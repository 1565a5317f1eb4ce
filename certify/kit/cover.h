// SPDX-License-Identifier: Apache-2.0
// A greedy cover: few sets that together contain as many outcomes as possible.
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

// Takes one set after another: always one with the largest number of wanted outcomes that no set before it has, the
// first one if there are several, until no set adds anything. The order of the list is the order of preference. A set
// is only a claim. Before it is taken, `prove` gets its index and the outcomes that it would add, and returns those
// that are true. If these are fewer, the set stays in the list with them. Returns the sets taken, in order. `wanted`
// keeps the outcomes that no set has. `take` may still refuse a set.
std::vector<std::size_t> greedy_cover(std::vector<OutcomeSet> sets, OutcomeSet& wanted,
                                      const std::function<OutcomeSet(std::size_t, const OutcomeSet&)>& prove,
                                      const std::function<bool(std::size_t)>& take);

}  // namespace toolcomp::certify::kit
