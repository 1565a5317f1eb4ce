// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_side_compensation/mode.h"

#include <algorithm>
#include <utility>

#include "model/basis/event.h"

namespace toolcomp::model {
namespace {

// From which side the tool sees the plane of an arc: +1 or -1. Throws LeftOpen if the tool lies in it.
int sense(Recorder& recorder, const Direction& tool, spec::Plane plane) {
  const Real& upright = component(tool.vector, normal_axis(plane));
  // fanuc.tool-side.arc-plane: N, the positive normal of the plane selected (Z of G17, Y of G18, X of G19), tells the
  // sense in which an arc is seen from the tool.
  const Sign seen = recorder.decide(Clause::fanuc_tool_side_arc_plane, upright, sqrt(tool.norm2));
  if (seen != Sign::zero && upright.sign() == Sign::zero) throw NotFinite();  // only a forced outcome comes here
  if (seen == Sign::zero)
    leave_open_alone(recorder, Clause::fanuc_tool_side_arc_plane, "an arc whose plane contains the tool direction");
  return static_cast<int>(seen);
}

bool leans(Recorder& recorder, const Direction& tool, spec::Plane plane) {
  // fanuc.tool-side.arc-plane-mismatch: An arc in the mode gives the warning ARC_PLANE_MISMATCH if VT at the end of the
  // block before it, or at its own end, is not at right angles to the plane selected. The warning comes once a block,
  // right before the first move that belongs to the block; the arc runs as computed.
  return recorder.decide(Clause::fanuc_tool_side_arc_plane_mismatch, squared_norm(in_plane_of(plane, tool.vector)),
                         tool.norm2) != Sign::zero;
}

}  // namespace

const SideEnd* SidePlan::start_at(std::uint64_t block) const {
  const auto found = std::ranges::find(starts, block, &Start::at);
  return found == starts.end() ? nullptr : &found->end;
}

SidePlan SideMode::next(const ToolSideBlock& block, const Step& step, std::vector<const SidePlan*> waiting) {
  waiting_ = std::move(waiting);
  const bool asked = asks(block);
  SidePlan plan;
  plan.plane.tool = step.rest.tool;
  if (asked || is_on()) find_movement(block, step, plan);
  // The block right after a lone start moves there and stays in the mode; else the start raises an alarm.
  if (is_pending() && !plan.moves_behind()) return plan;
  asked_ = asked;
  plan.part = phase_ == Phase::off ? SidePart::free : SidePart::idle;
  if (phase_ == Phase::off)
    while_off(block, plan);
  else if (asked)
    in_mode(block, step, plan);
  else if (phase_ != Phase::ending || plan.end)
    cancel(plan);
  plan.offset = last_;
  if (plan.part == SidePart::lone_start || plan.part == SidePart::start_up || plan.part == SidePart::moving) {
    plan.number = ++made_;
    has_vector_ = last_.distance != 0;
  }
  plan.changes = has_vector_;
  before_ = step.rest.tool;
  return plan;
}

void SideMode::while_off(const ToolSideBlock& block, SidePlan& plan) {
  // fanuc.tool-side.type-c: Start-up and cancel are of type C if No. 5003 bit 1, SUV, is 1, whatever bit 0 is. If SUV
  // is 0, bit 0 chooses between the other two types (fanuc.tool-side.type-b).
  const bool alone = asked_ && recorder_.decide(Clause::fanuc_tool_side_type_c, setup_.bit(5003, 1));
  if (!alone && !(asked_ && plan.end)) return;
  // fanuc.tool-side.start-up: With types A and B, if a code and a number other than 0 are in force and there is no
  // vector yet, the next block that moves in the plane (of VT at its own end) is the start-up block. The tool goes
  // straight from the uncompensated start of that block to the first head of the group at its end, which is made in the
  // plane there; the cause is start-up.
  if (!alone) recorder_.reach(Clause::fanuc_tool_side_start_up);
  plan.part = alone ? SidePart::lone_start : SidePart::start_up;
  phase_ = alone ? Phase::pending : Phase::started;
  last_ = offset_of(recorder_, block.side, block.offset);
  if (plan.end) plan.end->offset = last_.left();
}

void SideMode::in_mode(const ToolSideBlock& block, const Step& step, SidePlan& plan) {
  // fanuc.cutter-c.restart-before-removal: If G41 or G42 with a number other than 0 is in force again after a lone G40
  // or number 0, before the vector is removed, the run is undecided at that block. The blocks before it are given as if
  // it were absent. A vector that is exactly zero is removed at once.
  if (phase_ == Phase::ending)
    leave_open_alone(recorder_, Clause::fanuc_cutter_c_restart_before_removal,
                     "tool side compensation again before the vector of the cancelled mode is removed");
  if (!plan.end && !plan.moves_behind()) return;
  const Leg& leg = step.moves.front().leg;
  // fanuc.cutter-c.arc-ends-in-center: An arc block with G41 or G42 and a number other than 0 in force raises PS0038 if
  // its centre is its start or its end; both cases are alike. This is an alarm of a command. It comes after the alarms
  // that the words alone raise (PS0034 of a start-up in an arc among them) and after those of the length offset.
  if (leg.arc && !leg.arc->sweep)
    raise(recorder_, Clause::fanuc_cutter_c_arc_ends_in_center, AlarmCause::arc_ends_in_center);
  const CutterOffset offset = next_offset(block, plan);
  plan.offset_before = offset.side * last_.distance;
  if (plan.arc) look_at_arc(plan);
  for (SidePlan::Start& start : plan.starts) start.end.offset = offset.side * waiting(start.at).offset.distance;
  if (plan.end) {
    plan.end->offset = offset.left();
    plan.part = SidePart::moving;
  }
  last_ = offset;
  phase_ = Phase::running;
}

// G40 or number 0.
void SideMode::cancel(SidePlan& plan) {
  for (SidePlan::Start& start : plan.starts) start.end.offset = waiting(start.at).offset.left();
  const bool at_once = plan.end || setup_.bit(5003, 1);
  plan.part = plan.end ? SidePart::cancel : SidePart::lone_cancel;
  plan.leaves_corner = plan.moves_behind() && !at_once;
  phase_ = at_once || !has_vector_ ? Phase::off : Phase::ending;
}

// A line is asked in the plane of each corner that is still to be made, and in the one at its own end.
void SideMode::find_movement(const ToolSideBlock& block, const Step& step, SidePlan& plan) {
  if (step.moves.empty()) return;
  const Leg& leg = step.moves.front().leg;
  plan.travel = leg.travel;
  const bool at_last = !waiting_.empty() && waiting_.back()->number == made_;
  if (leg.arc) {
    plan.arc = SideArc{leg.arc->plane, arc_of(leg, block.radius, setup_.axes)};
    for (const SidePlan* w : waiting_) plan.starts.push_back({w->number, {}});
    plan.end.emplace();
    plan.at_corner = at_last;
    return;
  }
  const auto seen_in = [&](const CompensationPlane& plane) {
    return crosses_tool(plane, leg.travel) ? std::optional(line_end(plane, leg.travel)) : std::nullopt;
  };
  for (const SidePlan* w : waiting_)
    if (auto start = seen_in(w->plane)) plan.starts.push_back({w->number, std::move(*start)});
  if (!at_last || !plan.plane.is_same_as(waiting_.back()->plane))
    plan.end = seen_in(plan.plane);
  else if (const SideEnd* const at_former = plan.start_at(made_))
    plan.end = *at_former;
}

// Told by |VT × U|². A line along the tool has no direction in the plane.
bool SideMode::crosses_tool(const CompensationPlane& plane, const Vector& travel) const {
  const Real& norm2 = plane.tool.norm2;
  const Real left2 = squared_norm(plane.left(travel));
  const Real travel2 = squared_norm(travel);
  // fanuc.tool-side.along-the-tool: Without a limit (19630 is zero, negative or not given), a block moves if its
  // displacement is neither zero nor parallel to the tool.
  // fanuc.tool-side.no-movement-limit: With 19630 positive (in setup units), a block whose ends differ by less than
  // 19630 in the compensation plane counts as one that does not move.
  const Rational limit2 = shortest_ * shortest_;
  const bool limited = shortest_ > 0;
  const Sign decided = limited ? recorder_.decide(Clause::fanuc_tool_side_no_movement_limit, left2 - limit2 * norm2,
                                                  norm2 * (travel2 + limit2))
                               : recorder_.decide(Clause::fanuc_tool_side_along_the_tool, left2, norm2 * travel2);
  const bool crosses = decided == Sign::positive || (limited && decided == Sign::zero);
  if (crosses && left2.sign() != Sign::positive) throw NotFinite();  // only a forced outcome comes here
  return crosses;
}

CutterOffset SideMode::next_offset(const ToolSideBlock& block, const SidePlan& plan) const {
  const CutterOffset offset = offset_of(recorder_, block.side, block.offset);
  const bool meets_first = !waiting_.empty() && plan.start_at(waiting_.front()->number) != nullptr;
  const bool meets_start =
      meets_first && waiting_.front()->part != SidePart::moving && waiting_.front()->offset.side != offset.side;
  // fanuc.cutter-c.direction-change-at-start-up: The first moving block after a start-up must not change the side; a
  // change raises DIR_CHANGE_AT_STARTUP, a name of ours, at that block. A start-up here is the start-up block, also one
  // that follows G53 or a reference return, or the G41 or G42 of SUV = 1. The rule holds however many blocks without
  // motion come between, and whatever the value.
  //
  // The first block after a start that moves anywhere, and the one that the start's own vector is made with.
  if (changes_side_at_start(offset) || meets_start)
    raise(recorder_, Clause::fanuc_cutter_c_direction_change_at_start_up, AlarmCause::side_change_at_start);
  return offset;
}

void SideMode::look_at_arc(SidePlan& plan) {
  // fanuc.tool-side.arc: The start, end and centre of an arc, also of a helix, are projected onto the compensation
  // plane, and the vector found there is added to the programmed point. The machine then runs the arc in the plane
  // selected by G17, G18 or G19.
  recorder_.reach(Clause::fanuc_tool_side_arc);
  SideArc& arc = *plan.arc;
  for (SidePlan::Start& start : plan.starts) {
    const CompensationPlane& plane = waiting(start.at).plane;
    arc.sense_at_start = sense(recorder_, plane.tool, arc.plane);
    start.end = arc_end(plane, arc, arc.ends.start, arc.sense_at_start);
  }
  arc.sense_at_end = sense(recorder_, plan.plane.tool, arc.plane);
  if (!plan.at_corner) arc.sense_at_start = arc.sense_at_end;
  plan.end = arc_end(plan.plane, arc, arc.ends.end, arc.sense_at_end);
  if (leans(recorder_, before_, arc.plane) || leans(recorder_, plan.plane.tool, arc.plane)) {
    plan.warning = Warning{"ARC_PLANE_MISMATCH", "the tool is not at right angles to the plane of the arc", {}};
    plan.warning->clauses.add(Clause::fanuc_tool_side_arc_plane_mismatch);
  }
}

const SidePlan& SideMode::waiting(std::uint64_t number) const {
  return **std::ranges::find(waiting_, number, &SidePlan::number);
}

}  // namespace toolcomp::model
