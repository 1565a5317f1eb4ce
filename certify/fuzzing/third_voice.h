// SPDX-License-Identifier: Apache-2.0
// The formal specification as the third voice of a campaign: a process, in addition to the workers, that compares the
// model with it. It takes the inputs that workers keep, and generated cases while there are none.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "certify/fuzzing/state.h"
#include "certify/judge.h"
#include "fuzz/campaign/target.h"

namespace toolcomp::certify::fuzzing {

// Takes the place of the target in its slices.
const fuzz::Target& third_voice();

struct ThirdVoiceOptions {
  std::filesystem::path work;                // its folder (fuzz/campaign/diary.h)
  std::filesystem::path corpus;              // of the campaign, with one folder for each target
  std::filesystem::path asked;               // inputs it has had, one in each line, for the next start
  std::vector<const fuzz::Target*> targets;  // targets of sections; the one that has had the least time comes next
  std::uint64_t seed = 1;
  std::uint64_t seconds = 0;  // 0: run all kept inputs, and no others
};

// To be called in a separate process, from one thread. Returns the exit status. Requires spec_engine::available().
int run_third_voice(const ThirdVoiceOptions& options);

// The finding for an input that ended this process.
std::string ended_at(const std::string& case_line, const std::string& how);

// The counts of the third voice.
struct VoiceCount {
  std::uint64_t cases = 0;
  double per_second = 0;
  std::uint64_t agreed = 0;
  std::uint64_t differ = 0;
  std::uint64_t undecided = 0;  // cases that one of the two could not decide, or that the specification does not cover
  std::uint64_t refused = 0;    // setups that no control has, and programs that cannot be read
};
VoiceCount voice_count(const TargetState& counted);

}  // namespace toolcomp::certify::fuzzing
