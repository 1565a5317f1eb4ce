// SPDX-License-Identifier: Apache-2.0
// The look-ahead of a pass: the blocks whose moves are not made yet, in order.
#pragma once

#include <cstddef>
#include <deque>
#include <utility>

#include "spec/clauses/clauses.h"

namespace toolcomp::model {

// A block enters when it is planned, and leaves when its moves are made. Between the two the pass looks at the blocks
// that follow it.
template <class Block>
class Window {
 public:
  // What follows the first block.
  struct Ahead {
    const Block* next = nullptr;  // the block that its vectors are made with; without it `why` says that there is none
    bool repeated = false;        // the code is repeated in that block, or in one between
    bool between = false;         // blocks without motion come between
    spec::Clause why{};
  };

  void push(Block block) { blocks_.push_back(std::move(block)); }
  // No block follows those that are here.
  void end() { ended_ = true; }
  // An alarm ends the run: nothing that is here is given.
  void clear() { blocks_.clear(); }

  [[nodiscard]] bool empty() const { return blocks_.empty(); }
  [[nodiscard]] Block& back() { return blocks_.back(); }
  // Takes the first block out. References to the others stay valid.
  Block pop() {
    Block block = std::move(blocks_.front());
    blocks_.pop_front();
    return block;
  }

  // The first block, and those that follow it as far as they are known.
  [[nodiscard]] const Block& operator[](std::size_t i) const { return blocks_[i]; }
  [[nodiscard]] std::size_t size() const { return blocks_.size(); }
  [[nodiscard]] bool ended() const { return ended_; }

 private:
  std::deque<Block> blocks_;
  bool ended_ = false;
};

}  // namespace toolcomp::model
