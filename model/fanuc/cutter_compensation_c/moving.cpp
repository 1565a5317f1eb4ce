// Blocks that move in the plane: the corner between the block held and the one now taken.
#include <utility>

#include "model/basis/alarm.h"
#include "model/fanuc/corner/interference.h"
#include "model/fanuc/cutter_compensation_c/cutter_compensation_c.h"

namespace toolcomp::model {
void CutterCompensationC::take_moving(Step& now) {
  const CutterBlock& block = said(now);
  if (block.arc && !block.arc->sweep)
    raise(recorder(), Clause::fanuc_cutter_c_arc_ends_in_center, "PS0038", "an arc about its start or its end");
  const CutterOffset offset = next_offset(block);
  OffsetPath path = path_of(block, offset, last_.distance);
  make_corner(now, path, offset);
  hold(now, Held::Kind::moving, offset, std::move(path));
  held_->checked = !std::exchange(unchecked_, false);
  started_.reset();
}

CutterOffset CutterCompensationC::next_offset(const CutterBlock& block) {
  const CutterOffset offset = offset_of(recorder(), block.side, block.offset);
  if (started_ && started_->side != offset.side)
    raise(recorder(), Clause::fanuc_cutter_c_direction_change_at_start_up, "DIR_CHANGE_AT_STARTUP",
          "the side changes in the block behind a start-up");
  return offset;
}

void CutterCompensationC::make_corner(Step& now, const OffsetPath& path, const CutterOffset& offset) {
  if (!held_) return;
  const CutterBlock& block = said(now);
  if (block.repeats_code()) repeated_ = true;
  decide_held(now);
  switch (held_->kind) {
    case Held::Kind::start_up:
    case Held::Kind::moving:
      recorder().decide(Clause::fanuc_cutter_c_one_non_motion_block, count_ == 1);
      recorder().decide(Clause::fanuc_cutter_c_value_at_a_corner, offset.value != held_->offset.value);
      release(group_before(path, offset));
      break;
    case Held::Kind::lone_start:
      run_lone_start(path);
      break;
    case Held::Kind::corner_arc: {
      Held held = std::move(*held_);
      held_.reset();
      run_corner_arc(held.step, path.start.heading, offset.side == held.offset.side);
      for (Step& step : between_) emit_at_head(step);
      between_.clear();
      break;
    }
  }
  count_ = 0;
  repeated_ = false;
  recorder().at(now.line);
}

// The rules in their order (fanuc.cutter-c.which-rule).
VectorGroup CutterCompensationC::group_before(const OffsetPath& next, const CutterOffset& offset) {
  const PathEnd& former = held_->path.end;
  std::optional<VectorGroup> group;
  if (former.offset == 0) {
    group = rules_.square_to(former);
  } else if (recorder().decide(Clause::fanuc_cutter_c_direction_change, held_->offset.side != offset.side)) {
    group = rules_.direction_change(former, next.start);
  } else if (repeated_) {
    recorder().reach(Clause::fanuc_cutter_c_repeated);
    group = rules_.square_to(former);
  } else if (held_->kind == Held::Kind::start_up) {
    group = rules_.start_up(former, next.start);
  } else {
    group = rules_.offset_mode(former, next.start);
    if (!group)
      raise_held(Clause::fanuc_cutter_c_no_intersection, "PS0033", "the offset paths of an inner corner do not meet");
  }
  rules_.drop_small_movements(*group, next);
  recorder().decide(Clause::fanuc_cutter_c_corner_movement, group->size() > 1);
  return *group;
}

void CutterCompensationC::take_cancel(Step& now) {
  const CutterBlock& block = said(now);
  if (held_) {
    const Rational offset = held_->offset.left();
    const OffsetPath path = line_path(block.end - block.start, offset, offset);
    // A cancel block by number 0 can have the word too.
    if (block.repeats_code()) repeated_ = true;
    decide_held(now);
    if (held_->kind == Held::Kind::corner_arc) {
      Held held = std::move(*held_);
      held_.reset();
      run_corner_arc(held.step, path.start.heading, true);
      for (Step& step : between_) emit_at_head(step);
      between_.clear();
    } else {
      recorder().decide(Clause::fanuc_cutter_c_one_non_motion_block, count_ == 1);
      release(group_before_cancel(block, path));
    }
    count_ = 0;
    repeated_ = false;
    recorder().at(now.line);
  }
  recorder().reach(Clause::fanuc_cutter_c_cancel);
  insert_corner_moves(now);
  now.moves.back().leg.cause = spec::Cause::cancel;
  here_ = {CornerVector{}};
  made_by_move_ = false;
  started_.reset();
  state_ = State::off;
  send(now);
}

VectorGroup CutterCompensationC::group_before_cancel(const CutterBlock& block, const OffsetPath& next) {
  const PathEnd& former = held_->path.end;
  VectorGroup group;
  const bool by_word = block.code == CutterSide::none;
  const bool direction = by_word && block.direction && !is_zero(*block.direction);
  if (former.offset == 0) {
    group = rules_.square_to(former);
  } else if (repeated_) {
    recorder().reach(Clause::fanuc_cutter_c_repeated);
    group = rules_.square_to(former);
  } else if (recorder().decide(Clause::fanuc_cutter_c_cancel_direction, direction)) {
    group = rules_.cancel_along(former, *block.direction);
  } else {
    group = rules_.cancel(former, next.start);
  }
  rules_.drop_small_movements(group, next);
  recorder().decide(Clause::fanuc_cutter_c_corner_movement, group.size() > 1);
  return group;
}

// The tool moves by the vector perpendicular to the next block.
void CutterCompensationC::run_lone_start(const OffsetPath& next) {
  Held held = std::move(*held_);
  held_.reset();
  recorder().reach(Clause::fanuc_cutter_c_start_without_motion);
  here_ = {{perpendicular(next.start), Seat::off, Seat::square}};
  emit_change_alone(held.step, spec::Cause::start_up, held.offset.distance != 0);
  for (Step& step : between_) emit_at_head(step);
  between_.clear();
}

void CutterCompensationC::hold(Step& now, Held::Kind kind, const CutterOffset& offset, OffsetPath path) {
  now.clauses.add(recorder().take_clauses());
  held_ = Held{kind, std::move(now), offset, std::move(path), true};
  last_ = offset;
}

void CutterCompensationC::release(VectorGroup at_end) {
  Held& held = *held_;
  const OffsetPath& path = held.path;
  std::optional<ToolArcRun> arc;
  if (path.is_arc()) arc.emplace(recorder(), path, here_.back(), at_end.front());
  Passage passage = Passage::free;
  if (held.kind == Held::Kind::moving && held.checked &&
      recorder().decide(Clause::fanuc_cutter_c_interference_check, checks_)) {
    const spec::Plane plane = said(held.step).plane;
    SpaceGroup from = in_space(plane, here_);
    SpaceGroup to = in_space(plane, at_end);
    passage = remove_interference(recorder(), from, to, [&](bool first, const SpaceVector& v, const SpaceVector& w) {
      return first && arc
                 ? arc_interferes(recorder(), path.start, path.end, *arc)
                 : line_interferes(recorder(), path, in_plane_of(plane, v.vector), in_plane_of(plane, w.vector));
    });
    here_.resize(from.size());
    at_end.erase(at_end.begin(), at_end.end() - static_cast<std::ptrdiff_t>(to.size()));
    if (passage == Passage::blocked)
      raise_held(Clause::fanuc_cutter_c_interference_alarm, "PS0041",
                 "the tool's path goes against the programmed one");
    if (passage == Passage::shortened)
      recorder().decide(Clause::fanuc_cutter_c_interference_straightened, path.is_arc());
  }

  Step step = std::move(held.step);
  Move& own = step.moves.front();
  own.offset = in_space_of(step, at_end.front().vector);
  if (held.kind == Held::Kind::start_up) own.leg.cause = spec::Cause::start_up;
  if (arc && passage == Passage::shortened) {
    own.leg.type = spec::MoveType::linear;
    own.leg.arc.reset();
  } else if (arc) {
    const ToolArc tool = arc->arc();
    own.leg.arc->sweep = tool.sweep;
    own.leg.arc->radius = tool.radius;
  }
  insert_corner_moves(step);
  here_ = std::move(at_end);
  here_heading_ = path.end.heading;
  made_by_move_ = true;
  held_.reset();
  send(step);
  for (Step& other : between_) emit_at_head(other);
  between_.clear();
}

}  // namespace toolcomp::model
