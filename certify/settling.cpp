// SPDX-License-Identifier: Apache-2.0
#include "certify/settling.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "certify/evidence.h"
#include "certify/program_text.h"

namespace toolcomp::certify {
namespace {

std::pair<std::size_t, std::size_t> size_of(const Finding& f) {
  return {count_blocks(f.smallest.program), f.smallest.program.size()};
}

// The groups of what was seen, the largest first, and in each the finding with the smallest program first.
std::vector<SharedCause> groups_of(const std::vector<Sighting>& sightings) {
  std::vector<Finding> seen;
  seen.reserve(sightings.size());
  for (const Sighting& sighting : sightings) seen.push_back(sighting.finding);
  std::vector<SharedCause> groups = shared_causes(seen);
  for (SharedCause& group : groups) {
    for (const std::size_t i : group.findings) group.cases += seen[i].occurrences;
    const auto smallest = std::ranges::min_element(group.findings, {}, [&](std::size_t i) { return size_of(seen[i]); });
    std::rotate(group.findings.begin(), smallest, smallest + 1);
  }
  std::ranges::stable_sort(groups, std::ranges::greater(), &SharedCause::cases);
  return groups;
}

}  // namespace

Settled settle(std::vector<Sighting> sightings, const SettlingOptions& options) {
  Settled result;
  result.causes = groups_of(sightings);
  const std::size_t groups = result.causes.size();
  const auto end = options.clock() + options.budget;
  for (std::size_t g = 0; g < groups; ++g) {
    SharedCause& group = result.causes[g];
    const auto now = options.clock();
    const auto mine = now + std::max(end - now, decltype(end - now)::zero()) / (groups - g);
    const auto ends = [&] {
      if (options.told) options.told({g + 1, groups, group});
      return (options.stop && !options.stop().empty()) || options.clock() >= mine;
    };
    const std::size_t first = result.findings.size();
    for (const std::size_t i : group.findings) {
      const Finding& seen = sightings[i].finding;
      if (i != group.findings.front()) {
        result.findings.push_back(seen);
        const Finding& settled = result.findings[first];
        Finding& other = result.findings.back();
        other.seen = other.tried = 0;
        other.complete = false;
        other.not_settled = fmt::format("finding {} stands for its group", first + 1);
        if (settled.not_settled.empty()) other.before = last_of(other.before, settled.before.size());
        continue;
      }
      Finding settled = sightings[i].settle(ends);
      settled.occurrences = seen.occurrences;
      if (settled.tried == 0) {
        const std::string why = options.stop ? options.stop() : std::string();
        settled.not_settled = !why.empty() ? why : options.budget.count() == 0 ? "not asked for" : "no time was left";
      }
      if (options.settled) options.settled(settled);
      result.findings.push_back(std::move(settled));
    }
    std::iota(group.findings.begin(), group.findings.end(), first);
  }
  return result;
}

}  // namespace toolcomp::certify
