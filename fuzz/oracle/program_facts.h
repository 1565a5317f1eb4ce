// What scales and conditions need of a program and no event says, and from which block on.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "spec/language/block.h"
#include "spec/language/case.h"
#include "spec/language/klartext_block.h"

namespace toolcomp::fuzz {

// G43.5, without which all rotary positions are commanded, and the Q words that lean directions; the units of a
// Klartext program. Read block by block, so that whole cases and streams know the same of an event.
class ProgramFacts {
 public:
  struct Lean {
    std::uint64_t line = 0;
    double degrees = 0;
  };

  // As far as the text can be read.
  static ProgramFacts of(const spec::Case& c);
  void read(const spec::Block& block);
  void read(const spec::klartext::Block& block);

  // Whether positions can come out of inverse kinematics in this line of the program.
  [[nodiscard]] bool give_positions(std::uint64_t line) const { return line >= first_; }
  // In the order read, no angle twice; those of later lines may be among them.
  [[nodiscard]] std::span<const Lean> leans() const { return leans_; }
  // Of BEGIN PGM; without it those of the setup hold.
  [[nodiscard]] std::optional<spec::Units> units() const { return units_; }

 private:
  std::uint64_t first_ = std::numeric_limits<std::uint64_t>::max();  // line of the first G43.5
  std::vector<Lean> leans_;
  std::optional<spec::Units> units_;
};

}  // namespace toolcomp::fuzz
