// SPDX-License-Identifier: Apache-2.0
// Codes that a FANUC control has and this project does not. Texts are static, and begin with the word of the program:
// "G81 (drilling, a canned cycle) is not supported" (spec::code_of).
#pragma once

#include <string_view>

#include "spec/language/decimal.h"

namespace toolcomp::spec {

// Macros of machine builders and of probing are only in the control.
inline constexpr const char* kMacroOfNoProgram = "G65 (macro call of a program that is missing) is not supported";

// The message for a G code, by its number; nullptr for a code that is not listed, because it works here or no control
// has it.
const char* code_not_supported(const Decimal& number);

// The message for text that is not a word, given from its first character in upper case without blanks: custom macros,
// ,R and ,C. nullptr for any other text.
const char* text_not_supported(std::string_view text);

}  // namespace toolcomp::spec
