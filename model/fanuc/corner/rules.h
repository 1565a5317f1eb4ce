// SPDX-License-Identifier: Apache-2.0
// The rules of chapter 14 by which cutter compensation C and tool side compensation make the vectors at a corner of a
// plane. Clauses: fanuc.cutter-c.*.
#pragma once

#include <optional>

#include "model/fanuc/corner/vector_group.h"

namespace toolcomp::model {

// Out of the block that ends at the corner and the one that starts there. The offset at the end of `former` is not 0,
// but for square_to.

// P1 alone; of an offset of 0 the vector 0.
VectorGroup square_to(Recorder& recorder, const PathEnd& former);
// Offset mode; nothing where an inner corner has no intersection (PS0033).
std::optional<VectorGroup> offset_mode(Recorder& recorder, const PathEnd& former, const PathEnd& latter);
// The side changes; `latter.offset` is the opposite of `former.offset`.
VectorGroup direction_change(Recorder& recorder, const PathEnd& former, const PathEnd& latter);
// Whether an arc that turns from `start` to `end`, both seen from its centre or both a quarter turn from there, sweeps
// less than a half circle. `radii`: the product of their lengths.
bool is_under_half_circle(Recorder& recorder, int turn, const PlanePoint& start, const PlanePoint& end,
                          const Real& radii);

}  // namespace toolcomp::model
