// SPDX-License-Identifier: Apache-2.0
// The interference check of cutter compensation C, and what is known of the tool's own arc.
#pragma once

#include <optional>

#include "fast/fanuc/corner/interference.h"
#include "fast/fanuc/corner/tool_arc.h"
#include "fast/fanuc/cutter_compensation_c/cutter_group.h"

namespace toolcomp::fast {

// A block between the groups at its start and its end.
struct CheckedBlock {
  const PlanePath* path = nullptr;
  int start_side = 1;  // of the offset at the corner at its start
  const Amount* start_offset = nullptr;
  int end_side = 1;
  const Amount* end_offset = nullptr;
};

// Drops the vectors that interfere from the end of `start` and the beginning of `end`; where the answer is an alarm it
// drops none. `sweep`: of an arc, the tool's own, between the last of `start` and the first of `end`.
Interference check_interference(const CheckedBlock& block, const std::optional<double>& sweep, CutterGroup& start,
                                CutterGroup& end, const InterferenceParameters& parameters);

// Sweep and radii of the tool's own arc.
void set_tool_arc(spec::Arc<double>& arc, const CheckedBlock& block, const CutterGroup& start, const CutterGroup& end);

}  // namespace toolcomp::fast
