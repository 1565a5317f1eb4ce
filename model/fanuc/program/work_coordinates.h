// Where the workpiece stands in the machine: G54–G59, G92, and the reference positions.
#pragma once

#include <array>
#include <cstddef>

#include "model/fanuc/program/motion.h"
#include "model/kinematics/coordinate.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Machine coordinate = workpiece coordinate + zero. Setup units and degrees.
class WorkCoordinates {
 public:
  explicit WorkCoordinates(const spec::Setup& setup);

  // Of the workpiece system in force, with the shift of G92.
  [[nodiscard]] Coordinate zero(std::size_t axis) const { return shift_[axis] + origin_[selected_][axis]; }
  // The same of all axes as numbers: another object where it changes.
  [[nodiscard]] const SharedZero& zero() const;
  // What `position` becomes when the system changes and the machine stays.
  void select(std::size_t system, Position& position);
  // G92: `from` is now called `to`, in every system.
  void shift(std::size_t axis, const Coordinate& from, const Coordinate& to) {
    shift_[axis] = shift_[axis] + (from - to);
    zero_.reset();
  }

  // Machine coordinate of reference position 1 (G28), 2, 3, 4 (G30).
  [[nodiscard]] const Rational& reference(std::size_t number, std::size_t axis) const {
    return reference_.at(number - 1)[axis];
  }
  // Of the floating reference position (G30.1).
  [[nodiscard]] const Rational& floating_reference(std::size_t axis) const { return reference_[4][axis]; }

 private:
  using Values = std::array<Rational, spec::kMaxAxes>;
  std::size_t axes_;
  std::array<Values, 6> origin_;
  std::array<Values, 5> reference_;
  Position shift_;
  std::size_t selected_ = 0;
  mutable SharedZero zero_;  // made when it is asked for
};

// The values of a table by axis index; 0 where it has none.
std::array<Rational, spec::kMaxAxes> by_axis(const spec::AxisTable& table, const spec::Axes& axes);

}  // namespace toolcomp::model
