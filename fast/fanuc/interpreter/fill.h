// The event of a block's own move.
#pragma once

#include "fast/fanuc/interpreter/interpreter.h"

namespace toolcomp::fast {

[[gnu::always_inline]] inline void Interpreter::fill_here(Event& event, spec::MoveType type, spec::Cause cause) {
  event.line = line_;
  event.n = n_;
  event.type = type;
  event.cause = cause;
  positions_.fill(event);
  event.t_numerator = 0;
  if (type != spec::MoveType::arc) event.arc.reset();
  if (type == spec::MoveType::rapid)
    event.feed.reset();
  else
    event.feed = modal_.feed();
  if (!along_tool() && !kinematics_.defined())
    event.tool_axis.reset();
  else
    fill_tool_axis(event);
}

// The direction of the tool, and under G43.5 without kinematics its length along it.
[[gnu::always_inline]] inline void Interpreter::fill_tool_axis(Event& event) {
  const Eigen::Vector3d& unit = tool_.now().unit;
  event.tool_axis.emplace(std::array<double, 3>{unit[0] + 0.0, unit[1] + 0.0, unit[2] + 0.0});  // never -0
  if (tip_.active()) {
    event.t_numerator = tip_.tag();
    return;
  }
  if (!along_tool()) return;
  positions_.fill_machine(event);
  if (tip_.samples()) [[unlikely]]
    event.t_numerator = tag_direction();
  if (along_length_ != 0) add_length(event);
}

}  // namespace toolcomp::fast
