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

WorkCoordinates::WorkCoordinates(const spec::Setup& setup) : axes_(setup.axes.size()) {
  for (std::size_t i = 0; i < origin_.size(); ++i) origin_.at(i) = by_axis(setup.workpiece.at(i), setup.axes);
  for (const auto& [number, table] : setup.reference)
    if (number >= 1 && number <= 4) reference_.at(static_cast<std::size_t>(number - 1)) = by_axis(table, setup.axes);
  reference_[4] = by_axis(setup.floating_reference, setup.axes);
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

}  // namespace toolcomp::model
