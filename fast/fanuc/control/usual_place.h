// SPDX-License-Identifier: Apache-2.0
// Where short cuts stand in the selected plane, and where they send an event.
#pragma once

#include <array>
#include <cstddef>

#include "fast/arithmetic/trigonometry.h"
#include "fast/basis/event.h"
#include "fast/fanuc/control/control.h"
#include "fast/geometry/whole_pair.h"

namespace toolcomp::fast {

// The programmed position, 10^-6, if the axes of the plane are sent to it and it has few digits.
[[nodiscard]] inline bool find_usual_place(const Control& control, WholePair& at) {
  const std::array<std::size_t, 2>& axis = control.modal.plane_axis();
  const AxisPositions& positions = control.positions;
  if ((positions.length().live() & (bit(axis[0]) | bit(axis[1]))) != 0 || positions.along_tool()) return false;
  const Count& x = positions.programmed()[axis[0]];
  const Count& y = positions.programmed()[axis[1]];
  at = {x.small(), y.small()};
  return x.is_small() && y.is_small();
}

// What all events of a program in one plane share.
inline void set_frame(Event& event, const Event& from, spec::MoveType type, spec::Cause cause) {
  event.type = type;
  event.cause = cause;
  event.programmed = from.programmed;
  event.point = from.point;
  event.axes = from.axes;
  event.machine.present = 0;
  event.tool_axis = from.tool_axis;
  event.feed = from.feed;
  event.t_numerator = from.t_numerator;
}

// The positions of an event in the plane of these axes: `at`, in 10^-6, with a vector.
[[gnu::always_inline]] inline void place_in_plane(Event& event, const std::array<std::size_t, 2>& axis, DoublePair at,
                                                  DoublePair vector) {
  const DoublePair programmed = at / kWholePerOne;
  const DoublePair point = programmed + vector;
  for (std::size_t i = 0; i < 2; ++i) {
    event.programmed.value[axis[i]] = programmed[i];
    event.point.value[axis[i]] = point[i];
    event.axes.value[axis[i]] = point[i];
  }
}

}  // namespace toolcomp::fast
