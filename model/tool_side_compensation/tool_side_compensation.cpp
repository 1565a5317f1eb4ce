#include "model/tool_side_compensation/tool_side_compensation.h"

#include <utility>

#include "model/program/alarm.h"
#include "model/program/number.h"

namespace toolcomp::model {
namespace {

// Vectors are zero where their offset is, and nowhere else: such components are known.
bool is_zero_vector(const Vector& v) {
  const auto zero = [](const Real& x) { return x.is_rational() && x.sign() == Sign::zero; };
  return zero(v.x) && zero(v.y) && zero(v.z);
}

constexpr const char* kTypeC = "start-up or cancel of type C: words or a next block that do not fit";

}  // namespace

ToolSideCompensation::ToolSideCompensation(const spec::Setup& setup, Recorder& recorder, Output output)
    : recorder_(recorder),
      output_(std::move(output)),
      rules_(setup, recorder),
      plane_change_(setup, recorder),
      axes_(setup.axes),
      limit_(setup.parameter(19630) ? plain(*setup.parameter(19630)) : Rational(0)),
      type_c_(setup.bit(5003, 1)),
      checks_(!setup.bit(5008, 0)),
      here_{SideVector{}} {}

void ToolSideCompensation::read(const ToolSideBlock& words) {
  if (words.wrong_mode)
    raise(recorder_, Clause::fanuc_tool_side_code_for_the_mode, "TOOL_SIDE_MODE",
          "G41.2 or G42.2 under G43.5, or G41.6 or G42.6 without it");
  if (on() && words.plane_changed)
    raise(recorder_, Clause::fanuc_tool_side_plane_selected, "PS0037",
          "the plane changes while tool side compensation is on");
  forbid(words);
  if (words.wanted() && words.treatment == 0)
    raise(recorder_, Clause::fanuc_tool_side_q_format, "Q_FORMAT", "a Q other than 1, 2 or 3");
  const bool starts = words.wanted() && (state_ == State::off || state_ == State::waiting) && !held_;
  const bool cancels = !words.wanted() && (state_ == State::on || state_ == State::leaving);
  check_type_c(words, starts, cancels);
  if (words.arc_words && (starts || cancels))
    raise(recorder_, Clause::fanuc_cutter_c_start_or_cancel_in_arc, "PS0034",
          "tool side compensation started or cancelled in an arc");
}

void ToolSideCompensation::forbid(const ToolSideBlock& words) const {
  const bool around = (on() || words.wanted()) && words.leaves_the_path;
  const bool after =
      words.wanted() && (words.changes_coordinates || (words.auxiliary && (words.moves || words.arc_words)));
  if (around || after || (on() && words.other_compensation))
    raise(recorder_, Clause::fanuc_tool_side_forbidden, "FORBIDDEN_IN_3D_COMPENSATION",
          "a command that is not allowed while tool side compensation is on");
}

void ToolSideCompensation::check_type_c(const ToolSideBlock& words, bool starts, bool cancels) const {
  if (!type_c_ || !(starts || cancels)) return;
  if (words.moves || words.arc_mode || (starts && words.stops_look_ahead))
    raise(recorder_, Clause::fanuc_tool_side_type_c_format, "TYPE_C_FORMAT", kTypeC);
}

void ToolSideCompensation::take(const Step& step) {
  if (!step.side || !step.side->is_block) {
    output_(step);
    return;
  }
  Step now = step;
  const ToolSideBlock& block = *now.side;
  const bool in_force = block.side != CutterSide::none;
  const bool wanted = in_force && !recorder_.decide(Clause::fanuc_cutter_c_number_zero, block.number == 0);
  const Direction tool = now.rest.tool;
  if (held_ && now.stops_look_ahead) end_before(now, Clause::fanuc_tool_side_look_ahead_stopped);
  std::optional<Movement> movement;
  if (wanted || state_ == State::on || state_ == State::leaving) movement = movement_of(now);
  if (held_ && held_->kind == Held::Kind::lone_start)
    take_behind_lone_start(now, wanted, movement);
  else if (state_ == State::off || state_ == State::waiting)
    take_while_off(now, wanted, movement);
  else
    take_while_on(now, wanted, movement);
  before_ = tool;
}

void ToolSideCompensation::finish() { end_without_corner(Clause::fanuc_tool_side_no_next_block); }

void ToolSideCompensation::take_while_off(Step& now, bool wanted, const std::optional<Movement>& movement) {
  state_ = wanted ? State::waiting : State::off;
  if (wanted && recorder_.decide(Clause::fanuc_tool_side_type_c, type_c_))
    start_alone(now);
  else if (wanted && movement)
    start_up(now, *movement);
  else
    emit(now);
}

void ToolSideCompensation::start_up(Step& now, const Movement& movement) {
  recorder_.reach(Clause::fanuc_tool_side_start_up);
  const CutterOffset offset = offset_of(recorder_, now.side->side, now.side->offset);
  state_ = State::on;
  hold(now, Held::Kind::start_up, offset, movement, end_of(movement, offset));
  started_ = offset.side;
}

void ToolSideCompensation::start_alone(Step& now) {
  const CutterOffset offset = offset_of(recorder_, now.side->side, now.side->offset);
  Movement movement;
  movement.own = CompensationPlane(now.rest.tool);
  hold(now, Held::Kind::lone_start, offset, movement, {});
  started_ = offset.side;
}

// The block right behind the code must move and stay in the mode.
void ToolSideCompensation::take_behind_lone_start(Step& now, bool wanted, const std::optional<Movement>& movement) {
  if (!wanted || !movement) {
    decide_held(now);
    raise_held(Clause::fanuc_tool_side_type_c_format, "TYPE_C_FORMAT", kTypeC);
  }
  state_ = State::on;
  take_moving(now, *movement);
}

void ToolSideCompensation::take_while_on(Step& now, bool wanted, const std::optional<Movement>& movement) {
  if (wanted && state_ == State::leaving)
    leave_open_at(now, Clause::fanuc_cutter_c_restart_before_removal,
                  "tool side compensation again before the vector of the cancelled mode is removed");
  if (!wanted) {
    if (movement)
      take_cancel(now, *movement);
    else if (state_ == State::on)
      cancel_alone(now);
    else
      emit_at_head(now);
  } else if (movement) {
    take_moving(now, *movement);
  } else {
    take_without_movement(now);
  }
}

void ToolSideCompensation::take_without_movement(Step& now) {
  if (!held_) {
    emit_at_head(now);
    return;
  }
  repeated_ = repeated_ || now.side->repeats_code();
  ++count_;
  now.clauses.add(recorder_.take_clauses());
  const std::uint64_t line = now.line;
  between_.push_back(std::move(now));
  if (count_ >= 2) end_without_corner(Clause::fanuc_tool_side_two_blocks_without_movement);
  recorder_.at(line);
}

// G40 or number 0 in a block that does not move in the plane.
void ToolSideCompensation::cancel_alone(Step& now) {
  end_before(now, Clause::fanuc_tool_side_no_next_block);
  const bool had_vector = !is_zero_vector(here_.front().vector);
  started_.reset();
  if (recorder_.decide(Clause::fanuc_tool_side_type_c, type_c_)) {
    recorder_.reach(Clause::fanuc_tool_side_cancel_type_c);
    here_ = {SideVector{}};
    state_ = State::off;
    emit_change_alone(now, spec::Cause::cancel, had_vector);
    return;
  }
  recorder_.reach(Clause::fanuc_tool_side_cancel_without_movement);
  state_ = had_vector ? State::leaving : State::off;
  emit_at_head(now);
}

void ToolSideCompensation::end_without_corner(Clause why) {
  if (!held_) return;
  recorder_.at(held_->step.line);
  if (held_->kind == Held::Kind::lone_start) raise_held(Clause::fanuc_tool_side_type_c_format, "TYPE_C_FORMAT", kTypeC);
  recorder_.reach(why);
  release(rules_.square_to(held_->plane, held_->end));
  count_ = 0;
  repeated_ = false;
}

void ToolSideCompensation::end_before(Step& now, Clause why) {
  now.clauses.add(recorder_.take_clauses());
  end_without_corner(why);
  recorder_.at(now.line);
}

void ToolSideCompensation::decide_held(Step& now) {
  now.clauses.add(recorder_.take_clauses());
  recorder_.at(held_->step.line);
}

void ToolSideCompensation::raise_held(Clause clause, spec::Name number, const char* message) {
  flush();
  recorder_.reach(clause);
  Alarm alarm(number, message);
  alarm.line = held_->step.line;
  alarm.n = held_->step.n;
  held_.reset();
  between_.clear();
  throw Alarm(alarm);
}

// The blocks before go out as if this one were absent.
void ToolSideCompensation::leave_open_at(Step& now, Clause clause, const char* message) {
  end_before(now, Clause::fanuc_tool_side_no_next_block);
  leave_open(recorder_, clause, message);
}

}  // namespace toolcomp::model
