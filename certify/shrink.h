// SPDX-License-Identifier: Apache-2.0
// Shrinking: the smallest case that still fails in the same way, by blocks, then words, then digits.
#pragma once

#include <cstddef>
#include <functional>

#include "spec/language/case.h"

namespace toolcomp::certify {

// Says whether a candidate still fails in the same way. Called once for every different candidate.
using StillFails = std::function<bool(const spec::Case&)>;

struct ShrinkOptions {
  std::size_t max_runs = 2000;  // calls of the predicate
};

struct Shrunk {
  spec::Case smallest;
  std::size_t runs = 0;   // calls of the predicate
  bool complete = false;  // nothing simpler fails; false if max_runs ended the search
};

// Requires that `failing` fails (it is not tried again). Removes runs of blocks, then of words, joins blocks, removes
// setup entries, then shortens numbers, and repeats this until nothing can be removed. At least one block stays.
// Deterministic. `expect` is dropped: it belongs to the original program.
Shrunk shrink(const spec::Case& failing, const StillFails& still_fails, const ShrinkOptions& options = {});

}  // namespace toolcomp::certify
