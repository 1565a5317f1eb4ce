// SPDX-License-Identifier: Apache-2.0
// The usual arc of cutter compensation B: by its centre, and nothing of it cancels, so that doubles are enough.
#pragma once

#include "fast/arithmetic/trigonometry.h"
#include "fast/geometry/whole_pair.h"
#include "spec/language/event.h"

namespace toolcomp::fast {

// What the tool runs along it.
struct UsualArc {
  DoublePair vector{};  // at its end, setup units
  WholePair normal{};   // along it, of any length
  double sweep = 0;     // degrees
  DoublePair radius{};  // at its start, at its end
};

// Of an arc from `from` to `to`, seen from its centre, 10^-6: sigma is +1 counterclockwise, -1 clockwise. `vector`: at
// its start; `offset`: to the left, setup units. False: it is for the general way.
[[nodiscard]] bool make_usual_arc(const WholePair& from, const WholePair& to, int sigma, DoublePair vector,
                                  double offset, UsualArc& arc);

inline void set_usual_arc(spec::Arc<double>& arc, const UsualArc& usual) {
  arc.sweep = usual.sweep;
  arc.radius = {usual.radius[0], usual.radius[1]};
}

}  // namespace toolcomp::fast
