// SPDX-License-Identifier: Apache-2.0
#include "spec/coverage/coverage.h"

#include <algorithm>

#include "spec/coverage/trace.h"

namespace toolcomp::spec {
namespace {

// Is `name` one of the items of `list`?
bool contains_line(std::string_view list, std::string_view name) {
  const std::vector<std::string_view> all = items(list);
  return std::ranges::find(all, name) != all.end();
}

}  // namespace

std::vector<ClauseOutcome> required_outcomes(std::span<const OutcomeCounts> counts) {
  std::vector<ClauseOutcome> outcomes;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const auto clause = static_cast<Clause>(i);
    const ClauseInfo& about = info(clause);
    if (!needs_mark(about)) continue;
    const auto add = [&](std::string_view name, std::string_view text, std::uint64_t count) {
      if (!contains_line(about.unreachable, name)) outcomes.push_back({clause, name, text, count});
    };
    switch (about.outcomes) {
      case ClauseOutcomes::sign:
        add("positive", about.positive, counts[i].positive);
        add("negative", about.negative, counts[i].negative);
        add("tie", about.tie, counts[i].tie);
        break;
      case ClauseOutcomes::fact:
        add("true", about.positive, counts[i].positive);
        add("false", about.negative, counts[i].negative);
        break;
      case ClauseOutcomes::reach:
        add("reached", "", counts[i].reached);
        break;
    }
  }
  return outcomes;
}

std::vector<ClauseOutcome> missing_outcomes(std::span<const OutcomeCounts> counts) {
  std::vector<ClauseOutcome> outcomes = required_outcomes(counts);
  std::erase_if(outcomes, [](const ClauseOutcome& outcome) { return outcome.count != 0; });
  return outcomes;
}

}  // namespace toolcomp::spec
