// SPDX-License-Identifier: Apache-2.0
// results.jsonl of a bundle: what is said of each case, a JSON object a line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "certify/case_result.h"

namespace toolcomp::certify::bundle {

struct Record {
  bool asked = false;  // else the case was passed over
  CaseResult result;
  std::optional<Fault> fault;  // in place of a list of events
  bool cut = false;            // of such an answer, only the beginning is kept
};

// One line without a line feed, the same for the same record.
std::string write_record(std::uint64_t number, const Record& record);
// Without setup and picture; of the widths the largest alone. Throws spec::InputError for a line that is no record with
// this number.
Record read_record(std::uint64_t number, std::string_view line);
// What two records with one number say that is not the same: "values: 12 and 13"; empty: nothing. What a fault says for
// people does not count.
std::string difference(const Record& a, const Record& b);

}  // namespace toolcomp::certify::bundle
