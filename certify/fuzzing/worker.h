// SPDX-License-Identifier: Apache-2.0
// One worker of a campaign: a process that works on one target for one slice of time.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "fuzz/campaign/counters.h"
#include "fuzz/campaign/target.h"
#include "host/process.h"

namespace toolcomp::certify::fuzzing {

// The programs and first inputs of workers.
struct Bench {
  std::filesystem::path program;  // toolcomp: the built-in driver
  std::filesystem::path targets;  // folder of the libFuzzer targets, by name; `program` drives the missing ones
  std::vector<std::filesystem::path> inputs;  // folders of first inputs, which contain those of Target::seeds
  std::string controller;                     // instead of the fast engine; then the built-in driver is used
  double timeout = 10;                        // of a controller, seconds
  std::chrono::seconds patience{120};         // for one execution; after that the worker counts as hanging

  [[nodiscard]] bool has_clang(const fuzz::Target& target) const;
  // Whether there can be a worker for the target. Readers have no built-in driver.
  [[nodiscard]] bool can_run(const fuzz::Target& target) const;
};

struct Slice {
  std::uint64_t number = 0;
  const fuzz::Target* target = nullptr;
  std::uint64_t seed = 1;
  std::uint64_t seconds = 0;
  std::uint64_t runs = 0;  // instead of seconds
  // For the third voice (third_voice.h): the targets whose inputs it takes. With 0 seconds it takes the kept inputs
  // only.
  std::vector<const fuzz::Target*> heard;
};

class Worker {
 public:
  // `folder` belongs to the worker and is made here. Inputs that reach something new go to `corpus`. Throws
  // std::runtime_error.
  Worker(const Bench& bench, const Slice& slice, std::filesystem::path folder, const std::filesystem::path& corpus);

  // Whether it is still running. Waits for its end for up to `wait`. A hanging worker is killed.
  bool goes_on(std::chrono::milliseconds wait);
  // Kills it at once. The files that it has written stay.
  void stop();

  [[nodiscard]] const Slice& slice() const { return slice_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] std::int64_t process() const { return process_number_; }
  // Number of executions begun.
  [[nodiscard]] std::uint64_t executions() const { return executions_; }
  [[nodiscard]] std::uint64_t milliseconds() const;

  // How it ended, empty if it ended in time: "crash", "hang", "out of memory", "killed by signal 9", "cannot write".
  [[nodiscard]] const std::string& how() const { return how_; }
  [[nodiscard]] std::string errors() const { return process_.errors(); }

 private:
  void look();
  void end(std::string how);

  Slice slice_;
  std::filesystem::path folder_;
  std::chrono::seconds patience_;
  host::Clock::time_point begun_ = host::Clock::now();
  host::Clock::time_point ended_;
  host::Clock::time_point moved_ = begun_;  // when the last execution began, as far as was checked
  host::Clock::time_point looked_;
  std::uint64_t executions_ = 0;
  std::int64_t process_number_ = 0;
  std::string how_;
  host::Process process_;
};

// The counters that a worker wrote last to its folder, whether it is still running or not.
fuzz::Counters counters_in(const std::filesystem::path& folder);

}  // namespace toolcomp::certify::fuzzing
