// SPDX-License-Identifier: Apache-2.0
// Moves in machine coordinates, and workpiece coordinates: G53, G28, G30, G30.1, G29, G54 to G59, G54.1, G10 L2 L20.
#include "fast/fanuc/interpreter/interpreter.h"

namespace toolcomp::fast {

Alarm Interpreter::send_rapid(Stage* stage, spec::Cause cause, bool with_machine, CutterMotion motion) {
  if (control_.kinematics.defined()) control_.attitude.turn();
  if (const Alarm a = control_.positions.refresh()) return a;
  if (stage != nullptr) return stage->leave_path(motion, cause, with_machine);
  control_.fill(move_, spec::MoveType::rapid, cause);
  if (with_machine) control_.positions.fill_machine(move_);
  moves_->on(move_);
  return AlarmCause::none;
}

Alarm Interpreter::to_machine_position(const Words& words, Stage* stage) {
  if (const Alarm a = for_each_axis(words.axes(), [&](std::size_t axis) {
        return control_.positions.place_at_machine(
            axis, control_.units.value(words.axis(axis), (control_.axes.linear & bit(axis)) != 0));
      }))
    return a;
  return send_rapid(stage, spec::Cause::programmed, true, CutterMotion::to_machine);
}

Alarm Interpreter::to_reference(const Words& words, Stage* stage) {
  AxisPositions& positions = control_.positions;
  if (const Alarm a = for_each_axis(words.axes(), [&](std::size_t axis) {
        if (!control_.modal.incremental()) positions.clear_rounded(bit(axis));
        return positions.to_intermediate(axis, control_.target(words, axis));
      }))
    return a;
  positions.end_intermediate(words.axes());
  if (const Alarm a = send_rapid(stage, spec::Cause::reference, true, CutterMotion::to_intermediate)) return a;
  if (control_.stopped) return AlarmCause::none;
  if (stage != nullptr) stage->begin_leg(words);
  const Positions& reference = positions.reference(reference_point(words));
  if (const Alarm a = for_each_axis(
          words.axes(), [&](std::size_t axis) { return positions.place_at_machine(axis, reference[axis]); }))
    return a;
  return send_rapid(stage, spec::Cause::reference, true, CutterMotion::to_reference);
}

Alarm Interpreter::from_reference(const Words& words, Stage* stage) {
  AxisPositions& positions = control_.positions;
  if (const Alarm a = positions.from_intermediate(words.axes())) return a;
  if (const Alarm a = send_rapid(stage, spec::Cause::programmed, false, CutterMotion::from_intermediate)) return a;
  if (control_.stopped) return AlarmCause::none;
  if (stage != nullptr) stage->begin_leg(words);
  if (const Alarm a = for_each_axis(
          words.axes(), [&](std::size_t axis) { return positions.place(axis, control_.target(words, axis)); }))
    return a;
  if (!control_.modal.incremental()) positions.clear_rounded(words.axes());
  return send_rapid(stage, spec::Cause::programmed, false, CutterMotion::from_reference);
}

void Interpreter::select_workpiece(std::size_t system) {
  control_.positions.select_system(system);
  control_.attitude.take_zeros();
  if (control_.kinematics.defined()) control_.attitude.turn();
}

// P has been checked.
void Interpreter::write_origins(const Words& words) {
  AxisPositions& positions = control_.positions;
  const std::uint32_t number = whole_number(words['P'], spec::kAdditionalWorkpieces);
  const std::size_t origin = whole_number(words['L'], 20) == 20 ? AxisPositions::kFirstAdditional + number - 1
                             : number == 0                      ? AxisPositions::kExternal
                                                                : number - 1;
  for (unsigned rest = words.data_axes(); rest != 0; rest &= rest - 1) {
    const auto axis = static_cast<std::size_t>(__builtin_ctz(rest));
    const Count value = control_.units.value(words.axis(axis), (control_.axes.linear & bit(axis)) != 0);
    positions.set_origin(origin, axis, control_.modal.incremental() ? positions.origin(origin, axis) + value : value);
  }
  positions.end_origins();
  control_.attitude.take_zeros();
  if (control_.kinematics.defined()) control_.attitude.turn();
}

}  // namespace toolcomp::fast
