// The event of a block's own move.
#pragma once

#include "fast/fanuc/interpreter/interpreter.h"

namespace toolcomp::fast {

// X Y Z by themselves: a loop would count for nothing on most machines. What is not present is not looked at.
[[gnu::always_inline]] inline void Interpreter::fill_here(Event& event, spec::MoveType type, spec::Cause cause) {
  event.line = line_;
  event.n = n_;
  event.type = type;
  event.cause = cause;
  event.programmed.present = linear_;
  event.point.present = linear_;
  event.axes.present = all_;
  event.machine.present = 0;
  const auto fill_axis = [&](std::size_t axis) {
    const double programmed = programmed_value_[axis];
    event.programmed.value[axis] = programmed;
    event.point.value[axis] = programmed;
    event.axes.value[axis] = axes_value_[axis];
  };
  fill_axis(0);
  fill_axis(1);
  fill_axis(2);
  for (std::size_t axis = 3; axis < count_; ++axis) fill_axis(axis);
  if (tool_offset_.live() != 0) [[unlikely]]
    for (unsigned rest = tool_offset_.live(); rest != 0; rest &= rest - 1) {
      const auto axis = static_cast<std::size_t>(__builtin_ctz(rest));
      event.point.value[axis] = actual(axis).nearest();
    }
  event.t_numerator = 0;
  if (type != spec::MoveType::arc) event.arc.reset();
  if (type == spec::MoveType::rapid)
    event.feed.reset();
  else
    event.feed = feed_;
  if (!along_tool() && !kinematics_.defined())
    event.tool_axis.reset();
  else
    fill_tool_axis(event);
}

// The direction of the tool, and under G43.5 without kinematics its length along it.
[[gnu::always_inline]] inline void Interpreter::fill_tool_axis(Event& event) {
  const Eigen::Vector3d& unit = directions_[direction_].unit;
  event.tool_axis.emplace(std::array<double, 3>{unit[0] + 0.0, unit[1] + 0.0, unit[2] + 0.0});  // never -0
  if (tip_.active()) {
    event.t_numerator = tip_.tag();
    return;
  }
  if (!along_tool()) return;
  fill_machine(event);
  if (tip_.samples()) [[unlikely]]
    event.t_numerator = tag_direction();
  if (along_length_ != 0) add_length(event);
}

[[gnu::always_inline]] inline void Interpreter::fill_machine(Event& event) const {
  event.machine.present = all_;
  if ((displaced_ | stale_) != 0) [[unlikely]] {
    fill_displaced_machine(event);
    return;
  }
  event.machine.value[0] = axes_value_[0];
  event.machine.value[1] = axes_value_[1];
  event.machine.value[2] = axes_value_[2];
  for (std::size_t axis = 3; axis < count_; ++axis) event.machine.value[axis] = axes_value_[axis];
}

}  // namespace toolcomp::fast
