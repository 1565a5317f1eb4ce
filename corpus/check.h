// SPDX-License-Identifier: Apache-2.0
// Runs golden vectors through both engines, or through a controller.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "corpus/golden.h"
#include "judge/oracle/trial.h"
#include "spec/coverage/coverage.h"

namespace toolcomp::corpus {

// A vector that failed.
struct Failure {
  std::string file;
  std::size_t line = 0;
  std::string id;
  std::string what;
};

struct CheckResult {
  std::uint64_t vectors = 0;
  std::uint64_t values = 0;     // numbers and alarms judged
  std::uint64_t ties = 0;       // near ties at which the other, permitted outcome was taken
  std::uint64_t undecided = 0;  // neither agreed nor failed
  std::vector<Failure> failures;
};

struct CheckOptions {
  std::filesystem::path folder = default_folder();
  Selection selection;
  // Judges a controller instead of both engines. If it is empty, the model must give every vector again
  // character by character, and the fast engine must agree with it.
  judge::CaseJudge judged_by;
  std::function<void(std::uint64_t done, std::uint64_t all)> progress;
};

// Throws spec::InputError for a corpus that cannot be read.
CheckResult check(const CheckOptions& options);

// The clause outcomes that the selected vectors exercise in the model, by Clause, and how many vectors there are.
struct Coverage {
  std::vector<spec::OutcomeCounts> counts;
  std::uint64_t vectors = 0;
};
Coverage coverage(const std::filesystem::path& folder = default_folder(), const Selection& selection = {});

}  // namespace toolcomp::corpus
