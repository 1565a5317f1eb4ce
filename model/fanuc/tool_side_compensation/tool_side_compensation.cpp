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

constexpr const char* kTypeC = "start-up or cancel of type C: words or a next block that do not fit";

}  // namespace

ToolSideCompensation::ToolSideCompensation(const Place& place)
    : StageOf(place),
      words_(place.setup, place.memory, place.recorder),
      rules_(place.setup, place.recorder),
      plane_change_(place.setup, place.recorder),
      axes_(place.setup.axes),
      limit_(place.setup.parameter(19630) ? plain(*place.setup.parameter(19630)) : Rational(0)),
      type_c_(place.setup.bit(5003, 1)),
      checks_(!place.setup.bit(5008, 0)),
      here_{SideVector{}} {}

void ToolSideCompensation::refuse_rotary_word(const Command& command) const {
  if (on() || on_after(command))
    raise(recorder(), Clause::fanuc_tool_side_rotary_word, "PS5460",
          "a rotary axis word while tool side compensation is on under G43.5");
}

std::shared_ptr<StageWords> ToolSideCompensation::read(const StageCommand& now) {
  std::shared_ptr<ToolSideBlock> block = words_.read(now);
  if (!block) return nullptr;
  check(*block);
  words_.add_value(*block);
  return block;
}

void ToolSideCompensation::check(const ToolSideBlock& words) const {
  if (words.wrong_mode)
    raise(recorder(), Clause::fanuc_tool_side_code_for_the_mode, "TOOL_SIDE_MODE",
          "G41.2 or G42.2 under G43.5, or G41.6 or G42.6 without it");
  if (on() && words.plane_changed)
    raise(recorder(), Clause::fanuc_tool_side_plane_selected, "PS0037",
          "the plane changes while tool side compensation is on");
  forbid(words);
  if (words.wanted() && words.treatment == 0)
    raise(recorder(), Clause::fanuc_tool_side_q_format, "Q_FORMAT", "a Q other than 1, 2 or 3");
  const bool starts = words.wanted() && (state_ == State::off || state_ == State::waiting) && held_.empty();
  const bool cancels = !words.wanted() && (state_ == State::on || state_ == State::leaving);
  check_type_c(words, starts, cancels);
  if (words.arc_words && (starts || cancels))
    raise(recorder(), Clause::fanuc_cutter_c_start_or_cancel_in_arc, "PS0034",
          "tool side compensation started or cancelled in an arc");
}

void ToolSideCompensation::forbid(const ToolSideBlock& words) const {
  const bool around = (on() || words.wanted()) && words.leaves_the_path;
  const bool after =
      words.wanted() && (words.changes_coordinates || (words.auxiliary && (words.moves || words.arc_words)));
  if (around || after || (on() && words.other_compensation))
    raise(recorder(), Clause::fanuc_tool_side_forbidden, "FORBIDDEN_IN_3D_COMPENSATION",
          "a command that is not allowed while tool side compensation is on");
}

void ToolSideCompensation::check_type_c(const ToolSideBlock& words, bool starts, bool cancels) const {
  if (!type_c_ || !(starts || cancels)) return;
  if (words.moves || words.arc_mode || (starts && words.stops_look_ahead))
    raise(recorder(), Clause::fanuc_tool_side_type_c_format, "TYPE_C_FORMAT", kTypeC);
}

void ToolSideCompensation::take(const Step& step) {
  if (!has_words(step) || !said(step).is_block) {
    hand_on(step);
    return;
  }
  Step now = step;
  const ToolSideBlock& block = said(now);
  const bool in_force = block.side != CutterSide::none;
  const bool wanted = in_force && !recorder().decide(Clause::fanuc_cutter_c_number_zero, block.number == 0);
  const Direction tool = now.rest.tool;
  if (now.stops_look_ahead) end_before(now, Clause::fanuc_tool_side_look_ahead_stopped);
  Movement movement;
  if (wanted || state_ == State::on || state_ == State::leaving) movement = movement_of(now);
  if (!held_.empty() && held_.front().kind == Held::Kind::lone_start) {
    // The block right behind the code must move there and stay in the mode.
    if (!wanted || !movement.starts.front()) {
      decide_held(now);
      raise_held(Clause::fanuc_tool_side_type_c_format, "TYPE_C_FORMAT", kTypeC);
    }
    state_ = State::on;
  }
  if (state_ == State::off || state_ == State::waiting)
    take_while_off(now, wanted, movement);
  else
    take_while_on(now, wanted, movement);
  before_ = tool;
}

