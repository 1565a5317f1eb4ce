// SPDX-License-Identifier: Apache-2.0
// Reads numbers of usual lines. Internal to the readers of programs.
#pragma once

#include <cstdint>

#include "spec/language/digits.h"

namespace toolcomp::spec {

// The form of a number: so many digits before and after its point, and what it counts.
struct ColumnForm {
  unsigned before = 0;  // at most 7
  unsigned after = 0;   // at most 8
  unsigned places = 0;  // it counts 10^-places
};

// [+-]digits[.digits] as a whole number; returns the place after it, or nullptr if it is or may be any other number.
// Reads kDigitsRead bytes more.
template <ColumnForm kForm>
[[gnu::always_inline]] inline const char* read_column_number(const char* at, double& to) {
  const bool negative = *at == '-';
  at += negative || *at == '+' ? 1 : 0;  // without a branch: signs follow no pattern
  std::int64_t value = 0;
  if (const ShortDecimal number = short_decimal_at(at);
      number.size != 0 && (kForm.after >= 6 || number.decimals <= kForm.after) &&
      (kForm.before >= 6 || number.size - number.decimals <= kForm.before + 1)) [[likely]] {
    value = static_cast<std::int64_t>(number.digits * kPowersOfTen[kForm.places - number.decimals]);
    at += number.size;
  } else {
    const Digits before = digits_at(at);
    at += before.count;
    value = static_cast<std::int64_t>(before.number * kPowersOfTen[kForm.places]);
    unsigned count = before.count;
    if (*at == '.') {
      Digits behind = digits_at(++at);
      if constexpr (kForm.after > 7)
        if (behind.count == 8) behind.number = number_of(bytes_at(at));
      if (behind.count > kForm.after) [[unlikely]]
        return nullptr;
      at += behind.count;
      value += static_cast<std::int64_t>(behind.number * kPowersOfTen[kForm.places - behind.count]);
      count += behind.count;
    }
    if (count == 0 || before.count > kForm.before) [[unlikely]]
      return nullptr;
  }
  to = static_cast<double>(negative ? -value : value);
  return at;
}

}  // namespace toolcomp::spec
