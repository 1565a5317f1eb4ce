// SPDX-License-Identifier: Apache-2.0
// The shape of the active tool for pictures, as far as setup and program give it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "spec/language/case.h"

namespace toolcomp::certify {

// In the units of the program.
struct ToolShape {
  double radius = 0;
  double corner = 0;  // corner radius, at most the radius
  double length = 0;  // 0: not known
  std::string name;   // the source of the shape: "D1 H2", "tool table"
  friend bool operator==(const ToolShape&, const ToolShape&) = default;
};

class ToolShapes {
 public:
  // Reads the text block by block. Offsets that the program itself changes count with the values of the setup. Throws
  // spec::InputError for a program that is not text.
  explicit ToolShapes(const spec::Case& c);

  // The active tool in this line; std::nullopt if no radius is known.
  [[nodiscard]] std::optional<ToolShape> at(std::uint64_t line) const;

 private:
  std::map<std::uint64_t, std::optional<ToolShape>> by_line_;  // from a line on
};

}  // namespace toolcomp::certify
