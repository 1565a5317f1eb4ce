// SPDX-License-Identifier: Apache-2.0
// Tool length offset: G43, G44, G49 and H, types A, B and C, and what G53, G28, G30 and G30.1 do to it. G43.4 and G43.5
// share its modal group and its H rules; their length lies along the tool.
#pragma once

#include <cstdint>
#include <optional>

#include "model/basis/recorder.h"
#include "model/fanuc/program/codes.h"
#include "model/fanuc/program/offset_memory.h"
#include "model/fanuc/tool_length_offset/rules.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

struct LengthPlan {
  LengthVector on_way;  // on the way to the intermediate point of a reference return
  LengthVector at_end;
  bool changed = false;  // against the end of the block before
};

// Takes the blocks one after the other; no look-ahead. Clauses: fanuc.length-offset.*.
class ToolLengthOffset {
 public:
  ToolLengthOffset(const spec::Setup& setup, const OffsetMemory& memory, Recorder& recorder);

  // The offsets of this block. Throws Alarm PS0015, PS0027 or PS0029.
  LengthPlan plan(const LengthCommand& command);

  [[nodiscard]] const LengthVector& vector() const { return vector_; }
  // The number in force.
  [[nodiscard]] std::uint32_t number() const { return number_; }
  // G44 is in force.
  [[nodiscard]] bool minus() const { return mode_ == LengthCode::minus; }
  // G43 or G44 is in force once a block with this code, or none, has been read.
  [[nodiscard]] bool axis_mode(const std::optional<LengthCode>& code) const {
    const LengthCode mode = code.value_or(mode_);
    return mode == LengthCode::plus || mode == LengthCode::minus;
  }
  // G43.4 or G43.5 is in force.
  [[nodiscard]] bool tip_control() const { return is_tip_control(mode_); }
  // G43.5 is in force.
  [[nodiscard]] bool directed() const { return mode_ == LengthCode::tool_direction; }
  // Some axis is offset by G43 or G44.
  [[nodiscard]] bool axis_offset() const;

 private:
  [[nodiscard]] bool active() const { return mode_ != LengthCode::cancel; }
  void cancel();
  // A block with G43, G44, G43.4, G43.5 or an H that counts; one that commands no length offset.
  void take(const LengthCommand& command);
  void next_block(const LengthCommand& command);
  // The value of the number in force on these axes.
  void apply(AxisMask axes);
  // G53 and the reference returns: the axes they name lose their offset; the mode stays.
  void take_away(AxisMask named);

  const OffsetMemory& memory_;
  Recorder& recorder_;
  LengthRules rules_;

  LengthCode mode_ = LengthCode::cancel;
  std::uint32_t number_ = 0;
  LengthVector vector_;
  LengthAxes axes_;
};

}  // namespace toolcomp::model
