// SPDX-License-Identifier: Apache-2.0
// How numbers are written in events.
#pragma once

#include <string>
#include <string_view>

#include "spec/language/case.h"

namespace toolcomp::spec {

// The shortest text that reads back to the same double, as JSON has it; never -0. What is not finite is quoted, so that
// no reader takes it for a number.
void append_shortest(std::string& out, double value);
// The same without exponent, for G-code.
void append_shortest_fixed(std::string& out, double value);

// A JSON number where only v is stated, an object {"v", "r", "q"} where more is.
void append_number_text(std::string& out, const NumberText& value);

// [+-]digits[.digits][e[+-]digits], digits on one side of the point at least; `exponent` false: without one.
bool is_number_text(std::string_view text, bool exponent = true);

}  // namespace toolcomp::spec
