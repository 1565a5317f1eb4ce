// SPDX-License-Identifier: Apache-2.0
// Chooses, among generated cases, those that together reach as much as possible.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "corpus/share.h"
#include "spec/language/case.h"

namespace toolcomp::corpus {

struct SelectOptions {
  std::uint64_t seed = 1;
  std::size_t vectors = 200;      // at least
  std::size_t candidates = 6000;  // to choose from
};

// A separate seed for every case of a section, so that each case can be generated again without the others.
std::uint64_t seed_of(std::string_view section, std::uint64_t seed, std::size_t index);

// The complete vectors of one section. First come those that reach a clause, an outcome or a margin of a decision that
// no vector before them reached, in the order in which they were generated. If these are fewer than `vectors`, the
// first of the others follow. Cases that cannot be vectors (nothing decided, nothing judged) are skipped. A case on
// which the engines differ is returned without expected events, and the writer then refuses it.
std::vector<spec::Case> select(std::string_view section, const SelectOptions& options);

// A candidate that may be chosen: the complete case, with what it reaches.
struct Contender {
  std::size_t index = 0;  // of the candidate
  std::vector<std::uint32_t> features;
  std::optional<spec::Case> c;  // std::nullopt if the engines differ
};

// Examines one machine's share of the candidates and gives those that may be chosen, in order. The skipped candidates
// cannot be chosen, whatever the other shares contain, except for a few that `select` below examines itself.
void look(std::string_view section, const SelectOptions& options, const Share& share,
          const std::function<void(const Contender&)>& found);

// The choice of `select` among the candidates that all shares gave, by index. It gives the same cases without running
// most of the candidates.
std::vector<spec::Case> select(std::string_view section, const SelectOptions& options,
                               std::vector<Contender> contenders);

}  // namespace toolcomp::corpus
