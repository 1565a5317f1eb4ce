// SPDX-License-Identifier: Apache-2.0
// A file in memory that outlives its process: what it tried last, and what it could not write elsewhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace toolcomp::fuzz {

// Its blocks on disk are there from the beginning, so that a full disk does not matter later.
class BlackBox {
 public:
  // Throws std::runtime_error that names the file and the reason.
  explicit BlackBox(const std::filesystem::path& file);
  ~BlackBox();
  BlackBox(const BlackBox&) = delete;
  BlackBox& operator=(const BlackBox&) = delete;

  // Another execution, of this input. One that is too long for the box (64 KiB) counts and is not kept.
  void begin(std::string_view input);
  // Keeps a text that cannot be written to a file; false: the box (256 KiB) is full.
  bool keep(std::string_view text);

  struct Contents {
    std::int64_t process = 0;
    std::uint64_t executions = 0;  // begun
    std::string input;             // of the last of them
    std::vector<std::string> kept;
  };
  // Of a file, its process alive or not; nothing: there is none, or it is no black box.
  static std::optional<Contents> read(const std::filesystem::path& file);

 private:
  struct Layout;
  Layout* box_ = nullptr;
};

}  // namespace toolcomp::fuzz
