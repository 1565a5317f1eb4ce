// SPDX-License-Identifier: Apache-2.0
// Chooses, among generated cases, those that together reach the most.
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

// A seed of its own for every case of a section, so that each can be made again alone.
std::uint64_t seed_of(std::string_view section, std::uint64_t seed, std::size_t index);

// Vectors of one section, complete: first those that reach a clause, an outcome or a margin of decision that none
// before them reached, in the order they were generated; then, if those are fewer than `vectors`, the first of the
// rest. Cases that can be no vector (nothing decided, nothing judged) are passed over; one on which the engines differ
// comes back without expected events, for the writer to refuse.
std::vector<spec::Case> select(std::string_view section, const SelectOptions& options);

// A candidate that may be chosen, whole, with what it reaches.
struct Contender {
  std::size_t index = 0;  // of the candidate
  std::vector<std::uint32_t> features;
  std::optional<spec::Case> c;  // none: the engines differ
};

// Looks at one machine's share of the candidates and gives those that may be chosen, in order: whatever the other
// shares hold, the candidates passed over are not, but for a few that `select` below then looks at itself.
void look(std::string_view section, const SelectOptions& options, const Share& share,
          const std::function<void(const Contender&)>& found);

// The choice of `select` from what all shares gave, by index. The same cases, without running most of the candidates.
std::vector<spec::Case> select(std::string_view section, const SelectOptions& options,
                               std::vector<Contender> contenders);

}  // namespace toolcomp::corpus