void ToolSideCompensation::finish() { end_without_corner(Clause::fanuc_tool_side_no_next_block); }

void ToolSideCompensation::take_while_off(Step& now, bool wanted, Movement& movement) {
  state_ = wanted ? State::waiting : State::off;
  if (wanted && recorder().decide(Clause::fanuc_tool_side_type_c, type_c_))
    start_alone(now);
  else if (wanted && movement.end)
    start_up(now, movement);
  else
    emit(now);
}

void ToolSideCompensation::start_up(Step& now, Movement& movement) {
  recorder().reach(Clause::fanuc_tool_side_start_up);
  const CutterOffset offset = offset_of(recorder(), said(now).side, said(now).offset);
  state_ = State::on;
  movement.end->offset = offset.left();
  hold(now, Held::Kind::start_up, offset, movement);
  started_ = offset.side;
}

void ToolSideCompensation::start_alone(Step& now) {
  const CutterOffset offset = offset_of(recorder(), said(now).side, said(now).offset);
  Movement movement;
  movement.own = CompensationPlane(now.rest.tool);
  hold(now, Held::Kind::lone_start, offset, movement);
  started_ = offset.side;
}

void ToolSideCompensation::take_while_on(Step& now, bool wanted, Movement& movement) {
  if (wanted && state_ == State::leaving)
    leave_open_at(now, Clause::fanuc_cutter_c_restart_before_removal,
                  "tool side compensation again before the vector of the cancelled mode is removed");
  if (wanted)
    take_in_mode(now, movement);
  else if (state_ == State::on || movement.end)
    take_cancel(now, movement);
  else
    emit_at_head(now);
}

// G40 or number 0 in a block that does not move in the plane at its own end.
void ToolSideCompensation::cancel_alone(Step& now, bool cuts_corner) {
  const bool had_vector = !is_zero_vector(here_.front().vector);
  if (recorder().decide(Clause::fanuc_tool_side_type_c, type_c_)) {
    recorder().reach(Clause::fanuc_tool_side_cancel_type_c);
    here_ = {SideVector{}};
    state_ = State::off;
    emit_change_alone(now, spec::Cause::cancel, had_vector);
    return;
  }
  recorder().reach(Clause::fanuc_tool_side_cancel_without_movement);
  state_ = had_vector ? State::leaving : State::off;
  keep_vector(now, cuts_corner);
}

void ToolSideCompensation::end_first_without_corner(Clause why) {
  const Held& held = held_.front();
  recorder().at(held.step.line);
  if (held.kind == Held::Kind::lone_start) raise_held(Clause::fanuc_tool_side_type_c_format, "TYPE_C_FORMAT", kTypeC);
  recorder().reach(why);
  release(rules_.square_to(held.plane, held.end));
}

void ToolSideCompensation::end_without_corner(Clause why) {
  while (!held_.empty()) end_first_without_corner(why);
}

void ToolSideCompensation::end_before(Step& now, Clause why) {
  now.clauses.add(recorder().take_clauses());
  end_without_corner(why);
  recorder().at(now.line);
}

void ToolSideCompensation::decide_held(Step& now) {
  now.clauses.add(recorder().take_clauses());
  recorder().at(held_.front().step.line);
}

void ToolSideCompensation::raise_held(Clause clause, spec::Name number, const char* message) {
  flush();
  recorder().reach(clause);
  Alarm alarm(number, message);
  alarm.line = held_.front().step.line;
  alarm.n = held_.front().step.n;
  held_.clear();
  throw Alarm(alarm);
}

// The blocks before go out as if this one were absent.
void ToolSideCompensation::leave_open_at(Step& now, Clause clause, const char* message) {
  end_before(now, Clause::fanuc_tool_side_no_next_block);
  leave_open(recorder(), clause, message);
}

}  // namespace toolcomp::model
