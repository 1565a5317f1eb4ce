// Steps with the moves and vectors they get.
#include <utility>

#include "model/basis/alarm.h"
#include "model/fanuc/cutter_compensation_c/cutter_compensation_c.h"

namespace toolcomp::model {
namespace {

// The words of an ignored G53 are none.
bool has_axis_word(const CutterBlock& block) {
  const bool ignored = block.one_shot == OneShot::machine_coordinates && block.motion == PlaneMotion::none;
  return block.axis_word && !ignored;
}

}  // namespace

Vector CutterCompensationC::in_space_of(const Step& step, const PlanePoint& vector) const {
  return in_space(said(step).plane, vector);
}

void CutterCompensationC::send(Step& step) {
  step.clauses.add(recorder().take_clauses());
  hand_on(step);
  place_ = std::move(step.rest);
}

void CutterCompensationC::emit_at_head(Step& step) {
  for (Move& move : step.moves) move.offset = in_space_of(step, here_.front().vector);
  send(step);
}

void CutterCompensationC::emit_without_vector(Step& step) { send(step); }

void CutterCompensationC::emit_change_alone(Step& step, spec::Cause cause, bool changes) {
  recorder().decide(Clause::fanuc_cutter_c_start_without_motion_move, has_axis_word(said(step)));
  // Beside G92 the only move there can be is that of the length offset (clause fanuc.cutter-c.workpiece-change).
  if (changes && (step.moves.empty() || said(step).one_shot == OneShot::shift)) step.moves = {step.rest};
  if (!step.moves.empty()) step.moves.front().leg.cause = cause;
  emit_at_head(step);
}

// From head to head at the corner where the step starts: before its own move, everything else as before it.
void CutterCompensationC::insert_corner_moves(Step& step) {
  if (here_.size() < 2) return;
  const Move& own = step.moves.front();
  Move move = place_;
  move.leg.type = own.leg.type == spec::MoveType::rapid ? spec::MoveType::rapid : spec::MoveType::linear;
  move.leg.cause = spec::Cause::corner;
  // In the coordinates of the block that owns the move.
  if (const CutterBlock& block = said(step); block.position) {
    move.leg.end = *block.position;
    move.tool = block.tool;
  }
  move.feed = own.feed;
  move.zero.reset();
  std::vector<Move> moves;
  moves.reserve(here_.size() - 1 + step.moves.size());
  for (std::size_t i = 1; i < here_.size(); ++i) {
    move.offset = in_space_of(step, here_[i].vector);
    moves.push_back(move);
  }
  for (Move& other : step.moves) moves.push_back(std::move(other));
  step.moves = std::move(moves);
}

void CutterCompensationC::raise_held(Clause clause, spec::Name number, const char* message) {
  recorder().reach(clause);
  Alarm alarm(number, message);
  alarm.line = held_->step.line;
  alarm.n = held_->step.n;
  held_.reset();
  between_.clear();
  throw Alarm(alarm);
}

// The blocks before go out as if this one were absent.
void CutterCompensationC::leave_open_at(Step& now, Clause clause, const char* message) {
  end_before(now);
  leave_open(recorder(), clause, message);
}

}  // namespace toolcomp::model
