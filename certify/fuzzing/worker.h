// SPDX-License-Identifier: Apache-2.0
// One worker of a campaign: a process that works on one target for one slice of time.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "certify/process.h"
#include "fuzz/campaign/counters.h"
#include "fuzz/campaign/target.h"

namespace toolcomp::certify::fuzzing {

// Where workers find programs and first inputs.
struct Bench {
  std::filesystem::path program;              // toolcomp: the built-in driver
  std::filesystem::path targets;              // libFuzzer's, by name; those that are not there are driven by `program`
  std::vector<std::filesystem::path> inputs;  // folders of first inputs, below them those of Target::seeds
  std::string controller;                     // instead of the fast engine: then the built-in driver works
  double timeout = 10;                        // of a controller, seconds
  std::chrono::seconds patience{120};         // with one execution; then it hangs

  [[nodiscard]] bool has_clang(const fuzz::Target& target) const;
  // Whether any worker can be made for it: readers have no built-in driver.
  [[nodiscard]] bool can_run(const fuzz::Target& target) const;
};

struct Slice {
  std::uint64_t number = 0;
  const fuzz::Target* target = nullptr;
  std::uint64_t seed = 1;
  std::uint64_t seconds = 0;
  std::uint64_t runs = 0;  // instead of seconds
  // Of the third voice (third_voice.h): whose inputs it takes. No seconds: those that are kept.
  std::vector<const fuzz::Target*> heard;
};

class Worker {
 public:
  // `folder` is its own and made here; what reaches something new goes to `corpus`. Throws std::runtime_error.
  Worker(const Bench& bench, const Slice& slice, std::filesystem::path folder, const std::filesystem::path& corpus);

  // Whether it goes on; looks for its end so long. One that hangs is ended.
  bool goes_on(std::chrono::milliseconds wait);
  // Ends it at once. What it has written stays.
  void stop();

  [[nodiscard]] const Slice& slice() const { return slice_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] std::int64_t process() const { return process_number_; }
  // Executions begun.
  [[nodiscard]] std::uint64_t executions() const { return executions_; }
  [[nodiscard]] std::uint64_t milliseconds() const;

  // Once it has ended: how, empty where it ended in time: "crash", "hang", "out of memory", "killed by signal 9",
  // "cannot write".
  [[nodiscard]] const std::string& how() const { return how_; }
  [[nodiscard]] std::string errors() const { return process_.errors(); }

 private:
  void look();
  void end(std::string how);

  Slice slice_;
  std::filesystem::path folder_;
  std::chrono::seconds patience_;
  Clock::time_point begun_ = Clock::now();
  Clock::time_point ended_;
  Clock::time_point moved_ = begun_;  // when an execution began last, as far as it was looked
  Clock::time_point looked_;
  std::uint64_t executions_ = 0;
  std::int64_t process_number_ = 0;
  std::string how_;
  Process process_;
};

// What a worker says of itself in its folder, alive or not: its counters as it wrote them last.
fuzz::Counters counters_in(const std::filesystem::path& folder);

}  // namespace toolcomp::certify::fuzzing
