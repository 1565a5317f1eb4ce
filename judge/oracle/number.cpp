// SPDX-License-Identifier: Apache-2.0
#include "judge/oracle/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "judge/oracle/policy.h"

namespace toolcomp::judge {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Upwards to double: the conversion of a rational is to nearest or truncates, so one step more is enough.
double upwards(const exact::Rational& value) { return value == 0 ? 0 : std::nextafter(value.to_double(), kInfinity); }

double middle(const exact::DoubleEnclosure& e) { return e.lower + (e.upper - e.lower) / 2; }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

double outside(const exact::Real& exact, double actual) {
  if (!std::isfinite(actual)) return kInfinity;
  const exact::DoubleEnclosure e = exact.double_enclosure();
  if (actual < e.lower) return std::nextafter(e.lower - actual, kInfinity);
  if (actual > e.upper) return std::nextafter(actual - e.upper, kInfinity);
  return 0;
}

double outside(const exact::Real& exact, const exact::Rational& actual) {
  if (exact.is_rational()) return upwards(abs(exact::Rational(actual - exact.rational())));
  const exact::Enclosure e = exact.enclosure();
  if (actual < e.lower) return upwards(e.lower - actual);
  if (actual > e.upper) return upwards(actual - e.upper);
  return 0;
}

double outside_at_most(const exact::Real& exact, double actual) {
  if (!std::isfinite(actual)) return kInfinity;
  const exact::DoubleEnclosure e = exact.rough_enclosure();
  // What may be 0 is to be proven to be: events then say so.
  if (e.lower <= 0 && e.upper >= 0) return kInfinity;
  return std::nextafter(std::max(std::fabs(actual - e.lower), std::fabs(actual - e.upper)), kInfinity);
}

double outside_at_most(const exact::Real& /*exact*/, const exact::Rational& /*actual*/) { return kInfinity; }

double signed_distance(const exact::Real& exact, double actual) {
  if (!std::isfinite(actual)) return actual;
  return signed_distance(exact, exact::Rational(actual));
}

double signed_distance(const exact::Real& exact, const exact::Rational& actual) {
  return approximate(exact::Real(actual) - exact);
}

bool is_finite(double x) { return std::isfinite(x); }
bool is_finite(const exact::Rational&) { return true; }

double approximate(const exact::Real& exact) { return middle(exact.double_enclosure()); }

double roughly(const exact::Real& exact) {
  const exact::DoubleEnclosure rough = exact.rough_enclosure();
  const double size = std::min(std::fabs(rough.lower), std::fabs(rough.upper));
  return rough.upper - rough.lower <= policy::kWellKnown * size ? middle(rough) : approximate(exact);
}

double approximate(const spec::Decimal& value) {
  const double magnitude = static_cast<double>(value.digits) / std::pow(10.0, value.decimals);
  return value.negative ? -magnitude : magnitude;
}

std::string text(const exact::Real& exact) {
  try {
    return exact.decimal(15);
  } catch (const exact::Undecided&) {
    return fmt::format("about {}", approximate(exact));
  }
}

std::string text(double actual) { return fmt::format("{}", actual); }

std::string text(const exact::Rational& actual) { return text(exact::Real(actual)); }

bool is_decimal(const exact::Rational& value) {
  exact::Integer rest = denominator(value);
  for (const int prime : {2, 5})
    while (rest % prime == 0) rest /= prime;
  return rest == 1;
}

std::optional<exact::Rational> parse_number(std::string_view text) {
  constexpr std::size_t max_length = 1000;
  constexpr int max_exponent = 400;
  if (text.size() > max_length) return std::nullopt;
  std::size_t at = 0;
  const bool negative = at < text.size() && text[at] == '-';
  if (negative) ++at;
  std::string digits;
  int exponent = 0;
  for (; at < text.size() && is_digit(text[at]); ++at) digits += text[at];
  if (digits.empty()) return std::nullopt;
  if (at < text.size() && text[at] == '.') {
    const std::size_t first = ++at;
    for (; at < text.size() && is_digit(text[at]); ++at) digits += text[at];
    if (at == first) return std::nullopt;
    exponent = -static_cast<int>(at - first);
  }
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    const bool down = at < text.size() && text[at] == '-';
    if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
    const std::size_t first = at;
    int written = 0;
    for (; at < text.size() && is_digit(text[at]); ++at) {
      written = written * 10 + (text[at] - '0');
      if (written > max_exponent) return std::nullopt;
    }
    if (at == first) return std::nullopt;
    exponent += down ? -written : written;
  }
  if (at != text.size()) return std::nullopt;
  exact::Rational value{exact::Integer(digits)};
  const exact::Integer power = exact::power_of_ten(static_cast<unsigned>(std::abs(exponent)));
  if (exponent < 0)
    value /= exact::Rational(power);
  else
    value *= exact::Rational(power);
  return negative ? exact::Rational(-value) : value;
}

}  // namespace toolcomp::judge
