// SPDX-License-Identifier: Apache-2.0
// Where the workpiece stands in the machine: G54–G59, G54.1, G52, G92, and the reference positions.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "model/fanuc/program/motion.h"
#include "model/kinematics/coordinate.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Machine coordinate = workpiece coordinate + zero. Setup units and degrees.
class WorkCoordinates {
 public:
  explicit WorkCoordinates(const spec::Setup& setup);

  // Of the workpiece system in force, with the local one of G52 and the shift of G92.
  [[nodiscard]] Coordinate zero(std::size_t axis) const {
    return shift_[axis] + (origin_[0][axis] + origin_[selected_][axis] + local_[axis]);
  }
  // The same of all axes as numbers: another object where it changes.
  [[nodiscard]] const SharedZero& zero() const;
  // These change what `position` is called while the machine stays.
  // G54 to G59 are systems 1 to 6, G54.1 P1 is 7.
  void select(std::size_t system, Position& position);
  // G52: the origin of the local system in every workpiece system.
  void set_local(std::size_t axis, const Rational& origin, Position& position);
  // G92: the position is called `to`, in every system; the local system of the axis ends.
  void shift(std::size_t axis, const Coordinate& to, Position& position);
  // G10 L2, L20: the origin of a system becomes `value`, or is moved by it. That of 0 is added to all.
  void set_origin(std::size_t system, std::size_t axis, const Rational& value, bool add, Position& position);

  static constexpr std::size_t kFloating = 0;
  // Machine coordinate of reference position 1 (G28), 2, 3, 4 (G30), or the floating one (G30.1).
  [[nodiscard]] const Rational& reference(std::size_t number, std::size_t axis) const {
    return reference_.at(number)[axis];
  }

 private:
  using Values = std::array<Rational, spec::kMaxAxes>;
  void set(Rational& value, const Rational& to, std::size_t axis, Position& position);

  std::size_t axes_;
  std::vector<Values> origin_;
  Values local_;
  std::array<Values, 5> reference_;
  Position shift_;
  std::size_t selected_ = 1;
  mutable SharedZero zero_;  // made when it is asked for
};

// The values of a table by axis index; 0 where it has none.
std::array<Rational, spec::kMaxAxes> by_axis(const spec::AxisTable& table, const spec::Axes& axes);

}  // namespace toolcomp::model
