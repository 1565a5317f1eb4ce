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

// Of one target: all slices that have ended.
struct TargetState {
  fuzz::Counters sum;
  std::uint64_t slices = 0;
};

struct State {
  std::string begun;  // UTC
  std::uint64_t seed = 1;
  std::uint64_t starts = 0;
  std::uint64_t milliseconds = 0;  // of all starts
  std::map<std::string, TargetState> targets;
  TargetState specification;                  // of the third voice (third_voice.h)
  std::map<std::string, std::uint64_t> ends;  // how workers ended, in time apart: "crash", "hang", "killed by signal 9"
  std::map<std::string, std::uint64_t> groups;  // findings by the name of their folder: cases that came to it
  std::uint64_t next_slice = 1;
  std::set<std::uint64_t> open;  // slices begun whose counters are not in `targets` yet

  [[nodiscard]] std::uint64_t executions() const;
};

// With what runs now on top, for readers of the file: it counts once its slice has ended.
struct Running {
  std::uint64_t slice = 0;
  std::string target;
  std::int64_t process = 0;
  std::uint64_t executions = 0;
};
std::string write_state(const State& state, const std::vector<Running>& running);
// Throws spec::InputError for a file that is none.
State read_state(std::string_view text, const std::string& file);

// Sums, and of names the union: in whatever order states are merged, the result is the same.
void merge(State& total, const State& part);

}  // namespace toolcomp::certify::fuzzing
