// SPDX-License-Identifier: Apache-2.0
#include "cli/watched_files.h"

#include <system_error>

namespace toolcomp::cli {

WatchedFiles::Look WatchedFiles::look(const std::string& file) {
  std::error_code error;
  Look look;
  look.time = std::filesystem::last_write_time(file, error);
  look.there = !error;
  if (look.there) look.size = std::filesystem::file_size(file, error);
  return look;
}

void WatchedFiles::watch(const std::vector<std::string>& files) {
  known_.clear();
  latest_.clear();
  watch_too(files);
}

void WatchedFiles::watch_too(const std::vector<std::string>& files) {
  for (const std::string& file : files)
    if (known_.emplace(file, look(file)).second) latest_[file] = known_[file];
}

bool WatchedFiles::changed() {
  Looks now;
  for (const auto& [file, before] : known_) now[file] = look(file);
  const bool rests = now == latest_;
  latest_ = now;
  if (!rests || now == known_) return false;
  known_ = now;
  return true;
}

}  // namespace toolcomp::cli
