// SPDX-License-Identifier: Apache-2.0
// The file running.json in the folder of a run. It is there while the run lasts, so that the next run sees if this one
// was killed.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace toolcomp::certify {

class RunningMark {
 public:
  // The content of the mark that an earlier run left behind.
  struct Earlier {
    std::string begun;  // UTC
    std::uint64_t done = 0;
    std::uint64_t all = 0;  // 0 if not known
  };

  // Throws spec::InputError while another process of toolcomp runs in the folder, and std::runtime_error if the folder
  // cannot be written.
  RunningMark(const std::filesystem::path& folder, std::string command);
  ~RunningMark();
  RunningMark(const RunningMark&) = delete;
  RunningMark& operator=(const RunningMark&) = delete;

  [[nodiscard]] const std::optional<Earlier>& earlier() const { return earlier_; }
  // Writes at most twice a second.
  void progress(std::uint64_t done, std::uint64_t all);

 private:
  void write(std::uint64_t done, std::uint64_t all);

  bool made_folder_ = false;  // then it is removed with the mark, if it is empty
  std::filesystem::path file_;
  std::string command_;
  std::string begun_;
  std::optional<Earlier> earlier_;
  std::chrono::steady_clock::time_point last_;
};

// Moves the remains of an earlier run in a folder of its report aside, to interrupted-1, interrupted-2, … next to it.
// Returns the new place; std::nullopt if there are no remains.
std::optional<std::filesystem::path> set_aside(const std::filesystem::path& folder);

// "the run begun at … ended without a report, after 12 of 3400 cases"
std::string words(const RunningMark::Earlier& earlier);

}  // namespace toolcomp::certify
