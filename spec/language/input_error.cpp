// SPDX-License-Identifier: Apache-2.0
#include "spec/language/input_error.h"

#include <utility>

#include "spec/language/printable.h"

namespace toolcomp::spec {
namespace {

constexpr std::size_t kMost = 2000;

std::string located(const std::string& file, std::uint64_t line, std::uint64_t column, const std::string& message) {
  // Both may be quoted from what strangers wrote.
  std::string text = printable(file);
  if (line != 0) text += ':' + std::to_string(line);
  if (line != 0 && column != 0) text += ':' + std::to_string(column);
  return text + ": " + printable(message, kMost);
}

}  // namespace

InputError::InputError(std::string file, std::uint64_t line, std::uint64_t column, std::string message)
    : std::runtime_error(located(file, line, column, message)),
      file_(std::move(file)),
      line_(line),
      column_(column),
      message_(std::move(message)) {}

}  // namespace toolcomp::spec
