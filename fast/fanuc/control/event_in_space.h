// SPDX-License-Identifier: Apache-2.0
// The positions of an event in X, Y and Z with a compensation vector, where those are the first three axes.
#pragma once

#include "fast/arithmetic/trigonometry.h"
#include "fast/basis/event.h"
#include "fast/geometry/vector3.h"

namespace toolcomp::fast {

// X and Y side by side, written and read so: half of what was written at once would be waited for.
[[gnu::always_inline]] inline void set_xyz(spec::AxisValues<double>& values, DoublePair xy, double z) {
  store_pair(values.value.data(), xy);
  values.value[2] = z;
}

// Of an event whose point, axes and machine are the programmed position.
[[gnu::always_inline]] inline void set_from_programmed(Event& event, const Vector3<double>& vector) {
  const DoublePair xy = load_pair(event.programmed.value.data()) + DoublePair{vector.x, vector.y};
  const double z = event.programmed.value[2] + vector.z;
  set_xyz(event.point, xy, z);
  set_xyz(event.axes, xy, z);
  if (event.machine.present != 0) set_xyz(event.machine, xy, z);
}

// Of any other one.
[[gnu::always_inline]] inline void add_to_xyz(Event& event, const Vector3<double>& vector) {
  const auto add_to = [&](spec::AxisValues<double>& values) {
    values.value[0] += vector.x;
    values.value[1] += vector.y;
    values.value[2] += vector.z;
  };
  add_to(event.point);
  add_to(event.axes);
  if (event.machine.present != 0) add_to(event.machine);
}

}  // namespace toolcomp::fast
