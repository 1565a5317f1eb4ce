// SPDX-License-Identifier: Apache-2.0
// A finding, judged again.
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
  std::optional<std::string> controller;  // instead of the finding's own; empty: the built-in engine
  std::chrono::milliseconds timeout{10'000};
  // Told the command that the file names before it is run; throws where it must not be.
  std::function<void(const std::string& command)> before_running;
};

struct Replay {
  Finding finding;            // as read
  Judgement judgement;        // of the last try
  FailureKey key;             // of it
  std::string asked;          // the command; empty: the built-in engine
  std::uint64_t tried = 0;    // with fresh processes
  std::string other_subject;  // what the controller says of itself, where it is not what it said then
  [[nodiscard]] bool reproduced() const { return judgement.result == Result::differs && key == finding.key; }
};

// Asks a fresh process what the finding was asked, all before it included, and judges the answer: until it differs,
// three times, or where it did not come every time three times as often as it should take. Throws spec::InputError for
// a file that is no finding or case.
Replay replay(const std::filesystem::path& file, const ReplayOptions& options = {});

}  // namespace toolcomp::certify
