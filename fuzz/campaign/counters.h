// SPDX-License-Identifier: Apache-2.0
// What a search counts: added up, passed between processes.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "judge/oracle/trial.h"

namespace toolcomp::fuzz {

// Sums over executions; worst values are the largest.
struct Counters {
  std::uint64_t executions = 0;
  std::uint64_t milliseconds = 0;  // of workers
  std::array<std::uint64_t, judge::kAcceptances> acceptance{};
  std::vector<model::ClauseCount> clauses;
  std::uint64_t decisions = 0;
  std::uint64_t near_ties = 0;
  std::uint64_t ties = 0;
  std::uint64_t values = 0;
  std::uint64_t wide = 0;          // values that were granted more than policy::kCap: not judged
  std::uint64_t out_of_scope = 0;  // events behind one of reason OUT_OF_SCOPE
  std::uint64_t few_events = 0;    // executions with fewer than three events judged
  std::uint64_t law_checks = 0;
  double worst_ulp = 0;
  double worst_um = 0;
  std::map<std::string, std::uint64_t> hits;  // executions that differed, by group_of()

  [[nodiscard]] double accepted_share() const;
  [[nodiscard]] std::uint64_t count(judge::Acceptance of) const;
  // Executions that differed.
  [[nodiscard]] std::uint64_t differed() const;
  // Executions a second of a worker; 0 where no time is known.
  [[nodiscard]] double per_second() const;
};

// One execution more; hits are the diary's.
void add(Counters& total, const judge::Trial& trial);
// In whatever order parts are added, the sum is the same.
void add(Counters& total, const Counters& part);

// As lines of names and numbers.
std::string write_counters(const Counters& r);
// Reads them back; lines it does not know are left out.
Counters read_counters(std::string_view text);

// Of the outcomes that the clauses of a section can have.
struct Reached {
  std::size_t seen = 0;
  std::size_t all = 0;
  std::vector<std::string> missing;  // "fanuc.leading-edge.near-90 false"
};
Reached outcomes_reached(std::string_view section, const std::vector<model::ClauseCount>& clauses);

}  // namespace toolcomp::fuzz
