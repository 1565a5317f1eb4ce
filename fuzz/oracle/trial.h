// SPDX-License-Identifier: Apache-2.0
// One case through both engines and the judge.
#pragma once

#include <functional>
#include <string_view>

#include "fuzz/oracle/verdict.h"

namespace toolcomp::fuzz {

// Why a case was not accepted: executions are counted by it, none is dropped silently.
enum class Acceptance : std::uint8_t {
  accepted,     // at least one number was judged
  no_number,    // the run ended before the first move
  no_setup,     // a setup no control could have; both engines refuse it
  no_text,      // bytes that are no program text
  not_decided,  // the oracle could not decide
  too_long,     // calls and repeats make more blocks of it than are tried (fuzz/campaign/long_program.h)
};
inline constexpr std::size_t kAcceptances = 6;
std::string_view name(Acceptance acceptance);

struct Trial {
  Acceptance acceptance = Acceptance::no_text;
  Verdict verdict;
  ModelRun run;
  std::uint64_t law_checks = 0;  // questions that laws asked
  [[nodiscard]] bool found() const { return verdict.outcome == Outcome::differs; }
};

// Judges what a subject does with a case. The default is the fast engine.
using Subject = std::function<Verdict(const spec::Case&, const ModelRun&)>;

// Holds the model's events against the laws that know no clause (laws.h). Where one is broken, a verdict that agrees,
// or judged nothing, becomes a difference of kind "law" with the law as its field: both engines follow a wrong clause.
// Gives the number of questions asked.
std::uint64_t hold_laws(const spec::Case& c, const ModelRun& run, Verdict& verdict);

// Refusal of a setup by one engine alone, and an exception out of an engine, are differences ("setup", "exception").
Trial try_case(const spec::Case& c);
Trial try_case(const spec::Case& c, const Subject& subject);

}  // namespace toolcomp::fuzz
