// SPDX-License-Identifier: Apache-2.0
// The rules of the tool length offset: which axes a block offsets, by how much, and what it gives back or takes away.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "model/basis/recorder.h"
#include "model/fanuc/program/codes.h"
#include "model/fanuc/program/interpreter.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// What a block says to the length offset.
struct LengthCommand {
  std::optional<LengthCode> code;
  std::optional<std::uint32_t> h;
  spec::Plane plane = spec::Plane::xy;
  AxisMask axes = 0;         // axis words
  bool has_word = true;      // a word other than N and O
  bool cutter_code = false;  // G40 (G41, G42) in the block: no vector comes back in it
  AxisMask cancelled = 0;    // axes that G53, G28, G30 or G30.1 sends to a machine position

  // G43, G44, G43.4 or G43.5.
  [[nodiscard]] bool sets_mode() const { return code && *code != LengthCode::cancel; }
};

// The offset in force: what is added to each axis, and under G43.4 and G43.5 along the tool. Setup units.
struct LengthVector {
  std::array<Rational, spec::kMaxAxes> axis;
  Rational along_tool;
  friend bool operator==(const LengthVector&, const LengthVector&) = default;
};

// Axes of the length offset.
struct LengthAxes {
  AxisMask last = 0;       // the axes offset last
  AxisMask cancelled = 0;  // axes whose vector G53 or a reference return has taken away
};

// Clauses: fanuc.length-offset.*.
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

}  // namespace toolcomp::model
