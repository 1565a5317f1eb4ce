// SPDX-License-Identifier: Apache-2.0
// Numbers of custom macros: how well the number that a control holds is known. A control computes with fewer digits
// than a decimal may have, so a result is known only within the errors of its operations (16/18 operator's manual,
// "Arithmetic and logic operation", table of errors). toolcomp does not follow what depends on more digits than that.
#pragma once

#include <optional>
#include <string_view>

#include "spec/language/decimal.h"

namespace toolcomp::spec {

struct MacroValue {
  std::optional<Decimal> exact;  // the result of exact arithmetic, if it is a decimal of at most 18 digits
  double value = 0;              // the same in double
  double error = 0;              // largest distance of the control's number from `value`; 0: the number is `exact`
};

// A number as it is written.
MacroValue macro_literal(const Decimal& number);
MacroValue negated(MacroValue a);
MacroValue sum(const MacroValue& a, const MacroValue& b);
MacroValue product(const MacroValue& a, const MacroValue& b);
// std::nullopt if b may be 0.
std::optional<MacroValue> quotient(const MacroValue& a, const MacroValue& b);
// SIN COS TAN (degrees) SQRT ABS FIX FUP ROUND; std::nullopt if the name is another one, or if the digits of the
// control decide.
std::optional<MacroValue> macro_function(std::string_view name, const MacroValue& a);

// The sign of a - b; std::nullopt if the digits of the control decide it.
std::optional<int> compare(const MacroValue& a, const MacroValue& b);
// Rounded to this many decimals, as a control rounds the word of an address; std::nullopt if the digits of the control
// decide, or if the number has more than 15 digits.
std::optional<Decimal> rounded(const MacroValue& a, unsigned decimals);

}  // namespace toolcomp::spec
