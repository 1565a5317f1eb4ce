// SPDX-License-Identifier: Apache-2.0
// Programs that end early, changed so that more of them is judged.
#pragma once

#include "fuzz/gen/choices.h"

namespace toolcomp::fuzz {

// Events a directed case is to have before it ends.
inline constexpr std::size_t kFewestEvents = 3;

// Moves the block in which a run of the model ends to the end of the program while that block stands in the first half
// or before the third event, a few times at most. Whether the run has kFewestEvents then.
bool put_fault_last(spec::Case& c);

}  // namespace toolcomp::fuzz
