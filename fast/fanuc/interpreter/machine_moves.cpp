// Moves in machine coordinates and what shifts the coordinates: G53, G28, G30, G30.1, G29, G92, G54 to G59.
#include "fast/basis/fault.h"
#include "fast/fanuc/interpreter/fill.h"
#include "fast/fanuc/interpreter/interpreter.h"

namespace toolcomp::fast {

Alarm Interpreter::send_rapid(spec::Cause cause, bool with_machine, CutterMotion motion) {
  if (kinematics_.defined()) turn();
  if (const Alarm a = refresh()) return a;
  if (in_cutter_) {
    CutterBlock& block = cutter_next();
    fill(block.event, spec::MoveType::rapid, cause);
    if (with_machine) fill_machine(block.event);
    block.own = true;
    block.axis_word = true;
    block.feed = feed_;
    block.motion = motion;
    return send_cutter(block);
  }
  Event& event = leading_edge_.next().event;
  fill(event, spec::MoveType::rapid, cause);
  if (with_machine) fill_machine(event);
  leading_edge_.pass();
  return alarm::kNone;
}

// A named axis at machine position `machine`: its length offset is taken away, its workpiece position is what is left.
Alarm Interpreter::place_at_machine(std::size_t axis, const Count& machine) {
  length_.cancel(axis);
  if ((tool_offset_.live() & bit(axis)) != 0) tool_offset_.clear(axis);
  rounded_ = static_cast<Mask>((rounded_ & ~bit(axis)) | (shift_rounded_ & bit(axis)));
  return place(axis, machine - machine_origin(axis));
}

Alarm Interpreter::to_machine_position(const Words& words) {
  if (const Alarm a = for_each_axis(words.axes(), [&](std::size_t axis) {
        return place_at_machine(axis, value(words.axis(axis), (linear_ & bit(axis)) != 0, inch_program_));
      }))
    return a;
  return send_rapid(spec::Cause::programmed, true, CutterMotion::to_machine);
}

Alarm Interpreter::to_reference(const Words& words) {
  if (const Alarm a = for_each_axis(words.axes(), [&](std::size_t axis) {
        if (!incremental_) rounded_ = static_cast<Mask>(rounded_ & ~bit(axis));
        intermediate_[axis] = target(words, axis);
        return place(axis, intermediate_[axis]);
      }))
    return a;
  has_intermediate_ = static_cast<Mask>(has_intermediate_ | words.axes());
  intermediate_rounded_ = static_cast<Mask>((intermediate_rounded_ & ~words.axes()) | (rounded_ & words.axes()));
  if (const Alarm a = send_rapid(spec::Cause::reference, true, CutterMotion::to_intermediate)) return a;
  if (stopped_) return alarm::kNone;
  if (in_cutter_) start_cutter_leg(words, CutterSide::unchanged, false);
  const Positions& reference = reference_[reference_point(words)];
  if (const Alarm a =
          for_each_axis(words.axes(), [&](std::size_t axis) { return place_at_machine(axis, reference[axis]); }))
    return a;
  return send_rapid(spec::Cause::reference, true, CutterMotion::to_reference);
}

Alarm Interpreter::from_reference(const Words& words) {
  const auto through = static_cast<Mask>(words.axes() & has_intermediate_);
  if (const Alarm a = for_each_axis(through, [&](std::size_t axis) { return place(axis, intermediate_[axis]); }))
    return a;
  rounded_ = static_cast<Mask>((rounded_ & ~through) | (intermediate_rounded_ & through));
  if (const Alarm a = send_rapid(spec::Cause::programmed, false, CutterMotion::from_intermediate)) return a;
  if (stopped_) return alarm::kNone;
  if (in_cutter_) start_cutter_leg(words, CutterSide::unchanged, false);
  if (const Alarm a = for_each_axis(words.axes(), [&](std::size_t axis) { return place(axis, target(words, axis)); }))
    return a;
  if (!incremental_) rounded_ = static_cast<Mask>(rounded_ & ~words.axes());
  return send_rapid(spec::Cause::programmed, false, CutterMotion::from_reference);
}

// After a change of workpiece_ or shift_.
void Interpreter::mark_displaced() {
  displaced_ = 0;
  for (std::size_t axis = 0; axis < count_; ++axis)
    if (!origin_[workpiece_][axis].is_zero() || !shift_[axis].is_zero())
      displaced_ = static_cast<Mask>(displaced_ | bit(axis));
  if (turning_ == 0 || !machine_angles_) return;
  Positions zero;
  for (std::size_t axis = 0; axis < count_; ++axis) zero[axis] = machine_origin(axis);
  kinematics_.set_zeros(zero);
  machine_.set_zeros(zero);
}

// The machine stays where it is: the programmed position shifts by the difference of the origins.
void Interpreter::select_workpiece(Code code) {
  const auto chosen = static_cast<std::size_t>((code - 540) / 10);
  for (std::size_t axis = 0; axis < count_; ++axis) {
    programmed_[axis] += origin_[workpiece_][axis] - origin_[chosen][axis];
    programmed_value_[axis] = programmed_[axis].nearest();
  }
  workpiece_ = chosen;
  mark_displaced();
  stale_ = all_;
  if (kinematics_.defined()) turn();
}

// G92 in cutter compensation: the stage is told where the block began and what the position is called after it. A move
// of the length offset alone has the coordinates from before, one that makes or removes a vector those after: the stage
// chooses.
Alarm Interpreter::shift_in_cutter(const Words& words, bool extra) {
  CutterBlock& block = cutter_next();
  if (const Alarm a = refresh()) return a;
  fill(block.event, straight(), spec::Cause::programmed);
  if (const Alarm a = shift_coordinates(words)) return a;
  // A code makes or removes a vector at once, in C number 0 too (clause fanuc.cutter-c.number-zero).
  const bool number_zero = block.d_word && block.d == 0;
  if (is_b_ ? block.word == CutterSide::off : block.word != CutterSide::unchanged || number_zero) {
    if (const Alarm a = refresh()) return a;
    fill(block.renamed, straight(), spec::Cause::programmed);
  }
  block.own = extra;
  block.axis_word = false;
  block.feed = feed_;
  block.motion = CutterMotion::shift;
  if (const Alarm a = send_cutter(block)) return a;
  rename_in_cutter();
  return alarm::kNone;
}

// The position is called otherwise from here on: the corner before the next move too.
void Interpreter::rename_in_cutter() {
  if (is_b_ || stopped_) return;
  Event& event = cutter_c_.next().event;
  for (std::size_t axis = 0; axis < count_; ++axis) {
    const Count position = actual(axis);
    event.programmed.value[axis] = programmed_value_[axis];
    event.point.value[axis] = position.nearest();
    event.axes.value[axis] = (position + length_[axis]).nearest();
  }
  if (kinematics_.defined()) fill_tool_axis(event);  // where the programmed coordinates of the rotary axes turn it
  cutter_c_.rebase();
}

Alarm Interpreter::shift_coordinates(const Words& words) {
  const Alarm a = for_each_axis(words.axes(), [&](std::size_t axis) {
    const Count word = value(words.axis(axis), (linear_ & bit(axis)) != 0, inch_program_);
    shift_[axis] += programmed_[axis] - word;
    if (!shift_[axis].in_range()) return alarm::kRange;
    return place(axis, word);
  });
  mark_displaced();
  shift_rounded_ = static_cast<Mask>(shift_rounded_ | (rounded_ & words.axes()));
  rounded_ = static_cast<Mask>(rounded_ & ~words.axes());
  if (kinematics_.defined()) turn();
  return a;
}

}  // namespace toolcomp::fast
