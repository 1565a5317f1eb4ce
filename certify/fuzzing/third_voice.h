// SPDX-License-Identifier: Apache-2.0
// The formal specification as the third voice of a campaign: a process beside the workers that holds the model against
// it, on what workers keep and, while nothing waits, on generated cases.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "certify/fuzzing/state.h"
#include "certify/judge.h"
#include "fuzz/campaign/target.h"

namespace toolcomp::certify::fuzzing {

// What stands for it where a slice has its target.
const fuzz::Target& third_voice();

struct ThirdVoiceOptions {
  std::filesystem::path work;                // its folder (fuzz/campaign/diary.h)
  std::filesystem::path corpus;              // of the campaign: below it a folder a target
  std::filesystem::path asked;               // inputs it has had, a line each: the next start knows them
  std::vector<const fuzz::Target*> targets;  // of sections; the one that has had the least time comes next
  std::uint64_t seed = 1;
  std::uint64_t seconds = 0;  // 0: until every input that is kept has been asked, and no other
};

// In a process of its own, from one thread. Returns its exit status. Requires formal::available().
int run_third_voice(const ThirdVoiceOptions& options);

// An input that ended that process, as a finding.
std::string ended_at(const std::string& case_line, const std::string& how);

// What it has counted.
struct VoiceCount {
  std::uint64_t cases = 0;
  double per_second = 0;
  std::uint64_t agreed = 0;
  std::uint64_t differ = 0;
  std::uint64_t undecided = 0;  // by one of the two; and what the specification does not say
  std::uint64_t refused = 0;    // a setup that no control has, a program that is no text: nobody says anything
};
VoiceCount voice_count(const TargetState& counted);

}  // namespace toolcomp::certify::fuzzing
