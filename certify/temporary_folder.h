// SPDX-License-Identifier: Apache-2.0
// A folder that goes with its user.
#pragma once

#include <filesystem>

namespace toolcomp::certify {

// New and empty, in the system's folder of such; removed with all that is in it, unless it is kept.
class TemporaryFolder {
 public:
  // Throws std::runtime_error where none can be made.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  void keep() { kept_ = true; }

 private:
  bool kept_ = false;
  std::filesystem::path path_;
};

}  // namespace toolcomp::certify
