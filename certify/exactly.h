// SPDX-License-Identifier: Apache-2.0
// Two lists of exact events held together: the formal specification against the exact model.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "fuzz/oracle/verdict.h"
#include "model/basis/event.h"
#include "spec/language/axes.h"

namespace toolcomp::certify {

// The kind of a difference between the two.
inline constexpr const char* kSpecificationKind = "specification";

// What the formal specification says must be what the model does: the same events in the same order, every field of
// them but clauses and messages, every number to kModelDigits decimals. Nothing is granted: both are exact.
struct Exactly {
  std::optional<fuzz::Difference> difference;  // the first; its clause is that of the model's event
  std::uint64_t values = 0;                    // numbers held together, and those of alarms
  std::string undecided;                       // why they cannot be: a sign or digits that one of them cannot certify
};
Exactly hold_exactly(const spec::Axes& axes, const std::vector<model::Event>& model,
                     const std::vector<model::Event>& said);

}  // namespace toolcomp::certify
