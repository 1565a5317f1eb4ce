// SPDX-License-Identifier: Apache-2.0
// The words of tool side compensation: G41.2 G42.2, G41.6 G42.6, G40, the offset number and Q.
#pragma once

#include <memory>

#include "model/basis/recorder.h"
#include "model/fanuc/program/offset_in_force.h"
#include "model/fanuc/tool_side_compensation/tool_side_block.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Follows group 07 and the offset number through the program. Clauses: fanuc.tool-side.number and those it names.
class ToolSideWords {
 public:
  ToolSideWords(const spec::Setup& setup, const OffsetMemory& memory, Recorder& recorder);

  // The compensation is on after the block, which is read next or has been read last (fanuc.tool-side.on).
  [[nodiscard]] bool wanted(const Command& command) const;
  // What the block says, without the value of its number; nothing before the first code of the program.
  [[nodiscard]] std::shared_ptr<ToolSideBlock> read(const BlockWords& now);
  // The value in force at the end of the block. Throws Alarm PS0029.
  void add_value(ToolSideBlock& block);

 private:
  [[nodiscard]] CutterSide side_after(const Command& command) const;

  OffsetInForce offset_;
  spec::Axes axes_;
  bool seen_ = false;
  CutterSide side_ = CutterSide::none;
  spec::Plane plane_ = spec::Plane::xy;
};

}  // namespace toolcomp::model
