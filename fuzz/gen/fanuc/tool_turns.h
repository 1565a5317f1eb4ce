// SPDX-License-Identifier: Apache-2.0
// Choices and words of a turning tool that generators have in common.
#pragma once

#include <array>

#include "fuzz/gen/choices.h"
#include "fuzz/gen/fanuc/program_writer.h"
#include "fuzz/gen/fanuc/tool_direction.h"

namespace toolcomp::fuzz {

// Any signs; mostly upward.
SpaceCounts of_any_sense(Choices& choose, SpaceCounts direction);

// I J K: whole numbers where they are small, else counts. A zero is written in `zeros` of a hundred.
void direction_words(Choices& choose, ProgramWriter& write, const SpaceCounts& whole, std::uint64_t zeros);

// Where a rotary axis may turn, in counts. Weights: multiples of 15, 90 and 45 degrees, anything up to 60 degrees, a
// little from where it is, whole degrees from there.
std::int64_t rotary_target(Choices& choose, const ProgramWriter& write, char letter, const std::array<int, 6>& weights);

}  // namespace toolcomp::fuzz
