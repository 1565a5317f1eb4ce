// SPDX-License-Identifier: Apache-2.0
// The result of one judged case, and the sums of many.
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
  judge::Verdict verdict;
  FailureKey key;  // with `differs`
  std::string id;
  std::string why;
  std::string known_difference;  // with not_applicable, where the controller says so
  std::string picture;
  std::set<std::string> without_effect;  // words
  spec::FieldSet sent;                   // fields that the controller sent
  spec::FieldSet due;                    // fields that the model's events have
};

// "golden", "generated", "own".
std::string_view name(Origin origin);

// Why a case after too many faults is skipped.
inline constexpr std::string_view kLeftOut = "left out after repeated faults";

// The result of a case that is not asked.
CaseResult not_asked(const spec::Case& c, Origin origin, Result result, std::string why);
// The result of a case that was asked, with its judgement. `fields` are the fields of the model's events.
CaseResult asked_and_judged(const spec::Case& c, Origin origin, const spec::FieldSet& fields, const Answer& answer,
                            Judgement judgement);
CaseResult asked_and_judged(const spec::Case& c, Origin origin, const judge::ModelRun& run, const Answer& answer,
                            Judgement judgement);

// The result as it counts. For one of the user's own programs every case counts. For golden and generated cases, which
// probe difficult places, the section counts.
Result counted(const CaseResult& result);
// Adds a case to the sums of its section.
void add(SectionResult& section, const CaseResult& result);

// Fields that were announced and due, and that no answer had.
struct NeverSent {
  spec::Field field{};
  std::size_t first = 0;    // index of the first result in which the field was due
  std::uint64_t cases = 0;  // number of cases in which the field was due
};
std::vector<NeverSent> never_sent(const std::vector<std::string>& announced, const std::vector<CaseResult>& results);

// The SHA-256 of different setups: of their JSON, sorted, one in each line.
std::string setups_hash(const std::set<std::string>& setups);

}  // namespace toolcomp::certify
