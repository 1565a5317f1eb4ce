// SPDX-License-Identifier: Apache-2.0
// The generated cases of a certification: chosen by what the model reaches in them.
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
  std::vector<spec::Case> cases;  // those that reach something new first, then others
  std::size_t reaching = 0;       // how many of them
  std::size_t features = 0;       // outcomes of clauses, and bins of their margins, that these reach
  std::uint64_t looked_at = 0;    // candidates in which the model was run
};

// `count` cases of a section, the same for the same section, seed and count on every machine. Candidates are made round
// by round, fresh ones and changes of those chosen; one is chosen if the model reaches in it an outcome of a clause, or
// a bin of its margin, that it reached in none before, or ends with an alarm beside a word that stood with it in none.
// After a round without such a one, or a fixed number of rounds, those of the others are chosen that reach what few do,
// so that a fault that shows in some cases of a clause only is met; then fresh cases fill the number. Cases that the
// model cannot decide are passed over. Directed,
// unrestricted and slipped cases (fuzz/gen) have fixed shares. No other engine is run: how one behaves has no say in
// what it is asked. `progress` gets the candidates looked at.
Selection select_cases(std::string_view section, std::uint64_t seed, std::size_t count,
                       const std::function<void(std::uint64_t)>& progress = {});

// The id of the `index`-th of them.
std::string generated_id(std::string_view section, std::uint64_t seed, std::size_t index);

}  // namespace toolcomp::certify
