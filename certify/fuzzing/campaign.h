// SPDX-License-Identifier: Apache-2.0
// A campaign: workers on targets in turns, what they find settled, everything in one folder that the next start takes
// up.
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
  bool temporary = false;                    // it goes with this start: summaries do not name it
  std::vector<const fuzz::Target*> targets;  // at least one, each once
  Bench bench;
  std::optional<std::uint64_t> seconds;  // none: without end
  std::uint64_t runs = 0;                // of each target, instead of a time
  unsigned jobs = 1;
  std::uint64_t seed = 1;
  Shard shard;
  bool specification = false;                   // as third voice, where it is built in (third_voice.h)
  std::function<bool()> stop;                   // an end asked for
  std::function<void(const BoardView&)> show;   // about once a second
  std::function<void(const std::string&)> say;  // what happened, a line each
};

struct CampaignEnd {
  State state;                   // of all starts
  Found found;                   // what is there
  std::size_t waiting = 0;       // sightings that nobody has looked at
  double seconds = 0;            // this start
  std::uint64_t executions = 0;  // this start
};

// Runs it to its end. Throws spec::InputError while another one is at work in the folder, std::runtime_error where it
// cannot be written: what was found then stays in `work` for the next start.
CampaignEnd run_campaign(const CampaignOptions& options);

// What state.json says of targets, as rows in their order, and of the third voice.
BoardView view_of(const State& state, const std::vector<const fuzz::Target*>& targets);
// Why the formal specification says nothing here; empty: it does, or is not asked for.
std::string silence(const CampaignOptions& options);

}  // namespace toolcomp::certify::fuzzing
