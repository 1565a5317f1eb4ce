// SPDX-License-Identifier: Apache-2.0
// Arcs by R: how well their centre is determined.
#pragma once

#include <array>

#include "judge/oracle/head.h"
#include "model/basis/event.h"

namespace toolcomp::judge {

// The error of the centre of an arc that is given by R (policy::height_error), and the angle of this error, seen from
// either end of the arc. Both are multiples of k. Both are zero for other arcs, and if the arc does not start where the
// movement does, because the coordinates may have changed since then.
struct RadiusArc {
  double center = 0;    // setup units
  double turned = 0;    // radians
  bool hardly = false;  // doubles hardly determine it (policy::kHardly, at the arc or one unit away)

  // The weight of a direction that starts in the centre: its error in multiples of the error of another direction.
  [[nodiscard]] double weight() const;
};

// The rounding of positions, and the number of such roundings that a section is granted.
struct Rounded {
  double position = 0;  // the largest linear magnitude
  double k = 1;
};

// `way`: from the programmed start to the programmed end. `out`: from the centre to the end. In X Y Z, as in the event.
RadiusArc radius_arc(const model::Event& event, const Space& way, const Space& out, const Rounded& rounded);

}  // namespace toolcomp::judge
