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

// What is left of the vectors at both ends of a block: the last one at its start and the first one at its end, by
// index.
struct Kept {
  Passage passage = Passage::free;
  std::size_t from = 0;
  std::size_t to = 0;
};
// Asks one pair of vectors, the first time the inner one, whether the block interferes between them.
using Interferes = std::function<bool(bool first, std::size_t from, std::size_t to)>;
// The pairs from the inside outwards until one does not interfere. Clause: fanuc.cutter-c.interference-pairs.
Kept inner_pair(Recorder& recorder, std::size_t at_start, std::size_t at_end, const Interferes& interferes);

// Whether an arc interferes, of which the radii are taken at its ends and the sweeps of `run`. Clauses:
// fanuc.cutter-c.interference-radius, interference-sweep.
bool arc_interferes(Recorder& recorder, const PathEnd& start, const PathEnd& end, ToolArcRun& run);

// Drops vectors, the last ones at the start and the first ones at the end, until the block's motion goes with the
// programmed one; at each end one vector stays. `arc`: of an arc, between the last vector at its start and the first at
// its end; null of a line. Clauses: fanuc.cutter-c.interference-*.
Passage remove_interference(Recorder& recorder, const OffsetPath& path, VectorGroup& at_start, VectorGroup& at_end,
                            ToolArcRun* arc);

}  // namespace toolcomp::model
