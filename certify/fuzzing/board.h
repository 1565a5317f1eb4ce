// SPDX-License-Identifier: Apache-2.0
// The display of a campaign while it runs.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "certify/fuzzing/third_voice.h"
#include "host/process.h"

namespace toolcomp::certify::fuzzing {

// One target, with all its counts of this folder.
struct BoardRow {
  std::string target;
  unsigned workers = 0;
  std::uint64_t executions = 0;
  double per_second = 0;  // of a worker
  double accepted = 0;    // share
  std::size_t outcomes = 0;
  std::size_t of = 0;     // number of existing outcomes
  std::size_t fresh = 0;  // outcomes first reached in the last window
  std::uint64_t law_checks = 0;
  std::uint64_t ties = 0;
  std::uint64_t hits = 0;  // executions that differed
};

// The formal specification as third voice.
struct VoiceRow {
  std::string silent;  // why it is not used: "not built in"; empty if it is used, or was not asked for
  VoiceCount count;
};

struct BoardView {
  std::vector<BoardRow> rows;
  VoiceRow specification;
  double seconds = 0;  // since this start
  std::size_t findings = 0;
  std::size_t ways = 0;     // ways in which they show
  std::size_t waiting = 0;  // sightings that were not examined
  std::string state;        // "", "settling"
};

// Counts the outcomes that were first reached in the last window.
class OutcomeWindow {
 public:
  static constexpr std::chrono::seconds kLength{60};
  // Takes the current number of outcomes. Returns how many more these are than one window ago, or than at the first
  // call.
  std::size_t fresh(const std::string& target, std::size_t outcomes, host::Clock::time_point now);

 private:
  struct Count {
    host::Clock::time_point at;
    std::size_t outcomes = 0;
  };
  std::map<std::string, std::deque<Count>> counts_;
};

// The board as lines, with a header first. Targets without executions share one line. With `summary`, the columns for
// the workers and for new outcomes are left out.
std::vector<std::string> board_lines(const BoardView& view, bool summary = false);
// One line of plain text for logs.
std::string plain_line(const BoardView& view);

}  // namespace toolcomp::certify::fuzzing
