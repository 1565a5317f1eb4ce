// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/step_maker.h"

#include <memory>
#include <utility>

#include "model/basis/alarm.h"

namespace toolcomp::model {
namespace {

bool measures(const Command& command) { return command.codes.one_shot == OneShot::measure; }

}  // namespace

StepMaker::StepMaker(const spec::Setup& setup, OffsetMemory& memory, Recorder& recorder, bool with_motion)
    : axes_(setup.axes),
      with_motion_(with_motion),
      shifts_system_(setup.bit(5006, 6)),
      recorder_(recorder),
      memory_(memory),
      interpreter_(setup, recorder),
      cycles_(setup, interpreter_.numbers(), recorder),
      tip_control_(setup, recorder, interpreter_, with_motion),
      length_(setup, memory, recorder),
      tool_offset_(setup, memory, recorder),
      measurement_(setup, recorder) {}

OwnedStep StepMaker::make(const spec::Block& block, Passes& passes) {
  Command command = interpreter_.read(block);
  cycles_.read(command);
  interpreter_.require_feed(command);
  auto step = std::make_unique<Step>();
  Making now{command, passes, *step};
  step->line = block.line;
  step->n = block.n;
  read_words(now);
  find_legs(now);
  if (measures(command)) measure(now);
  make_moves(now);
  arrive(now);
  add_rest(now);
  step->has_word = command.codes.any;
  step->stops_look_ahead = command.codes.stops_look_ahead;
  step->ends_program = command.codes.ends_program;
  if (with_motion_) step->zero = zero();
  step->clauses = recorder_.take_clauses();
  if (now.write) {
    // It counts from the next block on.
    step->setting = memory_.write(*now.write);
    step->setting->clauses = recorder_.take_clauses();
  }
  return step;
}

void StepMaker::read_words(Making& now) {
  const Command& command = now.command;
  now.tip = tip_control_.read(command, length_, now.passes);
  if (command.cycle.on) cycles_.check(command, now.passes);
  now.compensates = shifts_system_ && (now.passes.in_force(Extent::space, command).any() ||
                                       now.passes.in_force(Extent::plane, command).any());
  const BlockWords for_passes{command, interpreter_, now.tip.directed};
  now.passes.read(Extent::space, for_passes, now.step.words);
  if (now.tip.ends || now.tip.again)
    tip_control_.rename_position(now.tip, tool_offset_.shifted(interpreter_.stay(command)));
  interpreter_.select_workpiece_system(command);
  now.passes.read(Extent::plane, for_passes, now.step.words);
  if (measures(command))
    measurement_.read(command, length_.number(), now.passes.in_force(Extent::plane, command).any());
  if (command.codes.writes_origin)
    interpreter_.write_origins(command);
  else if (command.codes.one_shot == OneShot::data)
    now.write = memory_.read_write(command.words, interpreter_.numbers(), command.incremental);
}

void StepMaker::find_legs(Making& now) {
  const Command& command = now.command;
  std::vector<Leg>& legs = now.legs;
  const TipMarks& tip = now.tip;
  if (shifts_system_) shift_system(now);
  legs = interpreter_.legs(command, tip.directed, tip.starts, now.passes.in_force(Extent::plane, command).after);
  const Leg start = tool_offset_.shifted(interpreter_.stay(command));
  if (command.cycle.on)
    tool_offset_.store_number(command.codes);
  else
    tool_offset_.apply(command, interpreter_,
                       {command.codes.h.value_or(length_.number()), length_.axis_mode(command.codes.length)}, legs);
  now.passes.see({start, legs, [this](const Position& position) { return tip_control_.at(position).tool; }},
                 now.step.words);
  now.machine = tip.tip_control || (!legs.empty() && goes_by_machine_coordinates(command.codes.one_shot));
  if (!shifts_system_) now.plan = length_.plan(length_command(command));
  if (!shifts_system_ && !tip.tip_control && now.plan.changed)
    recorder_.decide(Clause::fanuc_length_offset_shifted_system, false);
  // fanuc.length-offset.move-without-axis-word: Without an axis word a travel of zero is assumed, and the offset axis
  // still moves by the change of its offset. If the offset does not change, there is no move.
  const bool may_move = legs.empty() && !command.cycle.makes_holes() && (!shifts_system_ || tip.tip_control);
  const bool moves =
      tip.ends ? tip.takes_back && !command.cycle.makes_holes()
               : may_move && recorder_.decide(Clause::fanuc_length_offset_move_without_axis_word, now.plan.changed);
  if (legs.empty() && moves) legs.push_back(tool_offset_.shifted(interpreter_.stay(command)));
}

// fanuc.length-offset.shifted-system: With TOS (5006#6) = 1 the length offset shifts the coordinate system, with TOS =
// 0 the axes move. When the offset changes with TOS = 1, the programmed position of its axes is renamed by the change
// and nothing moves. G43, G44 and G49 alone make no move, and in a block with a move the system is shifted first. Under
// G91 the axes then go by the words alone.
// fanuc.length-offset.shifted-in-compensation: If a length offset shifts the system while a compensation by radius is
// on before or after the block, the run ends undecided at that block.
void StepMaker::shift_system(Making& now) {
  const LengthVector before = length_.vector();
  now.plan = length_.plan(length_command(now.command));
  if (now.plan.on_way.axis == before.axis) return;
  recorder_.decide(Clause::fanuc_length_offset_shifted_system, true);
  if (now.compensates)
    leave_open_alone(recorder_, Clause::fanuc_length_offset_shifted_in_compensation,
                     "a length offset shifts the coordinate system while a compensation is on");
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const Rational change = now.plan.on_way.axis.at(i) - before.axis.at(i);
    if (change != 0) interpreter_.stand(i, interpreter_.position().at(i) - Coordinate(change));
  }
}

