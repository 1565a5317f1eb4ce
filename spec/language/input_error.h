// SPDX-License-Identifier: Apache-2.0
// The error of input that cannot be read. It has a position, and the command ends with exit status 2.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace toolcomp::spec {

// For bytes that are not text, malformed cases and setups, missing files (docs/events.md, rule 5). what() is
// "FILE:LINE:COLUMN: what is wrong". Line and column count from 1, and are left out if they are 0.
class InputError : public std::runtime_error {
 public:
  InputError(std::string file, std::uint64_t line, std::uint64_t column, std::string message);

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] std::uint64_t line() const { return line_; }
  [[nodiscard]] std::uint64_t column() const { return column_; }
  [[nodiscard]] const std::string& message() const { return message_; }

 private:
  std::string file_;
  std::uint64_t line_;
  std::uint64_t column_;
  std::string message_;
};

}  // namespace toolcomp::spec
