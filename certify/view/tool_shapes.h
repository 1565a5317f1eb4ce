// SPDX-License-Identifier: Apache-2.0
// The shape of the tool in force, as far as setup and program say it: for pictures.
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
  double corner = 0;  // its rounding, at most the radius
  double length = 0;  // 0: not known
  std::string name;   // where it comes from: "D1 H2", "tool table"
  friend bool operator==(const ToolShape&, const ToolShape&) = default;
};

class ToolShapes {
 public:
  // Read from the text block by block; offsets that the program itself changes count as the setup has them. Throws
  // spec::InputError for a program that is no text.
  explicit ToolShapes(const spec::Case& c);

  // In force in this line; nothing where no radius is known.
  [[nodiscard]] std::optional<ToolShape> at(std::uint64_t line) const;

 private:
  std::map<std::uint64_t, std::optional<ToolShape>> by_line_;  // from a line on
};

}  // namespace toolcomp::certify
