// SPDX-License-Identifier: Apache-2.0
// Sums, products and quotients of decimals are those of exact fractions, and are there exactly where a decimal of at
// most 18 digits is.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <optional>

#include "model/basis/number.h"
#include "spec/language/decimal_arithmetic.h"

namespace {

using namespace toolcomp;
using exact::Rational;
using spec::Decimal;

Decimal any_decimal() {
  const auto digits = *rc::gen::oneOf(rc::gen::inRange<std::uint64_t>(0, 1000),
                                      rc::gen::inRange<std::uint64_t>(0, 1'000'000'000'000'000'000));
  const auto decimals = *rc::gen::inRange(0, 19);
  return {digits, static_cast<std::uint8_t>(decimals), digits != 0 && *rc::gen::arbitrary<bool>(), decimals > 0};
}

// Whether the fraction is a decimal of so many digits.
bool is_decimal(const Rational& value) {
  Rational scaled = value < 0 ? Rational(-value) : value;
  for (int decimals = 0; decimals <= Decimal::kMaxDigits; ++decimals, scaled *= 10)
    if (denominator(scaled) == 1) return numerator(scaled) < 1'000'000'000'000'000'000;
  return false;
}

void expect(const std::optional<Decimal>& result, const Rational& value) {
  RC_ASSERT(result.has_value() == is_decimal(value));
  if (!result) return;
  RC_ASSERT(model::plain(*result) == value);
  RC_ASSERT(!(result->is_zero() && result->negative));
}

RC_GTEST_PROP(DecimalArithmetic, IsThatOfFractions, ()) {
  const Decimal a = any_decimal();
  const Decimal b = any_decimal();
  const Rational x = model::plain(a);
  const Rational y = model::plain(b);
  expect(sum(a, b), x + y);
  expect(sum(a, negated(b)), x - y);
  expect(product(a, b), x * y);
  if (y == 0)
    RC_ASSERT(!quotient(a, b));
  else
    expect(quotient(a, b), x / y);
}

}  // namespace
