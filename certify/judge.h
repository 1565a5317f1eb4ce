// SPDX-License-Identifier: Apache-2.0
// One case judged: the subject's answer against what the model permits.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "certify/subject.h"
#include "fuzz/oracle/verdict.h"
#include "spec/clauses/clauses.h"

namespace toolcomp::certify {

enum class Result : std::uint8_t {
  agrees,
  differs,         // also every fault of the controller
  undecided,       // by the oracle
  nothing_judged,  // less than the minimum, or no value at all
  not_applicable,  // to this controller
  not_run,         // left out after many faults
  partly_judged,   // agrees where it was judged, but more than policy::kMostWide of its values were not, or it goes
                   // beyond what is supported
};
inline constexpr std::size_t kResults = 7;
std::string_view name(Result result);

// Whether so many values that were granted more than policy::kCap are too many beside those judged.
bool too_many_wide(std::uint64_t values, std::uint64_t wide);
// "17 of 200 values were granted more than 1 µm: not judged".
std::string words_on_wide(std::uint64_t values, std::uint64_t wide);

// "line 12: G81 (drilling, a canned cycle) is not supported; it and what follows are not judged".
std::string words_on_beyond(const fuzz::Beyond& beyond);

struct Judgement {
  Result result = Result::nothing_judged;
  fuzz::Verdict verdict;                       // counts; the difference too
  std::optional<fuzz::Difference> difference;  // with `differs`
  std::string status;                          // with a fault: how the process ended
  std::string errors;                          // and its standard error
  std::string why;                             // with undecided, nothing_judged, partly_judged, not_applicable
  std::string known_difference;                // with not_applicable: its name, where the controller says so
};

// Two failures with one key are one finding, however different their programs: the section, the clause of the first
// divergence, and what differs. A law that is broken ("law NAME") has no clause.
struct FailureKey {
  std::string section;
  std::string clause;  // empty: none was applied before the difference
  std::string kind;
  friend auto operator<=>(const FailureKey&, const FailureKey&) = default;
};
FailureKey key_of(const spec::Case& c, const Judgement& judgement);

// The clause a fault in this program is laid to: the last one the model applies.
std::optional<spec::Clause> clause_of_fault(const fuzz::ModelRun& run);

// Asks the subject and judges its answer, exact events by hold_exactly (exactly.h), all others by the oracle; where
// these agree, the model's events are held against the laws. The clause of a missing field is the last one of its
// event. InputError of the model passes through: no control could read such a case.
Judgement judge_case(Subject& subject, const Capabilities& capabilities, const spec::Case& c, const fuzz::ModelRun& run,
                     std::optional<std::chrono::milliseconds> patience = {});
// The same with the answer given.
Judgement judge_answer(const Capabilities& capabilities, const spec::Case& c, const fuzz::ModelRun& run,
                       const Answer& answer);
// What a verdict of the oracle comes to; the clause of a difference is the oracle's.
Judgement judged(fuzz::Verdict verdict);

}  // namespace toolcomp::certify
