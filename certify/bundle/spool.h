// SPDX-License-Identifier: Apache-2.0
// A temporary file without a name. Nothing of it is left, whatever ends the process.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "host/sha256.h"

namespace toolcomp::certify::bundle {

// The file is first written, then read. All functions throw std::runtime_error if the disk fails.
class Spool {
 public:
  explicit Spool(const std::filesystem::path& folder);

  void append(std::string_view bytes);
  [[nodiscard]] std::uint64_t size() const { return size_; }
  // Ends writing. Returns the SHA-256 of everything that was appended.
  std::string finish();

  // Goes back to the beginning.
  void rewind();
  // The next bytes, at most `most` of them; empty at the end. Valid until the next call.
  std::string_view read(std::size_t most);
  // The next line without its line feed; false at the end. A last line without a line feed counts as a line. Throws
  // Refused for a line of more than 256 MiB.
  bool next_line(std::string& line);

 private:
  struct Close {
    void operator()(std::FILE* file) const noexcept { static_cast<void>(std::fclose(file)); }
  };
  std::unique_ptr<std::FILE, Close> file_;
  host::Sha256 digest_;
  std::uint64_t size_ = 0;
  std::string buffer_;
  std::size_t at_ = 0;  // in buffer_, of next_line
};

}  // namespace toolcomp::certify::bundle
