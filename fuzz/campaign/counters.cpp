// SPDX-License-Identifier: Apache-2.0
#include "fuzz/campaign/counters.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <sstream>

namespace toolcomp::fuzz {
namespace {

using model::ClauseCount;

void add(ClauseCount& total, const ClauseCount& part) {
  total.reached += part.reached;
  total.positive += part.positive;
  total.negative += part.negative;
  total.tie += part.tie;
}

void add(std::vector<ClauseCount>& total, const std::vector<ClauseCount>& part) {
  total.resize(spec::kClauseCount);
  for (std::size_t i = 0; i < part.size(); ++i) add(total[i], part[i]);
}

// An outcome a clause can have, with how often it was seen.
struct OutcomeSeen {
  std::string_view name;
  std::uint64_t count;
};

std::vector<OutcomeSeen> outcomes(const spec::ClauseInfo& clause, const ClauseCount& count) {
  std::vector<OutcomeSeen> all;
  switch (clause.outcomes) {
    case spec::ClauseOutcomes::reach:
      all = {{"reached", count.reached}};
      break;
    case spec::ClauseOutcomes::fact:
      all = {{"true", count.positive}, {"false", count.negative}};
      break;
    case spec::ClauseOutcomes::sign:
      all = {{"positive", count.positive}, {"negative", count.negative}, {"tie", count.tie}};
      break;
  }
  std::erase_if(all, [&](const OutcomeSeen& o) {
    return ("\n" + std::string(clause.unreachable) + "\n").find("\n" + std::string(o.name) + "\n") != std::string::npos;
  });
  return all;
}

}  // namespace

double Counters::accepted_share() const {
  return executions == 0 ? 0
                         : static_cast<double>(count(judge::Acceptance::accepted)) / static_cast<double>(executions);
}

std::uint64_t Counters::count(judge::Acceptance of) const { return acceptance.at(static_cast<std::size_t>(of)); }

std::uint64_t Counters::differed() const {
  std::uint64_t sum = 0;
  for (const auto& [group, number] : hits) sum += number;
  return sum;
}

double Counters::per_second() const {
  return milliseconds == 0 ? 0 : static_cast<double>(executions) * 1000 / static_cast<double>(milliseconds);
}

void add(Counters& total, const judge::Trial& trial) {
  ++total.executions;
  ++total.acceptance.at(static_cast<std::size_t>(trial.acceptance));
  const judge::Verdict& v = trial.verdict;
  total.decisions += v.decisions;
  total.near_ties += v.near_ties;
  total.ties += v.ties;
  total.values += v.values;
  total.wide += v.wide;
  total.out_of_scope += v.out_of_scope;
  constexpr std::uint64_t few = 3;
  total.few_events += v.events < few ? 1 : 0;
  total.law_checks += trial.law_checks;
  // What is outside the policy is a finding, not a figure of merit.
  if (!trial.found()) {
    total.worst_ulp = std::max(total.worst_ulp, v.worst_ulp);
    total.worst_um = std::max(total.worst_um, v.worst_um);
  }
  add(total.clauses, trial.run.recorder.counts());
}

void add(Counters& total, const Counters& part) {
  total.executions += part.executions;
  total.milliseconds += part.milliseconds;
  total.decisions += part.decisions;
  total.near_ties += part.near_ties;
  total.ties += part.ties;
  total.values += part.values;
  total.wide += part.wide;
  total.out_of_scope += part.out_of_scope;
  total.few_events += part.few_events;
  total.law_checks += part.law_checks;
  total.worst_ulp = std::max(total.worst_ulp, part.worst_ulp);
  total.worst_um = std::max(total.worst_um, part.worst_um);
  for (std::size_t i = 0; i < judge::kAcceptances; ++i) total.acceptance.at(i) += part.acceptance.at(i);
  add(total.clauses, part.clauses);
  for (const auto& [group, count] : part.hits) total.hits[group] += count;
}

std::string write_counters(const Counters& r) {
  std::string out;
  const auto line = [&out](std::string_view name, auto value) {
    fmt::format_to(std::back_inserter(out), "{} {}\n", name, value);
  };
  line("executions", r.executions);
  line("milliseconds", r.milliseconds);
  line("decisions", r.decisions);
  line("near_ties", r.near_ties);
  line("ties", r.ties);
  line("values", r.values);
  line("wide", r.wide);
  line("out_of_scope", r.out_of_scope);
  line("few_events", r.few_events);
  line("law_checks", r.law_checks);
  line("worst_ulp", r.worst_ulp);
  line("worst_um", r.worst_um);
  for (std::size_t i = 0; i < judge::kAcceptances; ++i) line(fmt::format("acceptance {}", i), r.acceptance.at(i));
  for (const auto& [group, count] : r.hits) line("hits", fmt::format("{} {}", count, group));
  for (std::size_t i = 0; i < r.clauses.size(); ++i) {
    const ClauseCount& c = r.clauses[i];
    if (c.reached != 0)
      fmt::format_to(std::back_inserter(out), "clause {} {} {} {} {}\n", spec::info(static_cast<spec::Clause>(i)).id,
                     c.reached, c.positive, c.negative, c.tie);
  }
  return out;
}

Counters read_counters(std::string_view text) {
  Counters r;
  r.clauses.resize(spec::kClauseCount);
  std::istringstream in{std::string(text)};
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string name;
    words >> name;
    if (name == "executions") words >> r.executions;
    if (name == "milliseconds") words >> r.milliseconds;
    if (name == "decisions") words >> r.decisions;
    if (name == "near_ties") words >> r.near_ties;
    if (name == "ties") words >> r.ties;
    if (name == "values") words >> r.values;
    if (name == "wide") words >> r.wide;
    if (name == "out_of_scope") words >> r.out_of_scope;
    if (name == "few_events") words >> r.few_events;
    if (name == "law_checks") words >> r.law_checks;
    if (name == "worst_ulp") words >> r.worst_ulp;
    if (name == "worst_um") words >> r.worst_um;
    if (name == "acceptance") {
      std::size_t index = 0;
      std::uint64_t count = 0;
      if (words >> index >> count && index < judge::kAcceptances) r.acceptance.at(index) = count;
    }
    if (name == "hits") {
      std::uint64_t count = 0;
      std::string group;
      if (words >> count >> std::ws && std::getline(words, group)) r.hits[group] = count;
    }
    if (name == "clause") {
      std::string id;
      ClauseCount c;
      words >> id >> c.reached >> c.positive >> c.negative >> c.tie;
      if (const auto clause = spec::find_clause(id)) r.clauses[static_cast<std::size_t>(*clause)] = c;
    }
  }
  return r;
}

Reached outcomes_reached(std::string_view section, const std::vector<ClauseCount>& clauses) {
  Reached reached;
  for (std::size_t i = 0; i < spec::kClauseCount; ++i) {
    const spec::ClauseInfo& clause = spec::info(static_cast<spec::Clause>(i));
    if (clause.section != section || !clause.testable || clause.kind == spec::ClauseKind::note) continue;
    for (const OutcomeSeen& outcome : outcomes(clause, i < clauses.size() ? clauses[i] : ClauseCount{})) {
      ++reached.all;
      if (outcome.count != 0)
        ++reached.seen;
      else
        reached.missing.push_back(fmt::format("{} {}", clause.id, outcome.name));
    }
  }
  return reached;
}

}  // namespace toolcomp::fuzz
