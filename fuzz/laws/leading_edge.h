// Laws of the leading edge offset (G41.3).
#pragma once

#include "fuzz/laws/scene.h"

namespace toolcomp::fuzz::laws {

// The vector at the end of a block is perpendicular to the tool there, lies in the plane of tool and next movement, and
// is R long; it points backward where the tool leans forward and forward where it leans backward. Sheet "3-dimensional
// cutter compensation" 3.1 (definition and its verification). Only where two plain blocks with linear movement (or the
// G41.3 block and the next) follow each other directly, the latter without D; not where tool and movement are within
// 19631 of parallel (the vector is kept) and, for the sense alone, of perpendicular.
void leading_edge_vector(const Scene& scene, Holding& holding);

}  // namespace toolcomp::fuzz::laws
