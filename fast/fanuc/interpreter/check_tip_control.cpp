// SPDX-License-Identifier: Apache-2.0
// The alarms of commands about tool center point control G43.4 G43.5.
#include "fast/fanuc/interpreter/interpreter.h"

namespace toolcomp::fast {

// The alarms that words and state alone show (clause fanuc.tool-center-point.alarm-order).
Alarm Interpreter::check_tip_control(const Words& words, const Command& command) const {
  const ToolAttitude& attitude = control_.attitude;
  const Code length = words.code(Words::kLength);
  const Code one_shot = words.code(Words::kOneShot);
  const bool forbidden = (one_shot != kNone && one_shot != kG04 && one_shot != kG10) || command.cycle.on();
  const bool in_plane = words.code(Words::kCompensation) == kG41 || words.code(Words::kCompensation) == kG42;
  if (command.along && (forbidden || in_plane || words.code(Words::kWorkpiece) != kNone || words.writes_origin()))
    return AlarmCause::forbidden_under_tool_direction;
  if (control_.positions.along_tool() && (length == kG43 || length == kG44)) return AlarmCause::length_offset_exclusion;
  // The stage in space that is on before the block or after it.
  const Stage* on = nullptr;
  bool after = false;
  for (const auto& stage : asked_) {
    if (!stage->in_space()) continue;
    if (stage->on_before() || stage->on_after()) on = stage.get();
    after |= stage->on_after();
  }
  if (words.starts_tip_control())
    if (const Alarm a = check_tip_control_start(words, command, on != nullptr)) return a;
  if (command.ends_along && on != nullptr) return AlarmCause::tool_direction_format;
  if (!command.along) return AlarmCause::none;
  if (attitude.machine().workpiece_frame() && attitude.machine().has_table() && after)
    return AlarmCause::compensation_in_workpiece_system;
  return check_tip_move(words, command.motion, command.vector, on);
}

Alarm Interpreter::check_tip_move(const Words& words, Code motion, bool vector, const Stage* stage) const {
  const ControlAxes& axes = control_.axes;
  const bool ijk = words.has_any(Words::set_of("IJK"));
  if (vector) {
    if ((words.axes() & axes.rotary) != 0) return stage != nullptr ? stage->rotary_word() : AlarmCause::tool_direction;
    if (words.code(Words::kLength) == kG43_5 && ijk && control_.attitude.machine().has_table())
      return AlarmCause::direction_at_start;
    if (!ToolAttitude::names_direction(words)) return AlarmCause::tool_direction;
  }
  if (motion <= kG01) return AlarmCause::none;
  const Code plane = words.code(Words::kPlane);
  Mask in_plane = 0;
  for (const std::size_t axis : control_.modal.axes_of(plane == kNone ? control_.modal.plane() : plane_of(plane)))
    if (axis != spec::Axes::kNone) in_plane = static_cast<Mask>(in_plane | bit(axis));
  const bool turns_alone = (words.axes() & axes.linear) == 0 &&
                           (vector ? ijk : (words.axes() & axes.rotary) != 0 && !words.has_any(kArcLetters));
  if (turns_alone || (vector && (words.axes() & in_plane) != 0 && !words.has('R'))) return AlarmCause::tip_control_arc;
  return AlarmCause::none;
}

Alarm Interpreter::check_tip_control_start(const Words& words, const Command& command, bool in_space) const {
  const Machine& machine = control_.attitude.machine();
  if (control_.positions.length().live() != 0) return AlarmCause::length_offset_exclusion;
  const bool vector = command.vector;
  if (!vector && !machine.defined()) return AlarmCause::tip_control_parameters;
  if (vector && machine.defined() && machine.workpiece_frame()) return AlarmCause::tip_control_parameters;
  if (words.has('P') && words.code(Words::kOneShot) == kNone && !words.letters_are_data() &&
      whole_number(words['P'], 1) > 1)
    return AlarmCause::tip_control_word;
  if (vector && machine.defined()) {
    if (!machine.invertible()) return AlarmCause::tip_control_parameters;
    if (!machine.ranges_valid()) return AlarmCause::rotary_limits;
  }
  return in_space || command.motion > kG01 ? AlarmCause::tool_direction_format : AlarmCause::none;
}

}  // namespace toolcomp::fast
