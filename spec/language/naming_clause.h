// SPDX-License-Identifier: Apache-2.0
// The clause of an event to which a finding about it is attributed.
#pragma once

#include <optional>

#include "spec/language/event.h"

namespace toolcomp::spec {

// The last clause that makes the value of a move (`makes_value` in the clause files), if the list has one; otherwise
// the last clause that was applied; std::nullopt for an event without clauses.
inline std::optional<Clause> naming_clause(const ClauseList& clauses) {
  std::optional<Clause> naming;
  for (const Clause clause : clauses)
    if (info(clause).makes_value) naming = clause;
  if (!naming && !clauses.empty()) naming = clauses.back();
  return naming;
}

}  // namespace toolcomp::spec
