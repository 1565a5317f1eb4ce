// SPDX-License-Identifier: Apache-2.0
// One search of the built-in driver, guided by the model's recorder: its corpus, its engines.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "fuzz/campaign/counters.h"
#include "fuzz/campaign/steering.h"

namespace toolcomp::fuzz {

struct DriverOptions {
  std::string section;
  Mode mode = Mode::directed;
  std::uint64_t seed = 1;
  judge::CaseJudge judged_by;                                                   // empty: the fast engine is judged
  std::function<void(const spec::Case&)> on_input;                              // before each execution
  std::function<void(const spec::Case&, const judge::Difference&)> on_finding;  // each difference
  std::function<void(const spec::Case&, const std::string& why)> on_open;       // what could not be decided
  std::function<void(const spec::Case&)> on_corpus;                             // what reached something new
};

// Belongs to the thread that made it: exact values do. The same options and calls give the same search.
class Driver {
 public:
  explicit Driver(DriverOptions options);

  // The i-th execution: a fresh case or a changed one of the corpus.
  void step(std::uint64_t i);
  // Executes a case that was kept earlier.
  void revisit(spec::Case c);

  [[nodiscard]] const Counters& result() const { return result_; }

 private:
  spec::Case next(std::uint64_t i);
  void execute(spec::Case c, bool keep);

  DriverOptions options_;
  Coverage coverage_;
  std::vector<spec::Case> corpus_;
  Counters result_;
};

}  // namespace toolcomp::fuzz
