// SPDX-License-Identifier: Apache-2.0
// From a block's words to its step: everything about it but its compensation vector.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "model/basis/recorder.h"
#include "model/fanuc/canned_cycle/canned_cycle.h"
#include "model/fanuc/passes/passes.h"
#include "model/fanuc/program/interpreter.h"
#include "model/fanuc/program/offset_memory.h"
#include "model/fanuc/program/step.h"
#include "model/fanuc/tool_center_point_control/tool_center_point_control.h"
#include "model/fanuc/tool_length_measurement/rules.h"
#include "model/fanuc/tool_length_offset/tool_length_offset.h"
#include "model/fanuc/tool_offset/tool_offset.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Reads blocks one after the other, and keeps what is modal in the sections that are no stages: interpretation, tool
// offset, length offset and its measurement, the pose of tool center point control. The length offset is decided when
// the block is read, so that its alarms are known before a stage looks at the block; all of these only add to the
// programmed end, so their order does not show in the coordinates. The pose is known then too: compensation reads the
// direction of the tool, and moves the tip.
class StepMaker {
 public:
  // `memory`: G10 and G37 write to it. `with_motion`: what lies inside moves will be asked for. Throws
  // spec::InputError for a setup the control could not have.
  StepMaker(const spec::Setup& setup, OffsetMemory& memory, Recorder& recorder, bool with_motion);

  // The next block. `passes` have taken all steps before it. Throws Alarm or LeftOpen as reading and the words of the
  // block raise them, in their fixed order; then the block makes nothing.
  OwnedStep make(const spec::Block& block, Passes& passes);
  // What positions are counted from now.
  [[nodiscard]] const SharedZero& zero() const { return interpreter_.work().zero(); }

 private:
  // A block in the making.
  struct Making {
    const Command& command;
    Passes& passes;
    Step& step;
    TipMarks tip = {};
    bool compensates = false;  // by radius, before or after it
    LengthPlan plan = {};
    bool machine = false;  // its moves have machine coordinates
    // NOLINTBEGIN(*-redundant-member-init): GCC warns where braces leave them out otherwise
    std::vector<Leg> legs = {};
    std::optional<OffsetWrite> write = {};  // of a G10 or G37 block
    // NOLINTEND(*-redundant-member-init)
  };

  // In this order; the alarms of a command are found in the first three.
  void read_words(Making& now);
  void find_legs(Making& now);
  void measure(Making& now);
  void make_moves(Making& now);
  void make_holes(Making& now);
  void arrive(Making& now);
  void add_rest(Making& now);

  // The move of a leg, with what the length offset and the tool say about its end.
  [[nodiscard]] Move move(const Leg& leg, const LengthVector& offset, const ToolAtEnd& tool, bool machine) const;
  Move turned_move(Making& now);
  // With 5006#6 = 1: what the length offset shifts the coordinate system by, before the block moves.
  void shift_system(Making& now);
  [[nodiscard]] LengthCommand length_command(const Command& command) const;

  spec::Axes axes_;
  bool with_motion_;
  bool shifts_system_;  // 5006#6, TOS
  Recorder& recorder_;
  OffsetMemory& memory_;
  Interpreter interpreter_;
  CannedCycle cycles_;
  ToolCenterPointControl tip_control_;
  ToolLengthOffset length_;
  ToolOffset tool_offset_;
  ToolLengthMeasurement measurement_;
};

}  // namespace toolcomp::model
