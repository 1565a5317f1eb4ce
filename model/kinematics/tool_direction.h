// SPDX-License-Identifier: Apache-2.0
// The direction of the tool, tip to holder, from the positions of the rotary axes.
#pragma once

#include <cstddef>

#include "model/geometry/vector.h"
#include "model/kinematics/coordinate.h"
#include "model/kinematics/mechanism.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// A direction with its length kept apart, so that directions with rational components stay rational.
struct Direction {
  Vector vector{0, 0, 1};
  Real norm2 = 1;         // |vector|²
  Vector unit{0, 0, 1};   // vector / |vector|
  bool reported = false;  // events carry it: the setup has rotary axes that turn the tool, or the program said it

  // From components that are not all zero (I J K).
  static Direction of(const Vector& vector);
  // From components of length 1.
  static Direction of_unit(const Vector& unit) { return {unit, 1, unit, true}; }
};

// Tool direction of a setup: parameters 19680–19690 and 19697–19699, or, where 19680 is 0, the older set 19610–19623.
// Without either the tool stands in +Z. Clauses: fanuc.tool-direction.*.
class Kinematics {
 public:
  // Throws spec::InputError naming the parameter that makes no sense.
  explicit Kinematics(const spec::Setup& setup);

  // Rotary axes turn the tool or the table.
  [[nodiscard]] bool present() const { return !mechanism_.turns.empty(); }
  // G43.5 can use it: no table axis and no head offset.
  [[nodiscard]] bool tip_control_built() const { return tip_control_built_; }
  // A controlled axis on which the direction depends.
  [[nodiscard]] bool turns(std::size_t axis) const;

  // A rotary axis turns the table.
  [[nodiscard]] bool has_table() const {
    return mechanism_.type == MachineType::table || mechanism_.type == MachineType::mixed;
  }
  // Outside tool center point control directions are those in the machine, not those seen from the table.
  [[nodiscard]] bool table_stands() const { return table_stands_; }

  // V of the angles of the rotary axes, outside tool center point control.
  [[nodiscard]] Direction direction(const Position& angles) const;

 private:
  Mechanism mechanism_;
  bool tip_control_built_ = true;
  bool table_stands_ = false;
};

}  // namespace toolcomp::model
