// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/cutter_compensation_c/cutter_compensation_c.h"

#include <memory>
#include <utility>
#include <vector>

#include "model/basis/alarm.h"

namespace toolcomp::model {
namespace {

bool is_machine_move(PlaneMotion motion) {
  return motion == PlaneMotion::machine_coordinates || motion == PlaneMotion::reference ||
         motion == PlaneMotion::from_reference;
}

// G52 or G92 of the plane.
bool shifts_plane(const CutterBlock& block) { return is_shift(block.one_shot) && block.has_plane_word(); }

// A word G41 or G42.
bool has_side_word(const CutterBlock& block) { return block.code && *block.code != CutterSide::none; }

}  // namespace

// fanuc.cutter-c.one-non-motion-block: If the count between A and B is smaller than that of
// fanuc.cutter-c.two-non-motion-blocks (so it is one, or on the 30i more, by No. 19625), the group is made as if the
// blocks between were not there. The blocks between run at the first head, before the corner moves.
// fanuc.cutter-c.no-next-block: If there is no B to make a corner with, block A, also a start-up block, ends with P1 as
// well. There is no B at the end of the program, before a block that raises an alarm when it is read or leaves the run
// undecided, and before G39, G29 with axis words, G28, G30 or G30.1 with axis words (except in
// fanuc.cutter-c.reference-intersection), a lone G40 and a lone number 0.
CutterCompensationC::CutterCompensationC(const Place& place)
    : CutterCompensation(place),
      rules_(place.setup, place.recorder),
      axes_(place.setup.axes),
      at_once_(place.setup.bit(5003, 1)),
      keeps_the_mode_(place.setup.bit(5003, 2)),
      ahead_(place, *this,
             {LookAhead::Between::at_first_head, Clause::fanuc_cutter_c_one_non_motion_block,
              Clause::fanuc_cutter_c_no_next_block, blocks_read(place.setup) - 1,
              LookAhead::Rules::Interference{
                  .keeps_vectors = place.setup.series == spec::Series::series_30i && place.setup.bit(5008, 3),
                  .no_alarm = place.setup.bit(5008, 1)}}) {}

bool CutterCompensationC::wanted(CutterSide side, std::uint32_t number) const {
  return side != CutterSide::none && number != 0;
}

void CutterCompensationC::check(const CutterBlock& words) const {
  check_common(words);
  if (words.one_shot == OneShot::corner_arc) check_corner_arc(words);
  if (!words.arc_words) return;
  const bool starts = wanted(words) && !ahead_.in_mode() && ahead_.held().empty();
  const bool cancels = !wanted(words) && ahead_.in_mode();
  // fanuc.cutter-c.start-or-cancel-in-arc: An arc as start-up block or as cancel block raises PS0034. The words of the
  // block tell whether it is an arc: G02 or G03 in force, no code of group 00 in the block (G45 to G48 do not count
  // here), and an axis word of the plane, R, I, J or K in the block.
  if (starts || cancels)
    raise(recorder(), Clause::fanuc_cutter_c_start_or_cancel_in_arc, AlarmCause::arc_at_start_or_cancel);
}

void CutterCompensationC::check_corner_arc(const CutterBlock& words) const {
  const bool has_vector = ahead_.mode == CornerMode::on && (!ahead_.held().empty() || made_by_move_);
  const bool other_number = words.number_given && words.number != words.number_before;
  const bool no_direction = words.direction && is_zero(*words.direction);
  // fanuc.cutter-c.corner-arc-alarm: G39 raises PS0035 with G40 or number 0 in force, or after them while a vector
  // waits for its removal. It raises PS0035 before a moving block has made a vector: before the start-up block, after a
  // G41 or G42 of SUV = 1, and after G53, G28, G30, G30.1, G29, G52 or G92 of the plane. It raises PS0035 with G41,
  // G42, an axis word, or a word that gives the cutter another number in its block, and with letters of the plane that
  // are all 0.
  if (!wanted(words) || !has_vector || has_side_word(words) || words.axis_word || other_number || no_direction)
    raise(recorder(), Clause::fanuc_cutter_c_corner_arc_alarm, AlarmCause::corner_arc);
}

void CutterCompensationC::take(const Step& step) {
  if (!has_words(step)) {
    hand_on(step);
    return;
  }
  Step now = step;
  const CutterBlock& block = said(now);
  const bool in_force = block.side != CutterSide::none;
  // fanuc.cutter-c.number-zero: Number 0 in force acts as G40 does. G41 or G42 stays in force, and a later number other
  // than 0 asks for the mode again. A number other than 0 whose value is 0 does not cancel: the mode starts and stays
  // on.
  const bool wanted = in_force && !recorder().decide(Clause::fanuc_cutter_c_number_zero, block.number == 0);
  // fanuc.cutter-c.moving-block: A block moves in the plane if its end differs from its start in an axis of the plane,
  // or if it is a full circle. Its path is that of G00, G01, G02 or G03 seen in the plane.
  const bool moves = recorder().decide(Clause::fanuc_cutter_c_moving_block,
                                       block.motion == PlaneMotion::line || block.motion == PlaneMotion::arc);
  if (ahead_.holds(Held::Kind::lone_start) && (!wanted || is_machine_move(block.motion) || shifts_plane(block))) {
    now.clauses.add(recorder().take_clauses());
    drop_lone_start();
  }
  // fanuc.cutter-c.look-ahead-stopped: Nothing is read beyond a block with G53, whatever its words, or with an M code
  // that stops reading ahead (fanuc.program.stops-reading-ahead), before that block has run.
  const bool stops = now.stops_look_ahead || block.one_shot == OneShot::machine_coordinates;
  const bool may_be_next = moves || block.motion == PlaneMotion::reference;
  if (stops && !may_be_next) ahead_.end_before(now, Clause::fanuc_cutter_c_look_ahead_stopped);
  if (ahead_.in_mode() || ahead_.holds(Held::Kind::lone_start))
    take_while_on(now, wanted, moves);
  else
    take_while_off(now, wanted, moves);
  if (stops) ahead_.end_behind(Clause::fanuc_cutter_c_look_ahead_stopped);
}

void CutterCompensationC::finish() { ahead_.end(); }

void CutterCompensationC::take_while_off(Step& now, bool wanted, bool moves) {
  ahead_.mode = wanted ? CornerMode::waiting : CornerMode::off;
  unchecked_ = false;
  const CutterBlock& block = said(now);
  // fanuc.cutter-c.suv: With No. 5003 bit 1, SUV, at 1 (type C), a G41 or G42 that starts the mode, and a G40 or number
  // 0 that ends it, act at once in a block that does not move in the plane. With SUV = 0 such a block makes and removes
  // nothing.
  if (wanted && moves) {
    // fanuc.cutter-c.start-up: If G41 or G42 and a number other than 0 are in force and the mode is off, the next block
    // that moves in the plane is the start-up block, whether it has the code or not (except in
    // fanuc.cutter-c.start-without-motion).
    recorder().reach(Clause::fanuc_cutter_c_start_up);
    const CutterOffset offset = offset_of(recorder(), block.side, block.offset);
    ahead_.mode = CornerMode::on;
    hold_moving(now, Held::Kind::start_up, path_of(block, offset, offset.distance), offset);
  } else if (wanted && has_side_word(block) && !is_machine_move(block.motion) &&
             recorder().decide(Clause::fanuc_cutter_c_suv, at_once_)) {
    ahead_.hold(now, Held::Kind::lone_start, offset_of(recorder(), block.side, block.offset), nullptr);
  } else {
    ahead_.emit(now);
  }
}

// The code has no vector to make: the next moving block is a start-up block.
void CutterCompensationC::drop_lone_start() {
  const std::uint64_t line = recorder().line();
  recorder().at(ahead_.held().front().step.line);
  // fanuc.cutter-c.start-without-next-block: If no B follows the G41 or G42 of SUV = 1, no vector is made. The mode is
  // then off, and the next moving block is a start-up block if G41 or G42 is still in force. No B follows if one of
  // these comes first: a count of fanuc.cutter-c.two-non-motion-blocks; a case of fanuc.cutter-c.no-next-block, G28
  // included; a block that stops reading ahead; G52 or G92 of the plane; or a block in which the mode is no longer
  // asked for, also the cancel block.
  recorder().reach(Clause::fanuc_cutter_c_start_without_next_block);
  ahead_.pass();
  recorder().at(line);
}

void CutterCompensationC::take_while_on(Step& now, bool wanted, bool moves) {
  const CutterBlock& block = said(now);
  // fanuc.cutter-c.restart-before-removal: If G41 or G42 with a number other than 0 is in force again after a lone G40
  // or number 0, before the vector is removed, the run is undecided at that block. The blocks before it are given as if
  // it were absent. A vector that is exactly zero is removed at once.
  if (wanted && ahead_.mode == CornerMode::leaving)
    ahead_.leave_open_at(now, Clause::fanuc_cutter_c_restart_before_removal,
                         "G41 or G42 again before the vector of the cancelled mode is removed");
  if (shifts_plane(block)) take_vector_for_a_time(now);
  if (is_machine_move(block.motion)) {
    take_machine_move(now, wanted);
  } else if (!wanted) {
    if (moves)
      take_cancel(now);
    else if (ahead_.mode == CornerMode::leaving && block.motion == PlaneMotion::zero_travel)
      cancel_by_zero_travel(now);
    else if (ahead_.mode == CornerMode::on)
      cancel_alone(now);
    else
      ahead_.keep(now);
  } else if (moves) {
    take_moving(now);
  } else if (block.one_shot == OneShot::corner_arc) {
    take_corner_arc(now);
  } else {
    take_without_motion(now);
  }
}

void CutterCompensationC::take_moving(Step& now) {
  const CutterBlock& block = said(now);
  // fanuc.cutter-c.arc-ends-in-center: An arc block with G41 or G42 and a number other than 0 in force raises PS0038 if
  // its centre is its start or its end; both cases are alike. This is an alarm of a command. It comes after the alarms
  // that the words alone raise (PS0034 of a start-up in an arc among them) and after those of the length offset.
  if (block.arc && !block.arc->sweep)
    raise(recorder(), Clause::fanuc_cutter_c_arc_ends_in_center, AlarmCause::arc_ends_in_center);
  const CutterOffset offset = ahead_.next_offset(now, true);
  const OffsetPath path = path_of(block, offset, ahead_.last_offset().distance);
  meet_corner(now, path, offset);
  hold_moving(now, Held::Kind::moving, path, offset);
}

void CutterCompensationC::hold_moving(Step& now, Held::Kind kind, const OffsetPath& path, const CutterOffset& offset) {
  const bool checked = !std::exchange(unchecked_, false);
  ahead_.hold(now, kind, offset, std::make_shared<HeldCutterPath>(said(now).plane, path), checked);
}

void CutterCompensationC::meet_corner(Step& now, const OffsetPath& path, const CutterOffset& offset) {
  const CutterBlock& block = said(now);
  const auto group = [&](Held& held, std::size_t /*corner*/) {
    if (held.kind == Held::Kind::lone_start) return vector_of_start(held, path.start);
    if (held.kind == Held::Kind::corner_arc)
      return turn(held.step, path.start.heading, offset.side == held.offset.side);
    return group_before(held, block, path, offset);
  };
  ahead_.meet(now, {std::vector(ahead_.held().size(), true), 0, {}, group});
}

void CutterCompensationC::take_without_motion(Step& now) {
  const CutterBlock& block = said(now);
  int counts = 0;
  // fanuc.cutter-c.non-motion-count: Between two moving blocks, every block that does not move in the plane counts one:
  // M, S, T, F, G04, G10, other G codes, axes outside the plane, D or H alone, O alone, G41 or G42 alone.
  if (block.is_block && !ahead_.held().empty())
    counts = recorder().decide(Clause::fanuc_cutter_c_non_motion_count, block.motion == PlaneMotion::zero_travel)
                 ? ahead_.limit()
                 : 1;
  if (ahead_.holds(Held::Kind::lone_start) && has_side_word(block) &&
      ahead_.held().front().without_movement + counts >= ahead_.limit()) {
    // The look-ahead ends here without a moving block; the code has one of its own.
    now.clauses.add(recorder().take_clauses());
    drop_lone_start();
    take_while_off(now, true, false);
    return;
  }
  // fanuc.cutter-c.two-non-motion-blocks: As soon as the count after block A is two or more, A ends with P1. This holds
  // for a start-up block too. The next moving block starts from that vector, so there is no corner.
  ahead_.meet(now,
              {std::vector(ahead_.held().size(), false), counts, Clause::fanuc_cutter_c_two_non_motion_blocks, {}});
  ahead_.keep(now);
}

void CutterCompensationC::take_vector_for_a_time(Step& now) {
  // fanuc.cutter-c.coordinate-shift: G52 or G92 with an axis word of the plane while the mode is on takes the vector
  // away for a time. The block before, A, ends at its programmed point, without a move of its own for that. This holds
  // also if A is a start-up block, and with or without a block without motion between. The mode stays on, whatever CCN
  // is. The next moving block, also an arc, runs from there to its ordinary group, without a corner and without a
  // change of direction before it.
  if (!ahead_.held().empty() && !ahead_.held().front().stands()) {
    ahead_.end_without_vector(now, Clause::fanuc_cutter_c_coordinate_shift);
  } else {
    ahead_.end_before(now);
    // fanuc.cutter-c.coordinate-shift-with-vector: If the tool is already at a vector, G52 or G92 with an axis word of
    // the plane leaves the run undecided at that block. The blocks before it are given as if it were absent. This
    // happens after G39, after a count of two (on the 30i: of one less than 19625 gives), and after a lone G40 or
    // number 0 whose vector waits. A vector of length 0 is none.
    if (!is_zero(in_plane_of(said(now).plane, ahead_.here().front().vector)))
      ahead_.leave_open_at(now, Clause::fanuc_cutter_c_coordinate_shift_with_vector,
                           "G52 or G92 while the tool is at a vector of cutter compensation C");
    recorder().decide(Clause::fanuc_cutter_c_coordinate_shift, false);
  }
  go_on_without_vector();
}

void CutterCompensationC::take_cancel(Step& now) {
  const CutterBlock& block = said(now);
  const CutterOffset& offset = ahead_.last_offset();
  meet_corner(now, line_path(block.end - block.start, offset.left(), offset.left()), offset);
  // fanuc.cutter-c.cancel: The first moving block with G40 or number 0 in force while the mode is on is the cancel
  // block. The tool goes straight from the last head of the group at its start to its programmed end; the cause is
  // cancel.
  recorder().reach(Clause::fanuc_cutter_c_cancel);
  ahead_.take_away(now);
}

// G40 or number 0 in a block that does not move in the plane.
void CutterCompensationC::cancel_alone(Step& now) {
  ahead_.end_before(now);
  // fanuc.cutter-c.cancel-without-motion: A G40 or number 0 in a block that does not move in the plane while the mode
  // is on is called lone; its I, J and K mean nothing. Block A ends with P1.
  recorder().reach(Clause::fanuc_cutter_c_cancel_without_motion);
  const bool removes = recorder().decide(Clause::fanuc_cutter_c_suv, at_once_);
  const bool has_vector = !is_zero(in_plane_of(said(now).plane, ahead_.here().front().vector));
  if (removes) see_move_alone(now, has_vector);
  ahead_.cancel_alone(now, has_vector, removes);
}

// Nothing is held: the lone G40 before it has seen to that.
void CutterCompensationC::cancel_by_zero_travel(Step& now) {
  // fanuc.cutter-c.cancel-by-zero-travel: After a lone G40 or number 0 with SUV = 0, a block with an axis word of the
  // plane but no travel there is a move command, and it is the cancel block. The vector is removed, and the tool ends
  // at the programmed point; the cause is cancel.
  recorder().reach(Clause::fanuc_cutter_c_cancel_by_zero_travel);
  ahead_.take_away(now);
}

// Beside G52 and G92 the only move there can be is that of the length offset (clause fanuc.cutter-c.workpiece-change).
void CutterCompensationC::see_move_alone(Step& step, bool changes) const {
  const CutterBlock& block = said(step);
  // The words of an ignored G53 are none.
  const bool ignored = block.one_shot == OneShot::machine_coordinates && block.motion == PlaneMotion::none;
  // fanuc.cutter-c.start-without-motion-move: If a block without motion in the plane makes or removes the vector and
  // has no axis word, it does so by a move of its own, of the kind of group 01 (linear under G02 and G03). If the block
  // has an axis word, its own move takes the vector along.
  recorder().decide(Clause::fanuc_cutter_c_start_without_motion_move, block.axis_word && !ignored);
  if (changes && is_shift(block.one_shot)) step.moves.clear();
}

void CutterCompensationC::end_standing(Clause why) {
  if (ahead_.holds(Held::Kind::lone_start)) {
    drop_lone_start();
    return;
  }
  const bool too_far = why == Clause::fanuc_cutter_c_two_non_motion_blocks;
  // fanuc.cutter-c.corner-arc-without-next-block: If a case of fanuc.cutter-c.no-next-block comes before the next
  // moving block, a G39 without letters makes no arc and keeps the vector. If a count of
  // fanuc.cutter-c.two-non-motion-blocks comes after the G39, the run is undecided at the G39 block, and the blocks
  // before it are given as if it were absent.
  if (recorder().decide(Clause::fanuc_cutter_c_corner_arc_without_next_block, too_far)) {
    LeftOpen open(Clause::fanuc_cutter_c_corner_arc_without_next_block,
                  "two blocks without motion after a G39 without direction");
    open.line = ahead_.held().front().step.line;
    open.n = ahead_.held().front().step.n;
    throw LeftOpen(open);
  }
  ahead_.pass();
}

void CutterCompensationC::released(const Held& held) {
  here_heading_ = path_of(held).end.heading;
  made_by_move_ = true;
}

}  // namespace toolcomp::model
