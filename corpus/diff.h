// SPDX-License-Identifier: Apache-2.0
// The changes between two corpora, vector by vector.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "corpus/golden.h"

namespace toolcomp::corpus {

enum class ChangeKind : std::uint8_t { removed, changed, added, described };

// One vector. `changed`: its expected events differ. `described`: only comment, clauses, flags or source differ. Causes
// of alarms are compared if both sides have one.
struct Change {
  ChangeKind kind{};
  std::string id;
  // For the first event that differs: the clause that explains it, and the event before and after, or "nothing". The
  // clause is the last one that the event rests on after the change and not before, or else the last one that it rests
  // on. A removed vector has these values if it was asked again and the answer differs.
  std::string clause;
  std::string before;
  std::string after;
};

// Removed and changed vectors in the order of `before`, then added vectors in the order of `after`.
std::vector<Change> diff(std::span<const spec::Case> before, std::span<const spec::Case> after);

// Runs the removed vectors, as they were, through the model, and records the answers that differ from those that
// `before` expects. `progress` is called with the number of vectors run.
void ask_again(std::vector<Change>& changes, std::span<const spec::Case> before,
               const std::function<void(std::uint64_t)>& progress = {});

// The number of vectors with a different answer, by the clause that explains it.
std::map<std::string, std::size_t> by_clause(std::span<const Change> changes);

// The version that a corpus of version `before` has after these changes.
Version raised(Version before, std::span<const Change> changes);

// "changed fanuc.leading-edge-offset.0123456789 (fanuc.leading-edge.vector)" and the two events, a line each.
std::string to_string(const Change& change);

}  // namespace toolcomp::corpus
