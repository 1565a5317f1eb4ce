// SPDX-License-Identifier: Apache-2.0
// The files on disk while a certification runs. Whatever ends it, even a kill, the findings so far are there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "certify/finding.h"
#include "certify/running_mark.h"

namespace toolcomp::certify {

// In the folder of a report. findings/ has every finding as soon as it is seen, as a file that can be replayed. The
// mark (certify/running_mark.h) says what was done so far.
class RunningReport {
 public:
  // Moves the findings of an earlier run that ended without a report aside, to interrupted-1, interrupted-2, …
  RunningReport(std::filesystem::path folder, const std::string& command);

  // What happened to the earlier run, for people; empty if it wrote its report.
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
