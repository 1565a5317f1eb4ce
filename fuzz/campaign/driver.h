// SPDX-License-Identifier: Apache-2.0
// One search of the built-in driver: its corpus, its engines, its findings.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/campaign/campaign.h"
#include "fuzz/campaign/steering.h"

namespace toolcomp::fuzz {

struct DriverOptions {
  std::vector<std::string> sections;
  std::vector<Mode> modes;
  std::uint64_t seed = 1;
  unsigned number = 0;  // among searches side by side: their choices differ
  Subject subject;      // empty: the fast engine
  Steering steering = steering_of_process();
  std::function<bool()> stop;
  std::function<void(const spec::Case&)> on_input;                     // before each execution
  std::function<void(const Finding&, bool fresh)> on_finding;          // each difference; fresh: the first of its group
  std::function<void(const spec::Case&, const std::string&)> on_open;  // what could not be decided, and why
  std::function<void(const spec::Case&, Mode)> on_corpus;              // what reached something new
};

// Belongs to the thread that made it: exact values do.
class Driver {
 public:
  explicit Driver(DriverOptions options);

  // The i-th execution: fresh cases and changed corpus cases in turns, sections and modes in turns.
  void step(std::uint64_t i);
  // Executes a case that was kept earlier.
  void revisit(spec::Case c, Mode mode);

  [[nodiscard]] const CampaignResult& result() const { return result_; }

 private:
  spec::Case next(std::uint64_t i);
  void execute(spec::Case c, Mode mode, bool keep);
  void record(spec::Case c, const Difference& difference);

  DriverOptions options_;
  Coverage coverage_;
  Mode mode_ = Mode::directed;
  std::map<std::pair<std::string, Mode>, std::vector<spec::Case>> corpus_;
  std::map<std::string, std::size_t> index_;
  CampaignResult result_;
};

}  // namespace toolcomp::fuzz
