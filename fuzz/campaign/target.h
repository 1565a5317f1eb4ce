// SPDX-License-Identifier: Apache-2.0
// The fuzz targets by name: two of each section, and the readers.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "fuzz/gen/generator.h"

namespace toolcomp::fuzz {

struct Target {
  std::string name;     // that of its file in fuzz/targets: "tool_side_compensation_directed"
  std::string section;  // empty: a reader
  Mode mode = Mode::directed;
  std::string seeds;  // its folder below corpus/seeds: "fanuc/tool_side_compensation_directed"

  [[nodiscard]] bool is_reader() const { return section.empty(); }
};

// The twins in the order of the sections, then the readers.
std::span<const Target> targets();
// "fanuc/tool-side-compensation", directed: "tool_side_compensation_directed".
std::string twin_name(std::string_view section, Mode mode);
// None: nullptr.
const Target* find_target(std::string_view name);

}  // namespace toolcomp::fuzz
