// SPDX-License-Identifier: Apache-2.0
// The usual line of leading edge offset: what block() does with it, without the detours.
#pragma once

#include "fast/fanuc/control/event_in_space.h"
#include "fast/fanuc/leading_edge_offset/leading_edge_offset.h"

namespace toolcomp::fast {

// In the place of the move that is held: its radius stays in force, its direction is `tool`.
[[gnu::always_inline]] inline void LeadingEdgeOffset::take_line(const Vector3<double>& way, const Direction& tool,
                                                                bool plain) {
  Move& move = held();
  Displacement& displacement = move.displacement;
  displacement.value[0] = way.x;
  displacement.value[1] = way.y;
  displacement.value[2] = way.z;
  displacement.narrow = true;
  displacement.zero = false;
  displacement.slack = 0;
  update(displacement, tool, move.radius);
  if (plain)
    set_from_programmed(move.event, vector_);
  else
    add_to_xyz(move.event, vector_);
  sink_->on(move.event);
}

}  // namespace toolcomp::fast
