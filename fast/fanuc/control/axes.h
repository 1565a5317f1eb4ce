// SPDX-License-Identifier: Apache-2.0
// The axes of the control, as all parts of the interpreter see them.
#pragma once

#include <array>
#include <cstddef>

#include "fast/arithmetic/count.h"
#include "fast/basis/alarm.h"
#include "fast/basis/axis_mask.h"
#include "fast/fanuc/program/words.h"
#include "fast/kinematics/kinematics.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

using Positions = std::array<Count, spec::kMaxAxes>;

// Calls f(axis) for each bit of the mask, lowest first; stops at an alarm and returns it.
template <class Function>
Alarm for_each_axis(Mask mask, Function f) {
  for (unsigned rest = mask; rest != 0; rest &= rest - 1)
    if (const Alarm a = f(static_cast<std::size_t>(__builtin_ctz(rest)))) return a;
  return AlarmCause::none;
}

struct ControlAxes {
  ControlAxes(const spec::Setup& setup, const Kinematics& kinematics);
  // Positions of a table of the setup; axes that are not there are passed over. Throws spec::InputError, naming `key`.
  void read(const spec::AxisTable& table, const char* key, Positions& to) const;

  spec::Axes names;
  std::size_t count;
  Mask linear = 0;
  Mask rotary = 0;
  Mask all = 0;
  Mask turning = 0;                // axes that turn the tool
  std::array<std::size_t, 3> xyz;  // spec::Axes::kNone: not there
  AxisLetters letters;
};

}  // namespace toolcomp::fast
