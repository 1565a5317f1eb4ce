// The directions of the tool: the one in force, and those that moves held by a stage refer to.
#pragma once

#include <array>
#include <cstdint>

#include "fast/kinematics/direction.h"

namespace toolcomp::fast {

class ToolDirections {
 public:
  [[nodiscard]] const Direction& now() const { return ring_[now_ % ring_.size()]; }
  // Which one it is of all there have been: while it stays, so does the direction.
  [[nodiscard]] std::uint64_t number() const { return now_; }
  // Where the block started.
  [[nodiscard]] const Direction& before() const { return ring_[before_ % ring_.size()]; }
  void begin_block() { before_ = now_; }

  // A new one comes into force: to be filled in.
  [[nodiscard]] Direction& next() { return ring_[++now_ % ring_.size()]; }
  // Back to the one in force when its number() was asked for.
  void go_back(std::uint64_t number) { now_ = number; }

 private:
  // At most three blocks that are held have one at a time, and a block makes three at most.
  std::array<Direction, 8> ring_;
  std::uint64_t now_ = 0;
  std::uint64_t before_ = 0;
};

}  // namespace toolcomp::fast
