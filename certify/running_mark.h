// SPDX-License-Identifier: Apache-2.0
// running.json in the folder of a run: there while it runs, so that the next one knows of an end by a kill.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace toolcomp::certify {

class RunningMark {
 public:
  // What the mark of an earlier run says that nobody took away.
  struct Earlier {
    std::string begun;  // UTC
    std::uint64_t done = 0;
    std::uint64_t all = 0;  // 0: not known
  };

  // Throws spec::InputError while another process of this program runs in the folder, std::runtime_error for one that
  // cannot be written.
  RunningMark(const std::filesystem::path& folder, std::string command);
  ~RunningMark();
  RunningMark(const RunningMark&) = delete;
  RunningMark& operator=(const RunningMark&) = delete;

  [[nodiscard]] const std::optional<Earlier>& earlier() const { return earlier_; }
  // Written twice a second at most.
  void progress(std::uint64_t done, std::uint64_t all);

 private:
  void write(std::uint64_t done, std::uint64_t all);

  bool made_folder_ = false;  // then it goes with the mark, if nothing else is in it
  std::filesystem::path file_;
  std::string command_;
  std::string begun_;
  std::optional<Earlier> earlier_;
  std::chrono::steady_clock::time_point last_;
};

// Moves what an earlier run left in a folder of its report aside, to interrupted-1, interrupted-2, … beside it: where
// it is now; nothing if there is none.
std::optional<std::filesystem::path> set_aside(const std::filesystem::path& folder);

// "the run begun at … ended without a report, after 12 of 3400 cases"
std::string words(const RunningMark::Earlier& earlier);

}  // namespace toolcomp::certify
