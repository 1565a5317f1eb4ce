// Changes to a case: blocks, words, digits, setup values.
#pragma once

#include "fuzz/gen/generator.h"

namespace toolcomp::fuzz {

// One to four small changes; directed changes use the words of the section and keep numbers well formed.
void mutate(spec::Case& c, Mode mode, ChoiceSource& source);
// Setup and first blocks of `a` with last blocks of `b`.
spec::Case splice(const spec::Case& a, const spec::Case& b, ChoiceSource& source);

}  // namespace toolcomp::fuzz
