// The direction of the tool, tip to holder, from the positions of the rotary axes.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/geometry/vector.h"
#include "model/program/coordinate.h"
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
};

// Tool direction of a setup: parameters 19680–19690 and 19697–19699, or, where 19680 is 0, the older set 19610–19623.
// Without either the tool stands in +Z. Clauses: fanuc.tool-direction.*.
class Kinematics {
 public:
  // Throws spec::InputError naming the parameter that makes no sense.
  explicit Kinematics(const spec::Setup& setup);

  // Rotary axes turn the tool or the table.
  [[nodiscard]] bool present() const { return !turns_.empty(); }
  // G43.5 can use it: no table axis and no head offset.
  [[nodiscard]] bool tip_control_built() const { return tip_control_built_; }
  // A controlled axis on which the direction depends.
  [[nodiscard]] bool turns(std::size_t axis) const;

  // V of the pose; rotary axes in degrees.
  [[nodiscard]] Direction direction(const Position& position) const;

 private:
  // A rotation about a line through the origin. Turns about X, Y or Z move two components only.
  struct Turn {
    std::optional<std::size_t> axis;  // controlled axis; none: hypothetical, at `offset`
    Rational offset;                  // added to the position before the sense applies
    int sense = 1;                    // −1: positive positions turn left-handed
    std::size_t about = 2;            // 0, 1, 2 for X, Y, Z; 3: about `line`
    Vector line;                      // unit

    [[nodiscard]] Vector apply(const Vector& v, const Position& position) const;
  };

  void read_19680(const spec::Setup& setup);
  void read_19610(const spec::Setup& setup);

  Vector reference_{0, 0, 1};
  std::vector<Turn> turns_;  // in the order they act on the reference direction
  bool tip_control_built_ = true;
};

}  // namespace toolcomp::model
