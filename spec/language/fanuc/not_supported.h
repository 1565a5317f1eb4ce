// SPDX-License-Identifier: Apache-2.0
// What a FANUC control has and this project does not. Texts are static, and begin with what stands in the program:
// "G81 (drilling, a canned cycle) is not supported" (spec::code_of).
#pragma once

#include <string_view>

#include "spec/language/decimal.h"

namespace toolcomp::spec {

// Macros of machine builders and probing stand in the control alone.
inline constexpr const char* kMacroOfNoProgram = "G65 (macro call of a program that is not there) is not supported";

// Of a G code by its number; nullptr for one that is not listed: one that works here, or none of a control.
const char* code_not_supported(const Decimal& number);

// Of text that is no word, from its first character, in upper case without blanks: custom macros, ,R and ,C. nullptr
// for any other.
const char* text_not_supported(std::string_view text);

}  // namespace toolcomp::spec
