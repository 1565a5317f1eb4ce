// SPDX-License-Identifier: Apache-2.0
// Moves of codes that count in their block only: tool offset G45 to G48, measurement G37.
#include <bit>

#include "fast/fanuc/interpreter/interpreter.h"

namespace toolcomp::fast {

// The alarms of G45 to G48, then by how much each axis of the block is shifted, and the tool's arc.
Alarm Interpreter::plan_tool_offset(const Words& words, BlockArc& block_arc, Shifts& shifts) const {
  const AxisPositions& positions = control_.positions;
  const ArcWords& arc_words = block_arc.words;
  std::optional<spec::Arc<double>>& arc = block_arc.event;
  CutterValue::Number number = control_.cutter_value.number_after(words);
  if (positions.tool_offset().number_by_h()) {
    const ToolLengthOffset::Mode mode = positions.length().mode_after(words.code(Words::kLength));
    if (mode == ToolLengthOffset::Mode::plus || mode == ToolLengthOffset::Mode::minus)
      return AlarmCause::tool_offset_length;
    number = {words.has('H') ? whole_number(words['H'], control_.memory.count()) : positions.length().number(), true};
  }
  if (words.axes() == 0) return arc ? AlarmCause::tool_offset_arc : AlarmCause::none;
  const Count offset = control_.cutter_value.of(number);
  if (!control_.memory.fits(offset)) return AlarmCause::offset_value;
  const Count increase = ToolOffset::increase(words.code(Words::kOneShot), offset);

  if (arc) {
    if (arc_words.by_radius) return AlarmCause::tool_offset_arc;
    const std::array<std::size_t, 2>& axis = control_.modal.plane_axis();
    std::array<Count, 2> travel;
    for (std::size_t i = 0; i < 2; ++i)
      if (axis[i] != spec::Axes::kNone && (words.axes() & bit(axis[i])) != 0)
        travel[i] = control_.travel(words, axis[i]);
    ToolOffset::Arc made;
    if (const Alarm a = ToolOffset::arc(travel, arc_words.to_center, increase, made)) return a;
    for (std::size_t i = 0; i < 2; ++i) {
      if (axis[i] == spec::Axes::kNone) continue;
      Count center = positions.actual(axis[i]);
      if (i == made.along) center += made.to_center;
      arc->center.set(axis[i], center.nearest());
    }
    arc->radius.reset();
    if (made.zero) arc->sweep.reset();
  }
  return for_each_axis(static_cast<Mask>(words.axes() & control_.axes.linear), [&](std::size_t axis) {
    const Count travel = control_.travel(words, axis);
    const int sense = ToolOffset::sense(travel, words.axis(axis), control_.modal.incremental());
    shifts.by[axis] = sense < 0 ? -increase : increase;
    if (sense != 0) shifts.axes = static_cast<Mask>(shifts.axes | bit(axis));
    return AlarmCause::none;
  });
}

Alarm Interpreter::shift_axes(const Shifts& shifts) {
  ToolOffset& offset = control_.positions.tool_offset();
  return for_each_axis(shifts.axes, [&](std::size_t axis) {
    offset.add(axis, shifts.by[axis]);
    return offset[axis].in_range() ? AlarmCause::none : AlarmCause::position_range;
  });
}

// One move of G37 along its axis.
Alarm Interpreter::send_measuring_move(std::size_t axis, const Count& to, double commanded, bool measuring) {
  if (const Alarm a = control_.positions.place(axis, to)) return a;
  if (const Alarm a = control_.positions.refresh()) return a;
  if (measuring) {
    control_.fill(move_, spec::MoveType::linear, spec::Cause::measure);
    if (measurement_.feed()) move_.feed = measurement_.feed();
  } else {
    control_.fill(move_, spec::MoveType::rapid, spec::Cause::programmed);
  }
  move_.programmed.value[axis] = commanded;
  moves_->on(move_);
  return AlarmCause::none;
}

Alarm Interpreter::measure(const Words& words, Stage* stage) {
  if (stage != nullptr) {
    stage->retire();
    if (control_.stopped) return AlarmCause::none;
  }
  AxisPositions& positions = control_.positions;
  const auto axis = static_cast<std::size_t>(std::countr_zero(words.axes()));
  const Count commanded = control_.target(words, axis);
  if (!commanded.in_range()) return AlarmCause::position_range;
  if (commanded == positions.programmed()[axis]) {
    control_.end({AlarmCause::none, "fanuc.length-measurement.start-on-the-coordinate", control_.line, control_.n});
    return AlarmCause::none;
  }
  positions.clear_rounded(bit(axis));
  const ToolLengthMeasurement::Motion motion = measurement_.measure(
      axis, positions.programmed()[axis], commanded, positions.length()[axis] + positions.tool_offset()[axis]);
  const double coordinate = commanded.nearest();
  if (motion.approaches || !motion.measures)
    if (const Alarm a = send_measuring_move(axis, motion.begin, coordinate, false)) return a;
  if (motion.measures)
    if (const Alarm a = send_measuring_move(axis, motion.end, coordinate, true)) return a;
  if (motion.alarm) return motion.alarm;
  // What G10 L11 would do under G91, without its range.
  control_.write_offset(control_.memory.plan(11, positions.length().number(), motion.difference, true));
  return AlarmCause::none;
}

}  // namespace toolcomp::fast
