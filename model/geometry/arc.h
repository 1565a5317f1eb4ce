// SPDX-License-Identifier: Apache-2.0
// The arc of a G02 or G03 block in its plane.
#pragma once

#include <optional>
#include <utility>

#include "model/basis/recorder.h"
#include "model/geometry/plane.h"
#include "spec/language/event.h"

namespace toolcomp::model {

struct ArcGeometry {
  PlanePoint center;
  std::optional<Real> sweep;                    // degrees, over 0 up to 360; absent where an end lies in the centre
  std::optional<std::pair<Real, Real>> radius;  // at start and end, where they differ
};

// `travel`: from start to end. It is asked for, not the end: where the start is irrational it may still be rational.

// By the vector from start to centre (I J K), not zero. Without travel: a full circle. Throws Alarm where the radii
// differ by more than `allowed_difference`, setup units; 0: they may differ by anything.
ArcGeometry arc_by_center(Recorder& recorder, const PlanePoint& start, const PlanePoint& travel,
                          const PlanePoint& to_center, spec::ArcDirection direction,
                          const Rational& allowed_difference);

// By R: positive for the arc up to a half circle, negative for the larger one; there is a travel. Throws Alarm where
// there is no such arc.
ArcGeometry arc_by_radius(Recorder& recorder, const PlanePoint& start, const PlanePoint& travel, const Real& radius,
                          spec::ArcDirection direction);

// The angle turned through in degrees, over 0 up to 360, of which `sine` and `cosine` are multiples by one positive
// factor. `side` is the sign of the sine as decided; where that is zero the turn is a half or a whole one. Where
// it was forced the angle may be 0 or hardly below.
Real swept_angle(const Real& sine, const Real& cosine, Sign side);

}  // namespace toolcomp::model
