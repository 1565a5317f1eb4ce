// SPDX-License-Identifier: Apache-2.0
// The words of cutter compensation, B and C alike: G40, G41, G42, G39, the offset number and I J K as a direction.
#pragma once

#include <memory>

#include "model/basis/recorder.h"
#include "model/fanuc/cutter_compensation/cutter_block.h"
#include "model/fanuc/program/interpreter.h"
#include "model/fanuc/program/offset_in_force.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Follows group 07 and the offset number through the program. Clauses: fanuc.cutter.*.
class CutterWords {
 public:
  CutterWords(const spec::Setup& setup, const OffsetMemory& memory, Recorder& recorder);

  // In force at the end of a block, which is read next or has been read last: the side, and the number.
  [[nodiscard]] CutterSide side_after(const Command& command) const;
  [[nodiscard]] std::uint32_t number_after(const Command& command) const;

  // What the block says, without the value of its number and its movement; nothing before the first G41,
  // G42 or G39 of the program.
  [[nodiscard]] std::shared_ptr<CutterBlock> read(const BlockWords& now);
  // The value in force at the end of the block. Throws Alarm PS0029.
  void add_value(CutterBlock& block);
  // Its movement.
  void add_movement(CutterBlock& block, const BlockWay& way) const;

 private:
  [[nodiscard]] PlanePoint point(spec::Plane plane, const Leg& leg) const;
  [[nodiscard]] std::optional<PlanePoint> direction(const Command& command, const Interpreter& interpreter) const;

  OffsetInForce offset_;
  spec::Axes axes_;
  bool seen_ = false;
  CutterSide side_ = CutterSide::none;
  spec::Plane plane_ = spec::Plane::xy;
};

}  // namespace toolcomp::model