LengthCommand StepMaker::length_command(const Command& command) const {
  const OneShot one_shot = command.codes.one_shot;
  const bool ignored = one_shot == OneShot::machine_coordinates && command.incremental;
  const AxisMask cancelled = goes_by_machine_coordinates(one_shot) && !ignored ? command.axes : AxisMask{0};
  // fanuc.canned-cycle.length-offset: The length offset in force after the words of the block counts for the whole
  // hole. The axes of the hole event are those of the end of the block, with this offset. In type C the drilling axis
  // counts as the axis that the block names.
  const AxisMask axes = command.cycle.drills ? with(0, cycles_.axis()) : command.axes;
  return {command.codes, command.plane, axes, cancelled};
}

// The legs of a G37 block, and what it writes or the alarm it ends with.
void StepMaker::measure(Making& now) {
  const std::size_t axis = ToolLengthMeasurement::axis(now.command);
  Measurement measured = measurement_.measure(now.command, interpreter_.position(), now.legs.front(),
                                              now.plan.at_end.axis.at(axis), length_.minus());
  if (measured.in_zone)
    now.write = memory_.measured(length_.number(), measured.difference);
  else
    now.step.alarm = Alarm(AlarmCause::no_signal);
  now.legs = std::move(measured.legs);
}

void StepMaker::make_moves(Making& now) {
  if (now.command.cycle.drills) make_holes(now);
  if (now.tip.tip_control && !now.legs.empty()) {
    now.step.moves.push_back(turned_move(now));
    return;
  }
  for (const Leg& leg : now.legs) {
    const bool on_way = is_reference_return(now.command.codes.one_shot) && &leg == &now.legs.front();
    const LengthVector& offset = on_way ? now.plan.on_way : now.plan.at_end;
    now.step.moves.push_back(move(leg, offset, tip_control_.at(leg.end), now.machine));
    if (leg.cause == spec::Cause::measure)
      if (const auto feed = measurement_.feed()) now.step.moves.back().feed = *feed;
  }
}

void StepMaker::make_holes(Making& now) {
  recorder_.decide(Clause::fanuc_canned_cycle_length_offset, now.plan.changed);
  now.step.holes = cycles_.drill(now.command, interpreter_.position());
  for (DrilledHole& hole : now.step.holes) {
    const Leg& leg = hole.move.leg;
    hole.move = move(tool_offset_.shifted(leg), now.plan.at_end, tip_control_.at(leg.end), false);
  }
}

// The own move of a block under tool center point control; the leg ends where the rotary axes then stand.
Move StepMaker::turned_move(Making& now) {
  const LengthVector& offset = now.plan.at_end;
  Leg& leg = now.legs.front();
  TurnedBlock turned = tip_control_.turn(now.command, now.tip, offset.along_tool, leg);
  Move result = move(leg, offset, turned.end, true);
  if (turned.motion) {
    if (const ToolPose& tip = *turned.end.tip; tip.frame) tip.frame->place(tip.pose, result.leg.end);
    result.inside = std::make_shared<const OwnMotion>(std::move(*turned.motion));
  }
  return result;
}

Move StepMaker::move(const Leg& leg, const LengthVector& offset, const ToolAtEnd& tool, bool machine) const {
  Move result;
  result.leg = leg;
  result.tool = tool.tool;
  result.tip = tool.tip;
  for (std::size_t i = 0; i < axes_.size(); ++i) result.length.at(i) = offset.axis.at(i);
  result.machine = machine;
  if (machine || with_motion_) result.zero = zero();
  if (interpreter_.feed()) result.feed = *interpreter_.feed();
  return result;
}

void StepMaker::arrive(Making& now) {
  interpreter_.arrive(now.command, now.legs);
  if (!now.step.holes.empty()) interpreter_.stand(now.step.holes.back().move.leg.end);
  if (measures(now.command)) {
    // The programmed position is where the measurement has stopped, the shift of the tool offset apart.
    const std::size_t axis = ToolLengthMeasurement::axis(now.command);
    const Leg& leg = now.legs.back();
    const Rational by = leg.shift_of(axis) - tool_offset_.shift(axis);
    interpreter_.stand(axis, leg.end.at(axis) + Coordinate(by));
  }
  if (!now.tip.tip_control) tip_control_.follow(interpreter_.position());
}

void StepMaker::add_rest(Making& now) {
  if (!now.step.words.any()) return;
  // A move inserted behind G53 or a reference return is no move of that code; under tool center point control every
  // move has machine coordinates, and the leading edge offset inserts some even where G41 or G40 came before it.
  const Leg rest = tool_offset_.shifted(interpreter_.stay(now.command));
  const bool known = now.tip.tip_control || !now.step.moves.empty();
  const ToolAtEnd tool = known ? tip_control_.standing() : tip_control_.at(rest.end);
  now.step.rest = move(rest, now.plan.at_end, tool, now.tip.tip_control);
  if (!now.step.moves.empty()) now.step.rest.feed = now.step.moves.back().feed;
}

}  // namespace toolcomp::model
