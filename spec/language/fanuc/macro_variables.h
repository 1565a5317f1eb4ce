// SPDX-License-Identifier: Apache-2.0
// Variables of custom macros.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "spec/language/fanuc/macro_value.h"

namespace toolcomp::spec {

// Of one program and those that it calls.
class MacroVariables {
 public:
  static constexpr std::uint64_t kMostLocal = 33;
  // Those that hold a number for the program: local ones 1 to 33, common ones 100 to 199 and 500 to 999.
  static constexpr bool is_one(std::uint64_t number) {
    return (number >= 1 && number <= kMostLocal) || (number >= 100 && number <= 199) ||
           (number >= 500 && number <= 999);
  }
  using Values = std::map<std::uint64_t, MacroValue>;

  void set(std::uint64_t number, const MacroValue& value) { of(number)[number] = value; }
  // Nothing where it was not set.
  [[nodiscard]] std::optional<MacroValue> value(std::uint64_t number) {
    const Values& values = of(number);
    const auto found = values.find(number);
    return found == values.end() ? std::nullopt : std::optional(found->second);
  }
  // G65: the program called has local variables of its own, its arguments; and its end.
  void call(Values arguments) { local_.push_back(std::move(arguments)); }
  void leave() { local_.pop_back(); }

  bool inch = false;            // G20 in force
  bool per_revolution = false;  // G95
  std::uint64_t jumps = 0;      // of macro statements, so far

 private:
  Values& of(std::uint64_t number) { return number <= kMostLocal ? local_.back() : common_; }

  Values common_;
  std::vector<Values> local_{Values()};
};

}  // namespace toolcomp::spec
