// SPDX-License-Identifier: Apache-2.0
// What a campaign shows of itself while it runs.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "certify/fuzzing/third_voice.h"
#include "certify/process.h"

namespace toolcomp::certify::fuzzing {

// One target, everything counted that it ever did in this folder.
struct BoardRow {
  std::string target;
  unsigned workers = 0;
  std::uint64_t executions = 0;
  double per_second = 0;  // of a worker
  double accepted = 0;    // share
  std::size_t outcomes = 0;
  std::size_t of = 0;     // outcomes there are
  std::size_t fresh = 0;  // outcomes that came in the last window
  std::uint64_t law_checks = 0;
  std::uint64_t ties = 0;
  std::uint64_t hits = 0;  // executions that differed
};

// The formal specification as third voice.
struct VoiceRow {
  std::string silent;  // why it says nothing: "not built in"; empty: it does, or was not asked for
  VoiceCount count;
};

struct BoardView {
  std::vector<BoardRow> rows;
  VoiceRow specification;
  double seconds = 0;  // since this start
  std::size_t findings = 0;
  std::size_t ways = 0;     // in which they show
  std::size_t waiting = 0;  // sightings nobody has looked at
  std::string state;        // "", "settling"
};

// How many outcomes came in the last window.
class OutcomeWindow {
 public:
  static constexpr std::chrono::seconds kLength{60};
  // What is known now; how many more than a window ago, or than at the first call.
  std::size_t fresh(const std::string& target, std::size_t outcomes, Clock::time_point now);

 private:
  struct Count {
    Clock::time_point at;
    std::size_t outcomes = 0;
  };
  std::map<std::string, std::deque<Count>> counts_;
};

// The board as lines, a header first; the rows of targets without executions are summed up in one line. As a summary at
// the end the column of workers and that of what came last are left out.
std::vector<std::string> board_lines(const BoardView& view, bool summary = false);
// One line of plain text for logs.
std::string plain_line(const BoardView& view);

}  // namespace toolcomp::certify::fuzzing
