// SPDX-License-Identifier: Apache-2.0
// Judges one case: compares the subject's answer with what the model permits.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "certify/subject.h"
#include "judge/oracle/verdict.h"
#include "spec/clauses/clauses.h"

namespace toolcomp::certify {

enum class Result : std::uint8_t {
  agrees,
  differs,         // also every fault of the controller
  undecided,       // by the oracle
  nothing_judged,  // less than the minimum is announced, or there is no value at all
  not_applicable,  // to this controller
  not_run,         // left out after many faults
  partly_judged,   // agrees in what was judged, but more than policy::kMostWide of its values were not judged, or it
                   // goes beyond what is supported
};
inline constexpr std::size_t kResultCount = 7;
std::string_view name(Result result);

// Whether too many values are wide, that is, were granted more than policy::kCap, compared with those that were judged.
bool too_many_wide(std::uint64_t values, std::uint64_t wide);
// "17 of 200 values were granted more than 1 µm, and were not judged".
std::string words_on_wide(std::uint64_t values, std::uint64_t wide);

// "line 12: G81 (drilling, a canned cycle) is not supported; this block and the blocks after it are not judged".
std::string words_on_beyond(const judge::Beyond& beyond);

struct Judgement {
  Result result = Result::nothing_judged;
  judge::Verdict verdict;              // counts, and the difference
  std::optional<spec::Clause> clause;  // with `differs`: that of the difference, or the last one before its event
  std::string status;                  // with a fault: how the process ended
  std::string errors;                  // and its standard error
  std::string why;                     // with undecided, nothing_judged, partly_judged, not_applicable
  std::string known_difference;        // with not_applicable: its name, where the controller says so

  // With `differs`: the difference, attributed to `clause`.
  [[nodiscard]] std::optional<judge::Difference> difference() const;
};

// Two failures with the same key are one finding, even if their programs differ. The key has the section, the clause of
// the first divergence, and what differs. A broken law ("law NAME") has no clause.
struct FailureKey {
  std::string section;
  std::string clause;  // empty: no clause was applied before the difference
  std::string kind;
  friend auto operator<=>(const FailureKey&, const FailureKey&) = default;
};
FailureKey key_of(const spec::Case& c, const judge::Difference& difference);
// Without a difference it has the section alone.
FailureKey key_of(const spec::Case& c, const Judgement& judgement);

// The clause to which a fault in this program is attributed: the last one that the model applies.
std::optional<spec::Clause> clause_of_fault(const judge::ModelRun& run);

// Asks the subject and judges its answer. Exact events are judged by hold_exactly (exactly.h), all others by the
// oracle. If these agree, the laws are checked on the model's events. The clause of a missing field is the last one of
// its event. An InputError of the model passes through, because no control could read such a case.
Judgement judge_case(Subject& subject, const Capabilities& capabilities, const spec::Case& c,
                     const judge::ModelRun& run, std::optional<std::chrono::milliseconds> patience = {});
// The same for a given answer.
Judgement judge_answer(const Capabilities& capabilities, const spec::Case& c, const judge::ModelRun& run,
                       const Answer& answer);
// The judgement that follows from a verdict of the oracle. The oracle gives the clause of a difference.
Judgement judged(judge::Verdict verdict);

}  // namespace toolcomp::certify
