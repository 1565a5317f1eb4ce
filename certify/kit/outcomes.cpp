// SPDX-License-Identifier: Apache-2.0
#include "certify/kit/outcomes.h"

#include <algorithm>

#include "fuzz/gen/generator.h"
#include "spec/clauses/clauses.h"

namespace toolcomp::certify::kit {
namespace {

std::vector<spec::OutcomeCounts> counts_of(const model::Recorder& run) {
  std::vector<spec::OutcomeCounts> counts;
  counts.reserve(run.counts().size());
  for (const model::ClauseCount& count : run.counts())
    counts.push_back({count.reached, count.positive, count.negative, count.tie});
  return counts;
}

}  // namespace

Outcomes::Outcomes() : all_(spec::required_outcomes(std::vector<spec::OutcomeCounts>(spec::kClauseCount))) {}

std::string Outcomes::name(std::size_t outcome) const {
  return std::string(spec::info(all_[outcome].clause).id) + "=" + std::string(all_[outcome].name);
}

std::optional<exact::Sign> Outcomes::sign(std::size_t outcome) const {
  const std::string_view name = all_[outcome].name;
  if (name == "positive") return exact::Sign::positive;
  if (name == "negative") return exact::Sign::negative;
  if (name == "tie") return exact::Sign::zero;
  return std::nullopt;
}

OutcomeSet Outcomes::of_sections(const std::vector<std::string>& sections, std::string_view dialect) const {
  OutcomeSet set;
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const std::string_view section = spec::info(all_[i].clause).section;
    if (!section.starts_with(std::string(dialect) + "/")) continue;
    const bool has_vectors = std::ranges::find(fuzz::sections(), section) != fuzz::sections().end();
    const bool wanted = sections.empty() || std::ranges::find(sections, section) != sections.end();
    if (wanted || !has_vectors) set.push_back(i);
  }
  return set;
}

OutcomeSet Outcomes::reached(const model::Recorder& run, const model::Recorder* frame) const {
  const std::vector<spec::ClauseOutcome> mine = spec::required_outcomes(counts_of(run));
  const std::vector<spec::ClauseOutcome> other =
      frame != nullptr ? spec::required_outcomes(counts_of(*frame)) : std::vector<spec::ClauseOutcome>();
  OutcomeSet set;
  for (std::size_t i = 0; i < mine.size(); ++i)
    if (mine[i].count > (other.empty() ? 0 : other[i].count)) set.push_back(i);
  return set;
}

OutcomeSet Outcomes::shown_by_alarm(const model::Recorder& run, const spec::ClauseList& clauses) const {
  OutcomeSet shown;
  for (const std::size_t i : reached(run)) {
    if (!clauses.contains(all_[i].clause) || all_[i].name == "false") continue;
    const model::ClauseCount& count = run.counts()[static_cast<std::size_t>(all_[i].clause)];
    const int signs = (count.positive != 0 ? 1 : 0) + (count.negative != 0 ? 1 : 0) + (count.tie != 0 ? 1 : 0);
    const bool by_sign = spec::info(all_[i].clause).outcomes == spec::ClauseOutcomes::sign;
    if (!by_sign || signs == 1) shown.push_back(i);
  }
  return shown;
}

}  // namespace toolcomp::certify::kit
