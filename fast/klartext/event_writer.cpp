#include "fast/klartext/event_writer.h"

#include <bit>

namespace toolcomp::fast::klartext {
namespace {

// Never -0.
void put(std::array<double, 3>& to, const Vector& v) { to = {v.x + 0.0, v.y + 0.0, v.z + 0.0}; }

Vector along(const Vector& v, const Vector& unit, double length) {
  return {v.x + length * unit.x, v.y + length * unit.y, v.z + length * unit.z};
}

}  // namespace

EventWriter::EventWriter(const spec::Setup& setup, EventSink& sink)
    : sink_(sink),
      xyz_{setup.axes.index('X'), setup.axes.index('Y'), setup.axes.index('Z')},
      count_(setup.axes.size()) {
  for (std::size_t axis = 0; axis < count_; ++axis)
    if (spec::is_linear_axis(setup.axes.letter(axis))) linear_ = static_cast<std::uint16_t>(linear_ | 1U << axis);
  for (fast::Event* event : {&plain_, &contact_}) {
    event->kind = spec::EventKind::move;
    event->tool_axis.emplace();
    event->space.emplace();
    event->programmed.present = linear_;
    event->point.present = linear_;
  }
  contact_.space->contact.emplace();
}

void EventWriter::move(const MoveHead& head, const Placement& placement, const ToolValues& values, spec::Cause cause) {
  send(plain_, head, placement, values, cause);
}

void EventWriter::move_in_contact(const MoveHead& head, const Placement& placement, const ToolValues& values,
                                  spec::Cause cause) {
  send(contact_, head, placement, values, cause);
}

void EventWriter::send(fast::Event& event, const MoveHead& head, const Placement& placement, const ToolValues& values,
                       spec::Cause cause) {
  if (head.warnings != 0) [[unlikely]]
    warnings(head, head.warnings);
  event.line = head.line;
  event.n = head.n;
  event.type = head.rapid ? spec::MoveType::rapid : spec::MoveType::linear;
  event.cause = cause;
  event.axes.present = static_cast<std::uint16_t>(linear_ | head.rotary);
  if (head.rapid)
    event.feed.reset();
  else
    event.feed = head.feed;
  if (count_ > 3) [[likely]]
    for (std::size_t axis = 0; axis < count_; ++axis) {
      event.programmed.value[axis] = head.position[axis];
      event.point.value[axis] = head.position[axis];
      event.axes.value[axis] = head.position[axis];
    }
  spec::SpaceCompensation<double>& space = *event.space;
  const Vector& t = placement.tool;
  put(*event.tool_axis, t);
  const Vector p{head.position[xyz_[0]], head.position[xyz_[1]], head.position[xyz_[2]]};
  const Vector point = p + placement.tip;
  const Vector center = p + along(placement.tip, t, placement.corner);
  const Vector real = p + along(placement.tip, t, values.length_delta);
  for (std::size_t i = 0; i < 3; ++i) {
    event.programmed.value[xyz_[i]] = p[i];
    event.point.value[xyz_[i]] = point[i];
    event.axes.value[xyz_[i]] = real[i];
  }
  put(space.tool_center, center);
  put(space.shift, placement.shift);
  put(space.tool_shift, along(placement.shift, t, values.length_delta));
  if (values.has_length) {
    if (!space.carrier) space.carrier.emplace();
    put(*space.carrier, p + along(placement.tip, t, values.length));
  } else {
    space.carrier.reset();
  }
  sink_.on(event);
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
    const Alarm& warning = kWarnings[static_cast<std::size_t>(std::countr_zero(rest))];
    report(spec::EventKind::warning, head, warning.number, warning.message);
  }
}

void EventWriter::undecided(const BlockHead& head) {
  report(spec::EventKind::undecided, head, "heidenhain.peripheral.out-of-scope", "");
}

void EventWriter::alarm(const BlockHead& head, std::string_view number, const char* message) {
  report(spec::EventKind::alarm, head, number, message);
}

}  // namespace toolcomp::fast::klartext
