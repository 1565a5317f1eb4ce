// SPDX-License-Identifier: Apache-2.0
// results.jsonl of a bundle: the result of each case, one JSON object in each line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "certify/case_result.h"

namespace toolcomp::certify::bundle {

struct Record {
  bool asked = false;  // otherwise the case was skipped
  CaseResult result;
  std::optional<Fault> fault;  // instead of a list of events
  bool cut = false;            // only the beginning of such an answer is kept
};

// One line without a line feed, the same for the same record.
std::string write_record(std::uint64_t number, const Record& record);
// The result has no setup and no picture, and only the largest of the widths. Throws spec::InputError for a line that
// is not a record with this number.
Record read_record(std::uint64_t number, std::string_view line);
// The difference of two records with the same number: "values: 12 and 13"; empty if there is none. The text of a fault
// for people is not compared.
std::string difference(const Record& a, const Record& b);

}  // namespace toolcomp::certify::bundle
