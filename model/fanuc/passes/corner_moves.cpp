// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/passes/corner_moves.h"

#include <cstddef>
#include <memory>
#include <utility>

namespace toolcomp::model {
namespace {

// Everything but the feed as at the corner, in the coordinates of the block that owns the move.
Move corner_move(const Move& place, const Move& own) {
  Move move = place;
  move.leg.type = own.leg.type == spec::MoveType::rapid ? spec::MoveType::rapid : spec::MoveType::linear;
  move.leg.cause = spec::Cause::corner;
  return move;
}

}  // namespace

void at_head(Step& step, const SpaceVector& head) {
  for (Move& move : step.moves) move.offset = head.vector;
}

void insert_corner_moves(Step& step, const CornerBlock& block, Standing& tool) {
  SpaceGroup& heads = tool.heads;
  if (heads.size() < 2) return;
  Move move = corner_move(tool.place, step.moves.front());
  move.feed = step.moves.front().feed;
  if (block.position) {
    move.leg.end = *block.position;
    move.tool = block.tool;
  }
  // The last one first, each in front of those that are there.
  for (std::size_t i = heads.size() - 1; i > 0; --i) {
    move.offset = heads[i].vector;
    step.moves.insert(step.moves.begin(), move);
  }
  heads.erase(heads.begin(), heads.end() - 1);
}

void append_corner_moves(Step& step, Standing& tool) {
  SpaceGroup& heads = tool.heads;
  std::size_t stop = 0;
  for (; stop + 1 < heads.size() && !heads[stop + 1].after_stop; ++stop) {
    Move move = corner_move(tool.place, step.moves.back());
    move.offset = heads[stop + 1].vector;
    step.moves.push_back(move);
  }
  heads.erase(heads.begin(), heads.begin() + static_cast<std::ptrdiff_t>(stop));
}

void end_at(Move& own, const SpaceVector& head, ToolArcRun* run, Passage passage) {
  own.offset = head.vector;
  if (run == nullptr) return;
  if (passage != Passage::shortened) return run->report(*own.leg.arc);
  own.leg.type = spec::MoveType::linear;
  own.leg.arc.reset();
}

void change_alone(Step& step, spec::Cause cause, bool changes) {
  if (step.moves.empty() && changes) step.moves.push_back(step.rest);
  if (!step.moves.empty()) step.moves.front().leg.cause = cause;
}

Alarm geometry_alarm(const Step& step, const spec::Axes& axes, AlarmCause cause, Real crossing) {
  Alarm alarm(cause);
  alarm.line = step.line;
  alarm.n = step.n;
  alarm.crossing = std::move(crossing);
  if (step.moves.empty()) return alarm;
  // The corner before the block, if there is one, was made with its move.
  const Leg& leg = step.moves.front().leg;
  auto move = std::make_shared<Event>();
  move->type = leg.type;
  move->line = step.line;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (spec::is_linear_axis(axes.letter(i))) move->programmed.set(i, leg.end.at(i).value());
  move->arc = leg.arc;
  move->clauses = step.clauses;
  alarm.unmade = std::move(move);
  return alarm;
}

}  // namespace toolcomp::model
