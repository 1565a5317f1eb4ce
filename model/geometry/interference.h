// Interference check: what becomes of a block between the vectors at its start and at its end.
#pragma once

#include <cstdint>

#include "model/geometry/tool_arc.h"
#include "model/geometry/vector_group.h"

namespace toolcomp::model {

enum class Passage : std::uint8_t {
  free,       // the block runs as it is
  shortened,  // vectors were dropped: an arc becomes a line
  blocked     // the last pair interferes too: PS0041
};

// Drops vectors, the last ones at the start and the first ones at the end, until the block's motion goes with the
// programmed one; at each end one vector stays. `arc`: of an arc, between the last vector at its start and the first at
// its end; null of a line. Clauses: fanuc.cutter-c.interference-*.
Passage remove_interference(Recorder& recorder, const OffsetPath& path, VectorGroup& at_start, VectorGroup& at_end,
                            ToolArcRun* arc);

}  // namespace toolcomp::model
