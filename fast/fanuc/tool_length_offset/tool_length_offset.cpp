// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_length_offset/tool_length_offset.h"

#include <bit>

#include "fast/basis/axis_mask.h"

namespace toolcomp::fast {
namespace {

bool holds_cutter_code(const Words& words) {
  const Code code = words.code(Words::kCompensation);
  return code == kG40 || code == kG41 || code == kG42;
}

}  // namespace

ToolLengthOffset::ToolLengthOffset(const spec::Setup& setup)
    : ofh_(setup.bit(5001, 2)),
      tal_(setup.bit(5001, 3)),
      evo_(setup.bit(5001, 6)),
      g49_sets_h0_(setup.g49_sets_h0),
      axes_(setup.axes.size()),
      z_(setup.axes.index('Z')) {
  for (std::size_t axis = 0; axis < axes_; ++axis)
    if (spec::is_linear_axis(setup.axes.letter(axis))) linear_ = static_cast<std::uint16_t>(linear_ | bit(axis));
  if (setup.bit(5001, 0))
    type_ = Type::c;
  else if (setup.bit(5001, 1))
    type_ = Type::b;
}

ToolLengthOffset::Mode ToolLengthOffset::mode_after(Code code) const {
  switch (code) {
    case kG43:
      return Mode::plus;
    case kG44:
      return Mode::minus;
    case kG43_4:
    case kG43_5:
      return Mode::along_tool;
    case kG49:
      return Mode::off;
    default:
      return mode_;
  }
}

bool ToolLengthOffset::changed() const {
  if ((touched_ & kLength) != 0 && !(length_ == length_before_)) return true;
  for (unsigned rest = touched_ & ~static_cast<unsigned>(kLength); rest != 0; rest &= rest - 1) {
    const auto axis = static_cast<std::size_t>(std::countr_zero(rest));
    if (!(offset_[axis] == offset_before_[axis])) return true;
  }
  return false;
}

void ToolLengthOffset::set(std::size_t axis, const Count& value) {
  if ((touched_ & bit(axis)) == 0) offset_before_[axis] = offset_[axis];
  touched_ = static_cast<std::uint16_t>(touched_ | bit(axis));
  offset_[axis] = value;
  live_ = static_cast<std::uint16_t>(offset_[axis].is_zero() ? live_ & ~bit(axis) : live_ | bit(axis));
}

void ToolLengthOffset::set_length(const Count& value) {
  if ((touched_ & kLength) == 0) length_before_ = length_;
  touched_ = static_cast<std::uint16_t>(touched_ | kLength);
  length_ = value;
}

void ToolLengthOffset::cancel(std::size_t axis) {
  // An axis whose offset is 0 just now is taken away too: an H number may give it a value later.
  if (((live_ | last_) & bit(axis)) == 0) return;
  set(axis, Count());
  taken_ = static_cast<std::uint16_t>(taken_ | bit(axis));
}

Alarm ToolLengthOffset::restore(const Words& words, const OffsetMemory& memory) {
  if (!pending() || type_ == Type::c || !evo_ || mode_ == Mode::off) return AlarmCause::none;
  // A block with a length code, or an H that counts, acts by them alone.
  if (words.code(Words::kLength) != kNone || (words.has('H') && !ofh_)) return AlarmCause::none;
  // A block with G40, G41 or G42 puts the restoration off, but not an edited value.
  const bool back = (taken_ & last_) != 0 && !holds_cutter_code(words);
  if (!back && !edited_) return AlarmCause::none;
  const Count value = memory.h(number_);
  if (!memory.fits(value)) return AlarmCause::offset_value;
  edited_ = false;
  if (mode_ == Mode::along_tool) {
    set_length(value);
    return AlarmCause::none;
  }
  std::uint16_t axes = back ? last_ : static_cast<std::uint16_t>(last_ & ~taken_);
  taken_ = static_cast<std::uint16_t>(taken_ & ~axes);
  for (std::size_t axis = 0; axis < axes_; ++axis)
    if ((axes & bit(axis)) != 0) set(axis, signed_value(value, mode_));
  return AlarmCause::none;
}

std::uint16_t ToolLengthOffset::affected(Code code, std::size_t normal, std::uint16_t named) const {
  switch (type_) {
    case Type::a:
      return z_ == spec::Axes::kNone ? std::uint16_t{0} : bit(z_);
    case Type::b:
      return normal == spec::Axes::kNone ? std::uint16_t{0} : bit(normal);
    case Type::c:
      break;
  }
  return code == kNone ? last_ : static_cast<std::uint16_t>(named & linear_);
}

Alarm ToolLengthOffset::apply(const Words& words, const OffsetMemory& memory, std::size_t normal, std::uint16_t named) {
  const Code code = words.code(Words::kLength);
  const bool has_h = words.has('H');
  if (code == kNone && !has_h) [[likely]]
    return AlarmCause::none;
  if (code == kG49)
    if (const Alarm a = end_mode()) return a;

  // Which number holds: an H word of any block, or with OFH = 1 of a block with G43, G44 (or G43.4, G43.5) only; there
  // a first G43 without H means H0. So may a G49 without H.
  const bool sets = code == kG43 || code == kG44 || words.starts_tip_control();
  std::uint32_t number = number_;
  bool takes = false;
  if (has_h && (!ofh_ || sets)) {
    number = whole_number(words['H'], memory.count());
    takes = true;
  } else if ((ofh_ && sets && mode_ == Mode::off) || (code == kG49 && !has_h && g49_sets_h0_)) {
    number = 0;
  }
  const Mode mode = mode_after(code);
  if (code == kG49 || mode == Mode::off || (!takes && !sets)) {
    number_ = number;
    mode_ = mode;
    return AlarmCause::none;
  }
  const std::uint16_t axes = mode == Mode::along_tool ? std::uint16_t{0} : affected(code, normal, named);
  if (sets && mode != Mode::along_tool) {
    if (const Alarm a = check(axes)) return a;
  }
  // Where it would bring back a vector that was taken away, a block with G40, G41 or G42 only stores number and mode.
  if ((taken_ & axes) != 0 && holds_cutter_code(words)) {
    number_ = number;
    mode_ = mode;
    edited_ = true;  // for the axes offset last, where those are others
    return AlarmCause::none;
  }
  const Count value = memory.h(number);
  if (!memory.fits(value)) return AlarmCause::offset_value;
  number_ = number;
  mode_ = mode;
  take_value(value, axes);
  return AlarmCause::none;
}

// G49.
Alarm ToolLengthOffset::end_mode() {
  if (std::popcount(live_) >= 3) return AlarmCause::length_offset_axes;
  for (std::size_t axis = 0; axis < axes_; ++axis)
    if ((live_ & bit(axis)) != 0) set(axis, Count());
  set_length(Count());
  last_ = taken_ = 0;
  edited_ = false;
  return AlarmCause::none;
}

// Type C: at least one axis, and one at a time, unless TAL allows more.
Alarm ToolLengthOffset::check(std::uint16_t axes) const {
  if (type_ != Type::c) return AlarmCause::none;
  if (axes == 0) return AlarmCause::length_offset_without_axis;
  const bool second = std::popcount(axes) > 1 || (live_ & ~axes) != 0;
  return second && !tal_ ? AlarmCause::length_offset_second_axis : AlarmCause::none;
}

void ToolLengthOffset::take_value(const Count& value, std::uint16_t axes) {
  edited_ = false;
  if (mode_ == Mode::along_tool) {
    set_length(value);
    last_ = taken_ = 0;
    return;
  }
  taken_ = static_cast<std::uint16_t>(taken_ & ~axes);
  for (std::size_t axis = 0; axis < axes_; ++axis)
    if ((axes & bit(axis)) != 0) set(axis, signed_value(value, mode_));
  last_ = axes;
}

}  // namespace toolcomp::fast
