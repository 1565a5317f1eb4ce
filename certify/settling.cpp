// SPDX-License-Identifier: Apache-2.0
#include "certify/settling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include "certify/evidence.h"
#include "certify/program_text.h"
#include "certify/sort_by.h"

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
  sort_by(groups, [](const SharedCause& group) { return -static_cast<std::int64_t>(group.cases); });
  return groups;
}

}  // namespace

Settled settle(std::vector<Sighting> sightings, const SettlingOptions& options) {
  Settled result;
  result.causes = groups_of(sightings);
  const std::size_t groups = result.causes.size();
  const auto end = options.clock() + options.budget;
  const auto why_to_stop = [&] { return options.stop ? options.stop() : std::string(); };
  for (std::size_t g = 0; g < groups; ++g) {
    SharedCause& group = result.causes[g];
    const auto now = options.clock();
    const auto end_of_mine = now + std::max(end - now, decltype(end - now)::zero()) / (groups - g);
    Finding settled = sightings[group.findings.front()].settle([&] {
      if (options.told) options.told({g + 1, groups, group});
      return !why_to_stop().empty() || options.clock() >= end_of_mine;
    });
    settled.occurrences = sightings[group.findings.front()].finding.occurrences;
    if (settled.tried == 0) settled.not_settled = why_to_stop();
    if (settled.tried == 0 && settled.not_settled.empty())
      settled.not_settled = options.budget.count() == 0 ? "not asked for" : "no time was left";
    if (options.settled) options.settled(settled);
    const std::size_t first = result.findings.size();
    result.findings.push_back(settled);
    for (const std::size_t i : std::span(group.findings).subspan(1)) {
      Finding& other = result.findings.emplace_back(std::move(sightings[i].finding));
      other.seen = other.tried = 0;
      other.complete = false;
      other.not_settled = fmt::format("finding {} represents its group", first + 1);
      if (settled.not_settled.empty()) other.before = last_of(other.before, settled.before.size());
    }
    std::iota(group.findings.begin(), group.findings.end(), first);
  }
  return result;
}

}  // namespace toolcomp::certify
