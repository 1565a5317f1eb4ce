// SPDX-License-Identifier: Apache-2.0
// A decimal number as it was written. It is exact, and has no arithmetic.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace toolcomp::spec {

// The number (-1)^negative * digits * 10^-decimals, as written: the sign of -0, trailing zeros and the presence of a
// decimal point survive. At most kMaxDigits digits, so `digits` never overflows.
struct Decimal {
  static constexpr int kMaxDigits = 18;

  std::uint64_t digits = 0;
  std::uint8_t decimals = 0;  // digits after the point
  bool negative = false;
  bool point = false;  // a decimal point was written

  [[nodiscard]] constexpr bool is_zero() const { return digits == 0; }
  [[nodiscard]] constexpr bool is_integer() const { return decimals == 0; }
  friend constexpr bool operator==(const Decimal&, const Decimal&) = default;
};

// Reads [+-]digits[.digits] or [+-].digits. std::nullopt if `text` is anything else or has more than kMaxDigits digits.
std::optional<Decimal> parse_decimal(std::string_view text);

// Reads a number without sign, point and leading zeros, at most `most`, which must fit in a std::uint32_t.
std::optional<std::uint32_t> parse_small_number(std::string_view text, std::uint64_t most);

// The shortest text that parse_decimal reads back to the same Decimal.
std::string to_string(const Decimal& value);

// A Decimal from an integer, for tests and generators.
constexpr Decimal decimal(std::int64_t value) {
  return {value < 0 ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value), 0, value < 0, false};
}

}  // namespace toolcomp::spec
