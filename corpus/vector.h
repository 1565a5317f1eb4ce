// SPDX-License-Identifier: Apache-2.0
// The parts of a vector other than setup and program. All of them follow from a run of the model.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "judge/oracle/trial.h"
#include "spec/language/case.h"

namespace toolcomp::corpus {

// Decimals of the expected numbers. Exact rational values also have their fraction.
inline constexpr int kDigits = 15;

// The id of a vector: its section and the first digits of the digest of setup, program and samples. The same question
// always has the same id, and no other question gets it.
std::string vector_id(const spec::Case& c);

// The clauses that a run rests on, in the order of the clause files: clauses that were applied, and clauses that were
// decided by sign or found true.
std::vector<std::string> clauses_of(const model::Recorder& recorder);

// The flags (manifest.h) that follow from the run. The generator adds `generated-unrestricted`.
std::vector<std::string> flags_of(const judge::Trial& trial);

// The events of a run as a vector expects them. Throws exact::Undecided if digits cannot be certified.
std::vector<spec::TextEvent> expected_events(const judge::ModelRun& run);

// One event in the form of a vector.
std::string event_text(const spec::TextEvent& event, const spec::Axes& axes);

// Checks a vector against the model and the fast engine. Returns an empty text, or what is wrong: an event that
// differs, an engine that does not agree, flags or clauses that the run does not have.
std::string verify(const spec::Case& vector, const judge::Trial& trial);

// Runs both engines and fills in id, clauses, flags and expected events. Returns an empty text, or why the case cannot
// be a vector: a setup that no control could have, a decision or digits that cannot be certified, no event, engines
// that differ.
std::string complete(spec::Case& c);

}  // namespace toolcomp::corpus
