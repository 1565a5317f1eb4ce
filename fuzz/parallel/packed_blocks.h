// SPDX-License-Identifier: Apache-2.0
// Blocks of a program kept in little memory: of a FANUC block the words that are there.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "spec/language/fanuc/block.h"
#include "spec/language/heidenhain/klartext_block.h"

namespace toolcomp::fuzz {

template <class Block>
class PackedBlocks {
 public:
  void reserve(std::size_t blocks) { blocks_.reserve(blocks); }
  void add(const Block& block) { blocks_.push_back(block); }
  [[nodiscard]] std::size_t size() const { return blocks_.size(); }
  // `into` is a place to unpack it to.
  [[nodiscard]] const Block& at(std::size_t index, Block& /*into*/) const { return blocks_[index]; }

 private:
  std::vector<Block> blocks_;
};

template <>
class PackedBlocks<spec::Block> {
 public:
  void reserve(std::size_t blocks) { heads_.reserve(blocks); }
  void add(const spec::Block& block) {
    heads_.push_back({block.line, block.n, block.alarm, words_.size()});
    words_.insert(words_.end(), block.words().begin(), block.words().end());
  }
  [[nodiscard]] std::size_t size() const { return heads_.size(); }
  [[nodiscard]] const spec::Block& at(std::size_t index, spec::Block& into) const {
    const Head& head = heads_[index];
    const std::size_t end = index + 1 < heads_.size() ? heads_[index + 1].words : words_.size();
    into.line = head.line;
    into.n = head.n;
    into.alarm = head.alarm;
    into.size = end - head.words;
    std::copy_n(words_.begin() + static_cast<std::ptrdiff_t>(head.words), into.size, into.word.begin());
    return into;
  }

 private:
  struct Head {
    std::uint64_t line = 0;
    std::optional<std::uint64_t> n;
    std::optional<spec::ReadAlarm> alarm;
    std::size_t words = 0;  // where they begin
  };
  std::vector<Head> heads_;
  std::vector<spec::Word> words_;
};

}  // namespace toolcomp::fuzz
