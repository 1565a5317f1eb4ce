// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_offset/tool_offset.h"

namespace toolcomp::fast {

ToolOffset::ToolOffset(const spec::Setup& setup) : number_by_h_(!setup.bit(5001, 2) && setup.bit(5001, 5)) {}

void ToolOffset::add(std::size_t axis, const Count& change) {
  const auto bit = static_cast<std::uint16_t>(1U << axis);
  shift_[axis] += change;
  live_ = static_cast<std::uint16_t>(shift_[axis].is_zero() ? live_ & ~bit : live_ | bit);
}

void ToolOffset::clear(std::size_t axis) { add(axis, -shift_[axis]); }

Count ToolOffset::increase(Code code, const Count& value) {
  switch (code) {
    case kG45:
      return value;
    case kG46:
      return -value;
    case kG47:
      return value + value;
    default:
      return -(value + value);
  }
}

int ToolOffset::sense(const Count& travel, const spec::Decimal& word, bool incremental) {
  if (!travel.is_zero()) return travel < Count() ? -1 : 1;
  if (!incremental) return 0;
  return word.negative ? -1 : 1;
}

Alarm ToolOffset::arc(const std::array<Count, 2>& travel, const std::array<Count, 2>& to_center, const Count& increase,
                      Arc& arc) {
  const auto magnitude = [](const Count& value) { return value < Count() ? -value : value; };
  arc.along = to_center[0].is_zero() ? 1 : 0;
  const std::size_t across = 1 - arc.along;
  const Count& center = to_center[arc.along];
  const Count radius = magnitude(center);
  const bool quarter =
      to_center[across].is_zero() && travel[arc.along] == center && magnitude(travel[across]) == radius;
  if (!quarter) return AlarmCause::tool_offset_arc;
  const Count offset_radius = radius + increase;
  if (offset_radius < Count()) return AlarmCause::arc_ends_in_center;
  arc.zero = offset_radius.is_zero();
  arc.to_center = center < Count() ? -offset_radius : offset_radius;
  return AlarmCause::none;
}

}  // namespace toolcomp::fast
