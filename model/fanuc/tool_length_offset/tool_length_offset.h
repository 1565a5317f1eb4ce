// SPDX-License-Identifier: Apache-2.0
// Tool length offset: G43, G44, G49 and H, types A, B and C, and what G53, G28, G30 and G30.1 do to it. G43.4 and G43.5
// share its modal group and its H rules; their length lies along the tool.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "model/basis/recorder.h"
#include "model/fanuc/program/offset_memory.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// What a block says to the length offset.
struct LengthCommand {
  const Codes& codes;
  spec::Plane plane = spec::Plane::xy;
  AxisMask axes = 0;       // axis words
  AxisMask cancelled = 0;  // axes that G53, G28, G30 or G30.1 sends to a machine position

  // G43, G44, G43.4 or G43.5.
  [[nodiscard]] bool sets_mode() const { return codes.length && *codes.length != LengthCode::cancel; }
  // G40, G41 or G42: no vector comes back in the block.
  [[nodiscard]] bool has_cutter_code() const {
    return codes.compensation && (*codes.compensation == Compensation::cancel || is_cutter_side(*codes.compensation));
  }
};

// The offset in force: what is added to each axis, and under G43.4 and G43.5 along the tool. Setup units.
struct LengthVector {
  std::array<Rational, spec::kMaxAxes> axis;
  Rational along_tool;
  // Of G43 and G44.
  [[nodiscard]] AxisMask axes() const { return nonzero(axis); }
  friend bool operator==(const LengthVector&, const LengthVector&) = default;
};

// Axes of the length offset.
struct LengthAxes {
  AxisMask last = 0;       // the axes offset last
  AxisMask cancelled = 0;  // axes whose vector G53 or a reference return has taken away
};

// Which axes a block offsets, by how much, and what it gives back or takes away. Clauses: fanuc.length-offset.*.
class LengthRules {
 public:
  LengthRules(const spec::Setup& setup, Recorder& recorder);

  // With the offset value on these axes. `mode`: G43 or G44.
  [[nodiscard]] LengthVector offset(LengthVector before, AxisMask axes, LengthCode mode, const Rational& value) const;
  // The axes that G43, G44 or H of a block acts on. Throws Alarm PS0027.
  [[nodiscard]] AxisMask affected(const LengthCommand& command, const LengthVector& before, AxisMask last) const;
  // The number that a block brings into force. `active`: some mode is in force before it.
  [[nodiscard]] std::optional<std::uint32_t> number(const LengthCommand& command, bool active) const;
  // G49 may cancel this. Throws Alarm PS0015.
  void cancel(const LengthVector& before) const;
  // A block that commands no length offset brings an edited value, or a vector taken away, into force.
  [[nodiscard]] bool next_block_counts() const;
  // The axes that G53 or a reference return takes the offset of.
  [[nodiscard]] AxisMask taken_away(AxisMask named, const LengthVector& before, AxisMask last) const;
  // The axes on which such a block has the offset of the number in force.
  [[nodiscard]] AxisMask in_next_block(const LengthCommand& command, const LengthAxes& axes) const;
  // The number only is stored, of a block that would act on `affected`.
  [[nodiscard]] bool only_stored(const LengthCommand& command, AxisMask affected, AxisMask cancelled) const;

 private:
  enum class Type : std::uint8_t { a, b, c };

  [[nodiscard]] AxisMask named_axes(const LengthCommand& command, const LengthVector& before) const;

  Recorder& recorder_;
  spec::Axes axes_;
  Type type_;
  bool ofh_;  // 5001#2
  bool tal_;  // 5001#3
  bool evo_;  // 5001#6
  bool g49_sets_h0_;
};

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
  [[nodiscard]] bool axis_offset() const { return vector_.axes() != 0; }

 private:
  [[nodiscard]] bool active() const { return mode_ != LengthCode::cancel; }
  // A block with G43, G44, G43.4, G43.5 or an H that counts; one that commands no length offset.
  void take(const LengthCommand& command);
  void next_block(const LengthCommand& command);
  // The value of the number in force on these axes.
  void apply(AxisMask axes);

  const OffsetMemory& memory_;
  Recorder& recorder_;
  LengthRules rules_;

  LengthCode mode_ = LengthCode::cancel;
  std::uint32_t number_ = 0;
  LengthVector vector_;
  LengthAxes axes_;
};

}  // namespace toolcomp::model
