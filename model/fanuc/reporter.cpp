// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/reporter.h"

#include <utility>

#include "spec/language/run_end.h"

namespace toolcomp::model {
namespace {

Event event_of(const Step& step, spec::EventKind kind) {
  Event event;
  event.kind = kind;
  event.line = step.line;
  event.n = step.n;
  event.clauses = step.clauses;
  return event;
}

Event event_of(const Step& step, const DrilledHole& hole, const spec::Axes& axes) {
  Event event = event_of(step, spec::EventKind::hole);
  const Leg& leg = hole.move.leg;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Real at = leg.actual(i).value();
    if (spec::is_linear_axis(axes.letter(i)) && i != hole.axis) event.point.set(i, at);
    event.axes.set(i, at + hole.move.length.at(i));
  }
  const Rational shift = leg.shift_of(hole.axis);
  event.hole = {hole.axis, hole.point_r.value() + shift, hole.bottom.value() + shift, leg.actual(hole.axis).value()};
  return event;
}

Event event_of(const Step& step, const OffsetSetting& setting) {
  Event event = event_of(step, spec::EventKind::setting);
  event.setting = setting.name;
  event.value = setting.value;
  event.clauses.add(setting.clauses);
  return event;
}

Event event_of(const Step& step, const Warning& warning) {
  Event event = event_of(step, spec::EventKind::warning);
  event.number = warning.number;
  event.message = warning.message;
  event.clauses = warning.clauses;
  return event;
}

}  // namespace

Reporter::Reporter(const spec::Setup& setup, Recorder& recorder, EventSink& sink, std::uint32_t samples,
                   MotionSink* motions)
    : axes_(setup.axes),
      numbers_(setup),
      recorder_(recorder),
      sink_(sink),
      motions_(motions),
      tip_moves_(
          setup.axes, samples, motions != nullptr,
          [this](const Move& move, std::shared_ptr<const InsideMove> inside) { report(move, std::move(inside)); },
          [this](Event sample) { report(std::move(sample)); }) {}

void Reporter::at(const spec::Block& block) {
  line_ = block.line;
  n_ = block.n;
}

template <class Fault>
Event Reporter::fault_event(spec::EventKind kind, const Fault& fault, const spec::ClauseList& clauses) const {
  Event event;
  event.kind = kind;
  event.line = fault.line != 0 ? fault.line : line_;
  event.n = fault.line != 0 ? fault.n : n_;
  event.message = fault.message;
  event.clauses = clauses;
  return event;
}

void Reporter::report(const Step& step) {
  step_ = &step;
  if (step.warning) sink_.on(event_of(step, *step.warning));
  for (const Move& move : step.moves) {
    if (move.inside && move.inside->branch_differs) {
      Warning warning{"posture-branch", "the axes cannot follow the plane to the commanded positions", {}};
      // fanuc.tool-posture.branch-mismatch: If the end pair found along the great circle is not the one that has to be
      // reached, the block runs under conventional control, with the warning posture-branch. The warning comes just
      // before the own move of the block and the samples of that move, after every inserted move there and after
      // ARC_PLANE_MISMATCH.
      warning.clauses.add(Clause::fanuc_tool_posture_branch_mismatch);
      sink_.on(event_of(step, warning));
    }
    tip_moves_.take(move);
  }
  for (const DrilledHole& hole : step.holes) sink_.on(event_of(step, hole, axes_));
  if (motions_ != nullptr) motions_->stand(step.zero, step.line, step.n);
  if (step.setting) sink_.on(event_of(step, *step.setting));
  if (step.alarm) report(*step.alarm, step.clauses);
}

void Reporter::report(const Move& move, std::shared_ptr<const InsideMove> inside) {
  if (motions_ != nullptr) motions_->on({move.zero, std::move(inside), move.tip.has_value()});
  Event event = event_of(*step_, spec::EventKind::move);
  event.type = move.leg.type;
  event.cause = move.leg.cause;
  const Vector control_point = move.tip ? axes_at(move, axes_) : Vector();
  const std::optional<Vector> turned_tip = tip_beside_name(move, axes_);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const char letter = axes_.letter(i);
    Real at = move.leg.actual(i).value();
    if (spec::is_linear_axis(letter)) {
      event.programmed.set(i, move.leg.end.at(i).value());
      if (is_space_axis(letter)) at += component(move.offset, space_index(letter));
      event.point.set(i, turned_tip && is_space_axis(letter) ? component(*turned_tip, space_index(letter)) : at);
    }
    const bool of_tip = move.tip && is_space_axis(letter);
    const Real axis = of_tip ? component(control_point, space_index(letter)) : at + move.length.at(i);
    event.axes.set(i, axis);
    if (move.machine) event.machine.set(i, axis + move.zero->at(i));
  }
  if (move.tool.reported) event.tool_axis = {move.tool.unit.x, move.tool.unit.y, move.tool.unit.z};
  event.arc = move.leg.arc;
  if (event.type != spec::MoveType::rapid) event.feed = move.feed;
  sink_.on(event);
}

void Reporter::report(Event sample) {
  sample.line = step_->line;
  sample.n = step_->n;
  sample.clauses = step_->clauses;
  sink_.on(sample);
}

void Reporter::report(const Alarm& alarm, const spec::ClauseList& clauses) {
  Event event = fault_event(spec::EventKind::alarm, alarm, clauses);
  spec::end_run(event, alarm.cause, alarm.message, numbers_);
  event.unmade = alarm.unmade;
  event.value = alarm.crossing;
  sink_.on(event);
}

void Reporter::report(const LeftOpen& open, const spec::ClauseList& clauses) {
  Event event = fault_event(spec::EventKind::undecided, open, clauses);
  event.number = spec::info(open.clause).id;
  event.permitted = {true, true, true};
  sink_.on(event);
}

void Reporter::report_undecided() {
  LeftOpen open(recorder_.latest(), "the sign of a decision by this clause could not be certified");
  open.line = recorder_.line();
  if (open.line == line_) open.n = n_;
  report(open, recorder_.take_clauses());
}

}  // namespace toolcomp::model
