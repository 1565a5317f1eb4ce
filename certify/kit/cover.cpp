// SPDX-License-Identifier: Apache-2.0
#include "certify/kit/cover.h"

#include <algorithm>
#include <iterator>

namespace toolcomp::certify::kit {

std::size_t count_common(const OutcomeSet& set, const OutcomeSet& wanted) {
  return static_cast<std::size_t>(
      std::ranges::count_if(set, [&](std::size_t outcome) { return std::ranges::binary_search(wanted, outcome); }));
}

OutcomeSet without(const OutcomeSet& from, const OutcomeSet& what) {
  OutcomeSet rest;
  std::ranges::set_difference(from, what, std::back_inserter(rest));
  return rest;
}

OutcomeSet united(const OutcomeSet& a, const OutcomeSet& b) {
  OutcomeSet both;
  std::ranges::set_union(a, b, std::back_inserter(both));
  return both;
}

OutcomeSet common(const OutcomeSet& a, const OutcomeSet& b) {
  OutcomeSet both;
  std::ranges::set_intersection(a, b, std::back_inserter(both));
  return both;
}

std::vector<std::size_t> greedy_cover(std::vector<OutcomeSet> sets, OutcomeSet& wanted,
                                      const std::function<OutcomeSet(std::size_t, const OutcomeSet&)>& prove,
                                      const std::function<bool(std::size_t)>& take) {
  std::vector<std::size_t> taken;
  while (!wanted.empty()) {
    std::size_t best = sets.size();
    std::size_t most = 0;
    for (std::size_t i = 0; i < sets.size(); ++i) {
      const std::size_t gain = count_common(sets[i], wanted);
      if (gain <= most) continue;
      most = gain;
      best = i;
    }
    if (best == sets.size()) break;
    OutcomeSet proven = prove(best, common(sets[best], wanted));
    if (proven.size() < most) {
      sets[best] = std::move(proven);
      continue;
    }
    sets[best].clear();
    if (!take(best)) continue;
    taken.push_back(best);
    wanted = without(wanted, proven);
  }
  return taken;
}

}  // namespace toolcomp::certify::kit
