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

// The variables of one program and of the programs that it calls.
class MacroVariables {
 public:
  static constexpr std::uint64_t kMostLocal = 33;
  // Whether it is a variable that holds a number for the program: local variables 1 to 33, common variables 100 to 199
  // and 500 to 999.
  static constexpr bool is_one(std::uint64_t number) {
    return (number >= 1 && number <= kMostLocal) || (number >= 100 && number <= 199) ||
           (number >= 500 && number <= 999);
  }
  using Values = std::map<std::uint64_t, MacroValue>;

  void set(std::uint64_t number, const MacroValue& value) { of(number)[number] = value; }
  // std::nullopt if it was not set.
  [[nodiscard]] std::optional<MacroValue> value(std::uint64_t number) {
    const Values& values = of(number);
    const auto found = values.find(number);
    return found == values.end() ? std::nullopt : std::optional(found->second);
  }
  // The begin and the end of a G65 call. The called program has its own local variables, which begin as its arguments.
  void call(Values arguments) { local_.push_back(std::move(arguments)); }
  void leave() { local_.pop_back(); }

  bool inch = false;            // G20 in force
  bool per_revolution = false;  // G95
  std::uint64_t jumps = 0;      // number of jumps of macro statements so far

 private:
  Values& of(std::uint64_t number) { return number <= kMostLocal ? local_.back() : common_; }

  Values common_;
  std::vector<Values> local_{Values()};
};

}  // namespace toolcomp::spec
