// SPDX-License-Identifier: Apache-2.0
// Drilling cycles: their parameters, and the hole of a call.
#include "fast/heidenhain/interpreter/interpreter.h"

namespace toolcomp::fast::klartext {

// heidenhain.program.drilling-cycle: it sets the Q parameters that it names as assignments do, in the order written.
Alarm Interpreter::define_cycle(const Block& block) {
  for (const spec::klartext::Assignment& assignment : block.cycle_values)
    if (const Alarm a = assign(assignment.target, assignment.value)) return a;
  return AlarmCause::none;
}

// heidenhain.program.cycle-call: with Q201 = 0 the cycle does nothing, and to all other rules a hole is a motion of L
// under R0. heidenhain.program.unknown-position: it needs the linear axes other than the tool axis.
Alarm Interpreter::call_cycle() {
  if (parameters_.value(spec::klartext::kDepth).is_zero()) return AlarmCause::none;
  if (hole_needs_unknown()) return AlarmCause::not_judged;
  DrillingLevels levels;
  if (const Alarm a = find_levels(levels)) return a;
  stand_at(levels.level);
  face_.forget();
  if (!release_before_motion()) return AlarmCause::none;
  spec::Hole<double> hole;
  hole.axis = axis_[tool_axis_];
  hole.point_r = levels.point_r.nearest();
  hole.bottom = levels.bottom.nearest();
  hole.level = levels.level.nearest();
  writer_.hole(head_, hole, tool_.values());
  return AlarmCause::none;
}

bool Interpreter::hole_needs_unknown() const {
  return (unknown_ & ~(1U << tool_axis_)) != 0 && !parameters_.value(spec::klartext::kDepth).is_zero();
}

// r = Q203 + Q200; bottom = Q203 + Q201; return = Q203 + max(Q200, Q204); all of them from the shifted datum.
Alarm Interpreter::find_levels(DrillingLevels& levels) const {
  const Count& clearance = parameters_.value(spec::klartext::kSetUpClearance);
  const Count& second = parameters_.value(spec::klartext::kSecondClearance);
  const bool higher = clearance < second;
  Count surface = parameters_.value(spec::klartext::kSurface);
  surface += shift_[tool_axis_];
  levels.point_r = surface + clearance;
  levels.bottom = surface + parameters_.value(spec::klartext::kDepth);
  levels.level = surface + (higher ? second : clearance);
  const bool in_range = levels.point_r.in_range() && levels.bottom.in_range() && levels.level.in_range();
  return in_range ? AlarmCause::none : AlarmCause::position_range;
}

// heidenhain.program.cycle-return: the level is then the programmed position of the tool axis, known also where it was
// not before. A block that is held goes out with the way to it.
void Interpreter::stand_at(const Count& level) {
  const unsigned bit = 1U << tool_axis_;
  if (peripheral_.holds()) {
    std::array<Count, 3> way;
    way[tool_axis_] = level - position_[tool_axis_];
    set_displacement(peripheral_.next().travel, {}, way, (rounded_ & bit) != 0 ? slack_ : 0);
  }
  set_position(tool_axis_, level);
  rounded_ = static_cast<std::uint16_t>(rounded_ & ~bit);
  if (rounded_ == 0) slack_ = 0;
  set_unknown(unknown_ & ~bit);
}

}  // namespace toolcomp::fast::klartext
