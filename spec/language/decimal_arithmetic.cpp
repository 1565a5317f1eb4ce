// SPDX-License-Identifier: Apache-2.0
#include "spec/language/decimal_arithmetic.h"

#include <algorithm>

namespace toolcomp::spec {
namespace {

__extension__ using Wide = __int128;  // products of two numbers, and sums of one with the decimals of the other

constexpr Wide kLimit = 1'000'000'000'000'000'000;  // 10^Decimal::kMaxDigits

Wide power_of_ten(int exponent) {
  Wide power = 1;
  for (; exponent > 0; --exponent) power *= 10;
  return power;
}

Wide signed_digits(const Decimal& a) { return a.negative ? -Wide{a.digits} : Wide{a.digits}; }

// digits * 10^-decimals.
std::optional<Decimal> decimal_of(Wide digits, int decimals) {
  const bool negative = digits < 0;
  if (negative) digits = -digits;
  for (; decimals > 0 && digits % 10 == 0; --decimals) digits /= 10;
  for (; decimals < 0 && digits < kLimit; ++decimals) digits *= 10;
  if (digits >= kLimit || decimals > Decimal::kMaxDigits) return std::nullopt;
  return Decimal{static_cast<std::uint64_t>(digits), static_cast<std::uint8_t>(decimals), negative, decimals > 0};
}

}  // namespace

std::optional<Decimal> sum(const Decimal& a, const Decimal& b) {
  const int decimals = std::max(a.decimals, b.decimals);
  return decimal_of(
      signed_digits(a) * power_of_ten(decimals - a.decimals) + signed_digits(b) * power_of_ten(decimals - b.decimals),
      decimals);
}

std::optional<Decimal> product(const Decimal& a, const Decimal& b) {
  return decimal_of(signed_digits(a) * signed_digits(b), a.decimals + b.decimals);
}

std::optional<Decimal> quotient(const Decimal& a, const Decimal& b) {
  if (b.is_zero()) return std::nullopt;
  const Wide divisor = signed_digits(b);
  Wide dividend = signed_digits(a);
  // A decimal quotient of so few digits ends after that many places.
  for (int places = 0; places <= Decimal::kMaxDigits; ++places, dividend *= 10)
    if (dividend % divisor == 0) return decimal_of(dividend / divisor, a.decimals + places - b.decimals);
  return std::nullopt;
}

}  // namespace toolcomp::spec
