// SPDX-License-Identifier: Apache-2.0
// What a vector holds besides its setup and program: all of it follows from running the model.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fuzz/oracle/trial.h"
#include "spec/language/case.h"

namespace toolcomp::corpus {

// Decimals of the expected numbers; exact rational values carry their fraction besides.
inline constexpr int kDigits = 15;

// The id of a vector: its section and the first digits of the digest of setup, program and samples. The same question
// has the same id for ever, and no other question gets it.
std::string vector_id(const spec::Case& c);

// The clauses a run rests on, in the order of the clause files: those applied, and those decided by sign or found true.
std::vector<std::string> clauses_of(const model::Recorder& recorder);

// The flags (manifest.h) that the run earns. `generated-unrestricted` is the generator's to add.
std::vector<std::string> flags_of(const fuzz::Trial& trial);

// The events of a run as a vector expects them. Throws exact::Undecided where digits cannot be certified.
std::vector<spec::TextEvent> expected_events(const fuzz::ModelRun& run);

// One event as it stands in a vector.
std::string event_text(const spec::TextEvent& event, const spec::Axes& axes);

// Is this vector what the model and the fast engine say? Empty, or what is wrong: an event that differs, an engine that
// does not agree, flags or clauses that the run does not have.
std::string verify(const spec::Case& vector, const fuzz::Trial& trial);

// Runs both engines and fills in id, clauses, flags and expected events. Empty, or why it can be no vector: a setup no
// control could have, a decision or digits that cannot be certified, no event, engines that differ.
std::string complete(spec::Case& c);

}  // namespace toolcomp::corpus
