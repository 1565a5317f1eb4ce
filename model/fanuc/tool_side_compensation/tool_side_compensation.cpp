// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_side_compensation/tool_side_compensation.h"

#include <utility>

#include "model/basis/alarm.h"
#include "model/basis/number.h"

namespace toolcomp::model {
namespace {

// Vectors are zero where their offset is, and nowhere else: such components are known.
bool is_zero_vector(const Vector& v) {
  const auto zero = [](const Real& x) { return x.is_rational() && x.sign() == Sign::zero; };
  return zero(v.x) && zero(v.y) && zero(v.z);
}

}  // namespace

// fanuc.tool-side.one-block-without-movement: If one block between A and B does not move in the plane at the end of A
// (a rotation alone, a movement along the tool), the group is made of A and B in that plane, with VT before the first
// block between.
// fanuc.tool-side.no-next-block: If there is no B, block A, also a start-up block, ends with the vector perpendicular
// to it too. There is no B at the end of the program, before a block that raises an alarm when it is read or leaves the
// run undecided, and before G40 or number 0 in a block that does not move in the plane at the end of A.
ToolSideCompensation::ToolSideCompensation(const Place& place)
    : StageOf(place),
      words_(place.setup, place.memory, place.recorder),
      rules_(place.setup, place.recorder),
      plane_change_(place.setup, place.recorder),
      axes_(place.setup.axes),
      limit_(place.setup.parameter(19630) ? plain(*place.setup.parameter(19630)) : Rational(0)),
      type_c_(place.setup.bit(5003, 1)),
      on_mixed_machine_(parameter(place.setup, 19680) == 21),
      series_30i_(place.setup.series == spec::Series::series_30i),
      ahead_(place, *this,
             {LookAhead::Between::at_last_head, Clause::fanuc_tool_side_one_block_without_movement,
              Clause::fanuc_tool_side_no_next_block, blocks_read(place.setup) - 1}) {}

void ToolSideCompensation::refuse_rotary_word(const Command& command) const {
  // fanuc.tool-side.rotary-word: A rotary axis word in a block under G43.5 raises PS5460 if tool side compensation is
  // on before or after the block. Otherwise it raises PS5421 (fanuc.tool-center-point.rotary-word).
  if (on() || on_after(command))
    raise(recorder(), Clause::fanuc_tool_side_rotary_word, AlarmCause::rotary_word_in_compensation);
}

std::shared_ptr<StageWords> ToolSideCompensation::read(const StageCommand& now) {
  std::shared_ptr<ToolSideBlock> block = words_.read(now);
  if (!block) return nullptr;
  check(*block);
  words_.add_value(*block);
  return block;
}

void ToolSideCompensation::check(const ToolSideBlock& words) const {
  // fanuc.tool-side.code-for-the-mode: Under G43.5, where I J K give the tool direction, the codes are G41.6 and G42.6;
  // otherwise they are G41.2 and G42.2. The codes of both pairs mean the same (a program of the manual shows G42.6).
  if (words.wrong_mode) raise(recorder(), Clause::fanuc_tool_side_code_for_the_mode, AlarmCause::side_mode);
  // fanuc.tool-side.plane-selected: A G17, G18 or G19 that changes the plane raises PS0037 if tool side compensation is
  // on before the block. This holds also for the block that cancels it.
  if (on() && words.plane_changed) raise(recorder(), Clause::fanuc_tool_side_plane_selected, AlarmCause::plane_change);
  forbid(words);
  // fanuc.tool-side.q-format: A Q with another value than 1, 2 or 3 in a block after which tool side compensation is on
  // raises Q_FORMAT, a name of ours, whatever else the block does. In other blocks Q is not looked at.
  if (words.wanted() && words.treatment == 0)
    raise(recorder(), Clause::fanuc_tool_side_q_format, AlarmCause::treatment);
  const bool starts = words.wanted() && !ahead_.in_mode() && ahead_.held().empty();
  const bool cancels = !words.wanted() && ahead_.in_mode();
  check_type_c(words, starts, cancels);
  // fanuc.cutter-c.start-or-cancel-in-arc: An arc as start-up block or as cancel block raises PS0034. The words of the
  // block tell whether it is an arc: G02 or G03 in force, no code of group 00 in the block (G45 to G48 do not count
  // here), and an axis word of the plane, R, I, J or K in the block. In tool side compensation I, J and K count even if
  // they are a tool direction, because the manual speaks of the mode.
  if (words.arc_words && (starts || cancels))
    raise(recorder(), Clause::fanuc_cutter_c_start_or_cancel_in_arc, AlarmCause::arc_at_start_or_cancel);
  // fanuc.tool-side.arc-on-mixed-machine: On the 30i only G00 and G01 are allowed in compensation on a mixed machine
  // (19680 = 21). There an arc in a block after which tool side compensation is on raises PS5461; the words of the
  // block tell whether it is an arc, as in fanuc.cutter-c.start-or-cancel-in-arc. The 16i runs the arc.
  if (words.arc_words && words.wanted() && on_mixed_machine_ &&
      recorder().decide(Clause::fanuc_tool_side_arc_on_mixed_machine, series_30i_))
    throw Alarm(AlarmCause::arc_in_compensation);
}

void ToolSideCompensation::forbid(const ToolSideBlock& words) const {
  const bool around = (on() || words.wanted()) && words.leaves_the_path;
  const bool after =
      words.wanted() && (words.refused_while_on || (words.auxiliary && (words.moves || words.arc_words)));
  // fanuc.tool-side.forbidden: Codes that do not go together with tool side compensation raise
  // FORBIDDEN_IN_3D_COMPENSATION (the alarm number is not known). In a block after which the compensation is on, these
  // are G54 to G59, G54.1, G20, G21, G96, G97, G160, G05 except with P10000, and an M, S or T word together with an
  // axis word (I J K under G43.5 included) or in an arc.
  if (around || after || (on() && words.other_compensation))
    raise(recorder(), Clause::fanuc_tool_side_forbidden, AlarmCause::forbidden_in_compensation);
}

void ToolSideCompensation::check_type_c(const ToolSideBlock& words, bool starts, bool cancels) const {
  if (!type_c_ || !(starts || cancels)) return;
  // fanuc.tool-side.type-c-format: A block of type C that makes or removes the vector raises TYPE_C_FORMAT (a name of
  // ours, the number is not known) if it has an axis word, linear or rotary (I J K under G43.5 included), or if G02 or
  // G03 is in force. A block that makes the vector also raises it with an M code that stops reading ahead
  // (fanuc.program.stops-reading-ahead), or if the block right after it does not move in the plane of VT before that
  // block (its own end does not matter), cancels, raises an alarm of its own (DIR_CHANGE_AT_STARTUP and PS0038 too),
  // leaves the run undecided or is not there.
  if (words.moves || words.arc_mode || (starts && words.stops_look_ahead))
    raise(recorder(), Clause::fanuc_tool_side_type_c_format, AlarmCause::type_c_format);
}

void ToolSideCompensation::take(const Step& step) {
  if (!has_words(step) || !said(step).is_block) {
    hand_on(step);
    return;
  }
  Step now = step;
  const ToolSideBlock& block = said(now);
  const bool in_force = block.side != CutterSide::none;
  // fanuc.cutter-c.number-zero: Number 0 in force acts as G40 does. G41 or G42 stays in force, and a later number other
  // than 0 asks for the mode again. A number other than 0 whose value is 0 does not cancel: the mode starts and stays
  // on.
  const bool wanted = in_force && !recorder().decide(Clause::fanuc_cutter_c_number_zero, block.number == 0);
  const Direction tool = now.rest.tool;
  // fanuc.tool-side.look-ahead-stopped: An M code that stops reading ahead (fanuc.program.stops-reading-ahead) stops
  // the look-ahead. The block A before it, also a start-up block, ends with the vector perpendicular to it.
  if (now.stops_look_ahead) ahead_.end_before(now, Clause::fanuc_tool_side_look_ahead_stopped);
  Movement movement;
  if (wanted || ahead_.in_mode()) movement = movement_of(now);
  const bool started = ahead_.holds(Held::Kind::lone_start);
  // The block right behind a lone start must move there and stay in the mode.
  if (started && (!wanted || !movement.starts.front())) ahead_.end_before(now);
  if (!ahead_.in_mode() && !started)
    take_while_off(now, wanted, movement);
  else if (wanted)
    take_in_mode(now, movement);
  else if (ahead_.mode == CornerMode::on || movement.end)
    take_cancel(now, movement);
  else
    ahead_.keep(now);
  before_ = tool;
}

void ToolSideCompensation::finish() { ahead_.end(); }

void ToolSideCompensation::take_while_off(Step& now, bool wanted, Movement& movement) {
  ahead_.mode = wanted ? CornerMode::waiting : CornerMode::off;
  // fanuc.tool-side.type-c: Start-up and cancel are of type C if No. 5003 bit 1, SUV, is 1, whatever bit 0 is. If SUV
  // is 0, bit 0 chooses between the other two types (fanuc.tool-side.type-b).
  if (wanted && recorder().decide(Clause::fanuc_tool_side_type_c, type_c_)) {
    start(now, Held::Kind::lone_start, movement);
  } else if (wanted && movement.end) {
    // fanuc.tool-side.start-up: With types A and B, if a code and a number other than 0 are in force and there is no
    // vector yet, the next block that moves in the plane (of VT at its own end) is the start-up block. The tool goes
    // straight from the uncompensated start of that block to the first head of the group at its end, which is made in
    // the plane there; the cause is start-up.
    recorder().reach(Clause::fanuc_tool_side_start_up);
    ahead_.mode = CornerMode::on;
    start(now, Held::Kind::start_up, movement);
  } else {
    ahead_.emit(now);
  }
}

void ToolSideCompensation::start(Step& now, Held::Kind kind, Movement& movement) {
  const CutterOffset offset = offset_of(recorder(), said(now).side, said(now).offset);
  if (movement.end) movement.end->offset = offset.left();
  hold(now, kind, offset, movement);
}

void ToolSideCompensation::take_in_mode(Step& now, Movement& movement) {
  // fanuc.cutter-c.restart-before-removal: If G41 or G42 with a number other than 0 is in force again after a lone G40
  // or number 0, before the vector is removed, the run is undecided at that block. The blocks before it are given as if
  // it were absent. A vector that is exactly zero is removed at once.
  if (ahead_.mode == CornerMode::leaving)
    ahead_.leave_open_at(now, Clause::fanuc_cutter_c_restart_before_removal,
                         "tool side compensation again before the vector of the cancelled mode is removed");
  CutterOffset offset;
  if (movement.moves()) {
    const Leg& leg = now.moves.front().leg;
    // fanuc.cutter-c.arc-ends-in-center: An arc block with G41 or G42 and a number other than 0 in force raises PS0038
    // if its centre is its start or its end; both cases are alike. This is an alarm of a command. It comes after the
    // alarms that the words alone raise (PS0034 of a start-up in an arc among them) and after those of the length
    // offset.
    if (leg.arc && !leg.arc->sweep)
      raise(recorder(), Clause::fanuc_cutter_c_arc_ends_in_center, AlarmCause::arc_ends_in_center);
    offset = ahead_.next_offset(now, !movement.starts.empty() && movement.starts.front());
    look_at_movement(now, movement, offset);
  }
  meet_corners(now, movement, offset);
  if (movement.end) {
    hold(now, Held::Kind::moving, offset, movement);
    return;
  }
  if (movement.moves()) ahead_.moved(offset);
  const bool cuts_corner = movement.moves_behind();
  const bool is_next = ahead_.held().empty() || ahead_.held().back().met;
  // fanuc.tool-side.along-the-tool-at-its-end: A block that is B of a corner but does not move in the plane at its own
  // end has no vector made there. This happens if the tool turns in the block so that the displacement is along the
  // tool there, or shorter than 19630 as seen there. The block ends with the last vector at its start, and the next
  // block that moves at its own end starts from that vector, without a corner.
  if (cuts_corner) recorder().reach(Clause::fanuc_tool_side_along_the_tool_at_its_end);
  ahead_.keep(now);
  if (cuts_corner && is_next) ahead_.leave_corner();
}

void ToolSideCompensation::meet_corners(Step& now, const Movement& movement, const CutterOffset& offset) {
  const bool cancels = !said(now).wanted();
  // fanuc.tool-side.two-blocks-without-movement: As soon as two blocks that do not move in the plane at the end of A
  // follow block A (on the 30i N - 1, fanuc.tool-side.look-ahead), A ends with the vector perpendicular to it, and
  // there is no corner.
  const Clause why =
      cancels ? Clause::fanuc_tool_side_no_next_block : Clause::fanuc_tool_side_two_blocks_without_movement;
  const auto group = [this, cancels, tool = now.rest.tool, movement, offset](Held& held, std::size_t corner) {
    const SideEnd& start = *movement.starts[corner];
    return held.stands() ? vector_of_start(held, start)
                         : group_before(held, {cancels, tool, movement.path, start, offset});
  };
  ahead_.meet(now, {movement.corners(), cancels ? ahead_.limit() : 1, why, group});
}

void ToolSideCompensation::take_cancel(Step& now, Movement& movement) {
  for (std::size_t i = 0; i < movement.starts.size(); ++i)
    if (movement.starts[i]) movement.starts[i]->offset = ahead_.held()[i].offset.left();
  meet_corners(now, movement, ahead_.last_offset());
  if (!movement.end) {
    cancel_alone(now, movement.moves_behind());
    return;
  }
  // fanuc.tool-side.cancel: With types A and B, the first block that moves in the plane at its own end with G40 or
  // number 0 in force is the cancel block. The tool goes straight from the last head of the group at its start to its
  // programmed end; the cause is cancel.
  recorder().reach(Clause::fanuc_tool_side_cancel);
  ahead_.take_away(now);
}

// G40 or number 0 in a block that does not move in the plane at its own end.
void ToolSideCompensation::cancel_alone(Step& now, bool cuts_corner) {
  const bool has_vector = !is_zero_vector(ahead_.here().back().vector);
  const bool at_once = recorder().decide(Clause::fanuc_tool_side_type_c, type_c_);
  // fanuc.tool-side.cancel-type-c: With type C, the last compensated block ends with the vector perpendicular to it.
  // The block with G40 or number 0, which has no move of its own, inserts a move that takes the vector away. The cause
  // of this move is cancel, and it is of the kind of group 01.
  // fanuc.tool-side.cancel-without-movement: With types A and B, G40 or number 0 in a block that does not move in the
  // plane at its own end keeps the last vector at its start. The next block that moves in the plane of VT at its own
  // end removes that vector: the tool goes straight to the end of that block, the cause is cancel, and an arc raises
  // PS0034.
  recorder().reach(at_once ? Clause::fanuc_tool_side_cancel_type_c : Clause::fanuc_tool_side_cancel_without_movement);
  if (cuts_corner && !at_once) recorder().reach(Clause::fanuc_tool_side_along_the_tool_at_its_end);
  ahead_.cancel_alone(now, has_vector, at_once);
  if (cuts_corner && !at_once) ahead_.leave_corner();
}

void ToolSideCompensation::hold(Step& now, Held::Kind kind, const CutterOffset& offset, const Movement& movement) {
  auto held = std::make_shared<HeldSidePath>();
  held->plane = movement.own;
  held->path = movement.path;
  if (movement.end) held->end = *movement.end;
  if (const auto& arc = movement.path.arc) {
    const bool at_corner = !movement.starts.empty() && movement.starts.back();
    held->plane_at_start = corner_plane_;
    held->offset_at_start = offset.side * ahead_.last_offset().distance;
    const CompensationPlane& plane = at_corner ? corner_plane_ : movement.own;
    const Rational rho = at_corner ? held->offset_at_start : offset.left();
    held->start = seen(plane, plane.frame(), arc_start(*arc, rho));
  }
  ahead_.hold(now, kind, offset, std::move(held));
}

void ToolSideCompensation::end_standing(Clause /*why*/) {
  ahead_.raise_held(Clause::fanuc_tool_side_type_c_format, AlarmCause::type_c_format);
}

void ToolSideCompensation::released(const Held& held) { corner_plane_ = side_path_of(held).plane; }

}  // namespace toolcomp::model
