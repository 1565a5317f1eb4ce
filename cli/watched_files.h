// SPDX-License-Identifier: Apache-2.0
// Whether files have changed: looked at from time to time, which works on every file system and for every editor.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace toolcomp::cli {

class WatchedFiles {
 public:
  // From now on these; as they are is no change.
  void watch(const std::vector<std::string>& files);
  // These besides.
  void watch_too(const std::vector<std::string>& files);
  // True once behind each change, when they are as they were the last time this was asked: not while one is written.
  bool changed();

 private:
  struct Look {
    bool there = false;
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    friend bool operator==(const Look&, const Look&) = default;
  };
  using Looks = std::map<std::string, Look>;
  [[nodiscard]] static Look look(const std::string& file);

  Looks known_;   // what the last answer is of
  Looks latest_;  // what was seen last
};

}  // namespace toolcomp::cli
