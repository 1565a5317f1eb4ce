// SPDX-License-Identifier: Apache-2.0
// Arcs judged by backward error: by the heads a controller has at both ends.
#pragma once

#include <array>
#include <optional>

#include "model/basis/event.h"
#include "model/geometry/vector.h"

namespace toolcomp::fuzz {

// An end of an arc: where the exact head is, and how far the controller's own lies off it.
struct ArcEnd {
  model::Vector head;
  model::Vector off;
};

// The arc that runs between the controller's own heads about the same centre: sweep and radii are well conditioned
// functions of these, however badly the heads are determined. Nothing where a head is off by a right angle, seen from
// the centre, and where the arc does not start at that head: it may be called otherwise since then. `index`: of X Y Z.
std::optional<spec::Arc<model::Real>> fitted(const spec::Arc<model::Real>& arc, const ArcEnd& start, const ArcEnd& end,
                                             const std::array<std::size_t, 3>& index);

}  // namespace toolcomp::fuzz
