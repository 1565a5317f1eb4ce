// SPDX-License-Identifier: Apache-2.0
// The built-in fuzzing driver, guided by the model's recorder.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/campaign/steering.h"
#include "fuzz/gen/generator.h"
#include "fuzz/oracle/trial.h"

namespace toolcomp::fuzz {

// What a campaign has done so far.
struct CampaignProgress {
  std::uint64_t executions = 0;
  double seconds = 0;
  std::uint64_t reached = 0;   // things, in all (steering.h)
  std::uint64_t findings = 0;  // distinct
};

// Distinct by section, kind and clause of the first divergence.
struct Finding {
  spec::Case input;  // source.seed replays its generation
  Difference difference;
  std::uint64_t executions = 0;  // of the same key
  std::uint64_t first = 0;       // execution of its job at which it was found, from 1
};

// A case that could not be decided, and why.
struct NotDecided {
  spec::Case input;
  std::string why;
};

struct CampaignOptions {
  std::vector<std::string> sections;  // empty: all
  std::vector<Mode> modes = {Mode::directed};
  double seconds = 60;     // where runs is 0
  std::uint64_t runs = 0;  // executions in all
  unsigned jobs = 1;       // threads; each has its own engines and corpus
  std::uint64_t seed = 1;
  std::size_t max_findings = 100;  // distinct ones, then the campaign ends
  // What is tested, one for each job; empty: the fast engine.
  std::function<Subject(unsigned job)> subject;
  // Called about once a second, from one thread.
  std::function<void(const CampaignProgress&)> progress;
  // Called for each distinct finding as it is made, never at the same time from two threads; what it throws ends the
  // campaign.
  std::function<void(const Finding&)> on_finding;
  // Whether to come to an end; what is judged meanwhile does not count.
  std::function<bool()> stop;
};

struct CampaignResult {
  std::uint64_t executions = 0;
  double seconds = 0;
  double cores = 0;  // threads or processes side by side
  double per_second_per_core = 0;
  std::array<std::uint64_t, kAcceptances> acceptance{};
  std::vector<model::ClauseCount> clauses;  // summed over all executions
  Reach reached;
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
  std::map<std::string, std::uint64_t> hits;  // of a worker: executions that differed, by group_of()
  std::vector<Finding> findings;              // by job, then by when they were found
  std::optional<NotDecided> not_decided;      // the one with the shortest program

  [[nodiscard]] double accepted_share() const;
};

// Runs until `seconds` are over or `runs` executions are done. With one job and `runs`, the same seed gives the same
// result but for times. Throws std::invalid_argument for an unknown section.
CampaignResult run_campaign(const CampaignOptions& options_given);

}  // namespace toolcomp::fuzz
