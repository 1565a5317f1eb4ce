// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/corner/look_ahead.h"

#include <utility>

#include "model/basis/alarm.h"
#include "model/basis/number.h"
#include "spec/language/input_error.h"

namespace toolcomp::model {

int blocks_read(const spec::Setup& setup) {
  const std::optional<spec::Decimal> given = setup.parameter(19625);
  if (setup.series != spec::Series::series_30i || !given) return 3;
  for (int blocks = 3; blocks <= 8; ++blocks)
    if (plain(*given) == blocks) return blocks;
  throw spec::InputError("setup", 0, 0, "parameters.\"19625\": expected a number of blocks from 3 to 8");
}

namespace {

// A code that makes or removes the vector in a block that does not move: with the block's own move, or one for it.
void change_alone(Step& step, spec::Cause cause, bool changes) {
  if (step.moves.empty() && changes) step.moves.push_back(step.rest);
  if (!step.moves.empty()) step.moves.front().leg.cause = cause;
}

}  // namespace

LookAhead::LookAhead(const Stage::Place& place, CornerSection& section, const Rules& rules)
    : recorder_(place.recorder),
      slot_(place.slot),
      output_(place.output),
      section_(section),
      axes_(place.setup.axes),
      rules_(rules),
      checks_(!place.setup.bit(5008, 0)),
      here_{SpaceVector{}} {}

const CornerBlock& LookAhead::said(const Step& step) const {
  return static_cast<const CornerBlock&>(*step.words.at(slot_));
}

// The first block behind a start that moves anywhere, and the one that the start's own vector is made with.
CutterOffset LookAhead::next_offset(const Step& now, bool meets_first) const {
  const CutterOffset offset = offset_of(recorder_, said(now).side, said(now).offset);
  const bool first = started_ && *started_ != offset.side;
  const bool meets_start =
      meets_first && !held_.empty() && held_.front().starts() && held_.front().offset.side != offset.side;
  // fanuc.cutter-c.direction-change-at-start-up: The first moving block after a start-up must not change the side; a
  // change raises DIR_CHANGE_AT_STARTUP, a name of ours, at that block. A start-up here is the start-up block, also one
  // that follows G53 or a reference return, or the G41 or G42 of SUV = 1. The rule holds however many blocks without
  // motion come between, and whatever the value.
  if (first || meets_start)
    raise(recorder_, Clause::fanuc_cutter_c_direction_change_at_start_up, AlarmCause::side_change_at_start);
  return offset;
}

void LookAhead::hold(Step& now, Held::Kind kind, const CutterOffset& offset, std::shared_ptr<const HeldPath> path,
                     bool checked) {
  now.clauses.add(recorder_.take_clauses());
  Held held;
  held.kind = kind;
  held.offset = offset;
  held.path = std::move(path);
  held.checked = checked;
  held.step = std::move(now);
  held_.push_back(std::move(held));
  last_ = offset;
  if (kind == Held::Kind::moving) started_.reset();
  if (held_.back().starts()) started_ = offset.side;
}

// In order. What counts to the limit is the first one held: one behind it has fewer blocks behind itself.
void LookAhead::meet(Step& now, const Meeting& meeting) {
  for (std::size_t corner = 0; corner < meeting.moves.size(); ++corner) {
    const std::size_t gone = meeting.moves.size() - held_.size();
    if (corner < gone || held_[corner - gone].met) continue;
    Held& held = held_[corner - gone];
    if (said(now).repeats_code()) held.repeated = true;
    now.clauses.add(recorder_.take_clauses());
    recorder_.at(held.step.line);
    if (meeting.moves[corner] && held.stands()) {
      SpaceGroup vector = meeting.group(held, corner);
      if (held.kind == Held::Kind::lone_start) {
        mode = CornerMode::on;
        change_alone(held.step, spec::Cause::start_up, held.offset.distance != 0);
      }
      pass(std::move(vector));
    } else if (meeting.moves[corner]) {
      held.met = [group = meeting.group, corner](Held& self) { return group(self, corner); };
      release_met();
    } else {
      held.without_movement += meeting.counts;
      if (held.without_movement >= limit()) end_first(meeting.too_many);
    }
    recorder_.at(now.line);
  }
}

void LookAhead::pass(SpaceGroup at) {
  Held held = std::move(held_.front());
  held_.pop_front();
  here_ = std::move(at);
  run(held.step);
  for (Step& step : held.between) run(step);
}

void LookAhead::end_first(Clause why) {
  const Held& held = held_.front();
  recorder_.at(held.step.line);
  if (held.stands()) {
    section_.end_standing(why);
    return;
  }
  recorder_.reach(why);
  release(section_.without_corner(held));
  release_met();
}

void LookAhead::release_met() {
  while (!held_.empty() && held_.front().met) {
    Held& held = held_.front();
    recorder_.at(held.step.line);
    recorder_.decide(rules_.one_between, held.without_movement > 0);
    const bool leaves = held.leaves_corner;
    const auto group = std::move(held.met);
    release(group(held));
    if (!leaves) continue;
    flush();
    leave_corner();
  }
}

void LookAhead::end(Clause why) {
  while (!held_.empty()) end_first(why);
}

void LookAhead::end_behind(Clause why) {
  const std::uint64_t line = recorder_.line();
  end(why);
  recorder_.at(line);
}

void LookAhead::end_before(Step& now, Clause why) {
  now.clauses.add(recorder_.take_clauses());
  end(why);
  recorder_.at(now.line);
}

void LookAhead::end_without_vector(Step& now, Clause why) {
  now.clauses.add(recorder_.take_clauses());
  recorder_.at(held_.front().step.line);
  recorder_.decide(why, true);
  held_.front().checked = false;
  release({SpaceVector{}});
  recorder_.at(now.line);
}

void LookAhead::release(SpaceGroup at_end) {
  Held& held = held_.front();
  std::optional<ToolArcRun> run = held.path->arc_run(recorder_, here_.back(), at_end.front());
  const Passage passage = check(held, at_end, run ? &*run : nullptr);
  Step step = std::move(held.step);
  step.clauses.add(recorder_.take_clauses());
  flush();
  Move& own = step.moves.front();
  own.offset = at_end.front().vector;
  if (held.kind == Held::Kind::start_up) own.leg.cause = spec::Cause::start_up;
  if (run && passage == Passage::shortened) {
    own.leg.type = spec::MoveType::linear;
    own.leg.arc.reset();
  } else if (run) {
    const ToolArc tool = run->arc();
    step.clauses.add(recorder_.take_clauses());
    own.leg.arc->sweep = tool.sweep;
    own.leg.arc->radius = tool.radius;
  }
  insert_corner_moves(step);
  corner_ = step.rest;
  here_ = std::move(at_end);
  section_.released(held);
  waiting_.push_back(std::move(step));
  for (Step& other : held.between) waiting_.push_back(std::move(other));
  held_.pop_front();
  if (here_.size() == 1 || rules_.between == Between::at_first_head) flush();
}

Passage LookAhead::check(const Held& held, SpaceGroup& at_end, ToolArcRun* run) {
  // fanuc.cutter-c.interference-check: No. 5008 bit 0, CNI, switches the interference check: 0 checks, 1 does not.
  if (held.kind != Held::Kind::moving || !held.checked ||
      !recorder_.decide(Clause::fanuc_cutter_c_interference_check, checks_))
    return Passage::free;
  // fanuc.cutter-c.interference-at-once: With No. 5008 bit 3, CNV, at 1, cutter compensation C on series 30i drops no
  // vector. The first pair with interference is then the last one, so PS0041 comes at once. On series 16i the bit means
  // nothing.
  const auto& parameters = rules_.interference;
  bool by_direction = false;
  Vector last_from;
  Vector last_to;
  const auto interferes = [&](bool first, const SpaceVector& from, const SpaceVector& to) {
    by_direction = !first || run == nullptr;
    last_from = from.vector;
    last_to = to.vector;
    const bool result = by_direction ? held.path->line_interferes(recorder_, from.vector, to.vector)
                                     : held.path->arc_interferes(recorder_, *run);
    if (first && result && parameters)
      recorder_.decide(Clause::fanuc_cutter_c_interference_at_once, parameters->keeps_vectors);
    return result;
  };
  const bool drops = !(parameters && parameters->keeps_vectors);
  Passage passage = remove_interference(recorder_, here_, at_end, interferes, drops);
  // fanuc.cutter-c.interference-without-alarm: With No. 5008 bit 1, CNC, at 1, cutter compensation C raises no alarm if
  // the last pair interferes because the directions differ by 90 to 270 degrees
  // (fanuc.cutter-c.interference-direction). The block then runs between the vectors that are left.
  if (passage == Passage::blocked && by_direction && parameters &&
      recorder_.decide(Clause::fanuc_cutter_c_interference_without_alarm, parameters->no_alarm))
    passage = drops ? leave_outer_vectors(here_, at_end) : Passage::free;
  // fanuc.cutter-c.interference-alarm: Interference of the last pair, or of the only pair, raises PS0041 (except in
  // fanuc.cutter-c.interference-without-alarm). The alarm names the block. Neither the block nor its corner moves are
  // given; the block before it runs to the first head of its own group.
  if (passage == Passage::blocked)
    raise_held(Clause::fanuc_cutter_c_interference_alarm, AlarmCause::interference,
               by_direction ? held.path->backwards(last_from, last_to) : held.path->excess());
  // fanuc.cutter-c.interference-straightened: An arc block that has interfered in its first pair is a straight block
  // from then on. The next pairs are tested as for a line from P to Q. The block's own move is linear, from the last
  // vector left at its start to the first vector left at its end, with the block's feed; the cause is programmed.
  if (passage == Passage::shortened) recorder_.decide(Clause::fanuc_cutter_c_interference_straightened, run != nullptr);
  return passage;
}

void LookAhead::flush() {
  if (waiting_.empty()) return;
  Step& former = waiting_.front();
  std::size_t stop = 0;
  for (; stop + 1 < here_.size() && !here_[stop + 1].after_stop; ++stop) {
    Move move = corner_move(former.moves.back());
    move.offset = here_[stop + 1].vector;
    former.moves.push_back(move);
  }
  here_.erase(here_.begin(), here_.begin() + static_cast<std::ptrdiff_t>(stop));
  output_(former);
  for (std::size_t i = 1; i < waiting_.size(); ++i) {
    Step& other = waiting_[i];
    if (rules_.between == Between::at_last_head) {
      move_to_last_head(other);
    } else {
      for (Move& own : other.moves) own.offset = here_.front().vector;
      corner_ = other.rest;
    }
    output_(other);
  }
  waiting_.clear();
}

void LookAhead::keep(Step& now) {
  if (held_.empty()) {
    flush();
    run(now);
    return;
  }
  now.clauses.add(recorder_.take_clauses());
  held_.back().between.push_back(std::move(now));
}

// The head is no longer one of the corner where the vector was made.
void LookAhead::leave_corner() {
  if (held_.empty() || !held_.back().met)
    set_vector({here_.front().vector});
  else
    held_.back().leaves_corner = true;
}

void LookAhead::moved(const CutterOffset& offset) {
  last_ = offset;
  started_.reset();
}

void LookAhead::set_vector(SpaceVector vector) {
  here_ = {std::move(vector)};
  started_.reset();
}

void LookAhead::take_away(Step& now) {
  flush();
  insert_corner_moves(now);
  now.moves.back().leg.cause = spec::Cause::cancel;
  here_ = {SpaceVector{}};
  mode = CornerMode::off;
  emit(now);
}

void LookAhead::cancel_alone(Step& now, bool has_vector, bool at_once) {
  flush();
  if (at_once) change_alone(now, spec::Cause::cancel, has_vector);
  if (at_once || !has_vector) here_ = {SpaceVector{}};
  mode = at_once || !has_vector ? CornerMode::off : CornerMode::leaving;
  keep(now);
}

void LookAhead::run(Step& step) {
  move_to_last_head(step);
  emit(step);
}

void LookAhead::move_to_last_head(Step& step) {
  for (Move& move : step.moves) move.offset = here_.back().vector;
  if (!step.moves.empty()) insert_corner_moves(step);
}

// Everything but the feed as at the corner, in the coordinates of the block that owns the move.
Move LookAhead::corner_move(const Move& own) const {
  Move move = corner_;
  move.leg.type = own.leg.type == spec::MoveType::rapid ? spec::MoveType::rapid : spec::MoveType::linear;
  move.leg.cause = spec::Cause::corner;
  return move;
}

void LookAhead::insert_corner_moves(Step& step) {
  if (here_.size() < 2) return;
  Move move = corner_move(step.moves.front());
  move.feed = step.moves.front().feed;
  if (const CornerBlock& block = said(step); block.position) {
    move.leg.end = *block.position;
    move.tool = block.tool;
  }
  std::vector<Move> moves;
  moves.reserve(here_.size() - 1 + step.moves.size());
  for (std::size_t i = 1; i < here_.size(); ++i) {
    move.offset = here_[i].vector;
    moves.push_back(move);
  }
  for (Move& other : step.moves) moves.push_back(std::move(other));
  step.moves = std::move(moves);
  here_.erase(here_.begin(), here_.end() - 1);
}

void LookAhead::emit(Step& step) {
  step.clauses.add(recorder_.take_clauses());
  output_(step);
}

void LookAhead::raise_held(Clause clause, AlarmCause cause, Real crossing) {
  flush();
  recorder_.reach(clause);
  Alarm alarm(cause);
  alarm.line = held_.front().step.line;
  alarm.n = held_.front().step.n;
  alarm.unmade = unmade(held_.front().step);
  alarm.crossing = std::move(crossing);
  held_.clear();
  throw Alarm(alarm);
}

// The corner before it, if there is one, was made with it.
std::shared_ptr<const Event> LookAhead::unmade(const Step& step) const {
  if (step.moves.empty()) return nullptr;
  const Leg& leg = step.moves.front().leg;
  Event move;
  move.type = leg.type;
  move.line = step.line;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (spec::is_linear_axis(axes_.letter(i))) move.programmed.set(i, leg.end.at(i).value());
  move.arc = leg.arc;
  move.clauses = step.clauses;
  return std::make_shared<Event>(std::move(move));
}

void LookAhead::leave_open_at(Step& now, Clause clause, const char* message) {
  end_before(now);
  leave_open(recorder_, clause, message);
}

}  // namespace toolcomp::model
