// SPDX-License-Identifier: Apache-2.0
// What remains of one case that was judged, and the sums of many.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "certify/certificate.h"
#include "certify/judge.h"
#include "spec/language/fields.h"

namespace toolcomp::certify {

struct CaseResult {
  Result result = Result::not_run;
  Origin origin = Origin::own;
  std::string section;
  std::string setup;  // JSON; of a case that was asked
  fuzz::Verdict verdict;
  FailureKey key;  // with `differs`
  std::string id;
  std::string why;
  std::string known_difference;  // with not_applicable, where the controller says so
  std::string picture;
  std::set<std::string> without_effect;  // words
  spec::FieldSet sent;                   // by the controller
  spec::FieldSet due;                    // as the model's events have them
};

// "golden", "generated", "own".
std::string_view name(Origin origin);

// Why a case is passed over that comes after too many faults.
inline constexpr std::string_view kLeftOut = "left out after repeated faults";

// A case that is not asked.
CaseResult not_asked(const spec::Case& c, Origin origin, Result result, std::string why);
// A case that was, with its judgement; `fields`: of the model's events.
CaseResult asked_and_judged(const spec::Case& c, Origin origin, const spec::FieldSet& fields, const Answer& answer,
                            Judgement judgement);
CaseResult asked_and_judged(const spec::Case& c, Origin origin, const fuzz::ModelRun& run, const Answer& answer,
                            Judgement judgement);

// As which it counts: of a user's own program each counts; of golden and generated cases, which go where it is steep,
// their section.
Result counted(const CaseResult& result);
// One case more in the sums of its section.
void add(SectionResult& section, const CaseResult& result);

// Fields that were announced and due, and that no answer had.
struct NeverSent {
  spec::Field field{};
  std::size_t first = 0;    // index of the first result in which it was due
  std::uint64_t cases = 0;  // in which it was
};
std::vector<NeverSent> never_sent(const std::vector<std::string>& announced, const std::vector<CaseResult>& results);

// The SHA-256 of different setups, sorted: their JSON, a line each.
std::string setups_hash(const std::set<std::string>& setups);

}  // namespace toolcomp::certify
