// SPDX-License-Identifier: Apache-2.0
// The outcomes of clauses that a set of runs exercised.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "spec/clauses/clauses.h"

namespace toolcomp::spec {

// How often a clause was reached, and with which outcomes; the counts of the model's recorder, summed over runs.
struct OutcomeCounts {
  std::uint64_t reached = 0;
  std::uint64_t positive = 0;  // or true
  std::uint64_t negative = 0;  // or false
  std::uint64_t tie = 0;
};

// One outcome of one clause.
struct ClauseOutcome {
  Clause clause{};
  std::string_view name;  // "reached", "positive", "negative", "tie", "true", "false"
  std::string_view text;  // what it means; empty for "reached"
  std::uint64_t count = 0;
};

// The outcomes that runs can and must reach: of every clause that the model marks, each outcome that the clause file
// does not call unreachable. `counts` is indexed by Clause.
std::vector<ClauseOutcome> required_outcomes(std::span<const OutcomeCounts> counts);

// The required outcomes that were never reached.
std::vector<ClauseOutcome> missing_outcomes(std::span<const OutcomeCounts> counts);

}  // namespace toolcomp::spec
