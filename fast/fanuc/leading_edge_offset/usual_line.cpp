// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/leading_edge_offset/usual_line.h"

#include "fast/basis/short_cut.h"

namespace toolcomp::fast {

bool LeadingEdgeOffset::awaits_line() const {
  return is_open(ShortCut::leading_edge_line) && active_ && !starting_ && held_count_ == 1 && still_ == 0;
}

void LeadingEdgeOffset::complete_line(const Direction& tool, bool plain) {
  Move& move = held();
  move.direction = &tool;
  if (plain) set_from_programmed(move.event, {});
}

}  // namespace toolcomp::fast
