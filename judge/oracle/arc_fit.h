// SPDX-License-Identifier: Apache-2.0
// Judges arcs by backward error: with the heads that the controller has at both ends.
#pragma once

#include <array>
#include <optional>

#include "model/basis/event.h"
#include "model/geometry/vector.h"

namespace toolcomp::judge {

// An end of an arc: the exact head, and the distance of the controller's own head from it.
struct ArcEnd {
  model::Vector head;
  model::Vector off;
};

// The arc that runs between the controller's own heads about the same centre: sweep and radii are well conditioned
// functions of these heads, however badly the heads are determined. std::nullopt if a head is off by a right angle,
// seen from the centre, and if the arc does not start at this head, because the coordinates may have changed since
// then. `index`: of X Y Z.
std::optional<spec::Arc<model::Real>> fitted(const spec::Arc<model::Real>& arc, const ArcEnd& start, const ArcEnd& end,
                                             const std::array<std::size_t, 3>& index);

}  // namespace toolcomp::judge
