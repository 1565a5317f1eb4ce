// SPDX-License-Identifier: Apache-2.0
// What `toolcomp fuzz` finds, on disk from the moment it is seen.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "certify/failure_groups.h"
#include "certify/running_mark.h"
#include "cli/controller.h"
#include "cli/verbs.h"
#include "fuzz/campaign/campaign.h"

namespace toolcomp::cli {

// Every finding is a file of its own in the folder, by the next number that is free: nothing found earlier is written
// over. As seen first; shrunk when its section is done.
class FuzzFindings {
 public:
  // Says on stderr what an earlier run did that was ended by a kill.
  FuzzFindings(const FuzzOptions& options, std::function<bool()> stop);

  // For controllers: what differs is seen here.
  Watch watch();
  // For the fast engine: a finding of the campaign, as soon as it is made.
  void seen(const fuzz::Finding& found);
  void progress(std::uint64_t executions) { mark_.progress(executions, 0); }

  // Makes findings of what was seen, shrunk where possible, and prints them.
  void settle(const fuzz::CampaignResult& result);

  // One that is shrunk already.
  void adopt(certify::Finding finding);

  [[nodiscard]] std::size_t count() const { return files_.size() + adopted_; }

 private:
  certify::Finding settled(const fuzz::Finding& found) const;
  certify::Finding signed_by_us(certify::Finding finding) const;
  void write(const certify::Finding& finding);
  void settle(certify::Finding finding, std::uint64_t executions);
  static void print(const std::filesystem::path& file, const certify::Finding& finding);

  const FuzzOptions& options_;
  std::function<bool()> stop_;
  std::filesystem::path folder_;
  certify::RunningMark mark_;
  std::mutex mutex_;
  certify::FailureGroups groups_;  // of a controller, not yet settled
  certify::Capabilities able_;
  std::map<certify::FailureKey, std::filesystem::path> files_;
  std::size_t adopted_ = 0;
};

}  // namespace toolcomp::cli
