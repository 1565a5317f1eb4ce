// Blocks of the mode: the corners between those held and the one now taken.
#include <algorithm>
#include <utility>

#include "model/basis/alarm.h"
#include "model/basis/event.h"
#include "model/fanuc/tool_side_compensation/tool_side_compensation.h"

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

bool ToolSideCompensation::Movement::moves_behind() const {
  return std::ranges::any_of(starts, [](const auto& start) { return start.has_value(); });
}

// A line is asked in the plane of each corner that is still to be made, and in the one at its own end.
ToolSideCompensation::Movement ToolSideCompensation::movement_of(const Step& now) const {
  Movement movement;
  movement.own = CompensationPlane(now.rest.tool);
  movement.starts.resize(held_.size());
  if (now.moves.empty()) return movement;
  const Leg& leg = now.moves.front().leg;
  movement.path.travel = leg.travel;
  if (leg.arc) {
    movement.path.arc = arc_of(leg, said(now).radius, axes_);
    for (auto& start : movement.starts) start.emplace();
    movement.end.emplace();
    return movement;
  }
  const auto seen_in = [&](const CompensationPlane& plane) {
    SideEnd line = line_end(plane, leg.travel, 0);
    return crosses_tool(plane, line) ? std::optional(std::move(line)) : std::nullopt;
  };
  for (std::size_t i = 0; i < held_.size(); ++i) movement.starts[i] = seen_in(held_[i].plane);
  const bool same = !held_.empty() && movement.own.is_same_as(held_.back().plane);
  movement.end = same ? movement.starts.back() : seen_in(movement.own);
  return movement;
}

bool ToolSideCompensation::crosses_tool(const CompensationPlane& plane, const SideEnd& line) const {
  const Real& norm2 = plane.tool().norm2;
  const Real travel2 = squared_norm(line.travel);
  if (limit_ <= 0)
    return crosses(recorder().decide(Clause::fanuc_tool_side_along_the_tool, line.left2, norm2 * travel2), line.left2);
  const Rational limit2 = limit_ * limit_;
  const Sign decided = recorder().decide(Clause::fanuc_tool_side_no_movement_limit, line.left2 - limit2 * norm2,
                                         norm2 * (travel2 + limit2));
  return decided != Sign::negative && crosses(Sign::positive, line.left2);
}

void ToolSideCompensation::take_in_mode(Step& now, Movement& movement) {
  CutterOffset offset;
  if (movement.moves()) {
    const Leg& leg = now.moves.front().leg;
    if (leg.arc && !leg.arc->sweep)
      raise(recorder(), Clause::fanuc_cutter_c_arc_ends_in_center, "PS0038", "an arc that ends in its centre");
    offset = offset_of(recorder(), said(now).side, said(now).offset);
    check_side_behind_start(movement, offset);
    look_at_movement(now, movement, offset);
  }
  meet_corners(now, movement, offset);
  if (movement.moves()) started_.reset();
  if (movement.end) {
    hold(now, Held::Kind::moving, offset, movement);
    return;
  }
  if (movement.moves()) last_ = offset;
  keep_vector(now, movement.moves_behind());
}

// The side each corner sees, and the sense of an arc there.
void ToolSideCompensation::look_at_movement(Step& now, Movement& movement, const CutterOffset& offset) {
  if (movement.path.arc) look_at_arc(now, movement);
  for (std::size_t i = 0; i < held_.size(); ++i)
    if (movement.starts[i]) movement.starts[i]->offset = offset.side * held_[i].offset.distance;
  if (movement.end) movement.end->offset = offset.left();
}

// The block makes no vector at its own end. `cuts_corner`: it was the outgoing leg of a corner before it.
void ToolSideCompensation::keep_vector(Step& now, bool cuts_corner) {
  if (cuts_corner) recorder().reach(Clause::fanuc_tool_side_along_the_tool_at_its_end);
  if (!held_.empty()) {
    now.clauses.add(recorder().take_clauses());
    held_.back().keeping.push_back(std::move(now));
    return;
  }
  flush();
  for (Move& move : now.moves) move.offset = here_.back().vector;
  insert_corner_moves(now);
  if (cuts_corner) here_.front().former = here_.front().latter = Seat::off;
  emit(now);
}

// The first block behind a start that moves anywhere, and the one that the start's own vector is made with.
void ToolSideCompensation::check_side_behind_start(const Movement& movement, const CutterOffset& offset) const {
  const bool first = started_ && *started_ != offset.side;
  const bool meets_start = !held_.empty() && held_.front().kind != Held::Kind::moving && movement.starts.front() &&
                           held_.front().offset.side != offset.side;
  if (first || meets_start)
    raise(recorder(), Clause::fanuc_cutter_c_direction_change_at_start_up, "DIR_CHANGE_AT_STARTUP",
          "the side changes in the block behind a start-up");
}

