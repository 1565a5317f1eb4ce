// SPDX-License-Identifier: Apache-2.0
// Laws of the leading edge offset (G41.3).
#pragma once

#include "judge/laws/fanuc/scene.h"

namespace toolcomp::judge::laws {

// The vector at the end of a block is perpendicular to the tool there, lies in the plane of tool and next movement, and
// is R long; it points backward where the tool leans forward and forward where it leans backward.
// fanuc.leading-edge.vector and -sign. Only where two plain blocks with linear movement (or the G41.3 block and the
// next) follow each other directly, the latter without D, D0 nowhere since G41.3; not where tool and movement are
// within 19631 of parallel (the vector is kept) and, for the sense alone, of perpendicular.
void leading_edge_vector(const FanucScene& scene, Holding& holding);

}  // namespace toolcomp::judge::laws
