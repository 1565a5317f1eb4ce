// SPDX-License-Identifier: Apache-2.0
// What scales and conditions need of a program and no event says, and from which block on.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "spec/language/case.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/heidenhain/klartext_block.h"

namespace toolcomp::fuzz {

// Where G43.5 is in force, without which all rotary positions are commanded, and the Q that leans directions under it;
// the units of a Klartext program. Read block by block, so that whole cases and streams know the same of an event.
class ProgramFacts {
 public:
  // As far as the text can be read.
  static ProgramFacts of(const spec::Case& c);
  void read(const spec::Block& block);
  void read(const spec::klartext::Block& block);

  // Whether rotary positions come out of directions in this line of the program.
  [[nodiscard]] bool directed(std::uint64_t line) const;
  // The Q in force under G43.5, degrees.
  [[nodiscard]] double lean(std::uint64_t line) const;
  // Of BEGIN PGM; without it those of the setup hold.
  [[nodiscard]] std::optional<spec::Units> units() const { return units_; }

 private:
  // From a block with G43.4, G43.5 or G49 on.
  struct Mode {
    std::uint64_t line = 0;
    bool directed = false;
    double lean = 0;
  };
  [[nodiscard]] const Mode* mode(std::uint64_t line) const;

  std::vector<Mode> modes_;
  std::optional<spec::Units> units_;
};

}  // namespace toolcomp::fuzz
