// The words of cutter compensation, B and C alike: G40, G41, G42, G39, the offset number and I J K as a direction.
#pragma once

#include <optional>
#include <vector>

#include "model/basis/recorder.h"
#include "model/fanuc/program/interpreter.h"
#include "model/fanuc/program/offset_in_force.h"
#include "model/fanuc/program/step.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Follows group 07 and the offset number through the program. Clauses: fanuc.cutter.*.
class CutterWords {
 public:
  CutterWords(const spec::Setup& setup, const OffsetMemory& memory, Recorder& recorder);

  // What the block says, without the value of its number and its movement; nothing before the first G41,
  // G42 or G39 of the program.
  [[nodiscard]] std::optional<CutterBlock> read(const Command& command, const Interpreter& interpreter);
  // The value in force at the end of the block. Throws Alarm PS0029.
  void add_value(CutterBlock& block);
  // Its movement: from where the block starts (a leg that stays there) along its legs.
  void add_movement(CutterBlock& block, const Leg& start, const std::vector<Leg>& legs) const;

  // In force at the end of the block read last; G45 to G48 use it too.
  [[nodiscard]] const OffsetNumber& number() const { return offset_.number(); }

 private:
  [[nodiscard]] bool has_word(const Command& command, char letter) const;
  [[nodiscard]] PlanePoint point(spec::Plane plane, const Leg& leg) const;
  [[nodiscard]] std::optional<PlanePoint> direction(const Command& command, const Interpreter& interpreter) const;

  OffsetInForce offset_;
  spec::Axes axes_;
  bool seen_ = false;
  CutterSide side_ = CutterSide::none;
  spec::Plane plane_ = spec::Plane::xy;
};

}  // namespace toolcomp::model
