// SPDX-License-Identifier: Apache-2.0
#include "spec/language/fanuc/macro_value.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "spec/language/decimal_arithmetic.h"
#include "spec/language/digits.h"

namespace toolcomp::spec {
namespace {

// Errors of one operation, relative but where it says otherwise: the largest of the table, rounded up. They cover the
// roundings of double here.
constexpr double kSumError = 6e-10;  // of the larger summand
constexpr double kProductError = 5e-10;
constexpr double kQuotientError = 2e-9;
constexpr double kRootError = 4e-9;
constexpr double kSineError = 1e-8;  // absolute
constexpr double kRadians = std::numbers::pi / 180;

double in_double(const Decimal& number) {
  const double value = static_cast<double>(number.digits) / static_cast<double>(kPowersOfTen[number.decimals]);
  return number.negative ? -value : value;
}

// A number of so few binary digits that every control holds it as it is.
bool is_short(const MacroValue& a) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 28U;
  if (!a.exact || a.error != 0) return false;
  std::uint64_t digits = a.exact->digits;
  for (unsigned i = 0; i < a.exact->decimals; ++i) {
    if (digits % 5 != 0) return false;
    digits /= 5;
  }
  return digits < kMost;
}

MacroValue result(const std::optional<Decimal>& exact, double value, double error, bool of_short) {
  MacroValue made{exact, exact ? in_double(*exact) : value, 0};
  if (!of_short || !is_short(made)) made.error = error;
  return made;
}

std::optional<Decimal> both(const MacroValue& a, const MacroValue& b,
                            std::optional<Decimal> (*operation)(const Decimal&, const Decimal&)) {
  return a.exact && b.exact ? operation(*a.exact, *b.exact) : std::nullopt;
}

Decimal integer(double number) {
  Decimal made;
  made.digits = static_cast<std::uint64_t>(std::fabs(number));
  made.negative = number < 0;
  return made;
}

// A whole number, by a function that goes up or down with its argument.
template <class Whole>
std::optional<MacroValue> whole(const MacroValue& a, const Whole& function) {
  constexpr double kMost = 1e15;
  const double slack = is_short(a) ? 0 : a.error + std::fabs(a.value) * 1e-15;
  const double least = function(a.value - slack);
  if (least != function(a.value + slack) || std::fabs(least) >= kMost) return std::nullopt;
  return macro_literal(integer(least));
}

double away_from_zero(double a) { return a < 0 ? std::floor(a) : std::ceil(a); }
double half_up(double a) { return a < 0 ? -std::floor(-a + 0.5) : std::floor(a + 0.5); }

}  // namespace

MacroValue macro_literal(const Decimal& number) { return {number, in_double(number), 0}; }

MacroValue negated(MacroValue a) {
  if (a.exact) a.exact = negated(*a.exact);
  a.value = -a.value;
  return a;
}

MacroValue sum(const MacroValue& a, const MacroValue& b) {
  const double error = a.error + b.error + std::max(std::fabs(a.value), std::fabs(b.value)) * kSumError;
  return result(both(a, b, sum), a.value + b.value, error, is_short(a) && is_short(b));
}

MacroValue product(const MacroValue& a, const MacroValue& b) {
  const double error = std::fabs(a.value) * b.error + std::fabs(b.value) * a.error + a.error * b.error +
                       std::fabs(a.value * b.value) * kProductError;
  return result(both(a, b, product), a.value * b.value, error, is_short(a) && is_short(b));
}

std::optional<MacroValue> quotient(const MacroValue& a, const MacroValue& b) {
  const double least = std::fabs(b.value) - b.error;
  if (!(least > 0)) return std::nullopt;
  const double value = a.value / b.value;
  const double error = (a.error + std::fabs(value) * b.error) / least + std::fabs(value) * kQuotientError;
  return result(both(a, b, quotient), value, error, is_short(a) && is_short(b));
}

std::optional<MacroValue> macro_function(std::string_view name, const MacroValue& a) {
  const double turned = std::remainder(a.value, 360.0) * kRadians;
  const double sine_error = kSineError + a.error * kRadians;
  if (name == "SIN") return MacroValue{{}, std::sin(turned), sine_error};
  if (name == "COS") return MacroValue{{}, std::cos(turned), sine_error};
  if (name == "TAN")
    return quotient(MacroValue{{}, std::sin(turned), sine_error}, MacroValue{{}, std::cos(turned), sine_error});
  if (name == "SQRT") {
    if (!(a.value - a.error >= 0)) return std::nullopt;
    const double root = std::sqrt(a.value);
    return MacroValue{{}, root, root - std::sqrt(a.value - a.error) + root * kRootError};
  }
  if (name == "ABS") return a.value < 0 ? negated(a) : a;
  if (name == "FIX") return whole(a, [](double x) { return std::trunc(x); });
  if (name == "FUP") return whole(a, away_from_zero);
  if (name == "ROUND") return whole(a, half_up);
  return std::nullopt;
}

std::optional<int> compare(const MacroValue& a, const MacroValue& b) {
  const double error = a.error + b.error;
  const double difference = a.value - b.value;
  if (const auto exact = both(a, negated(b), sum); exact && (error == 0 || std::fabs(difference) > error))
    return exact->is_zero() ? 0 : exact->negative ? -1 : 1;
  const double slack = (std::fabs(a.value) + std::fabs(b.value)) * 1e-15;
  if (!(std::fabs(difference) > error + slack)) return std::nullopt;
  return difference < 0 ? -1 : 1;
}

std::optional<Decimal> rounded(const MacroValue& a, unsigned decimals) {
  const auto unit = static_cast<double>(kPowersOfTen[decimals]);
  const auto scaled = whole({{}, a.value * unit, a.error * unit}, half_up);
  if (!scaled) return std::nullopt;
  Decimal made = *scaled->exact;
  made.decimals = static_cast<std::uint8_t>(decimals);
  return made;
}

}  // namespace toolcomp::spec
