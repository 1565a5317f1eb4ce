// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/leading_edge_offset/leading_edge_offset.h"

#include <algorithm>
#include <utility>

#include "model/basis/alarm.h"

namespace toolcomp::model {
namespace {}  // namespace

LeadingEdgeOffset::LeadingEdgeOffset(const Place& place)
    : StageOf(place), memory_(place.memory), rules_(place.setup, place.recorder) {}

bool LeadingEdgeOffset::on_after(const Command& command) const {
  const Codes& codes = command.codes;
  if (codes.compensation == Compensation::leading_edge) return number(command) != 0;
  return active_ && codes.compensation != Compensation::cancel && codes.d != 0U;
}

std::shared_ptr<StageWords> LeadingEdgeOffset::read(const StageCommand& now) {
  using Code = EdgeBlock::Code;
  const Command& command = now.command;
  const Codes& codes = command.codes;
  number_ = number(command);
  auto block = std::make_shared<EdgeBlock>();
  if (codes.compensation == Compensation::leading_edge) {
    // fanuc.leading-edge.start-format: An axis word (I J K under G43.5 included), or an M code that stops reading ahead
    // (fanuc.program.stops-reading-ahead), in the G41.3 block raises PS5406.
    if (now.moves() || codes.stops_look_ahead)
      raise(recorder(), Clause::fanuc_leading_edge_start_format, AlarmCause::leading_edge_format);
    // fanuc.leading-edge.start-in-arc-mode: G41.3 while G02 or G03 is in force raises PS5408.
    if (command.is_arc_motion())
      raise(recorder(), Clause::fanuc_leading_edge_start_in_arc_mode, AlarmCause::leading_edge_start);
    // fanuc.leading-edge.repeated: G41.3 while the mode is on raises PS5407.
    if (active_) raise(recorder(), Clause::fanuc_leading_edge_repeated, AlarmCause::leading_edge_command);
    // fanuc.leading-edge.start-with-d0: G41.3 with D0 in force starts nothing: the state stays cancelled, and the next
    // block may be any block. A number whose value is 0 starts the mode with vectors of length 0. The format of the
    // block is checked in both cases.
    if (!recorder().decide(Clause::fanuc_leading_edge_start_with_d0, number_ == 0)) block->code = Code::start;
  } else if (active_) {
    // fanuc.leading-edge.d0-cancels: A D0 word while the mode is on cancels it as G40 does.
    const bool by_number = recorder().decide(Clause::fanuc_leading_edge_d0_cancels, codes.d == 0U);
    if (codes.compensation == Compensation::cancel || by_number) {
      // fanuc.leading-edge.cancel-format: An axis word (I J K under G43.5 included) in the block that cancels the mode
      // raises PS5406.
      if (now.moves()) raise(recorder(), Clause::fanuc_leading_edge_cancel_format, AlarmCause::leading_edge_format);
      block->code = Code::cancel;
    }
    // fanuc.leading-edge.arc: G02 or G03 while the mode is on raises PS5407, also in the block that cancels the mode:
    // only G00 and G01 are allowed.
    if (command.is_arc_motion()) raise(recorder(), Clause::fanuc_leading_edge_arc, AlarmCause::leading_edge_command);
  }
  if (!active_ && block->code == Code::none) return nullptr;
  if (block->code != Code::cancel) {
    forbid(now);
    block->radius = memory_.d(number_);
    // fanuc.leading-edge.number-changed: Another D while the mode is on counts for the vector at the end of the block
    // that has it. A vector that is kept keeps its length.
    recorder().decide(Clause::fanuc_leading_edge_number_changed, active_ && codes.d.has_value());
  }
  return block;
}

void LeadingEdgeOffset::complete(StageWords& words, const Step& step) const {
  EdgeBlock& block = own(words);
  // fanuc.leading-edge.no-movement: A block counts as one without movement if its travel in X Y Z is exactly zero:
  // rotary axes alone, a tool direction alone, M S T F H alone, a travel of zero. A block with N or O alone is no
  // block.
  if (block.code == EdgeBlock::Code::none)
    block.travels = !recorder().decide(Clause::fanuc_leading_edge_no_movement,
                                       step.moves.empty() || is_zero(step.moves.front().leg.travel));
}

void LeadingEdgeOffset::forbid(const StageCommand& now) const {
  const Codes& codes = now.command.codes;
  const bool other = codes.compensation && (is_cutter_side(*codes.compensation) || is_tool_side(*codes.compensation));
  const bool code =
      codes.one_shot != OneShot::none || codes.workpiece || codes.units || codes.refused_in_space || other;
  // fanuc.leading-edge.forbidden: Codes that do not go together with the leading edge offset raise
  // FORBIDDEN_IN_3D_COMPENSATION (the alarm number is not known) in a block after which the mode is on. These are G04
  // G10 G28 G29 G30 G30.1 G37 G39 G41 G42 G41.2 G42.2 G41.6 G42.6 G45 to G48 G52 G53 G92 G54 to G59 G54.1 G20 G21 G96
  // G97 G160, G05 except with P10000, and an M, S or T word together with an axis word.
  if (code || (codes.auxiliary && now.moves()))
    raise(recorder(), Clause::fanuc_leading_edge_forbidden, AlarmCause::forbidden_in_compensation);
}

void LeadingEdgeOffset::take(const Step& step) {
  if (!has_words(step)) {
    hand_on(step);
    return;
  }
  const EdgeBlock& block = said(step);
  if (block.code == EdgeBlock::Code::start) {
    active_ = starting_ = true;
    vector_ = {};
    held_ = step;
  } else if (block.code == EdgeBlock::Code::cancel) {
    take_cancel(step);
  } else if (block.travels) {
    take_moving(step);
  } else {
    take_other(step);
  }
}

void LeadingEdgeOffset::take_moving(const Step& step) {
  if (held_) {
    const Vector& movement = step.moves.front().leg.travel;
    decide_held();
    if (starting_) {
      try {
        vector_ = rules_.first(movement, held_->rest.tool, said(*held_).radius);
      } catch (Alarm& alarm) {
        alarm.line = held_->line;
        alarm.n = held_->n;
        held_.reset();
        throw;
      }
    } else {
      // fanuc.leading-edge.one-block-without-movement: If one block without movement comes between two moving blocks,
      // the vector is made of the tool direction before that block and the movement after it. The vector is kept
      // through that block, whatever the tool does there.
      recorder().decide(Clause::fanuc_leading_edge_one_block_without_movement, !behind_.empty());
      vector_ = rules_.next(vector_, movement, held_->rest.tool, said(*held_).radius);
    }
    release(&step);
  }
  held_ = step;
}

// A block without linear movement.
void LeadingEdgeOffset::take_other(const Step& step) {
  // fanuc.leading-edge.no-movement-after-start: The G41.3 block raises PS5407 if the block right after it has no linear
  // movement: no travel in X Y Z, G40, the end of the program, or a block that raises an alarm of its own.
  if (step.has_word && starting_)
    start_alarm(Clause::fanuc_leading_edge_no_movement_after_start, AlarmCause::leading_edge_command);
  if (!held_) {
    emit(step);
    return;
  }
  // A block with N or O alone is no block: any number of them may come, and has nothing to wait for.
  if (!step.has_word && !behind_.empty()) return;
  behind_.push_back(step);
  const auto counted = std::ranges::count_if(behind_, [](const Step& s) { return s.has_word; });
  if (!step.stops_look_ahead && counted < 2) return;
  decide_held();
  // fanuc.leading-edge.kept-without-look-ahead: Before a block that stops the look-ahead (an M code of
  // fanuc.program.stops-reading-ahead), the vector made before is kept. This holds also if that block is the cancel
  // block.
  // fanuc.leading-edge.two-blocks-without-movement: If two or more blocks without movement come in a row, the vector
  // made before is kept: the moving block before them ends with the vector it started with. What exactly is kept is our
  // reading.
  recorder().reach(step.stops_look_ahead ? Clause::fanuc_leading_edge_kept_without_look_ahead
                                         : Clause::fanuc_leading_edge_two_blocks_without_movement);
  release(&step);
}

// The block before makes its vector from its own movement; then the tool returns to the programmed point.
void LeadingEdgeOffset::take_cancel(const Step& step) {
  if (starting_) start_alarm(Clause::fanuc_leading_edge_no_movement_after_start, AlarmCause::leading_edge_command);
  if (held_) {
    decide_held();
    if (step.stops_look_ahead) {
      recorder().reach(Clause::fanuc_leading_edge_kept_without_look_ahead);
    } else {
      // fanuc.leading-edge.before-cancel: The block before G40 makes its vector from its own movement and the tool
      // direction at its end. That the ranges near 0, 90 and 180 degrees hold here too, and that one block without
      // movement may come between, is our definition.
      recorder().reach(Clause::fanuc_leading_edge_before_cancel);
      vector_ = rules_.next(vector_, held_->moves.front().leg.travel, held_->rest.tool, said(*held_).radius);
    }
    release(&step);
  }
  active_ = false;
  vector_ = {};
  // fanuc.leading-edge.cancel: At G40 the tool returns by the vector to the programmed point, in rapid traverse under
  // G00, otherwise straight with the feed. G40 while nothing is on does nothing.
  recorder().reach(Clause::fanuc_leading_edge_cancel);
  Step cancel = step;
  cancel.clauses.add(recorder().take_clauses());
  emit(cancel, spec::Cause::cancel);
}

void LeadingEdgeOffset::finish() {
  if (!held_) return;
  if (starting_) start_alarm(Clause::fanuc_leading_edge_no_movement_after_start, AlarmCause::leading_edge_command);
  decide_held();
  // fanuc.leading-edge.kept-at-the-end: At the end of the program, and before a block that ends the run by an alarm,
  // the vector made before is kept.
  recorder().reach(Clause::fanuc_leading_edge_kept_at_the_end);
  release(nullptr);
}

void LeadingEdgeOffset::release(const Step* now) {
  held_->clauses.add(recorder().take_clauses());
  if (starting_) {
    emit(*held_, spec::Cause::start_up);
    starting_ = false;
  } else {
    emit(*held_);
  }
  for (const Step& step : behind_) emit(step);
  held_.reset();
  behind_.clear();
  if (now != nullptr) recorder().at(now->line);
}

void LeadingEdgeOffset::emit(const Step& step) {
  Step out = step;
  for (Move& move : out.moves) move.offset = vector_.vector;
  hand_on(out);
}

void LeadingEdgeOffset::emit(const Step& step, spec::Cause inserted) {
  Step out = step;
  out.moves = {step.rest};
  out.moves.front().leg.cause = inserted;
  out.moves.front().offset = vector_.vector;
  hand_on(out);
}

void LeadingEdgeOffset::start_alarm(Clause clause, AlarmCause cause) {
  decide_held();
  recorder().reach(clause);
  Alarm raised(cause);
  raised.line = held_->line;
  raised.n = held_->n;
  held_.reset();
  throw Alarm(raised);
}

}  // namespace toolcomp::model
