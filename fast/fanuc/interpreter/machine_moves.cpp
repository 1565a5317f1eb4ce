// Moves in machine coordinates and what shifts the coordinates: G53, G28, G30, G30.1, G29, G92, G54 to G59.
#include "fast/basis/fault.h"
#include "fast/fanuc/interpreter/interpreter.h"
#include "fast/fanuc/interpreter/own_move.h"

namespace toolcomp::fast {

Alarm Interpreter::send_rapid(spec::Cause cause, bool with_machine, CutterMotion motion) {
  if (kinematics_.defined()) attitude_.turn();
  if (const Alarm a = positions_.refresh()) return a;
  if (in_cutter_) {
    CutterBlock& block = cutter_next();
    fill(block.event, spec::MoveType::rapid, cause);
    if (with_machine) positions_.fill_machine(block.event);
    block.own = true;
    block.axis_word = true;
    block.feed = modal_.feed();
    block.motion = motion;
    return send_cutter(block);
  }
  Event& event = leading_edge_.next().event;
  fill(event, spec::MoveType::rapid, cause);
  if (with_machine) positions_.fill_machine(event);
  leading_edge_.pass();
  return alarm::kNone;
}

Alarm Interpreter::to_machine_position(const Words& words) {
  if (const Alarm a = for_each_axis(words.axes(), [&](std::size_t axis) {
        return positions_.place_at_machine(axis, units_.value(words.axis(axis), (axes_.linear & bit(axis)) != 0));
      }))
    return a;
  return send_rapid(spec::Cause::programmed, true, CutterMotion::to_machine);
}

Alarm Interpreter::to_reference(const Words& words) {
  if (const Alarm a = for_each_axis(words.axes(), [&](std::size_t axis) {
        if (!modal_.incremental()) positions_.clear_rounded(bit(axis));
        return positions_.to_intermediate(axis, target(words, axis));
      }))
    return a;
  positions_.end_intermediate(words.axes());
  if (const Alarm a = send_rapid(spec::Cause::reference, true, CutterMotion::to_intermediate)) return a;
  if (stopped_) return alarm::kNone;
  if (in_cutter_) start_cutter_leg(words, CutterSide::unchanged, false);
  const Positions& reference = positions_.reference(reference_point(words));
  if (const Alarm a = for_each_axis(
          words.axes(), [&](std::size_t axis) { return positions_.place_at_machine(axis, reference[axis]); }))
    return a;
  return send_rapid(spec::Cause::reference, true, CutterMotion::to_reference);
}

Alarm Interpreter::from_reference(const Words& words) {
  if (const Alarm a = positions_.from_intermediate(words.axes())) return a;
  if (const Alarm a = send_rapid(spec::Cause::programmed, false, CutterMotion::from_intermediate)) return a;
  if (stopped_) return alarm::kNone;
  if (in_cutter_) start_cutter_leg(words, CutterSide::unchanged, false);
  if (const Alarm a =
          for_each_axis(words.axes(), [&](std::size_t axis) { return positions_.place(axis, target(words, axis)); }))
    return a;
  if (!modal_.incremental()) positions_.clear_rounded(words.axes());
  return send_rapid(spec::Cause::programmed, false, CutterMotion::from_reference);
}

void Interpreter::select_workpiece(Code code) {
  positions_.select_system(static_cast<std::size_t>((code - 540) / 10));
  attitude_.take_zeros();
  if (kinematics_.defined()) attitude_.turn();
}

// G92 in cutter compensation: the stage is told where the block began and what the position is called after it. A move
// of the length offset alone has the coordinates from before, one that makes or removes a vector those after: the stage
// chooses.
Alarm Interpreter::shift_in_cutter(const Words& words, bool extra) {
  CutterBlock& block = cutter_next();
  if (const Alarm a = positions_.refresh()) return a;
  fill(block.event, modal_.straight(), spec::Cause::programmed);
  if (const Alarm a = shift_coordinates(words)) return a;
  // A code makes or removes a vector at once, in C number 0 too (clause fanuc.cutter-c.number-zero).
  const bool number_zero = block.d_word && block.d == 0;
  if (is_b_ ? block.word == CutterSide::off : block.word != CutterSide::unchanged || number_zero) {
    if (const Alarm a = positions_.refresh()) return a;
    fill(block.renamed, modal_.straight(), spec::Cause::programmed);
  }
  block.own = extra;
  block.axis_word = false;
  block.feed = modal_.feed();
  block.motion = CutterMotion::shift;
  if (const Alarm a = send_cutter(block)) return a;
  rename_in_cutter();
  return alarm::kNone;
}

// The position is called otherwise from here on: the corner before the next move too.
void Interpreter::rename_in_cutter() {
  if (is_b_ || stopped_) return;
  Event& event = cutter_c_.next().event;
  for (std::size_t axis = 0; axis < axes_.count; ++axis) {
    const Count position = positions_.actual(axis);
    event.programmed.value[axis] = positions_.programmed_value(axis);
    event.point.value[axis] = position.nearest();
    event.axes.value[axis] = (position + positions_.length()[axis]).nearest();
  }
  if (kinematics_.defined()) attitude_.fill(event);  // where the programmed coordinates of the rotary axes turn it
  cutter_c_.rebase();
}

Alarm Interpreter::shift_coordinates(const Words& words) {
  const Alarm a = for_each_axis(words.axes(), [&](std::size_t axis) {
    return positions_.shift(axis, units_.value(words.axis(axis), (axes_.linear & bit(axis)) != 0));
  });
  positions_.end_shift(words.axes());
  attitude_.take_zeros();
  if (kinematics_.defined()) attitude_.turn();
  return a;
}

}  // namespace toolcomp::fast
