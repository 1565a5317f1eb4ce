// SPDX-License-Identifier: Apache-2.0
// Blocks that drill: canned cycles G73 G74 G76 G81 to G89.
#include "fast/fanuc/interpreter/interpreter.h"

namespace toolcomp::fast {

// No vector is on: a stage learns of the codes alone. G52 and G92 call the place behind the holes otherwise.
Alarm Interpreter::drill(const Words& words, const CycleCommand& command, Stage* stage, bool extra) {
  if (stage != nullptr) {
    stage->retire();
    if (control_.stopped) return AlarmCause::none;
  }
  if (command.makes_holes()) {
    if (const Alarm a = send_holes(words, command)) return a;
  } else {
    if (const Alarm a = control_.place_words(words, Mask{0})) return a;
    if (extra) {
      control_.fill(move_, control_.modal.straight(), spec::Cause::programmed);
      moves_->on(move_);
    }
  }
  return words.shifts_coordinates() ? control_.shift_coordinates(words) : Alarm();
}

Alarm Interpreter::send_holes(const Words& words, const CycleCommand& command) {
  AxisPositions& positions = control_.positions;
  const std::size_t drilling = command.axis;
  const auto axes = static_cast<Mask>(command.named & ~bit(drilling));
  HoleLevels levels;
  const bool rounded = (positions.rounded() & bit(drilling)) != 0;
  if (const Alarm a = cycle_.find_levels(positions.programmed()[drilling], rounded, levels)) return a;
  Positions travel;
  visit_axes(axes, [&](std::size_t axis) { travel[axis] = control_.travel(words, axis); });
  const bool goes_on = control_.modal.incremental();
  if (const Alarm a = check_holes(axes, travel, goes_on ? command.repeats : 1)) return a;
  Event event;
  if (const Alarm a = begin_hole(event, drilling, levels)) return a;
  if (const Alarm a = positions.place(drilling, levels.level)) return a;

  for (std::uint32_t hole = 0; hole < command.repeats; ++hole) {
    if (hole == 0 || goes_on)
      if (const Alarm a = for_each_axis(axes, [&](std::size_t axis) {
            return positions.place(axis, positions.programmed()[axis] + travel[axis]);
          }))
        return a;
    if (const Alarm a = positions.refresh()) return a;
    fill_hole(event);
    sink_.on(event);
  }
  if (!control_.modal.incremental()) positions.clear_rounded(axes);
  positions.clear_rounded(bit(drilling));
  if (levels.level_rounded) positions.set_rounded(bit(drilling));
  cycle_.stand_at(levels);
  if ((axes & control_.axes.turning) != 0) control_.attitude.turn();
  return AlarmCause::none;
}

// An alarm is one of the block: no hole is sent before all have been looked at.
Alarm Interpreter::check_holes(Mask axes, const Positions& travel, std::uint32_t holes) const {
  const AxisPositions& positions = control_.positions;
  return for_each_axis(axes, [&](std::size_t axis) {
    const Count offset = positions.tool_offset()[axis] + positions.length()[axis];
    Count to = positions.programmed()[axis];
    for (std::uint32_t hole = 0; hole < holes; ++hole) {
      to += travel[axis];
      if (!to.in_range() || !(to + offset).in_range()) return AlarmCause::position_range;
    }
    return AlarmCause::none;
  });
}

Alarm Interpreter::begin_hole(Event& event, std::size_t axis, const HoleLevels& levels) const {
  const Count& shift = control_.positions.tool_offset()[axis];
  event.kind = spec::EventKind::hole;
  event.line = control_.line;
  event.n = control_.n;
  event.point.present = static_cast<Mask>(control_.axes.linear & ~bit(axis));
  event.axes.present = control_.axes.all;
  spec::Hole<double>& hole = event.hole.emplace();
  hole.axis = axis;
  Alarm alarm;
  const auto shifted = [&](const Count& level) {
    const Count at = level + shift;
    if (!at.in_range()) alarm = AlarmCause::position_range;
    return at.nearest();
  };
  hole.point_r = shifted(levels.point_r);
  hole.bottom = shifted(levels.bottom);
  hole.level = shifted(levels.level);
  return alarm;
}

void Interpreter::fill_hole(Event& event) const {
  const AxisPositions& positions = control_.positions;
  for (std::size_t axis = 0; axis < control_.axes.count; ++axis) {
    const double without_length = positions.actual(axis).nearest();
    if (event.point.has(axis)) event.point.value[axis] = without_length;
    event.axes.value[axis] = positions.sent_to(axis);
  }
}

}  // namespace toolcomp::fast
