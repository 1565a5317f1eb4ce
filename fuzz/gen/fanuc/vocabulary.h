// SPDX-License-Identifier: Apache-2.0
// Words at random.
#pragma once

#include <string>
#include <string_view>

#include "fuzz/gen/choices.h"
#include "spec/language/setup.h"

namespace toolcomp::fuzz {

// A word of these sections, those of `section` among them, with a well-formed number.
std::string any_word(Choices& choose, const spec::Setup& setup, std::string_view section);
// Any letter with a number that may be wrong: two points, signs, too many digits, none.
std::string odd_word(Choices& choose);
// A number beside the usual: zero, -0, one increment, the limits of what can be written.
std::string boundary_number(Choices& choose);

}  // namespace toolcomp::fuzz
