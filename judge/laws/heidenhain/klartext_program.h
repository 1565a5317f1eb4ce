// SPDX-License-Identifier: Apache-2.0
// What the blocks of a Klartext program say, as far as laws ask: tool, deltas and modes in force. Read anew from the
// text; nothing here knows a rule of compensation.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "judge/laws/certainty.h"
#include "spec/language/case.h"
#include "spec/language/heidenhain/klartext_block.h"

namespace toolcomp::judge::laws {

// Nominal tool and the sum of its deltas, in the units of the program.
struct Cutter {
  Real r, r2, dl, dr, dr2;
  Real ring, effective_r2, effective_ring;  // R - R2; R2'; R' - R2', but not below 0
  std::optional<Real> length;               // of the table
  bool by_angle = false;                    // a table gives the deviation of R2: dr2 is not all of it
};

struct KlartextBlock {
  std::uint64_t line = 0;
  spec::klartext::Statement statement{};
  int side = 0;  // RL 1, RR -1, R0 0
  bool tcpm = false;
  bool center = false;   // CNT-CNT: the programmed point is the tool centre
  bool contour = false;  // PROG PATH IS CONTOUR
  bool drills = false;   // it calls a drilling cycle
  char axis = 'Z';
  // Positions of A, B and C by their words, degrees. Nothing where they do not say how the tool stands: a parameter, a
  // vector or another tool axis under TCPM came before.
  std::shared_ptr<const std::array<Rational, 3>> rotary;
  std::shared_ptr<const Cutter> cutter;  // nothing where it cannot be known from the text (parameters, no tool)
  std::optional<Vector> normal;
  std::optional<Vector> tool;
};

class KlartextProgram {
 public:
  // Empty where the control is another.
  explicit KlartextProgram(const spec::Case& c);

  // In the order they run.
  [[nodiscard]] const std::vector<KlartextBlock>& blocks() const { return blocks_; }
  // The block that begins in this line, or nothing.
  [[nodiscard]] const KlartextBlock* block(std::uint64_t line) const;
  // Whether a tool call stands in the lines behind `from`, up to `to`.
  [[nodiscard]] bool calls_tool(std::uint64_t from, std::uint64_t to) const;

 private:
  std::vector<KlartextBlock> blocks_;
};

}  // namespace toolcomp::judge::laws
