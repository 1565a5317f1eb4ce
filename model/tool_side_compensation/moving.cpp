// Blocks that move in the plane: the corner between the block held and the one now taken.
#include <utility>

#include "model/engine.h"
#include "model/program/alarm.h"
#include "model/tool_side_compensation/tool_side_compensation.h"

namespace toolcomp::model {
namespace {

// The arc of a leg, seen from its centre in the plane selected.
SideArc arc_of(const Leg& leg, const std::optional<Rational>& radius, const spec::Axes& axes) {
  const spec::Arc<Real>& arc = *leg.arc;
  const PlaneLetters in_plane = letters(arc.plane);
  // A machine without an axis of the plane stands at 0 in it.
  const auto from_center = [&](char letter) {
    if (!axes.has(letter)) return Real(0);
    const std::size_t axis = axes.index(letter);
    return leg.actual(axis).value() - arc.center[axis];
  };
  SideArc result;
  result.plane = arc.plane;
  result.ends.end = {from_center(in_plane.first), from_center(in_plane.second)};
  result.ends.start = result.ends.end - in_plane_of(arc.plane, leg.travel);
  result.ends.turn = arc.direction == spec::ArcDirection::ccw ? 1 : -1;
  result.ends.radius = radius;
  result.ends.one_radius = !arc.radius;
  return result;
}

// What was decided on |VT × U|². A line along the tool has no direction in the plane.
bool crosses(Sign decided, const Real& left2) {
  if (decided != Sign::positive) return false;
  if (left2.sign() != Sign::positive) throw NotFinite();  // only a forced outcome comes here
  return true;
}

}  // namespace

// A line is asked in the plane of the corner at its start, or where there is none in the one at its end.
std::optional<ToolSideCompensation::Movement> ToolSideCompensation::movement_of(const Step& now) const {
  if (now.moves.empty()) return std::nullopt;
  const Leg& leg = now.moves.front().leg;
  Movement movement;
  movement.own = CompensationPlane(now.rest.tool);
  movement.path.travel = leg.travel;
  movement.at_corner = held_.has_value();
  if (leg.arc) {
    movement.path.arc = arc_of(leg, now.side->radius, axes_);
    return movement;
  }
  const CompensationPlane& plane = held_ ? held_->plane : movement.own;
  movement.start = line_end(plane, leg.travel, 0);
  if (!crosses_tool(plane, movement.start)) return std::nullopt;
  return movement;
}

bool ToolSideCompensation::crosses_tool(const CompensationPlane& plane, const SideEnd& line) const {
  const Real& norm2 = plane.tool().norm2;
  const Real travel2 = squared_norm(line.travel);
  if (limit_ <= 0)
    return crosses(recorder_.decide(Clause::fanuc_tool_side_along_the_tool, line.left2, norm2 * travel2), line.left2);
  const Rational limit2 = limit_ * limit_;
  const Sign decided = recorder_.decide(Clause::fanuc_tool_side_no_movement_limit, line.left2 - limit2 * norm2,
                                        norm2 * (travel2 + limit2));
  return decided != Sign::negative && crosses(Sign::positive, line.left2);
}

void ToolSideCompensation::take_moving(Step& now, Movement movement) {
  const Leg& leg = now.moves.front().leg;
  if (leg.arc && !leg.arc->sweep)
    raise(recorder_, Clause::fanuc_cutter_c_arc_ends_in_center, "PS0038", "an arc that ends in its centre");
  const CutterOffset offset = next_offset(*now.side);
  const Rational at_start = offset.side * last_.distance;
  if (movement.path.arc) {
    look_at_arc(now, movement);
    movement.start = arc_start(*movement.path.arc, at_start);
  }
  movement.start.offset = at_start;
  make_corner(now, movement, offset);
  started_.reset();
  const SideEnd end = end_of(movement, offset);
  if (!leg.arc && movement.at_corner && !has_direction(movement.own, end))
    run_along_tool(now, offset);
  else
    hold(now, Held::Kind::moving, offset, movement, end);
}

// How a block reaches the corner at its end.
SideEnd ToolSideCompensation::end_of(const Movement& movement, const CutterOffset& offset) {
  if (movement.path.arc) return arc_end(*movement.path.arc, offset.left());
  if (movement.at_corner) return line_end(movement.own, movement.path.travel, offset.left());
  SideEnd end = movement.start;
  end.offset = offset.left();
  return end;
}

// The tool turns in the block so that it travels along it at its end: no corner can be made there.
bool ToolSideCompensation::has_direction(const CompensationPlane& plane, const SideEnd& end) const {
  const Real scale = plane.tool().norm2 * squared_norm(end.travel);
  return crosses(recorder_.decide(Clause::fanuc_tool_side_along_the_tool_at_its_end, end.left2, scale), end.left2);
}

void ToolSideCompensation::run_along_tool(Step& now, const CutterOffset& offset) {
  flush();
  last_ = offset;
  now.moves.front().offset = here_.back().vector;
  insert_corner_moves(now);
  here_.front().former = here_.front().latter = Seat::off;
  emit(now);
}

CutterOffset ToolSideCompensation::next_offset(const ToolSideBlock& block) const {
  const CutterOffset offset = offset_of(recorder_, block.side, block.offset);
  if (started_ && *started_ != offset.side)
    raise(recorder_, Clause::fanuc_cutter_c_direction_change_at_start_up, "DIR_CHANGE_AT_STARTUP",
          "the side changes in the block behind a start-up");
  return offset;
}

// From which side the tool sees the plane of an arc: +1, -1, or 0 where it lies in it.
int ToolSideCompensation::sense(const Direction& tool, spec::Plane plane) const {
  const Real& upright = component(tool.vector, third_axis(plane));
  const Sign seen = recorder_.decide(Clause::fanuc_tool_side_arc_plane, upright, sqrt(tool.norm2));
  if (seen != Sign::zero && upright.sign() == Sign::zero) throw NotFinite();  // only a forced outcome comes here
  return static_cast<int>(seen);
}

bool ToolSideCompensation::leans(const Direction& tool, spec::Plane plane) const {
  return recorder_.decide(Clause::fanuc_tool_side_arc_plane_mismatch, squared_norm(in_plane_of(plane, tool.vector)),
                          tool.norm2) != Sign::zero;
}

void ToolSideCompensation::look_at_arc(Step& now, Movement& movement) {
  recorder_.reach(Clause::fanuc_tool_side_arc);
  constexpr const char* kOnEdge = "an arc whose plane holds the tool";
  SideArc& arc = *movement.path.arc;
  if (movement.at_corner) {
    arc.sense_at_start = sense(held_->plane.tool(), arc.plane);
    if (arc.sense_at_start == 0) leave_open_at(now, Clause::fanuc_tool_side_arc_plane, kOnEdge);
  }
  arc.sense_at_end = sense(movement.own.tool(), arc.plane);
  if (arc.sense_at_end == 0) leave_open_at(now, Clause::fanuc_tool_side_arc_plane, kOnEdge);
  if (!movement.at_corner) arc.sense_at_start = arc.sense_at_end;
  if (leans(before_, arc.plane) || leans(movement.own.tool(), arc.plane)) {
    Warning warning{"ARC_PLANE_MISMATCH", "the tool does not stand at right angles to the plane of the arc", {}};
    warning.clauses.add(Clause::fanuc_tool_side_arc_plane_mismatch);
    now.warning = warning;
  }
}

void ToolSideCompensation::make_corner(Step& now, const Movement& movement, const CutterOffset& offset) {
  if (!held_) return;
  if (now.side->repeats_code()) repeated_ = true;
  decide_held(now);
  if (held_->kind == Held::Kind::lone_start) {
    run_lone_start(movement.start);
  } else {
    recorder_.decide(Clause::fanuc_tool_side_one_block_without_movement, count_ == 1);
    recorder_.decide(Clause::fanuc_cutter_c_value_at_a_corner, offset.value != held_->offset.value);
    release(group_before(now, movement, offset));
  }
  count_ = 0;
  repeated_ = false;
  recorder_.at(now.line);
}

// The rules in their order (fanuc.tool-side.which-rule).
SideGroup ToolSideCompensation::group_before(const Step& now, const Movement& movement, const CutterOffset& offset) {
  const SideEnd& former = held_->end;
  if (former.offset == 0) return rules_.square_to(held_->plane, former);
  const SideCorner corner{held_->plane, former, movement.start};
  const bool starts = held_->kind == Held::Kind::start_up;
  const int treatment = starts ? 0 : held_->step.side->treatment.value_or(0);
  const bool one_side = held_->offset.side == offset.side;
  SideGroup group;
  if (treatment == 1) {
    recorder_.reach(Clause::fanuc_tool_side_q1);
    group = rules_.square_to(held_->plane, former);
  } else if (recorder_.decide(Clause::fanuc_cutter_c_direction_change, !one_side)) {
    group = rules_.side_change(corner);
  } else if (repeated_) {
    recorder_.reach(Clause::fanuc_tool_side_repeated);
    group = rules_.square_to(held_->plane, former);
  } else if (starts) {
    group = rules_.start_up(corner);
  } else {
    auto found = rules_.in_mode(corner);
    if (!found)
      raise_held(Clause::fanuc_cutter_c_no_intersection, "PS0033", "the offset paths of an inner corner do not meet");
    group = std::move(*found);
    if (treatment == 2 && recorder_.decide(Clause::fanuc_tool_side_q2, corner.of_lines() && group.size() == 2))
      group.pop_back();
  }
  if (treatment == 3) recorder_.reach(Clause::fanuc_tool_side_q3);
  if (may_drop(group, movement.path)) rules_.drop_small_differences(group, held_->offset.distance);
  if (!starts && treatment == 0 && one_side && !repeated_ &&
      plane_change_.interferes({held_->path.travel, held_->plane.tool()}, {movement.path.travel, now.rest.tool}))
    raise_held(Clause::fanuc_tool_side_plane_change_alarm, "OVERCUT_PLANE_CHANGE",
               "the tool turns and the path goes back: it would cut too much");
  return group;
}

// Nothing is dropped before an arc of a half circle or more.
bool ToolSideCompensation::may_drop(const SideGroup& group, const SidePath& next) const {
  if (group.size() < 2 || !next.arc) return true;
  const ArcEnds& ends = next.arc->ends;
  return is_under_half_circle(recorder_, ends.start, ends.end, ends.turn,
                              sqrt(squared_norm(ends.start) * squared_norm(ends.end)));
}

void ToolSideCompensation::take_cancel(Step& now, const Movement& movement) {
  if (held_) {
    SideEnd start = movement.start;
    start.offset = held_->offset.left();
    // A cancel block by number 0 can have the word too.
    if (now.side->repeats_code()) repeated_ = true;
    decide_held(now);
    recorder_.decide(Clause::fanuc_tool_side_one_block_without_movement, count_ == 1);
    release(group_before_cancel(start));
    flush();
    count_ = 0;
    repeated_ = false;
    recorder_.at(now.line);
  }
  recorder_.reach(Clause::fanuc_tool_side_cancel);
  insert_corner_moves(now);
  now.moves.back().leg.cause = spec::Cause::cancel;
  here_ = {SideVector{}};
  started_.reset();
  state_ = State::off;
  emit(now);
}

SideGroup ToolSideCompensation::group_before_cancel(const SideEnd& start) {
  const SideEnd& former = held_->end;
  if (former.offset == 0) return rules_.square_to(held_->plane, former);
  if (repeated_) {
    recorder_.reach(Clause::fanuc_tool_side_repeated);
    return rules_.square_to(held_->plane, former);
  }
  if (held_->kind == Held::Kind::start_up) {
    recorder_.reach(Clause::fanuc_tool_side_start_then_cancel);
    return rules_.square_to(held_->plane, former);
  }
  SideGroup group = rules_.cancel({held_->plane, former, start});
  rules_.drop_small_differences(group, held_->offset.distance);
  return group;
}

// The tool moves by the vector perpendicular to the next block.
void ToolSideCompensation::run_lone_start(const SideEnd& start) {
  recorder_.reach(Clause::fanuc_tool_side_start_type_c);
  Held held = std::move(*held_);
  held_.reset();
  here_ = rules_.square_to_latter(held.plane, start);
  here_plane_ = held.plane;
  emit_change_alone(held.step, spec::Cause::start_up, held.offset.distance != 0);
}

void ToolSideCompensation::hold(Step& now, Held::Kind kind, const CutterOffset& offset, const Movement& movement,
                                const SideEnd& end) {
  now.clauses.add(recorder_.take_clauses());
  Held held;
  held.kind = kind;
  held.offset = offset;
  held.plane = movement.own;
  held.path = movement.path;
  held.end = end;
  if (const auto& arc = movement.path.arc) {
    held.offset_at_start = offset.side * last_.distance;
    const CompensationPlane& plane = movement.at_corner ? here_plane_ : movement.own;
    const Rational rho = movement.at_corner ? held.offset_at_start : offset.left();
    held.start = seen(plane, plane.frame(), arc_start(*arc, rho));
  }
  held.step = std::move(now);
  held_ = std::move(held);
  last_ = offset;
}

}  // namespace toolcomp::model
