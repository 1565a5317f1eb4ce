// SPDX-License-Identifier: Apache-2.0
// Numbers of custom macros: what is known of the number that a control holds. A control computes with fewer digits than
// a decimal may have, so a result is known within the errors of its operations (16/18 operator's manual, "Arithmetic
// and logic operation", table of errors); what depends on more than that is not followed.
#pragma once

#include <optional>
#include <string_view>

#include "spec/language/decimal.h"

namespace toolcomp::spec {

struct MacroValue {
  std::optional<Decimal> exact;  // the result of exact arithmetic, where it is a decimal of at most 18 digits
  double value = 0;              // the same in double
  double error = 0;              // the control's number is at most so far from `value`; 0: it is `exact`
};

// A number as it is written.
MacroValue macro_literal(const Decimal& number);
MacroValue negated(MacroValue a);
MacroValue sum(const MacroValue& a, const MacroValue& b);
MacroValue product(const MacroValue& a, const MacroValue& b);
// Nothing where b may be 0.
std::optional<MacroValue> quotient(const MacroValue& a, const MacroValue& b);
// SIN COS TAN (degrees) SQRT ABS FIX FUP ROUND; nothing where the name is another, or the control's digits decide.
std::optional<MacroValue> macro_function(std::string_view name, const MacroValue& a);

// The sign of a - b; nothing where the control's digits decide it.
std::optional<int> compare(const MacroValue& a, const MacroValue& b);
// Rounded to this many decimals, as a control rounds the word of an address; nothing where its digits decide, or where
// the number has more than 15.
std::optional<Decimal> rounded(const MacroValue& a, unsigned decimals);

}  // namespace toolcomp::spec
