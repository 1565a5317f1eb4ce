// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/control/axis_positions.h"

#include "spec/language/input_error.h"

namespace toolcomp::fast {

void AxisPositions::read(const spec::Setup& setup) {
  for (std::size_t i = 0; i < setup.workpiece.size(); ++i) axes_.read(setup.workpiece[i], "workpiece", origin_[i]);
  for (const auto& [number, table] : setup.additional_workpiece)
    axes_.read(table, "workpiece", origin_[number == 0 ? kExternal : kFirstAdditional + number - 1]);
  add_zeros();
  axes_.read(setup.floating_reference, "reference.floating", reference_[0]);
  for (const auto& [number, table] : setup.reference)
    if (number >= 1 && number <= 4) axes_.read(table, "reference", reference_[static_cast<std::size_t>(number)]);
  axes_.read(setup.position, "position", programmed_);
  for (std::size_t axis = 0; axis < axes_.count; ++axis)
    if (place(axis, programmed_[axis])) throw spec::InputError("setup", 0, 0, "position: out of range");
}

Alarm AxisPositions::place(std::size_t axis, const Count& position) {
  if (!position.in_range()) return AlarmCause::position_range;
  programmed_[axis] = position;
  programmed_value_[axis] = position.nearest();
  stale_ = static_cast<Mask>(stale_ | bit(axis));
  return AlarmCause::none;
}

Count AxisPositions::target(const Words& words, std::size_t axis, const WordUnits& units, bool incremental) const {
  const Count word = units.value(words.axis(axis), (axes_.linear & bit(axis)) != 0);
  if (!incremental) return word;
  return programmed_[axis] + word;
}

Count AxisPositions::travel(const Words& words, std::size_t axis, const WordUnits& units, bool incremental) const {
  if (incremental) return units.value(words.axis(axis), (axes_.linear & bit(axis)) != 0);
  return target(words, axis, units, incremental) - programmed_[axis];
}

Alarm AxisPositions::refresh() {
  const Alarm a = for_each_axis(stale_, [this](std::size_t axis) {
    axes_value_[axis] = programmed_value_[axis];
    if (((length_.live() | tool_offset_.live()) & bit(axis)) != 0) {
      const Count position = actual(axis) + length_[axis];
      if (!position.in_range()) return AlarmCause::position_range;
      axes_value_[axis] = position.nearest();
    }
    return AlarmCause::none;
  });
  stale_ = 0;
  return a;
}

std::array<Count, 3> AxisPositions::shift_xyz() const {
  std::array<Count, 3> shift;
  for (std::size_t i = 0; i < 3; ++i)
    if (axes_.xyz[i] != spec::Axes::kNone) shift[i] = tool_offset_[axes_.xyz[i]];
  return shift;
}

void AxisPositions::fill_displaced_machine(Event& event) const {
  for (std::size_t axis = 0; axis < axes_.count; ++axis) {
    const bool displaced = ((displaced_ | stale_) & bit(axis)) != 0;
    event.machine.value[axis] =
        displaced ? (actual(axis) + length_[axis] + machine_origin(axis)).nearest() : axes_value_[axis];
  }
}

void AxisPositions::add_zeros() {
  displaced_ = 0;
  for (std::size_t axis = 0; axis < axes_.count; ++axis) {
    zero_[axis] = origin_[workpiece_][axis] + local_[axis] + shift_[axis];
    zero_[axis] += origin_[kExternal][axis];
    if (!zero_[axis].is_zero()) displaced_ = static_cast<Mask>(displaced_ | bit(axis));
  }
}

void AxisPositions::set_origin(std::size_t number, std::size_t axis, const Count& value) {
  const bool counts = number == workpiece_ || number == kExternal;
  if (counts) set(axis, programmed_[axis] + origin_[number][axis] - value);
  origin_[number][axis] = value;
}

void AxisPositions::end_origins() {
  add_zeros();
  make_stale();
}

Alarm AxisPositions::set_local(std::size_t axis, const Count& origin) {
  const Count called = programmed_[axis] + local_[axis] - origin;
  local_[axis] = origin;
  return place(axis, called);
}

void AxisPositions::select_system(std::size_t system) {
  for (std::size_t axis = 0; axis < axes_.count; ++axis) set(axis, in_system(axis, system));
  workpiece_ = system;
  add_zeros();
  make_stale();
}

Alarm AxisPositions::shift(std::size_t axis, const Count& position) {
  shift_[axis] += programmed_[axis] + local_[axis] - position;
  local_[axis] = Count();
  if (!shift_[axis].in_range()) return AlarmCause::position_range;
  return place(axis, position);
}

void AxisPositions::end_shift(Mask axes) {
  add_zeros();
  shift_rounded_ = static_cast<Mask>(shift_rounded_ | (rounded_ & axes));
  clear_rounded(axes);
}

Alarm AxisPositions::place_at_machine(std::size_t axis, const Count& machine) {
  length_.cancel(axis);
  if ((tool_offset_.live() & bit(axis)) != 0) tool_offset_.clear(axis);
  rounded_ = static_cast<Mask>((rounded_ & ~bit(axis)) | (shift_rounded_ & bit(axis)));
  return place(axis, machine - machine_origin(axis));
}

Alarm AxisPositions::to_intermediate(std::size_t axis, const Count& position) {
  intermediate_[axis] = position;
  return place(axis, position);
}

void AxisPositions::end_intermediate(Mask axes) {
  has_intermediate_ = static_cast<Mask>(has_intermediate_ | axes);
  intermediate_rounded_ = static_cast<Mask>((intermediate_rounded_ & ~axes) | (rounded_ & axes));
}

Alarm AxisPositions::from_intermediate(Mask axes) {
  const auto through = static_cast<Mask>(axes & has_intermediate_);
  if (const Alarm a = for_each_axis(through, [&](std::size_t axis) { return place(axis, intermediate_[axis]); }))
    return a;
  rounded_ = static_cast<Mask>((rounded_ & ~through) | (intermediate_rounded_ & through));
  return AlarmCause::none;
}

}  // namespace toolcomp::fast
