// SPDX-License-Identifier: Apache-2.0
// An arc of cutter compensation B by its centre, where nothing of it cancels: doubles are enough.
#pragma once

#include "fast/arithmetic/trigonometry.h"
#include "fast/geometry/whole_pair.h"

namespace toolcomp::fast {

// What the tool runs along it.
struct ArcInDoubles {
  DoublePair vector{};  // at its end, setup units
  WholePair normal{};   // along it, of any length
  double sweep = 0;     // degrees
  DoublePair radius{};  // at its start, at its end
};

// Of an arc from `from` to `to`, seen from its centre, 10^-6: sigma is +1 counterclockwise, -1 clockwise. `vector`: at
// its start; `offset`: to the left, setup units. False: it is for the general way.
[[nodiscard]] bool make_arc_in_doubles(const WholePair& from, const WholePair& to, int sigma, DoublePair vector,
                                       double offset, ArcInDoubles& arc);

}  // namespace toolcomp::fast
