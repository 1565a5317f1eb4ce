// SPDX-License-Identifier: Apache-2.0
// Judges a finding again.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "certify/finding.h"
#include "certify/judge.h"

namespace toolcomp::certify {

struct ReplayOptions {
  std::optional<std::string> controller;  // instead of the controller of the finding; empty: the built-in engine
  std::chrono::milliseconds timeout{10'000};
  // Called with the command that the file names, before it is run. Throws if it must not be run.
  std::function<void(const std::string& command)> before_running;
};

struct Replay {
  Finding finding;            // as read
  Judgement judgement;        // of the last attempt
  FailureKey key;             // key of this judgement
  std::string asked;          // the command; empty: the built-in engine
  std::uint64_t tried = 0;    // number of attempts with fresh processes
  std::string other_subject;  // what the controller announces now, if it differs from what it announced then
  [[nodiscard]] bool reproduced() const { return judgement.result == Result::differs && key == finding.key; }
};

// Asks a fresh process the requests of the finding, including the earlier ones, and judges the answer. It repeats this
// until the answer differs: three times, or, if the finding was not reproduced every time, three times as often as its
// rate requires. Throws spec::InputError for a file that is not a finding or a case.
Replay replay(const std::filesystem::path& file, const ReplayOptions& options = {});

}  // namespace toolcomp::certify
