// SPDX-License-Identifier: Apache-2.0
// What a FANUC control has and this project does not, by name. Texts are static: "G81 (drilling cycle) is not
// supported".
#pragma once

#include <cstdint>
#include <string_view>

#include "spec/language/fanuc/block.h"

namespace toolcomp::spec {

// Of a G code in tenths (G43.4 is 434); nullptr for one that is not listed: one that works here, or none of a control.
const char* code_not_supported(std::uint64_t tenths);

// Of text that is no word, from its first character, in upper case without blanks: custom macros, ,R and ,C. nullptr
// for any other.
const char* text_not_supported(std::string_view text);

// The word of such a code, the first one; nullptr where the block has none.
const Word* word_not_supported(const Block& block);

// Of the block: its fault, or its first code; nullptr where it has nothing of the kind. What a control does in it, and
// from there on, is not known here.
const char* not_supported(const Block& block);

}  // namespace toolcomp::spec
