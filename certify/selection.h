// SPDX-License-Identifier: Apache-2.0
// The generated cases of a certification. They are chosen by what the model reaches in them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "spec/language/case.h"

namespace toolcomp::certify {

struct Selection {
  std::vector<spec::Case> cases;  // first the cases that reach something new, then others
  std::size_t reaching = 0;       // number of cases that reach something new
  std::size_t features = 0;       // number of outcomes of clauses, and of bins of their margins, that these cases reach
  std::uint64_t looked_at = 0;    // number of candidates that the model has run
};

// `count` cases of a section, the same for the same section, seed and count on every machine. Candidates are made round
// by round: new ones, and changes of those that were chosen. A candidate is chosen if the model reaches in it an
// outcome of a clause, or a bin of its margin, that it reached in no candidate before, or if it ends with an alarm next
// to a word that no earlier candidate had with that alarm. After a round without such a candidate, or after a fixed
// number of rounds, candidates are chosen that reach what few others reach, so that a fault that shows only in some
// cases of a clause is met. Then new cases fill up the number. Cases that the model cannot decide are skipped.
// Directed, unrestricted and slipped cases (fuzz/gen) have fixed shares. No other engine is run, so that the choice
// does not depend on how an engine behaves. `progress` gets the number of candidates examined.
Selection select_cases(std::string_view section, std::uint64_t seed, std::size_t count,
                       const std::function<void(std::uint64_t)>& progress = {});

// The id of the `index`-th of these cases.
std::string generated_id(std::string_view section, std::uint64_t seed, std::size_t index);

}  // namespace toolcomp::certify
