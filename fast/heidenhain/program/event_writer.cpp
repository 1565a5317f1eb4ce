// SPDX-License-Identifier: Apache-2.0
#include "fast/heidenhain/program/event_writer.h"

#include <bit>

#include "spec/language/run_end.h"

namespace toolcomp::fast::klartext {
EventWriter::EventWriter(const spec::Setup& setup, EventSink& sink)
    : sink_(sink),
      xyz_{setup.axes.index('X'), setup.axes.index('Y'), setup.axes.index('Z')},
      numbers_(setup),
      in_order_(xyz_ == std::array<std::size_t, 3>{0, 1, 2}) {
  for (std::size_t axis = 0; axis < setup.axes.size(); ++axis) {
    const char letter = setup.axes.letter(axis);
    if (!spec::is_linear_axis(letter)) continue;
    linear_ = static_cast<std::uint16_t>(linear_ | 1U << axis);
    if (letter < 'X') others_ = static_cast<std::uint16_t>(others_ | 1U << axis);
  }
  for (fast::Event* event : {&plain_, &contact_}) {
    event->kind = spec::EventKind::move;
    event->tool_axis.emplace();
    event->space.emplace();
    event->programmed.present = linear_;
    event->point.present = linear_;
  }
  contact_.space->contact.emplace();
  hole_.kind = spec::EventKind::hole;
  hole_.axes.present = linear_;
}

void EventWriter::move(const MoveHead& head, const Placement& placement, const ToolLength& length, spec::Cause cause) {
  if (head.unknown != 0) [[unlikely]]
    move_to_unknown(head, placement, length, cause);
  else
    send(plain_, head, placement, length, cause);
}

void EventWriter::move_to_unknown(const MoveHead& head, const Placement& placement, const ToolLength& length,
                                  spec::Cause cause) {
  warnings(head, head.warnings);
  fill(plain_, head, placement, length, cause);
  fast::Event event = plain_;
  event.unknown = head.unknown;
  event.space.reset();
  for (spec::AxisValues<double>* values : {&event.programmed, &event.point, &event.axes})
    values->present = static_cast<std::uint16_t>(values->present & ~head.unknown);
  sink_.on(event);
}

// heidenhain.program.length-along-the-tool: axes = point + dL t, with the tool along the axis of the hole.
void EventWriter::hole(const MoveHead& head, const spec::Hole<double>& hole, const ToolLength& length) {
  hole_.line = head.line;
  hole_.n = head.n;
  hole_.hole = hole;
  hole_.point.present = static_cast<std::uint16_t>(linear_ & ~(1U << hole.axis));
  other_axes(hole_, head);
  put_xyz(hole_.point, head.xyz);
  put_xyz(hole_.axes, head.xyz);
  hole_.axes.value[hole.axis] += length.length_delta;
  sink_.on(hole_);
}

void EventWriter::other_axes(fast::Event& event, const MoveHead& head) const {
  for (auto rest = static_cast<unsigned>(others_ | head.rotary); rest != 0; rest &= rest - 1) {
    const auto axis = static_cast<std::size_t>(std::countr_zero(rest));
    event.programmed.value[axis] = head.position[axis];
    event.point.value[axis] = head.position[axis];
    event.axes.value[axis] = head.position[axis];
  }
}

void EventWriter::report(spec::EventKind kind, const BlockHead& head, std::string_view number, const char* message) {
  report_.kind = kind;
  report_.line = head.line;
  report_.n = head.n;
  report_.number = number;
  report_.message = message;
  report_.out_of_scope = kind == spec::EventKind::undecided;
  sink_.on(report_);
}

void EventWriter::warnings(const BlockHead& head, Warnings warnings) {
  for (unsigned rest = warnings; rest != 0; rest &= rest - 1) {
    const NamedWarning& warning = kWarnings[static_cast<std::size_t>(std::countr_zero(rest))];
    report(spec::EventKind::warning, head, warning.name, warning.message);
  }
}

void EventWriter::undecided(const BlockHead& head) {
  report(spec::EventKind::undecided, head, "heidenhain.peripheral.out-of-scope", "");
}

void EventWriter::alarm(const BlockHead& head, AlarmCause cause, const char* more) {
  spec::end_run(report_, cause, more != nullptr ? more : spec::info(cause).text, numbers_);
  report(report_.kind, head, report_.number.view(), report_.message);
}

}  // namespace toolcomp::fast::klartext
