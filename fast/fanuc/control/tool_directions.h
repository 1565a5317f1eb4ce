// The directions of the tool: the one in force, and those that moves held by a stage refer to.
#pragma once

#include <array>
#include <cstdint>

#include "fast/kinematics/direction.h"

namespace toolcomp::fast {

class ToolDirections {
 public:
  [[nodiscard]] const Direction& now() const { return ring_[now_]; }
  // Where the block started.
  [[nodiscard]] const Direction& before() const { return ring_[before_]; }
  void begin_block() { before_ = now_; }

  // A new one comes into force: to be filled in.
  [[nodiscard]] Direction& next() {
    now_ = static_cast<std::uint8_t>((now_ + 1U) % ring_.size());
    return ring_[now_];
  }
  // Back to the one in force when place() was asked for.
  [[nodiscard]] std::uint8_t place() const { return now_; }
  void go_back(std::uint8_t place) { now_ = place; }

 private:
  // At most three blocks that are held have one at a time, and a block makes three at most.
  std::array<Direction, 8> ring_;
  std::uint8_t now_ = 0;
  std::uint8_t before_ = 0;
};

}  // namespace toolcomp::fast
