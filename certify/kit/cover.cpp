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

std::vector<std::size_t> greedy_cover(std::span<const OutcomeSet> sets, OutcomeSet& wanted,
                                      const std::function<bool(std::size_t)>& accepts) {
  std::vector<std::size_t> taken;
  std::vector<bool> open(sets.size(), true);
  while (!wanted.empty()) {
    std::size_t best = sets.size();
    std::size_t most = 0;
    for (std::size_t i = 0; i < sets.size(); ++i) {
      if (!open[i]) continue;
      const std::size_t gain = count_common(sets[i], wanted);
      if (gain == 0) open[i] = false;  // it never gains again
      if (gain <= most) continue;
      most = gain;
      best = i;
    }
    if (best == sets.size()) break;
    open[best] = false;
    if (!accepts(best)) continue;
    taken.push_back(best);
    wanted = without(wanted, sets[best]);
  }
  return taken;
}

}  // namespace toolcomp::certify::kit
