// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/control/control.h"

#include "spec/language/input_error.h"
#include "spec/language/run_end.h"

namespace toolcomp::fast {

Control::Control(const spec::Setup& setup, EventSink& sink, std::uint32_t samples)
    : kinematics(setup),
      axes(setup, kinematics),
      stop_codes(setup),
      units(setup),
      modal(axes.xyz, !setup.bit(3403, 5, true)),
      positions(setup, axes),
      attitude(setup, kinematics, axes, units, modal, positions, sink, samples),
      memory(setup),
      cutter_value(setup, memory),
      refuses_repeats(setup.bit(3403, 6)),
      radii_apart_(Count::of(setup.parameter(3410).value_or(spec::Decimal()))),
      numbers_(setup),
      sink_(sink) {}

void Control::begin(const spec::Setup& setup) {
  if (setup.control != spec::Control::fanuc)
    throw spec::InputError("setup", 0, 0, "control: only \"fanuc\" programs can be run");
  if (const auto feed = setup.parameter(1411); feed && !feed->is_zero()) modal.set_feed(Count::of(*feed).nearest());
  positions.read(setup);
  attitude.take_zeros();
  if (kinematics.defined()) attitude.turn();
}

void Control::fill(Event& event, spec::MoveType type, spec::Cause cause) { fill_here(event, type, cause); }

void Control::name_place(Event& event) {
  for (std::size_t axis = 0; axis < axes.count; ++axis) {
    const Count position = positions.actual(axis);
    event.programmed.value[axis] = positions.programmed_value(axis);
    event.point.value[axis] = position.nearest();
    event.axes.value[axis] = (position + positions.length()[axis]).nearest();
  }
  // Where the programmed coordinates of the rotary axes turn it.
  if (kinematics.defined()) attitude.fill(event);
}

Alarm Control::shift_coordinates(const Words& words) {
  const Alarm a = for_each_axis(words.axes(), [&](std::size_t axis) {
    const Count word = units.value(words.axis(axis), (axes.linear & bit(axis)) != 0);
    return words.code(Words::kOneShot) == kG52 ? positions.set_local(axis, word) : positions.shift(axis, word);
  });
  if (words.code(Words::kOneShot) == kG52)
    positions.end_origins();
  else
    positions.end_shift(words.axes());
  attitude.take_zeros();
  if (kinematics.defined()) attitude.turn();
  return a;
}

void Control::store_offset(const OffsetMemory::Write& write, spec::Name& name, double& stored) {
  name = memory.store(write);
  stored = memory.value(write).nearest();
  if (memory.changes_h(write)) positions.length().edited(write.number);
  cutter_value.edit();
}

void Control::write_offset(const OffsetMemory::Write& write) {
  notice_.kind = spec::EventKind::setting;
  notice_.line = line;
  notice_.n = n;
  store_offset(write, notice_.setting, notice_.value);
  sink_.on(notice_);
}

void Control::end(const StageEnd& end) {
  if (end.undecided == nullptr) return send_alarm(end.alarm.cause, nullptr, end.line, end.n);
  notice_.number = end.undecided;
  notice_.permitted = {true, true, true};  // whatever the outcome
  send_end(spec::EventKind::undecided, end.line, end.n);
}

void Control::send_alarm(AlarmCause cause, const char* more, std::uint64_t at,
                         const std::optional<std::uint64_t>& n_at) {
  spec::end_run(notice_, cause, more != nullptr ? more : spec::info(cause).text, numbers_);
  send_end(notice_.kind, at, n_at);
}

void Control::send_end(spec::EventKind kind, std::uint64_t at, const std::optional<std::uint64_t>& n_at) {
  stopped = true;
  notice_.kind = kind;
  notice_.line = at;
  notice_.n = n_at;
  sink_.on(notice_);
}

}  // namespace toolcomp::fast
