// SPDX-License-Identifier: Apache-2.0
// What has changed between two corpora, vector by vector.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "corpus/golden.h"

namespace toolcomp::corpus {

enum class ChangeKind : std::uint8_t { removed, changed, added, described };

// One vector. `changed`: its expected events are others; `described`: only comment, clauses, flags or source are.
struct Change {
  ChangeKind kind{};
  std::string id;
  std::string clause;  // changed: the last clause of the first event that differs, before or after; else empty
  std::string before;  // changed: that event, or "nothing"
  std::string after;
};

// Removed and changed vectors in the order of `before`, then added ones in that of `after`.
std::vector<Change> diff(std::span<const spec::Case> before, std::span<const spec::Case> after);

// The version that a corpus of version `before` has after these changes.
Version raised(Version before, std::span<const Change> changes);

// "changed fanuc.leading-edge-offset.0123456789 (fanuc.leading-edge.vector)" and the two events, a line each.
std::string to_string(const Change& change);

}  // namespace toolcomp::corpus
