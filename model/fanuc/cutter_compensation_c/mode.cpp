// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/cutter_compensation_c/mode.h"

namespace toolcomp::model {
namespace {

// G52 or G92 of the plane.
bool shifts_plane(const CutterBlock& block) { return is_shift(block.one_shot) && block.has_plane_word(); }

// The path of a block that moves, a reference return to its intermediate point: at its start with the distance in force
// before it, each on the block's own side.
OffsetPath path_of(const CutterBlock& block, const CutterOffset& own, const Rational& distance_before) {
  const Rational at_start = own.side * distance_before;
  return block.arc ? arc_path(*block.arc, at_start, own.left())
                   : line_path(block.first_end - block.start, at_start, own.left());
}

}  // namespace

CutterPlan CutterMode::next(const Step& step, const std::optional<Waiting>& waiting) {
  const CutterBlock& block = *step.words.cutter;
  waiting_ = waiting;
  const bool asked = asks(block);
  // fanuc.cutter-c.moving-block: A block moves in the plane if its end differs from its start in an axis of the plane,
  // or if it is a full circle. Its path is that of G00, G01, G02 or G03 seen in the plane.
  const bool moves = recorder_.decide(Clause::fanuc_cutter_c_moving_block, block.moves());
  if (is_pending() && (!asked || is_machine_move(block.motion) || shifts_plane(block))) nothing_follows();
  // fanuc.cutter-c.look-ahead-stopped: Nothing is read beyond a block with G53, whatever its words, or with an M code
  // that stops reading ahead (fanuc.program.stops-reading-ahead), before that block has run.
  const bool stops = step.stops_look_ahead || block.one_shot == OneShot::machine_coordinates;
  if (stops && !moves && block.motion != PlaneMotion::reference) nothing_follows();
  asked_ = asked;
  CutterPlan plan = phase_ == Phase::off ? while_off(block) : while_on(block, step);
  if (stops) nothing_follows();
  plan.stops = stops;
  return plan;
}

void CutterMode::nothing_follows() {
  waiting_.reset();
  if (is_pending()) phase_ = Phase::off;
}

CutterPlan CutterMode::while_off(const CutterBlock& block) {
  // fanuc.cutter-c.suv: With No. 5003 bit 1, SUV, at 1 (type C), a G41 or G42 that starts the mode, and a G40 or number
  // 0 that ends it, act at once in a block that does not move in the plane. With SUV = 0 such a block makes and removes
  // nothing.
  const bool starts = asked_ && block.moves();
  const bool starts_alone = asked_ && !starts && block.says_side() && !is_machine_move(block.motion) &&
                            recorder_.decide(Clause::fanuc_cutter_c_suv, setup_.bit(5003, 1));
  if (!starts && !starts_alone) return of_part(CutterPart::free);
  // fanuc.cutter-c.start-up: If G41 or G42 and a number other than 0 are in force and the mode is off, the next block
  // that moves in the plane is the start-up block, whether it has the code or not (except in
  // fanuc.cutter-c.start-without-motion).
  if (starts) recorder_.reach(Clause::fanuc_cutter_c_start_up);
  last_ = offset_of(recorder_, block.side, block.offset);
  phase_ = starts ? Phase::started : Phase::pending;
  CutterPlan plan = of_part(starts ? CutterPart::start_up : CutterPart::lone_start);
  if (starts) plan.path = path_of(block, last_, last_.distance);
  plan.changes = last_.distance != 0;
  return plan;
}

CutterPlan CutterMode::while_on(const CutterBlock& block, const Step& step) {
  // fanuc.cutter-c.restart-before-removal: If G41 or G42 with a number other than 0 is in force again after a lone G40
  // or number 0, before the vector is removed, the run is undecided at that block. The blocks before it are given as if
  // it were absent. A vector that is exactly zero is removed at once.
  if (asked_ && phase_ == Phase::ending)
    leave_open_alone(recorder_, Clause::fanuc_cutter_c_restart_before_removal,
                     "G41 or G42 again before the vector of the cancelled mode is removed");
  const bool shifts = shifts_plane(block);
  const bool after_leg = shifts && take_vector_away();
  CutterPlan plan;
  if (is_machine_move(block.motion))
    plan = machine_move(block, step);
  else if (!asked_ && (block.moves() || (phase_ == Phase::ending && block.motion == PlaneMotion::zero_travel)))
    plan = cancel(block);
  else if (!asked_)
    plan = phase_ == Phase::ending ? of_part(CutterPart::idle) : lone_cancel();
  else if (block.moves())
    plan = in_mode(CutterPart::moving, block, step);
  else if (block.one_shot == OneShot::corner_arc)
    plan = of_part(CutterPart::corner_arc);
  else
    plan = without_motion(block);
  plan.shifts = shifts;
  plan.after_leg = after_leg;
  return plan;
}

CutterPlan CutterMode::in_mode(CutterPart part, const CutterBlock& block, const Step& step) {
  // fanuc.cutter-c.arc-ends-in-center: An arc block with G41 or G42 and a number other than 0 in force raises PS0038 if
  // its centre is its start or its end; both cases are alike. This is an alarm of a command. It comes after the alarms
  // that the words alone raise (PS0034 of a start-up in an arc among them) and after those of the length offset.
  if (block.arc && !step.moves.front().leg.arc->sweep)
    raise(recorder_, Clause::fanuc_cutter_c_arc_ends_in_center, AlarmCause::arc_ends_in_center);
  const CutterOffset offset = offset_of(recorder_, block.side, block.offset);
  // fanuc.cutter-c.direction-change-at-start-up: The first moving block after a start-up must not change the side; a
  // change raises DIR_CHANGE_AT_STARTUP, a name of ours, at that block. A start-up here is the start-up block, also one
  // that follows G53 or a reference return, or the G41 or G42 of SUV = 1. The rule holds however many blocks without
  // motion come between, and whatever the value.
  if (changes_side_at_start(offset))
    raise(recorder_, Clause::fanuc_cutter_c_direction_change_at_start_up, AlarmCause::side_change_at_start);
  CutterPlan plan{.part = part, .offset = offset, .path = path_of(block, offset, last_.distance)};
  plan.to_check = phase_ != Phase::taken_away;
  last_ = offset;
  phase_ = Phase::running;
  return plan;
}

CutterPlan CutterMode::without_motion(const CutterBlock& block) {
  CutterPlan plan = of_part(CutterPart::idle);
  if (!waiting_) return plan;
  // fanuc.cutter-c.non-motion-count: Between two moving blocks, every block that does not move in the plane counts one:
  // M, S, T, F, G04, G10, other G codes, axes outside the plane, D or H alone, O alone, G41 or G42 alone.
  plan.count = recorder_.decide(Clause::fanuc_cutter_c_non_motion_count, block.motion == PlaneMotion::zero_travel)
                   ? idle_limit
                   : 1;
  if (waiting_->count + plan.count < idle_limit) return plan;
  const bool restarts = is_pending() && block.says_side();
  nothing_follows();
  // The look-ahead ends here without a moving block; the code has one of its own.
  return restarts ? while_off(block) : plan;
}

CutterPlan CutterMode::cancel(const CutterBlock& block) {
  const bool moves = block.motion != PlaneMotion::zero_travel;
  CutterPlan plan = of_part(moves ? CutterPart::cancel : CutterPart::cancel_by_zero_travel);
  if (moves) plan.path = path_of(block, last_, last_.distance);
  if (block.says_cancel() && block.direction && !is_zero(*block.direction)) plan.direction = block.direction;
  phase_ = Phase::off;
  return plan;
}

// G40 or number 0 in a block that does not move in the plane.
CutterPlan CutterMode::lone_cancel() {
  CutterPlan plan = of_part(CutterPart::lone_cancel);
  plan.changes = phase_ != Phase::taken_away && last_.distance != 0;
  phase_ = !setup_.bit(5003, 1) && plan.changes ? Phase::ending : Phase::off;
  return plan;
}

// G52 or G92 of the plane, before what else the block does.
bool CutterMode::take_vector_away() {
  const bool after_leg = waiting_ && waiting_->moves;
  const bool at_vector = phase_ != Phase::taken_away && last_.distance != 0;
  // fanuc.cutter-c.coordinate-shift-with-vector: If the tool is already at a vector, G52 or G92 with an axis word of
  // the plane leaves the run undecided at that block. The blocks before it are given as if it were absent. This happens
  // after G39, after a count of two (on the 30i: of one less than 19625 gives), and after a lone G40 or number 0 whose
  // vector waits. A vector of length 0 is none.
  if (!after_leg && at_vector)
    leave_open_alone(recorder_, Clause::fanuc_cutter_c_coordinate_shift_with_vector,
                     "G52 or G92 while the tool is at a vector of cutter compensation C");
  waiting_.reset();
  phase_ = Phase::taken_away;
  return after_leg;
}

// G53, G28, G30, G30.1, G29: the vector goes, and comes back by parameter 5003#2.
CutterPlan CutterMode::machine_move(const CutterBlock& block, const Step& step) {
  if (!block.has_plane_word()) {
    if (!asked_ && phase_ != Phase::ending) return lone_cancel();
    nothing_follows();
    return of_part(CutterPart::outside_axes);
  }
  // fanuc.cutter-c.ccn: No. 5003 bit 2, CCN, says whether the mode stays on after G53, G28, G30, G30.1 or G29 of the
  // plane. With CCN = 0 the mode is off, and the next moving block is a start-up block.
  const bool goes_on = asked_ && recorder_.decide(Clause::fanuc_cutter_c_ccn, setup_.bit(5003, 2));
  CutterPlan plan = of_part(CutterPart::vector_goes);
  if (goes_on && block.motion == PlaneMotion::reference) {
    // fanuc.cutter-c.reference-intersection: With G28, G30 or G30.1 of the plane and CCN = 1, the way to the
    // intermediate point is a line B of the offset mode, and the group at its end is its own P1. After a start-up
    // block, the group before this B is that of the start-up (SUP).
    const bool travels =
        recorder_.decide(Clause::fanuc_cutter_c_reference_intersection, !is_zero(block.first_end - block.start));
    // After the intermediate point the vector goes.
    plan = travels ? in_mode(CutterPart::way_to_intermediate, block, step) : of_part(CutterPart::along_to_intermediate);
  }
  phase_ = goes_on ? Phase::taken_away : Phase::off;
  return plan;
}

}  // namespace toolcomp::model
