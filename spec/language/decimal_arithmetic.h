// SPDX-License-Identifier: Apache-2.0
// Exact sums, products and quotients of numbers in a program (macro variables, Q parameters). std::nullopt if a result
// is not a decimal of at most Decimal::kMaxDigits digits.
#pragma once

#include <optional>

#include "spec/language/decimal.h"

namespace toolcomp::spec {

// Results have no trailing zeros after the point and no -0. They have a point if they have decimals.
std::optional<Decimal> sum(const Decimal& a, const Decimal& b);
std::optional<Decimal> product(const Decimal& a, const Decimal& b);
// Also std::nullopt if b is 0.
std::optional<Decimal> quotient(const Decimal& a, const Decimal& b);
// The number with the opposite sign.
constexpr Decimal negated(Decimal a) {
  a.negative = !a.negative && a.digits != 0;
  return a;
}

}  // namespace toolcomp::spec
