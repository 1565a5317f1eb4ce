// Tool length offset: G43, G44, G49 and H, types A, B and C, and what G53, G28, G30 and G30.1 do to it. G43.4 and G43.5
// share its modal group and its H rules; their length lies along the tool.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "model/basis/recorder.h"
#include "model/fanuc/program/codes.h"
#include "model/fanuc/program/interpreter.h"
#include "model/fanuc/program/offset_memory.h"
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
};

// The offset in force: what is added to each axis, and under G43.4 and G43.5 along the tool. Setup units.
struct LengthVector {
  std::array<Rational, spec::kMaxAxes> axis;
  Rational along_tool;
  friend bool operator==(const LengthVector&, const LengthVector&) = default;
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
  [[nodiscard]] bool axis_offset() const;

 private:
  enum class Type : std::uint8_t { a, b, c };

  [[nodiscard]] bool active() const { return mode_ != LengthCode::cancel; }
  void cancel();
  // Whether the H of this block counts; then it is the number in force.
  bool take_number(const LengthCommand& command, bool sets_mode);
  // The axes that G43, G44 or H of this block acts on.
  [[nodiscard]] AxisMask affected(const LengthCommand& command, bool sets_mode) const;
  [[nodiscard]] AxisMask named_axes(const LengthCommand& command) const;
  [[nodiscard]] AxisMask letter(char axis) const;
  void apply(AxisMask axes);
  void next_block(const LengthCommand& command);
  void take_away(AxisMask axes);

  const OffsetMemory& memory_;
  Recorder& recorder_;
  spec::Axes axes_;
  Type type_;
  bool ofh_;  // 5001#2
  bool tal_;  // 5001#3
  bool evo_;  // 5001#6

  LengthCode mode_ = LengthCode::cancel;
  std::uint32_t number_ = 0;
  LengthVector vector_;
  AxisMask last_ = 0;       // the axes offset last
  AxisMask cancelled_ = 0;  // axes whose vector G53 or a reference return has taken away
};

}  // namespace toolcomp::model
