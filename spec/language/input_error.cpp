// SPDX-License-Identifier: Apache-2.0
#include "spec/language/input_error.h"

#include <utility>

namespace toolcomp::spec {
namespace {

std::string located(const std::string& file, std::uint64_t line, std::uint64_t column, const std::string& message) {
  std::string text = file;
  if (line != 0) text += ':' + std::to_string(line);
  if (line != 0 && column != 0) text += ':' + std::to_string(column);
  return text + ": " + message;
}

}  // namespace

InputError::InputError(std::string file, std::uint64_t line, std::uint64_t column, std::string message)
    : std::runtime_error(located(file, line, column, message)),
      file_(std::move(file)),
      line_(line),
      column_(column),
      message_(std::move(message)) {}

}  // namespace toolcomp::spec
