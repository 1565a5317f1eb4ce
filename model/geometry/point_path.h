// SPDX-License-Identifier: Apache-2.0
// The path of a point from one end of a move to the other: a line, or a turn about an axis of space.
#pragma once

#include <optional>

#include "model/geometry/plane.h"
#include "spec/language/axes.h"
#include "spec/language/event.h"

namespace toolcomp::model {

// X Y Z. Along an arc the fraction of the path is that of the sweep; the radius and the travel across the plane go
// evenly with it.
struct PointPath {
  struct Turn {
    spec::Plane plane = spec::Plane::xy;
    PlanePoint center;
    Real sweep;   // degrees, counter-clockwise positive
    Real growth;  // of the radius, as a multiple of the radius at the start
  };

  Vector from;
  Vector to;
  std::optional<Turn> turn;  // none: straight
};

// About the centre of the arc; one without a sweep is straight.
PointPath path_along(Vector from, Vector to, const spec::Arc<Real>& arc, const spec::Axes& axes);

}  // namespace toolcomp::model