// From which side the tool sees the plane of an arc: +1, -1, or 0 where it lies in it.
int ToolSideCompensation::sense(const Direction& tool, spec::Plane plane) const {
  const Real& upright = component(tool.vector, third_axis(plane));
  const Sign seen = recorder().decide(Clause::fanuc_tool_side_arc_plane, upright, sqrt(tool.norm2));
  if (seen != Sign::zero && upright.sign() == Sign::zero) throw NotFinite();  // only a forced outcome comes here
  return static_cast<int>(seen);
}

bool ToolSideCompensation::leans(const Direction& tool, spec::Plane plane) const {
  return recorder().decide(Clause::fanuc_tool_side_arc_plane_mismatch, squared_norm(in_plane_of(plane, tool.vector)),
                           tool.norm2) != Sign::zero;
}

void ToolSideCompensation::look_at_arc(Step& now, Movement& movement) {
  recorder().reach(Clause::fanuc_tool_side_arc);
  constexpr const char* kOnEdge = "an arc whose plane holds the tool";
  SideArc& arc = *movement.path.arc;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    arc.sense_at_start = sense(held_[i].plane.tool(), arc.plane);
    if (arc.sense_at_start == 0) leave_open_at(now, Clause::fanuc_tool_side_arc_plane, kOnEdge);
    movement.starts[i] = arc_start(arc, 0);
  }
  arc.sense_at_end = sense(movement.own.tool(), arc.plane);
  if (arc.sense_at_end == 0) leave_open_at(now, Clause::fanuc_tool_side_arc_plane, kOnEdge);
  if (held_.empty()) arc.sense_at_start = arc.sense_at_end;
  movement.end = arc_end(arc, 0);
  if (leans(before_, arc.plane) || leans(movement.own.tool(), arc.plane)) {
    Warning warning{"ARC_PLANE_MISMATCH", "the tool does not stand at right angles to the plane of the arc", {}};
    warning.clauses.add(Clause::fanuc_tool_side_arc_plane_mismatch);
    now.warning = warning;
  }
}

// In order; a corner is the first one held when its turn comes: two blocks behind the first of two make or end it.
void ToolSideCompensation::meet_corners(Step& now, const Movement& movement, const CutterOffset& offset) {
  for (const std::optional<SideEnd>& start : movement.starts) {
    Held& held = held_.front();
    if (said(now).repeats_code()) held.repeated = true;
    decide_held(now);
    if (start)
      make_corner(now, movement, *start, offset);
    else if (++held.without_movement >= 2)
      end_first_without_corner(Clause::fanuc_tool_side_two_blocks_without_movement);
    recorder().at(now.line);
  }
}

void ToolSideCompensation::make_corner(const Step& now, const Movement& movement, const SideEnd& start,
                                       const CutterOffset& offset) {
  const Held& held = held_.front();
  if (held.kind == Held::Kind::lone_start) {
    run_lone_start(start);
    return;
  }
  recorder().decide(Clause::fanuc_tool_side_one_block_without_movement, held.without_movement == 1);
  recorder().decide(Clause::fanuc_cutter_c_value_at_a_corner, offset.value != held.offset.value);
  release(group_before(now, movement, start, offset));
}

// The rules in their order (fanuc.tool-side.which-rule).
SideGroup ToolSideCompensation::group_before(const Step& now, const Movement& movement, const SideEnd& start,
                                             const CutterOffset& offset) {
  const Held& held = held_.front();
  const SideEnd& former = held.end;
  if (former.offset == 0) return rules_.square_to(held.plane, former);
  const SideCorner corner{held.plane, former, start};
  const bool starts = held.kind == Held::Kind::start_up;
  const int treatment = starts ? 0 : said(held.step).treatment.value_or(0);
  const bool one_side = held.offset.side == offset.side;
  SideGroup group;
  if (treatment == 1) {
    recorder().reach(Clause::fanuc_tool_side_q1);
    group = rules_.square_to(held.plane, former);
  } else if (recorder().decide(Clause::fanuc_cutter_c_direction_change, !one_side)) {
    group = rules_.side_change(corner);
  } else if (held.repeated) {
    recorder().reach(Clause::fanuc_tool_side_repeated);
    group = rules_.square_to(held.plane, former);
  } else if (starts) {
    group = rules_.start_up(corner);
  } else {
    auto found = rules_.in_mode(corner);
    if (!found)
      raise_held(Clause::fanuc_cutter_c_no_intersection, "PS0033", "the offset paths of an inner corner do not meet");
    group = std::move(*found);
    if (treatment == 2 && recorder().decide(Clause::fanuc_tool_side_q2, corner.of_lines() && group.size() == 2))
      group.pop_back();
  }
  if (treatment == 3) recorder().reach(Clause::fanuc_tool_side_q3);
  if (may_drop(group, movement.path)) rules_.drop_small_differences(group, held.offset.distance);
  if (!starts && treatment == 0 && one_side && !held.repeated &&
      plane_change_.interferes({held.path.travel, held.plane.tool()}, {movement.path.travel, now.rest.tool}))
    raise_held(Clause::fanuc_tool_side_plane_change_alarm, "PS0041",
               "OVERCUT_PLANE_CHANGE: the tool turns and the path goes back, it would cut too much");
  return group;
}

