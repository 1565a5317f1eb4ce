// SPDX-License-Identifier: Apache-2.0
// Q parameters, as far as the reader knows their values, and formulas of them: Q1 = Q2 * ( 3 - Q3 ). Internal to the
// reader.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "spec/language/decimal.h"
#include "spec/language/heidenhain/klartext_block.h"

namespace toolcomp::spec::klartext {

// Clause heidenhain.program.formula. Does not allocate for the first few parameters.
class ParameterValues {
 public:
  ParameterValues() { values_.reserve(kUsual); }
  // std::nullopt stands for a value that is not known here (FN 18).
  void set(const Parameter& parameter, const std::optional<Decimal>& value);
  // A parameter that was never set is 0.
  [[nodiscard]] std::optional<Decimal> value(const Parameter& parameter) const;
  // The value of a word. A word that is given by a parameter has its own sign.
  [[nodiscard]] std::optional<Decimal> value(const Value& word) const;

 private:
  static constexpr std::size_t kUsual = 64;
  struct Entry {
    Parameter parameter;
    std::optional<Decimal> value;
  };
  std::vector<Entry> values_;
};

struct Formula {
  const char* end = nullptr;     // place after the formula; nullptr if it is not a formula
  std::optional<Decimal> value;  // std::nullopt if toolcomp does not evaluate it
  const char* beyond = nullptr;  // the reason in this case, a static text
  const char* beyond_at = nullptr;
};

// A sum of products of numbers, parameters and brackets, with + - * /, up to the end of the line or a comment. `at`:
// its first character.
Formula read_formula(const char* at, const ParameterValues& values);
// Two values with an operation between them, as in FN 1 to FN 4: + - * and DIV, which is given as /.
Formula read_operation(const char* at, char operation, const ParameterValues& values);

}  // namespace toolcomp::spec::klartext
