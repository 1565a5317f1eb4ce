// SPDX-License-Identifier: Apache-2.0
#include "spec/language/heidenhain/klartext_formula.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "spec/language/decimal_arithmetic.h"
#include "spec/language/heidenhain/klartext_words.h"

namespace toolcomp::spec::klartext {
namespace {

constexpr int kDeepest = 8;  // brackets in brackets

struct Function {
  std::string_view name;
  const char* beyond;
};
constexpr auto kFunctions = std::to_array<Function>({
    {"SIN", "SIN (in a formula) is not supported"},
    {"COS", "COS (in a formula) is not supported"},
    {"TAN", "TAN (in a formula) is not supported"},
    {"ASIN", "ASIN (in a formula) is not supported"},
    {"ACOS", "ACOS (in a formula) is not supported"},
    {"ATAN", "ATAN (in a formula) is not supported"},
    {"SQRT", "SQRT (in a formula) is not supported"},
    {"SQ", "SQ (in a formula) is not supported"},
    {"LN", "LN (in a formula) is not supported"},
    {"LOG", "LOG (in a formula) is not supported"},
    {"EXP", "EXP (in a formula) is not supported"},
    {"NEG", "NEG (in a formula) is not supported"},
    {"INT", "INT (in a formula) is not supported"},
    {"ABS", "ABS (in a formula) is not supported"},
    {"FRAC", "FRAC (in a formula) is not supported"},
    {"SGN", "SGN (in a formula) is not supported"},
    {"PI", "PI (in a formula) is not supported"},
});

class Reader {
 public:
  Reader(const char* at, const ParameterValues& values) : at_(at), values_(values) {}

  Formula formula() {
    const std::optional<Decimal> value = sum_of_products(kDeepest);
    if (bad_ || !at_end()) return {};
    return {at_, value, beyond_, beyond_at_};
  }
  Formula operation(char operation) {
    const std::optional<Decimal> first = operand(0);
    blanks();
    if (const char* const end = operation == '/' ? read_word(at_, "DIV") : *at_ == operation ? at_ + 1 : nullptr)
      at_ = end;
    else
      bad_ = true;
    const std::optional<Decimal> second = operand(0);
    if (bad_) return {};
    const std::optional<Decimal> value = combined(first, operation, second);
    return {at_, value, beyond_, beyond_at_};
  }

 private:
  void blanks() {
    while (is_blank(*at_)) ++at_;
  }
  bool at_end() {
    blanks();
    return *at_ == '\n' || *at_ == ';';
  }
  std::optional<Decimal> refuse(const char* at, const char* why) {
    if (beyond_ == nullptr) beyond_ = why, beyond_at_ = at;
    return std::nullopt;
  }
  std::optional<Decimal> fail() {
    bad_ = true;
    return std::nullopt;
  }

  std::optional<Decimal> combined(const std::optional<Decimal>& a, char operation, const std::optional<Decimal>& b) {
    if (!a || !b) return std::nullopt;
    const std::optional<Decimal> result = operation == '*'   ? product(*a, *b)
                                          : operation == '/' ? quotient(*a, *b)
                                          : operation == '-' ? sum(*a, negated(*b))
                                                             : sum(*a, *b);
    return result ? result
                  : refuse(at_, "Q = (a formula whose value is not a decimal of at most 18 digits) is not supported");
  }

  std::optional<Decimal> sum_of_products(int depth) {
    std::optional<Decimal> value = products(depth);
    for (blanks(); !bad_ && (*at_ == '+' || *at_ == '-'); blanks()) {
      const char operation = *at_++;
      value = combined(value, operation, products(depth));
    }
    return value;
  }
  std::optional<Decimal> products(int depth) {
    std::optional<Decimal> value = operand(depth);
    for (blanks(); !bad_ && (*at_ == '*' || *at_ == '/' || *at_ == '^'); blanks()) {
      const char operation = *at_++;
      const std::optional<Decimal> factor = operand(depth);
      value = operation == '^' ? refuse(at_, "^ (in a formula) is not supported") : combined(value, operation, factor);
    }
    return value;
  }
  std::optional<Decimal> operand(int depth) {
    blanks();
    if (*at_ == '(') {
      if (depth == 0) return refuse(at_, "( (nested too deep in a formula) is not supported"), fail();
      ++at_;
      const std::optional<Decimal> inner = sum_of_products(depth - 1);
      blanks();
      if (bad_ || *at_ != ')') return fail();
      ++at_;
      return inner;
    }
    if ((*at_ == '-' || *at_ == '+') && (is_blank(at_[1]) || at_[1] == '(')) {
      const bool negative = *at_++ == '-';
      const std::optional<Decimal> value = operand(depth);
      return value && negative ? negated(*value) : value;
    }
    for (const Function& function : kFunctions)
      if (const char* const end = read_word(at_, function.name)) {
        refuse(at_, function.beyond);
        at_ = end;
        if (function.name != "PI") operand(depth);
        return std::nullopt;
      }
    Value word;
    const char* const end = read_value(at_, word);
    if (end == nullptr) return fail();
    const char* const begin = at_;
    at_ = end;
    const std::optional<Decimal> value = values_.value(word);
    return value ? value : refuse(begin, "Q (set by FN 18) is not supported");
  }

  const char* at_;
  const ParameterValues& values_;
  bool bad_ = false;
  const char* beyond_ = nullptr;
  const char* beyond_at_ = nullptr;
};

}  // namespace

void ParameterValues::set(const Parameter& parameter, const std::optional<Decimal>& value) {
  const auto found = std::ranges::find(values_, parameter, &Entry::parameter);
  if (found == values_.end())
    values_.push_back({parameter, value});
  else
    found->value = value;
}

std::optional<Decimal> ParameterValues::value(const Parameter& parameter) const {
  const auto found = std::ranges::find(values_, parameter, &Entry::parameter);
  return found == values_.end() ? Decimal() : found->value;
}

std::optional<Decimal> ParameterValues::value(const Value& word) const {
  if (word.parameter.kind == ParameterKind::none) return word.number;
  const std::optional<Decimal> found = value(word.parameter);
  return found && word.number.negative ? negated(*found) : found;
}

Formula read_formula(const char* at, const ParameterValues& values) { return Reader(at, values).formula(); }

Formula read_operation(const char* at, char operation, const ParameterValues& values) {
  return Reader(at, values).operation(operation);
}

}  // namespace toolcomp::spec::klartext
