// SPDX-License-Identifier: Apache-2.0
// Variables of custom macros that a program sets before it does anything else: #100 = 5.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "spec/language/decimal.h"
#include "spec/language/fanuc/block.h"

namespace toolcomp::spec {

// Of one program and those that it calls.
class MacroVariables {
 public:
  // Those that hold a number for the program: local ones 1 to 33, common ones 100 to 199 and 500 to 999.
  static constexpr bool is_one(std::uint64_t number) {
    return (number >= 1 && number <= 33) || (number >= 100 && number <= 199) || (number >= 500 && number <= 999);
  }

  void set(std::uint64_t number, const Decimal& value) { values_[number] = value; }
  // Nothing where it was not set.
  [[nodiscard]] std::optional<Decimal> value(std::uint64_t number) const {
    const auto found = values_.find(number);
    return found == values_.end() ? std::nullopt : std::optional(found->second);
  }
  // False from the first block on that has a word other than G, M, S, T, F and O: what is set later may be read ahead.
  [[nodiscard]] bool may_be_set() const { return may_be_set_; }
  // The next block, while may_be_set().
  void follow(const Block& block);

 private:
  std::map<std::uint64_t, Decimal> values_;
  bool may_be_set_ = true;
};

}  // namespace toolcomp::spec
