// SPDX-License-Identifier: Apache-2.0
// A campaign: workers take turns on targets, their sightings are settled, and everything is in one folder from which
// the next start resumes.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "certify/fuzzing/board.h"
#include "certify/fuzzing/folder.h"
#include "certify/fuzzing/found.h"
#include "certify/fuzzing/schedule.h"
#include "certify/fuzzing/settler.h"
#include "certify/fuzzing/worker.h"

namespace toolcomp::certify::fuzzing {

struct CampaignOptions {
  std::filesystem::path folder;
  bool temporary = false;                    // the folder is removed after this start: summaries do not name it
  std::vector<const fuzz::Target*> targets;  // at least one, each once
  Bench bench;
  std::optional<std::uint64_t> seconds;  // std::nullopt: no time limit
  std::uint64_t runs = 0;                // of each target, instead of a time
  unsigned jobs = 1;
  std::uint64_t seed = 1;
  Shard shard;
  bool specification = false;                   // use it as third voice, if it is built in (third_voice.h)
  std::function<bool()> stop;                   // whether an end was asked for
  std::function<void(const BoardView&)> show;   // about once a second
  std::function<void(const std::string&)> say;  // one line for each thing that happened
};

struct CampaignEnd {
  State state;                   // of all starts
  Found found;                   // all findings
  std::size_t waiting = 0;       // sightings that were not examined
  double seconds = 0;            // this start
  std::uint64_t executions = 0;  // this start
};

// Runs a campaign to its end. Throws spec::InputError while another campaign works in the folder, and
// std::runtime_error if the folder cannot be written. The sightings then stay in `work` for the next start.
CampaignEnd run_campaign(const CampaignOptions& options);

// The targets of state.json as rows, in their order, and its third voice.
BoardView view_of(const State& state, const std::vector<const fuzz::Target*>& targets);
// Why the formal specification is not used here; empty if it is used, or not asked for.
std::string silence(const CampaignOptions& options);

}  // namespace toolcomp::certify::fuzzing
