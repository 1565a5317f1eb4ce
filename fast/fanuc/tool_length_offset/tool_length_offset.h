// SPDX-License-Identifier: Apache-2.0
// Tool length offset G43 G44 G49 and its H rules (chapter 14.1.1), cancellation and restoration (14.1.2).
#pragma once

#include <array>
#include <cstdint>

#include "fast/arithmetic/count.h"
#include "fast/basis/alarm.h"
#include "fast/fanuc/program/words.h"
#include "fast/fanuc/tool_length_offset/offset_memory.h"
#include "spec/language/axes.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// The length-offset vector, one signed value per axis, and the rules that change it. Also keeps the length L that
// G43.4 and G43.5 lay along the tool direction, because it follows the same H rules.
class ToolLengthOffset {
 public:
  enum class Mode : std::uint8_t { off, plus, minus, along_tool };  // G49, G43, G44, G43.4 or G43.5

  explicit ToolLengthOffset(const spec::Setup& setup);

  [[nodiscard]] Mode mode() const { return mode_; }
  [[nodiscard]] const Count& operator[](std::size_t axis) const { return offset_[axis]; }
  [[nodiscard]] const Count& length() const { return length_; }   // under G43.4, G43.5
  [[nodiscard]] std::uint32_t number() const { return number_; }  // H
  [[nodiscard]] std::uint16_t live() const { return live_; }      // axes whose offset is not 0
  // Whether the vector, or L, differs from what it was at begin_block().
  [[nodiscard]] bool changed() const;
  // By how much the vector of an axis differs.
  [[nodiscard]] Count change(std::size_t axis) const {
    return (touched_ >> axis & 1U) != 0 ? offset_[axis] - offset_before_[axis] : Count();
  }
  void begin_block() { touched_ = 0; }
  // Whether restore() may have something to do.
  [[nodiscard]] bool pending() const { return taken_ != 0 || edited_; }
  // The mode after a block with this code of group 08.
  [[nodiscard]] Mode mode_after(Code code) const;

  // The restoration that becomes due at any block with words (EVO).
  Alarm restore(const Words& words, const OffsetMemory& memory);
  // G43 G44 G43.4 G43.5 G49 and H of a block; `normal` is the axis normal to the plane in force, `named` the axes that
  // the block names for type C. On an alarm nothing changes.
  Alarm apply(const Words& words, const OffsetMemory& memory, std::size_t normal, std::uint16_t named);
  // G53, G28, G30, G30.1 on this axis: its vector goes to 0, the mode stays.
  void cancel(std::size_t axis);
  // G10 changed the value of an H number.
  void edited(std::uint32_t number) { edited_ |= number == number_ && mode_ != Mode::off; }

 private:
  enum class Type : std::uint8_t { a, b, c };

  // Steps of apply().
  [[nodiscard]] Alarm end_mode();
  [[nodiscard]] Alarm check(std::uint16_t axes) const;
  // Of the number and mode now in force, on these axes or along the tool.
  void take_value(const Count& value, std::uint16_t axes);
  void set(std::size_t axis, const Count& value);
  void set_length(const Count& value);
  [[nodiscard]] Count signed_value(const Count& value, Mode mode) const { return mode == Mode::minus ? -value : value; }
  [[nodiscard]] std::uint16_t affected(Code code, std::size_t normal, std::uint16_t named) const;

  Type type_ = Type::a;
  bool ofh_ = false;
  bool tal_ = false;
  bool evo_ = false;
  bool g49_sets_h0_ = false;
  std::size_t axes_;
  std::uint16_t linear_ = 0;
  std::size_t z_;

  Mode mode_ = Mode::off;
  std::uint32_t number_ = 0;  // H
  std::uint16_t last_ = 0;    // axes offset last
  std::uint16_t live_ = 0;
  std::uint16_t taken_ = 0;  // axes whose vector G53 or a reference return took away
  bool edited_ = false;      // the axes offset last may not have the value of number and mode
  std::array<Count, spec::kMaxAxes> offset_;
  Count length_;

  // What was written since begin_block(), one bit an axis and kLength, and the values from before.
  static constexpr std::uint16_t kLength = 1U << spec::kMaxAxes;
  std::uint16_t touched_ = 0;
  std::array<Count, spec::kMaxAxes> offset_before_;
  Count length_before_;
};

}  // namespace toolcomp::fast