// Nothing is dropped before an arc of a half circle or more.
bool ToolSideCompensation::may_drop(const SideGroup& group, const SidePath& next) const {
  if (group.size() < 2 || !next.arc) return true;
  const ArcEnds& ends = next.arc->ends;
  return is_under_half_circle(recorder(), ends.start, ends.end, ends.turn,
                              sqrt(squared_norm(ends.start) * squared_norm(ends.end)));
}

void ToolSideCompensation::take_cancel(Step& now, Movement& movement) {
  meet_corners_before_cancel(now, movement);
  flush();
  started_.reset();
  if (!movement.end) {
    cancel_alone(now, movement.moves_behind());
    return;
  }
  recorder().reach(Clause::fanuc_tool_side_cancel);
  insert_corner_moves(now);
  now.moves.back().leg.cause = spec::Cause::cancel;
  here_ = {SideVector{}};
  state_ = State::off;
  emit(now);
}

// A block with number 0 can have the word that repeats the code too.
void ToolSideCompensation::meet_corners_before_cancel(Step& now, Movement& movement) {
  for (std::optional<SideEnd>& start : movement.starts) {
    Held& held = held_.front();
    if (said(now).repeats_code()) held.repeated = true;
    decide_held(now);
    if (start) {
      start->offset = held.offset.left();
      recorder().decide(Clause::fanuc_tool_side_one_block_without_movement, held.without_movement == 1);
      release(group_before_cancel(*start));
    } else {
      end_first_without_corner(Clause::fanuc_tool_side_no_next_block);
    }
    recorder().at(now.line);
  }
}

SideGroup ToolSideCompensation::group_before_cancel(const SideEnd& start) {
  const Held& held = held_.front();
  const SideEnd& former = held.end;
  if (former.offset == 0) return rules_.square_to(held.plane, former);
  if (held.repeated) {
    recorder().reach(Clause::fanuc_tool_side_repeated);
    return rules_.square_to(held.plane, former);
  }
  if (held.kind == Held::Kind::start_up) {
    recorder().reach(Clause::fanuc_tool_side_start_then_cancel);
    return rules_.square_to(held.plane, former);
  }
  SideGroup group = rules_.cancel({held.plane, former, start});
  rules_.drop_small_differences(group, held.offset.distance);
  return group;
}

// The tool moves by the vector perpendicular to the next block.
void ToolSideCompensation::run_lone_start(const SideEnd& start) {
  recorder().reach(Clause::fanuc_tool_side_start_type_c);
  Held held = std::move(held_.front());
  held_.pop_front();
  here_ = rules_.square_to_latter(held.plane, start);
  here_plane_ = held.plane;
  emit_change_alone(held.step, spec::Cause::start_up, held.offset.distance != 0);
}

void ToolSideCompensation::hold(Step& now, Held::Kind kind, const CutterOffset& offset, const Movement& movement) {
  now.clauses.add(recorder().take_clauses());
  Held held;
  held.kind = kind;
  held.offset = offset;
  held.plane = movement.own;
  held.path = movement.path;
  if (movement.end) held.end = *movement.end;
  if (const auto& arc = movement.path.arc) {
    const bool at_corner = !movement.starts.empty();
    held.offset_at_start = offset.side * last_.distance;
    const CompensationPlane& plane = at_corner ? here_plane_ : movement.own;
    const Rational rho = at_corner ? held.offset_at_start : offset.left();
    held.start = seen(plane, plane.frame(), arc_start(*arc, rho));
  }
  held.step = std::move(now);
  held_.push_back(std::move(held));
  last_ = offset;
}

}  // namespace toolcomp::model
