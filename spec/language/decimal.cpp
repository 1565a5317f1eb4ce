// SPDX-License-Identifier: Apache-2.0
#include "spec/language/decimal.h"

namespace toolcomp::spec {

std::optional<Decimal> parse_decimal(std::string_view text) {
  Decimal value;
  if (!text.empty() && (text.front() == '+' || text.front() == '-')) {
    value.negative = text.front() == '-';
    text.remove_prefix(1);
  }
  bool any_digit = false;
  int significant = 0;  // leading zeros of the integer part do not count
  for (const char c : text) {
    if (c == '.') {
      if (value.point) return std::nullopt;
      value.point = true;
      continue;
    }
    if (c < '0' || c > '9') return std::nullopt;
    any_digit = true;
    if (significant > 0 || c != '0' || value.point) ++significant;
    if (significant > Decimal::kMaxDigits) return std::nullopt;
    value.digits = value.digits * 10 + static_cast<std::uint64_t>(c - '0');
    if (value.point) ++value.decimals;
  }
  if (!any_digit) return std::nullopt;
  return value;
}

std::optional<std::uint32_t> parse_small_number(std::string_view text, std::uint64_t most) {
  const std::optional<Decimal> value = parse_decimal(text);
  if (!value || value->digits > most || std::to_string(value->digits) != text) return std::nullopt;
  return static_cast<std::uint32_t>(value->digits);
}

std::string to_string(const Decimal& value) {
  std::string digits = std::to_string(value.digits);
  if (value.decimals > 0) {
    if (value.digits == 0) digits.clear();
    if (digits.size() < value.decimals) digits.insert(0, value.decimals - digits.size(), '0');
    digits.insert(digits.size() - value.decimals, 1, '.');
  } else if (value.point) {
    digits += '.';
  }
  return value.negative ? '-' + digits : digits;
}

}  // namespace toolcomp::spec
