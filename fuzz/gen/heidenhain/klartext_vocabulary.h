// SPDX-License-Identifier: Apache-2.0
// Klartext words and statements at random.
#pragma once

#include <string>

#include "fuzz/gen/choices.h"
#include "spec/language/setup.h"

namespace toolcomp::fuzz {

// A word of a motion block.
std::string any_klartext_word(Choices& choose);
// A whole statement, mostly well formed.
std::string any_klartext_statement(Choices& choose, const spec::Setup& setup);
// Text that looks like Klartext: wrong numbers, broken keys, bytes of other kinds.
std::string odd_klartext(Choices& choose);

}  // namespace toolcomp::fuzz
