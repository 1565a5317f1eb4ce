// SPDX-License-Identifier: Apache-2.0
#include "model/heidenhain/program/report.h"

#include <array>
#include <utility>

#include "spec/language/run_end.h"

namespace toolcomp::model::klartext {
namespace {

Event event_of(spec::EventKind kind, const Place& place) {
  Event event;
  event.kind = kind;
  event.line = place.line;
  event.n = place.n;
  return event;
}

std::array<Real, 3> components(const Vector& v) { return {v.x, v.y, v.z}; }

// All linear axes as programmed, X Y Z of them at a point.
spec::AxisValues<Real> moved_to(const Vector& point, const Motion& motion, const spec::Axes& axes) {
  spec::AxisValues<Real> result = motion.programmed;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (is_space_axis(axes.letter(i)) && result.has(i)) result.set(i, component(point, space_index(axes.letter(i))));
  return result;
}

void report_warnings(const Motion& motion, EventSink& sink) {
  for (const Warning& warning : motion.warnings) {
    Event event = event_of(spec::EventKind::warning, {motion.line, motion.n});
    event.number = warning.number;
    event.message = warning.message;
    event.clauses.add(warning.clause);
    sink.on(event);
  }
}

}  // namespace

void report_move(const Motion& motion, const Compensated& compensated, const spec::Setup& setup, EventSink& sink) {
  report_warnings(motion, sink);
  const EffectiveTool& tool = *motion.tool;
  const Vector& t = motion.direction.unit;
  const Vector lengthened = tool.dl * t;
  Event event = event_of(spec::EventKind::move, {motion.line, motion.n});
  event.type = motion.rapid ? spec::MoveType::rapid : spec::MoveType::linear;
  event.cause = compensated.cause;
  event.programmed = motion.programmed;
  event.point = moved_to(compensated.point, motion, setup.axes);
  event.axes = moved_to(compensated.point + lengthened, motion, setup.axes);
  for (std::size_t i = 0; i < setup.axes.size(); ++i)
    if (motion.rotary.has(i)) event.axes.set(i, motion.rotary[i]);
  event.tool_axis = components(t);
  if (!motion.rapid) event.feed = motion.feed;
  event.clauses = motion.clauses;
  if (motion.unknown != 0) {
    for (std::size_t i = 0; i < setup.axes.size(); ++i)
      if (spec::is_linear_axis(setup.axes.letter(i)) && !event.programmed.has(i))
        event.unknown = static_cast<std::uint16_t>(event.unknown | 1U << i);
    sink.on(event);
    return;
  }
  auto& space = event.space.emplace();
  space.tool_center = components(compensated.tool_center);
  space.shift = components(compensated.shift);
  space.tool_shift = components(compensated.shift + lengthened);
  if (tool.l) space.carrier = components(compensated.point + (*tool.l + tool.dl) * t);
  space.contact = compensated.contact;
  sink.on(event);
}

void report_hole(const DrilledHole& hole, const spec::Setup& setup, EventSink& sink) {
  const Motion& motion = hole.motion;
  Event event = event_of(spec::EventKind::hole, {motion.line, motion.n});
  event.point = motion.programmed;
  event.point.clear(hole.axis);
  event.hole = {hole.axis, hole.r, hole.bottom, motion.programmed[hole.axis]};
  event.axes = moved_to(motion.position + motion.tool->dl * motion.direction.unit, motion, setup.axes);
  event.clauses = motion.clauses;
  sink.on(event);
}

std::shared_ptr<const Event> unmade(const Motion& motion) {
  Event event = event_of(spec::EventKind::move, {motion.line, motion.n});
  event.programmed = motion.programmed;
  return std::make_shared<Event>(std::move(event));
}

void report_out_of_scope(const Motion& motion, EventSink& sink) {
  report_warnings(motion, sink);
  Event event = event_of(spec::EventKind::undecided, {motion.line, motion.n});
  // heidenhain.peripheral.out-of-scope: RL or RR without TCPM, in an L block or an LN block without a normal, is the
  // ordinary compensation in the plane by the full radius, which is not modelled. In place of the move there is an
  // undecided event with the reason OUT_OF_SCOPE. The run goes on from the programmed end point.
  event.number = spec::info(Clause::heidenhain_peripheral_out_of_scope).id;
  event.message = "radius compensation in the plane (RL or RR without TCPM) is not modelled";
  event.out_of_scope = true;
  event.clauses = motion.clauses;
  event.unmade = unmade(motion);
  sink.on(event);
}

void report_alarm(const Alarm& alarm, const spec::AlarmNumbers& numbers, const Place& current,
                  const spec::ClauseList& clauses, EventSink& sink) {
  Event event = event_of(spec::EventKind::alarm, alarm.line != 0 ? Place{alarm.line, alarm.n} : current);
  spec::end_run(event, alarm.cause, alarm.message, numbers);
  event.clauses = clauses;
  event.unmade = alarm.unmade;
  sink.on(event);
}

void report_undecided(Recorder& recorder, const Place& current, EventSink& sink) {
  const bool here = recorder.line() == current.line;
  Event event = event_of(spec::EventKind::undecided, here ? current : Place{recorder.line(), {}});
  event.number = spec::info(recorder.latest()).id;
  event.permitted = {true, true, true};
  event.message = "the sign of a decision by this clause could not be certified";
  event.clauses = recorder.take_clauses();
  sink.on(event);
}

}  // namespace toolcomp::model::klartext
