// SPDX-License-Identifier: Apache-2.0
// Facts of a program that scales and conditions need and that events do not give, with the block from which on they
// apply.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "spec/language/case.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/heidenhain/klartext_block.h"

namespace toolcomp::judge {

// In which lines G43.5 is in force (without it all rotary positions are commanded), and the Q that leans directions
// under it; the units of a Klartext program. The program is read block by block, so that the facts of an event are the
// same for whole cases and for streams.
class ProgramFacts {
 public:
  // Reads the text as far as possible.
  static ProgramFacts of(const spec::Case& c);
  void read(const spec::Block& block);
  void read(const spec::klartext::Block& block);

  // Whether rotary positions come from directions in this line of the program.
  [[nodiscard]] bool directed(std::uint64_t line) const;
  // The Q in force under G43.5, degrees.
  [[nodiscard]] double lean(std::uint64_t line) const;
  // The units of BEGIN PGM. Without BEGIN PGM, those of the setup apply.
  [[nodiscard]] std::optional<spec::Units> units() const { return units_; }

 private:
  // The mode from a block with G43.4, G43.5 or G49 on.
  struct Mode {
    std::uint64_t line = 0;
    bool directed = false;
    double lean = 0;
  };
  [[nodiscard]] const Mode* mode(std::uint64_t line) const;

  std::vector<Mode> modes_;
  std::optional<spec::Units> units_;
};

}  // namespace toolcomp::judge
