// SPDX-License-Identifier: Apache-2.0
// What stands on disk while a campaign runs, so that whatever ends it, even a kill, what was found is there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "certify/finding.h"
#include "certify/running_mark.h"

namespace toolcomp::certify {

// In the folder of a report: findings/ has every finding from the moment it is seen, as a file that can be replayed;
// its mark (certify/running_mark.h) says what was done so far.
class RunningReport {
 public:
  // Moves findings of a run that did not come to its report aside, to interrupted-1, interrupted-2, …
  RunningReport(std::filesystem::path folder, const std::string& command);

  // What became of the earlier run, for people; empty: it came to its report.
  [[nodiscard]] const std::string& earlier() const { return earlier_; }

  void found(const Finding& finding);
  void progress(std::uint64_t done, std::uint64_t all) { mark_.progress(done, all); }

 private:
  std::filesystem::path folder_;
  RunningMark mark_;
  std::string earlier_;
  std::map<FailureKey, std::filesystem::path> files_;
};

}  // namespace toolcomp::certify
