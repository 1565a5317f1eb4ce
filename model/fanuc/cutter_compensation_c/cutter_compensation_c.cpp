#include "model/fanuc/cutter_compensation_c/cutter_compensation_c.h"

#include <utility>

#include "model/basis/alarm.h"

namespace toolcomp::model {
namespace {

bool is_machine_move(PlaneMotion motion) {
  return motion == PlaneMotion::machine_coordinates || motion == PlaneMotion::reference ||
         motion == PlaneMotion::from_reference;
}

// A word G41 or G42.
bool has_side_word(const CutterBlock& block) { return block.code && *block.code != CutterSide::none; }

// G92 with an axis word of the plane.
bool shifts_plane(const CutterBlock& block) { return block.one_shot == OneShot::shift && block.has_plane_word(); }
constexpr const char* kShift = "G92 in the plane of cutter compensation C";

}  // namespace

CutterCompensationC::CutterCompensationC(const Place& place)
    : CutterCompensation(place),
      rules_(place.setup, place.recorder),
      axes_(place.setup.axes),
      at_once_(place.setup.bit(5003, 1)),
      keeps_the_mode_(place.setup.bit(5003, 2)),
      checks_(!place.setup.bit(5008, 0)),
      here_{CornerVector{}} {}

bool CutterCompensationC::wanted(CutterSide side, std::uint32_t number) const {
  return side != CutterSide::none && number != 0;
}

void CutterCompensationC::check(const CutterBlock& words) const {
  check_common(words);
  if (words.one_shot == OneShot::corner_arc) check_corner_arc(words);
  if (!words.arc_words) return;
  const bool starts = wanted(words) && (state_ == State::off || state_ == State::waiting) && !held_;
  const bool cancels = !wanted(words) && (state_ == State::on || state_ == State::leaving);
  if (starts || cancels)
    raise(recorder(), Clause::fanuc_cutter_c_start_or_cancel_in_arc, "PS0034",
          "cutter compensation started or cancelled in an arc");
}

void CutterCompensationC::check_corner_arc(const CutterBlock& words) const {
  const bool has_vector = state_ == State::on && (held_ || made_by_move_);
  const bool other_number = words.number_given && words.number != words.number_before;
  const bool no_direction = words.direction && is_zero(*words.direction);
  if (!wanted(words) || !has_vector || has_side_word(words) || words.axis_word || other_number || no_direction)
    raise(recorder(), Clause::fanuc_cutter_c_corner_arc_alarm, "PS0035", "G39 where no corner arc can be");
}

void CutterCompensationC::take(const Step& step) {
  if (!has_words(step)) {
    hand_on(step);
    return;
  }
  Step now = step;
  const CutterBlock& block = said(now);
  const bool in_force = block.side != CutterSide::none;
  const bool wanted = in_force && !recorder().decide(Clause::fanuc_cutter_c_number_zero, block.number == 0);
  const bool moves = recorder().decide(Clause::fanuc_cutter_c_moving_block,
                                       block.motion == PlaneMotion::line || block.motion == PlaneMotion::arc);
  if (held_ && held_->kind == Held::Kind::lone_start && !take_behind_lone_start(now, wanted, moves)) return;
  if (state_ == State::off || state_ == State::waiting)
    take_while_off(now, wanted, moves);
  else
    take_while_on(now, wanted, moves);
}

void CutterCompensationC::finish() { end_without_corner(Clause::fanuc_cutter_c_no_next_block); }

void CutterCompensationC::take_while_off(Step& now, bool wanted, bool moves) {
  state_ = wanted ? State::waiting : State::off;
  const CutterBlock& block = said(now);
  if (wanted && moves) {
    start_up(now);
  } else if (wanted && has_side_word(block) && !is_machine_move(block.motion) &&
             recorder().decide(Clause::fanuc_cutter_c_suv, at_once_)) {
    start_alone(now);
  } else {
    emit_without_vector(now);
  }
}

void CutterCompensationC::start_up(Step& now) {
  recorder().reach(Clause::fanuc_cutter_c_start_up);
  const CutterOffset offset = offset_of(recorder(), said(now).side, said(now).offset);
  unchecked_ = false;
  state_ = State::on;
  hold(now, Held::Kind::start_up, offset, path_of(said(now), offset, offset.distance));
  started_ = offset;
}

void CutterCompensationC::start_alone(Step& now) {
  const CutterOffset offset = offset_of(recorder(), said(now).side, said(now).offset);
  unchecked_ = false;
  hold(now, Held::Kind::lone_start, offset, {});
  started_ = offset;
}

bool CutterCompensationC::take_behind_lone_start(Step& now, bool wanted, bool moves) {
  const CutterBlock& block = said(now);
  if (!wanted || is_machine_move(block.motion)) {
    now.clauses.add(recorder().take_clauses());
    drop_lone_start();
    return true;
  }
  if (shifts_plane(block)) leave_open_at(now, Clause::fanuc_cutter_c_coordinate_shift, kShift);
  if (moves) {
    state_ = State::on;
    take_moving(now);
  } else {
    take_without_motion(now);
  }
  return false;
}

// The code has no vector to make: the next moving block is a start-up block.
void CutterCompensationC::drop_lone_start() {
  const std::uint64_t line = recorder().line();
  recorder().at(held_->step.line);
  recorder().reach(Clause::fanuc_cutter_c_start_without_next_block);
  Held held = std::move(*held_);
  held_.reset();
  started_.reset();
  emit_without_vector(held.step);
  for (Step& step : between_) emit_without_vector(step);
  between_.clear();
  count_ = 0;
  repeated_ = false;
  recorder().at(line);
}

void CutterCompensationC::take_while_on(Step& now, bool wanted, bool moves) {
  const CutterBlock& block = said(now);
  if (wanted && state_ == State::leaving)
    leave_open_at(now, Clause::fanuc_cutter_c_restart_before_removal,
                  "G41 or G42 again before the vector of the cancelled mode is removed");
  if (shifts_plane(block)) leave_open_at(now, Clause::fanuc_cutter_c_coordinate_shift, kShift);
  if (is_machine_move(block.motion)) {
    take_machine_move(now, wanted);
  } else if (!wanted) {
    if (moves)
      take_cancel(now);
    else if (state_ == State::on)
      cancel_alone(now);
    else
      emit_at_head(now);
  } else if (moves) {
    take_moving(now);
  } else if (block.one_shot == OneShot::corner_arc) {
    take_corner_arc(now);
  } else {
    take_without_motion(now);
  }
}

void CutterCompensationC::take_without_motion(Step& now) {
  if (!held_) {
    emit_at_head(now);
    return;
  }
  const CutterBlock& block = said(now);
  const bool counts = block.is_block;
  if (counts) {
    repeated_ = repeated_ || block.repeats_code();
    count_ +=
        recorder().decide(Clause::fanuc_cutter_c_non_motion_count, block.motion == PlaneMotion::zero_travel) ? 2 : 1;
  }
  if (held_->kind == Held::Kind::lone_start && count_ >= 2 && has_side_word(block)) {
    // The look-ahead ends here without a moving block; the code has one of its own.
    now.clauses.add(recorder().take_clauses());
    drop_lone_start();
    take_while_off(now, true, false);
    return;
  }
  now.clauses.add(recorder().take_clauses());
  const std::uint64_t line = now.line;
  between_.push_back(std::move(now));
  if (count_ >= 2) end_without_corner(Clause::fanuc_cutter_c_two_non_motion_blocks);
  recorder().at(line);
}

// G40 or number 0 in a block that does not move in the plane.
void CutterCompensationC::cancel_alone(Step& now) {
  end_before(now);
  recorder().reach(Clause::fanuc_cutter_c_cancel_without_motion);
  const bool removes = recorder().decide(Clause::fanuc_cutter_c_suv, at_once_);
  if (!removes && !is_zero(here_.front().vector)) {
    state_ = State::leaving;
    emit_at_head(now);
    return;
  }
  const bool had_vector = !is_zero(here_.front().vector);
  here_ = {CornerVector{}};
  made_by_move_ = false;
  state_ = State::off;
  started_.reset();
  if (removes)
    emit_change_alone(now, spec::Cause::cancel, had_vector);
  else
    emit_at_head(now);
}

void CutterCompensationC::end_without_corner(Clause why) {
  if (!held_) return;
  recorder().at(held_->step.line);
  switch (held_->kind) {
    case Held::Kind::start_up:
    case Held::Kind::moving:
      recorder().reach(why);
      release(rules_.square_to(held_->path.end));
      break;
    case Held::Kind::lone_start:
      drop_lone_start();
      break;
    case Held::Kind::corner_arc: {
      const bool too_far = why == Clause::fanuc_cutter_c_two_non_motion_blocks;
      Held held = std::move(*held_);
      held_.reset();
      if (recorder().decide(Clause::fanuc_cutter_c_corner_arc_without_next_block, too_far)) {
        LeftOpen open(Clause::fanuc_cutter_c_corner_arc_without_next_block,
                      "two blocks without motion behind a G39 without direction");
        open.line = held.step.line;
        open.n = held.step.n;
        throw LeftOpen(open);
      }
      emit_at_head(held.step);
      for (Step& step : between_) emit_at_head(step);
      break;
    }
  }
  between_.clear();
  count_ = 0;
  repeated_ = false;
}

void CutterCompensationC::end_before(Step& now) {
  now.clauses.add(recorder().take_clauses());
  end_without_corner(Clause::fanuc_cutter_c_no_next_block);
  recorder().at(now.line);
}

void CutterCompensationC::decide_held(Step& now) {
  now.clauses.add(recorder().take_clauses());
  recorder().at(held_->step.line);
}

}  // namespace toolcomp::model
