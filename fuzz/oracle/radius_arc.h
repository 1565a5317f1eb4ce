// SPDX-License-Identifier: Apache-2.0
// Arcs by R: how well their centre is determined.
#pragma once

#include <array>

#include "fuzz/oracle/head.h"
#include "model/basis/event.h"

namespace toolcomp::fuzz {

// What the centre of an arc is off by where R gives it (policy::height_error), and by how much that turns it, seen from
// either end of the arc. Both in multiples of k; zero of other arcs, and where the arc does not start where the
// movement does: it may be called otherwise since then.
struct RadiusArc {
  double center = 0;    // setup units
  double turned = 0;    // radians
  bool hardly = false;  // doubles hardly know it (policy::kHardly, at the arc or one unit away)

  // Of a direction that leads out of the centre, in multiples of the error of one that does not.
  [[nodiscard]] double weight() const;
};

// What positions are rounded by, and how many of it a section is granted.
struct Rounded {
  double position = 0;  // the largest linear magnitude
  double k = 1;
};

// `way`: from start to end, programmed. `out`: from the centre to the end. In X Y Z, as the event has them.
RadiusArc radius_arc(const model::Event& event, const Space& way, const Space& out, const Rounded& rounded);

}  // namespace toolcomp::fuzz
