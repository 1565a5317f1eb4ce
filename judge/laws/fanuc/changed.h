// SPDX-License-Identifier: Apache-2.0
// FANUC programs changed in a way whose effect geometry knows. What each law says: changed_program.h.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "judge/laws/changed_program.h"
#include "spec/language/fanuc/block.h"

namespace toolcomp::judge::laws {

// value-zero: H, D and 19666 are zero.
void no_offsets(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding);

void mirrored(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding);
void quarter_turn(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding);
void a_tenth(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding);
void reversed(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding);

void moved_origins(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding);
// Whether the program selects another workpiece system than the first.
bool selects_a_system(const spec::Case& c);

void cut_at_a_stop(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding);
// Whether a program with a compensation has an M00 or M01.
bool stops_in_compensation(const spec::Case& c);

// A word of the block of this index (FanucProgram) in the changed program; nothing where it cannot be written.
using ChangedWord = std::function<std::optional<spec::Word>(std::size_t, const spec::Block&, const spec::Word&)>;
// The program with every word changed, every block in its line, up to the first that cannot be read; nothing where a
// word cannot be written, two blocks share a line, or programs are called (blocks run in another order than they
// stand).
std::optional<std::string> rewritten(const spec::Case& c, const ChangedWord& changed);

// The same kind of event, at the same place.
bool is_alike(const model::Event& a, const model::Event& b);

// Where the run is left open, or ends at a range of the offset memory.
bool is_open(std::span<const model::Event> events);

}  // namespace toolcomp::judge::laws
