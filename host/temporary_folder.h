// SPDX-License-Identifier: Apache-2.0
// A temporary folder that is removed with its object.
#pragma once

#include <filesystem>

namespace toolcomp::host {

// A new empty folder in the system's temporary folder. It is removed with everything in it, unless it is kept.
class TemporaryFolder {
 public:
  // Throws std::runtime_error if the folder cannot be made.
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

}  // namespace toolcomp::host
