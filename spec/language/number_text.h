// SPDX-License-Identifier: Apache-2.0
// Writes numbers of events.
#pragma once

#include <string>
#include <string_view>

#include "spec/language/case.h"

namespace toolcomp::spec {

// The shortest text in the form of JSON that reads back to the same double; never -0. A value that is not finite is
// quoted, so that no reader takes it for a number.
void append_shortest(std::string& out, double value);
// The same without exponent, for G-code.
void append_shortest_fixed(std::string& out, double value);

// A JSON number if only v is given, an object {"v", "r", "q"} if more is given.
void append_number_text(std::string& out, const NumberText& value);

// Whether the text is [+-]digits[.digits][e[+-]digits], with digits on at least one side of the point. If `exponent` is
// false, without exponent.
bool is_number_text(std::string_view text, bool exponent = true);

}  // namespace toolcomp::spec
