// SPDX-License-Identifier: Apache-2.0
// The directions of the tool: the one in force, and those that moves held by a stage refer to.
#pragma once

#include <array>
#include <cstdint>

#include "fast/kinematics/direction.h"

namespace toolcomp::fast {

class ToolDirections {
 public:
  ToolDirections() = default;
  ToolDirections(const ToolDirections&) = delete;
  ToolDirections& operator=(const ToolDirections&) = delete;

  [[nodiscard]] const Direction& now() const { return *now_; }
  // Which one it is of all there have been: while it stays, so does the direction.
  [[nodiscard]] std::uint64_t number() const { return number_; }
  // Where the block started.
  [[nodiscard]] const Direction& before() const { return *before_; }
  void begin_block() { before_ = now_; }

  // A new one comes into force: to be filled in.
  [[nodiscard]] Direction& next() {
    go_to(number_ + 1);
    return *now_;
  }
  // Back to the one in force when its number() was asked for.
  void go_back(std::uint64_t number) { go_to(number); }

 private:
  void go_to(std::uint64_t number) {
    number_ = number;
    now_ = &ring_[number % ring_.size()];
  }

  // At most three blocks that are held have one at a time, and a block makes three at most.
  std::array<Direction, 8> ring_;
  std::uint64_t number_ = 0;
  Direction* now_ = ring_.data();
  const Direction* before_ = now_;
};

}  // namespace toolcomp::fast
