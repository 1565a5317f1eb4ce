// The least that shows the most: a greedy cover.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace toolcomp::certify::kit {

// Outcomes by index, each once, ascending.
using OutcomeSet = std::vector<std::size_t>;

// The members of `set` that are in `wanted`.
std::size_t count_common(const OutcomeSet& set, const OutcomeSet& wanted);
// `from` without `what`.
OutcomeSet without(const OutcomeSet& from, const OutcomeSet& what);
OutcomeSet united(const OutcomeSet& a, const OutcomeSet& b);

// Takes one set after another, always one with the most wanted outcomes that none before it has, of several the first,
// until none brings anything new; the order of the list is the order of preference. `accepts` is asked once about each
// set before it is taken; one that it refuses counts no more. Gives what was taken, in that order; `wanted` keeps what
// no set has.
std::vector<std::size_t> greedy_cover(std::span<const OutcomeSet> sets, OutcomeSet& wanted,
                                      const std::function<bool(std::size_t)>& accepts);

}  // namespace toolcomp::certify::kit
