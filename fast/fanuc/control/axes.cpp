// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/control/axes.h"

#include <string>

#include "spec/language/input_error.h"

namespace toolcomp::fast {

ControlAxes::ControlAxes(const spec::Setup& setup, const Kinematics& kinematics)
    : names(setup.axes),
      count(setup.axes.size()),
      xyz{setup.axes.index('X'), setup.axes.index('Y'), setup.axes.index('Z')},
      letters(names) {
  for (std::size_t axis = 0; axis < count; ++axis) {
    Mask& kind = spec::is_linear_axis(names.letter(axis)) ? linear : rotary;
    kind = static_cast<Mask>(kind | bit(axis));
    if (kinematics.turns_with(axis)) turning = static_cast<Mask>(turning | bit(axis));
  }
  all = static_cast<Mask>(linear | rotary);
}

void ControlAxes::read(const spec::AxisTable& table, const char* key, Positions& to) const {
  for (const auto& [letter, decimal] : table) {
    const std::size_t axis = names.index(letter);
    if (axis == spec::Axes::kNone) continue;
    if (!fits_count(decimal)) throw spec::InputError("setup", 0, 0, std::string(key) + "." + letter + ": too large");
    to[axis] = Count::of(decimal);
  }
}

}  // namespace toolcomp::fast
