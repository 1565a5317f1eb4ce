// SPDX-License-Identifier: Apache-2.0
// Interference check: what becomes of a block between the vectors at its start and at its end.
#pragma once

#include <cstdint>
#include <functional>

#include "model/fanuc/corner/tool_arc.h"
#include "model/fanuc/corner/vector_group.h"

namespace toolcomp::model {

enum class Passage : std::uint8_t {
  free,       // the block runs as it is
  shortened,  // vectors were dropped: an arc becomes a line
  blocked     // the last pair interferes too: PS0041
};

// Whether a block interferes between two vectors; the first time they are the inner ones.
using Interferes = std::function<bool(bool first, const SpaceVector& from, const SpaceVector& to)>;
// Drops vectors, the last ones at the start and the first ones at the end of a block, until it does not interfere; at
// each end one vector stays. Nothing is dropped where the block is blocked; without `drops` it is by its first pair.
// Clause: fanuc.cutter-c.interference-pairs.
Passage remove_interference(Recorder& recorder, SpaceGroup& at_start, SpaceGroup& at_end, const Interferes& interferes,
                            bool drops = true);
// Of a blocked block that runs all the same: between the outermost vectors.
Passage leave_outer_vectors(SpaceGroup& at_start, SpaceGroup& at_end);

// Whether an arc interferes, of which the radii are taken at its ends and the sweeps of `run`. Clauses:
// fanuc.cutter-c.interference-radius, interference-sweep.
bool arc_interferes(Recorder& recorder, const PathEnd& start, const PathEnd& end, ToolArcRun& run);
// Whether a path interferes, taken as a line from end to end. Clause: fanuc.cutter-c.interference-direction.
bool line_interferes(Recorder& recorder, const OffsetPath& path, const PlanePoint& from, const PlanePoint& to);
// By how much the offset of an arc is larger than its radius, setup units: at its start, or where it is not, at its
// end; 0: at neither.
Real excess(const PathEnd& start, const PathEnd& end);

}  // namespace toolcomp::model
