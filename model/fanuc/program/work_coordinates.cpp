// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/program/work_coordinates.h"

#include <utility>

#include "model/basis/number.h"

namespace toolcomp::model {

std::array<Rational, spec::kMaxAxes> by_axis(const spec::AxisTable& table, const spec::Axes& axes) {
  std::array<Rational, spec::kMaxAxes> values;
  for (const auto& [letter, value] : table)
    if (axes.has(letter)) values.at(axes.index(letter)) = plain(value);
  return values;
}

WorkCoordinates::WorkCoordinates(const spec::Setup& setup)
    : axes_(setup.axes.size()), origin_(1 + setup.workpiece.size() + spec::kAdditionalWorkpieces) {
  for (std::size_t i = 0; i < setup.workpiece.size(); ++i) origin_[1 + i] = by_axis(setup.workpiece.at(i), setup.axes);
  for (const auto& [number, origin] : setup.additional_workpiece)
    origin_.at(number == 0 ? 0 : setup.workpiece.size() + number) = by_axis(origin, setup.axes);
  for (const auto& [number, table] : setup.reference)
    reference_.at(static_cast<std::size_t>(number)) = by_axis(table, setup.axes);
  reference_[kFloating] = by_axis(setup.floating_reference, setup.axes);
}

const SharedZero& WorkCoordinates::zero() const {
  if (!zero_) {
    Zero now;
    for (std::size_t i = 0; i < axes_; ++i) now.at(i) = zero(i).value();
    zero_ = std::make_shared<const Zero>(std::move(now));
  }
  return zero_;
}

void WorkCoordinates::select(std::size_t system, Position& position) {
  if (system == selected_) return;
  zero_.reset();
  for (std::size_t i = 0; i < axes_; ++i)
    position.at(i) = position.at(i) + Coordinate(origin_.at(selected_).at(i) - origin_.at(system).at(i));
  selected_ = system;
}

// Of a value that is part of the zero in force.
void WorkCoordinates::set(Rational& value, const Rational& to, std::size_t axis, Position& position) {
  position.at(axis) = position.at(axis) + Coordinate(value - to);
  value = to;
  zero_.reset();
}

void WorkCoordinates::set_local(std::size_t axis, const Rational& origin, Position& position) {
  set(local_.at(axis), origin, axis, position);
}

void WorkCoordinates::shift(std::size_t axis, const Coordinate& to, Position& position) {
  set_local(axis, 0, position);
  shift_.at(axis) = shift_.at(axis) + (position.at(axis) - to);
  position.at(axis) = to;
}

void WorkCoordinates::set_origin(std::size_t system, std::size_t axis, const Rational& value, bool add,
                                 Position& position) {
  Rational& origin = origin_.at(system).at(axis);
  const Rational to = add ? Rational(origin + value) : value;
  if (system == 0 || system == selected_)
    set(origin, to, axis, position);
  else
    origin = to;
}

}  // namespace toolcomp::model
