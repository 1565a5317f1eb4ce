// SPDX-License-Identifier: Apache-2.0
// The look-ahead of a pass: the blocks whose moves are not made yet, in order.
#pragma once

#include <cstddef>
#include <deque>
#include <utility>

namespace toolcomp::model {

// A block enters when it is planned, and leaves when its moves are made. Between the two the pass looks at the blocks
// that follow it.
template <class Block>
class Window {
 public:
  void push(Block block) { blocks_.push_back(std::move(block)); }
  // No block follows those that are here.
  void end() { ended_ = true; }
  // An alarm ends the run: nothing that is here is given.
  void clear() { blocks_.clear(); }

  [[nodiscard]] bool empty() const { return blocks_.empty(); }
  [[nodiscard]] const Block& front() const { return blocks_.front(); }
  [[nodiscard]] Block& back() { return blocks_.back(); }
  // Takes the first block out. References to the others stay valid.
  Block pop() {
    Block block = std::move(blocks_.front());
    blocks_.pop_front();
    return block;
  }

  // The blocks that follow the first one, as far as they are known.
  [[nodiscard]] std::size_t following() const { return blocks_.size() - 1; }
  [[nodiscard]] const Block& after(std::size_t i) const { return blocks_[i + 1]; }
  [[nodiscard]] bool ended() const { return ended_; }

 private:
  std::deque<Block> blocks_;
  bool ended_ = false;
};

}  // namespace toolcomp::model
