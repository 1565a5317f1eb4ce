// SPDX-License-Identifier: Apache-2.0
// The blocks by which an engine may be brought to a place of a program without running all of it: a guess.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "spec/language/fanuc/block.h"
#include "spec/language/heidenhain/klartext_block.h"

namespace toolcomp::fuzz {

// What a block may leave behind: its words, without the values that the next block of its kind replaces (coordinates,
// directions, feeds).
std::string kind_of(const spec::Block& block);
std::string kind_of(const spec::klartext::Block& block);

// Remembers of a program that is read the latest blocks, and of every kind the latest two before these, each with some
// blocks around it: most words are modal, and of two blocks with the same words the later one counts.
template <class Block>
class Lead {
 public:
  explicit Lead(std::size_t latest) : latest_most_(std::max<std::size_t>(latest, 1)) {}

  void add(const Block& block);
  // In the order of the program; the latest ones are at the end.
  [[nodiscard]] std::vector<Block> blocks() const;

 private:
  static constexpr std::size_t kMostKinds = 500;
  static constexpr std::size_t kAround = 4;  // before and behind: what look-ahead holds
  struct Known {
    std::uint64_t number = 0;
    std::string kind;
    Block block;
  };
  using Shared = std::shared_ptr<const Known>;
  // Block `at` of the latest.
  void remember(std::size_t at);

  std::size_t latest_most_;
  std::uint64_t count_ = 0;
  std::deque<Shared> latest_;  // with kAround before
  std::unordered_map<std::string, std::deque<std::vector<Shared>>> kinds_;
};

// The same without compensation before the last `latest` blocks, where the leaps over the blocks left out would make
// corners. One that is on there begins in the first straight move of those, within the first `most` of them. Without
// the arcs before. Nothing where no compensation is begun before, or there is no such move.
std::optional<std::vector<spec::Block>> with_late_start(std::vector<spec::Block> lead, std::size_t latest,
                                                        std::size_t most);
inline std::optional<std::vector<spec::klartext::Block>> with_late_start(
    const std::vector<spec::klartext::Block>& /*lead*/, std::size_t /*latest*/, std::size_t /*most*/) {
  return std::nullopt;
}

// Work at the end of a lead, of which the last `latest` blocks stand one behind another: begun(blocks) with a late
// start where there is one and it gives any, else with the blocks as they are. Null where that gives none.
template <class Block, class Begun>
auto begin_by(const std::vector<Block>& lead, std::size_t latest, std::size_t most, const Begun& begun) {
  if (const auto late = with_late_start(lead, latest, most))
    if (auto work = begun(*late)) return work;
  return begun(lead);
}

}  // namespace toolcomp::fuzz
