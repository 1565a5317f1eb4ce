// SPDX-License-Identifier: Apache-2.0
// Compares two lists of exact events: the formal specification with the exact model.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "judge/oracle/verdict.h"
#include "model/basis/event.h"
#include "spec/language/axes.h"

namespace toolcomp::certify {

// The kind of a difference between the two.
inline constexpr const char* kSpecificationKind = "specification";

// The formal specification must give what the model gives: the same events in the same order, with the same fields
// except clauses and messages, and every number equal to kModelDigits decimals. There is no tolerance, because both are
// exact.
struct Exactly {
  std::optional<judge::Difference> difference;  // the first difference; its clause is that of the model's event
  std::uint64_t values = 0;                     // number of compared numbers and alarm numbers
  std::string undecided;  // why they cannot be compared: a sign or digits that one of them cannot certify
};
Exactly hold_exactly(const spec::Axes& axes, const std::vector<model::Event>& model,
                     const std::vector<model::Event>& said);

}  // namespace toolcomp::certify
