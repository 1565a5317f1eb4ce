// SPDX-License-Identifier: Apache-2.0
// Sums, products and quotients of numbers in a program (macro variables, Q parameters), exactly. Nothing where a result
// is no decimal of at most Decimal::kMaxDigits digits.
#pragma once

#include <optional>

#include "spec/language/decimal.h"

namespace toolcomp::spec {

// Results have no trailing zeros behind the point, no -0, and a point where they have decimals.
std::optional<Decimal> sum(const Decimal& a, const Decimal& b);
std::optional<Decimal> product(const Decimal& a, const Decimal& b);
// Nothing where b is 0, too.
std::optional<Decimal> quotient(const Decimal& a, const Decimal& b);
// A number with the other sign.
constexpr Decimal negated(Decimal a) {
  a.negative = !a.negative && a.digits != 0;
  return a;
}

}  // namespace toolcomp::spec
