// SPDX-License-Identifier: Apache-2.0
// Changes to a case: blocks, words, digits, setup values.
#pragma once

#include "fuzz/gen/generator.h"

namespace toolcomp::fuzz {

// Up to four small changes; directed ones are two at most, keep numbers well formed and mostly the words as they are.
void mutate(spec::Case& c, Mode mode, ChoiceSource& source);
// Setup and first blocks of `a` with last blocks of `b`.
spec::Case splice(const spec::Case& a, const spec::Case& b, ChoiceSource& source);

}  // namespace toolcomp::fuzz
