// SPDX-License-Identifier: Apache-2.0
// Which clause of an event names a finding about it.
#pragma once

#include <optional>

#include "spec/language/event.h"

namespace toolcomp::spec {

// The last that makes the value of a move, where one of the list does (`makes_value` in the clause files), else the
// last that was applied; nothing for an event without clauses.
inline std::optional<Clause> naming_clause(const ClauseList& clauses) {
  std::optional<Clause> naming;
  for (const Clause clause : clauses)
    if (info(clause).makes_value) naming = clause;
  if (!naming && !clauses.empty()) naming = clauses.back();
  return naming;
}

}  // namespace toolcomp::spec
