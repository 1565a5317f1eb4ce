// SPDX-License-Identifier: Apache-2.0
// A mutation that knows the exact model: it pushes a decision toward its boundary.
#pragma once

#include "fuzz/gen/choices.h"
#include "spec/language/case.h"

namespace toolcomp::fuzz {

// Moves one number of the case so that one of the decisions by sign that the model takes lies nearer to its boundary,
// or behind it. Asks the model some ten times. False where it found none, or where the case is larger than what is
// searched (numbers.h): then it is as it was. A case on which the model throws is taken as it is: whoever executes it
// will see that too.
bool push_toward_boundary(spec::Case& c, Choices& choose);

}  // namespace toolcomp::fuzz
