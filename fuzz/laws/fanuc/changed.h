// SPDX-License-Identifier: Apache-2.0
// FANUC programs changed in a way whose effect geometry knows. What each law says: changed_program.h.
#pragma once

#include "fuzz/laws/changed_program.h"

namespace toolcomp::fuzz::laws {

// value-zero: H, D and 19666 are zero.
void no_offsets(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding);

void mirrored(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding);
void quarter_turn(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding);
void a_tenth(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding);
void reversed(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding);

// Where the run is left open, or ends at a range of the offset memory.
bool is_open(std::span<const model::Event> events);

}  // namespace toolcomp::fuzz::laws
