// SPDX-License-Identifier: Apache-2.0
// Tool offset: G45, G46, G47, G48, and the shift that stays behind.
#pragma once

#include <array>
#include <vector>

#include "model/basis/recorder.h"
#include "model/fanuc/program/interpreter.h"
#include "model/fanuc/program/offset_memory.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// What G45 to G48 need to know of the length offset.
struct LengthState {
  std::uint32_t number = 0;  // H in force at the end of the block
  bool active = false;       // G43 or G44 is in force after the codes of the block
};

// Takes the blocks one after the other; no look-ahead. Clauses: fanuc.tool-offset.*.
class ToolOffset {
 public:
  ToolOffset(const spec::Setup& setup, const OffsetMemory& memory, Recorder& recorder);

  // Makes the legs of the block longer or shorter where it holds G45 to G48, and shifts them. Throws Alarm
  // G45_LENGTH_OFFSET, PS0029, G45_ARC or PS0038.
  void apply(const Command& command, const Interpreter& interpreter, const LengthState& length, std::vector<Leg>& legs);

  // Of a block in which the codes do nothing else.
  void store_number(const Codes& codes) { offset_.take(codes); }

  // The leg, its programmed end shifted as after the last block.
  [[nodiscard]] Leg shifted(Leg leg) const;
  // Actual minus programmed position of an axis after the last block, setup units.
  [[nodiscard]] const Rational& shift(std::size_t axis) const { return shift_.at(axis); }

 private:
  // rules.cpp
  // By how much one of G45 to G48 lengthens a travel, with the offset value in force.
  [[nodiscard]] Rational lengthening(OneShot code, const Rational& value) const;
  // What is added to the position of an axis that the block names, where its travel is lengthened.
  [[nodiscard]] Rational shift_by(const Command& command, char axis, const Real& travel, const Rational& by) const;
  // Changes the radius of the arc of the leg. Throws Alarm G45_ARC or PS0038.
  void lengthen_arc(const Command& command, const Numbers& numbers, const Rational& by, Leg& leg) const;

  // The offset value in force.
  [[nodiscard]] Rational value(const LengthState& length) const;
  // The leg as the axes run it, their shift with it. Throws Alarm G45_ARC or PS0038.
  void lengthen(const Command& command, const Interpreter& interpreter, const Rational& value, Leg& leg);
  // G53, G28, G30, G30.1: the axes they name lose their shift.
  void take_away(AxisMask named);

  const OffsetMemory& memory_;
  Recorder& recorder_;
  spec::Axes axes_;
  bool by_length_number_;  // 5001#5 with 5001#2 = 0
  OffsetInForce offset_;   // else by the number of cutter compensation
  std::array<Rational, spec::kMaxAxes> shift_;
};

}  // namespace toolcomp::model
