// SPDX-License-Identifier: Apache-2.0
// What a campaign has done so far: state.json of its folder.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "fuzz/campaign/counters.h"

namespace toolcomp::certify::fuzzing {

// All slices of one target that have ended.
struct TargetState {
  fuzz::Counters sum;
  std::uint64_t slices = 0;
};

struct State {
  std::string begun;  // UTC
  std::uint64_t seed = 1;
  std::uint64_t starts = 0;
  std::uint64_t milliseconds = 0;  // sum of all starts
  std::map<std::string, TargetState> targets;
  TargetState specification;  // of the third voice (third_voice.h)
  // How workers ended, if not in time: "crash", "hang", "killed by signal 9".
  std::map<std::string, std::uint64_t> ends;
  std::map<std::string, std::uint64_t> groups;  // number of cases of each finding, by the name of its folder
  std::uint64_t next_slice = 1;
  std::set<std::uint64_t> open;  // started slices whose counters are not yet in `targets`

  [[nodiscard]] std::uint64_t executions() const;
};

// A slice that is running. It is shown to readers of the file, and counted when it has ended.
struct Running {
  std::uint64_t slice = 0;
  std::string target;
  std::int64_t process = 0;
  std::uint64_t executions = 0;
};
std::string write_state(const State& state, const std::vector<Running>& running);
// Throws spec::InputError for a file that is not such a state.
State read_state(std::string_view text, const std::string& file);

// Adds the counts and unites the names. The order in which states are merged does not matter.
void merge(State& total, const State& part);

}  // namespace toolcomp::certify::fuzzing
