// SPDX-License-Identifier: Apache-2.0
// The passes of compensation of one run, one after the other.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "model/fanuc/program/pass.h"

namespace toolcomp::model {

using PassMaker = std::unique_ptr<Pass> (*)(const Pass::Place& place);
// The passes of compensation that there are, each in the folder of its name. Throw spec::InputError naming parameter
// 19631 (leading edge offset), 19625, and for tool side compensation others.
std::unique_ptr<Pass> leading_edge_offset(const Pass::Place& place);
std::unique_ptr<Pass> cutter_compensation_b(const Pass::Place& place);
std::unique_ptr<Pass> cutter_compensation_c(const Pass::Place& place);
std::unique_ptr<Pass> tool_side_compensation(const Pass::Place& place);
// Those of a setup, in the order in which a step goes through them.
std::vector<PassMaker> passes_of(const spec::Setup& setup);

// Asks every pass alike.
class Passes {
 public:
  // Before and after a block.
  struct InForce {
    bool before = false;
    bool after = false;
    [[nodiscard]] bool any() const { return before || after; }
  };

  // `makers` in the order in which a step passes. Throws spec::InputError as the passes do.
  Passes(const std::vector<PassMaker>& makers, const Pass::Place& place);

  // Whether a compensation of this extent is on: Pass::on, Pass::on_after.
  [[nodiscard]] InForce in_force(Extent extent, const Command& command) const;
  // Pass::refuse_rotary_word.
  void refuse_rotary_word(const Command& command) const;

  // Pass::read of the passes of this extent, in order; Pass::see of all.
  void read(Extent extent, const BlockWords& now, StepWords& words);
  void see(const BlockWay& way, StepWords& words) const;

  // The next block of the program. It is planned when next() asks for it, so an alarm of planning comes from there.
  void put(OwnedStep step) { made_ = std::move(step); }
  // No block follows.
  void end() { ended_ = true; }
  // The next step that has gone through all passes; nothing as long as one of them waits for other blocks.
  OwnedStep next() { return next_of(passes_.size()); }

 private:
  // Through the first `count` passes.
  OwnedStep next_of(std::size_t count);

  std::vector<std::unique_ptr<Pass>> passes_;
  OwnedStep made_;
  bool ended_ = false;
};

}  // namespace toolcomp::model
