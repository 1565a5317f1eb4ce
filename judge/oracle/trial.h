// SPDX-License-Identifier: Apache-2.0
// Runs one case through both engines and the judge.
#pragma once

#include <functional>
#include <string_view>

#include "judge/oracle/verdict.h"

namespace toolcomp::judge {

// Whether a case was accepted, and if not, why. Executions are counted by it, and none is dropped silently.
enum class Acceptance : std::uint8_t {
  accepted,     // at least one number was judged
  no_number,    // the run ended before the first move
  no_setup,     // a setup that no control could have; both engines refuse it
  no_text,      // bytes that are not the text of a program
  not_decided,  // the oracle could not decide
  too_long,     // calls and repeats give more blocks than a campaign tries
};
inline constexpr std::size_t kAcceptances = 6;
std::string_view name(Acceptance acceptance);

struct Trial {
  Acceptance acceptance = Acceptance::no_text;
  Verdict verdict;
  ModelRun run;
  std::uint64_t law_checks = 0;  // number of law checks
  [[nodiscard]] bool found() const { return verdict.outcome == Outcome::differs; }
};

// Judges what a controller answers to a case. An empty one stands for the fast engine.
using CaseJudge = std::function<Verdict(const spec::Case&, const ModelRun&)>;

// Checks the laws on the model's events (laws.h). If a law is broken, a verdict that agrees, or judged nothing, becomes
// a difference of kind "law" with the law as its field: both engines follow a wrong clause. Returns the number of
// checks.
std::uint64_t hold_laws(const spec::Case& c, const ModelRun& run, Verdict& verdict);

// If only one engine refuses a setup, or if an engine throws an exception, this is a difference ("setup", "exception").
Trial try_case(const spec::Case& c);
Trial try_case(const spec::Case& c, const CaseJudge& judged_by);

}  // namespace toolcomp::judge
