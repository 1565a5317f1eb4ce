// What a program says of tool directions, and from which block on.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "spec/language/block.h"
#include "spec/language/case.h"

namespace toolcomp::fuzz {

// G43.5, without which all rotary positions are commanded, and the Q words that lean directions. Read block by block,
// so that whole cases and streams know the same of an event.
class DirectionWords {
 public:
  struct Lean {
    std::uint64_t line = 0;
    double degrees = 0;
  };

  static DirectionWords of(const spec::Case& c);
  void read(const spec::Block& block);

  // Whether positions can come out of inverse kinematics in this line of the program.
  [[nodiscard]] bool give_positions(std::uint64_t line) const { return line >= first_; }
  // In the order read, no angle twice; those of later lines may be among them.
  [[nodiscard]] std::span<const Lean> leans() const { return leans_; }

 private:
  std::uint64_t first_ = std::numeric_limits<std::uint64_t>::max();  // line of the first G43.5
  std::vector<Lean> leans_;
};

}  // namespace toolcomp::fuzz
