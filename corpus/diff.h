// SPDX-License-Identifier: Apache-2.0
// What has changed between two corpora, vector by vector.
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

// One vector. `changed`: its expected events are others; `described`: only comment, clauses, flags or source are. The
// cause of an alarm counts where both name one.
struct Change {
  ChangeKind kind{};
  std::string id;
  // Of the first event that differs: the clause that tells why, the last one that it rests on after and not before
  // (where there is none, the last one that it rests on), and the event or "nothing". A removed vector has them once it
  // was asked again and is answered otherwise.
  std::string clause;
  std::string before;
  std::string after;
};

// Removed and changed vectors in the order of `before`, then added ones in that of `after`.
std::vector<Change> diff(std::span<const spec::Case> before, std::span<const spec::Case> after);

// Puts the questions of the removed vectors, as they stood, to the model: those that it answers otherwise than `before`
// expects say so. `progress` is called with the number of those asked.
void ask_again(std::vector<Change>& changes, std::span<const spec::Case> before,
               const std::function<void(std::uint64_t)>& progress = {});

// How many vectors are answered otherwise, by the clause that tells why.
std::map<std::string, std::size_t> by_clause(std::span<const Change> changes);

// The version that a corpus of version `before` has after these changes.
Version raised(Version before, std::span<const Change> changes);

// "changed fanuc.leading-edge-offset.0123456789 (fanuc.leading-edge.vector)" and the two events, a line each.
std::string to_string(const Change& change);

}  // namespace toolcomp::corpus
