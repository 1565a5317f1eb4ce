// The general interference check of tool side compensation: chapter 14's, line by line in the plane of the tool.
#pragma once

#include "fast/cutter_compensation_c/interference.h"
#include "fast/tool_side_compensation/side_group.h"

namespace toolcomp::fast {

// A block between the groups at its start and its end.
struct CheckedSide {
  const SidePath* path = nullptr;
  const Direction* start_tool = nullptr;  // of the corner at its start; where there is none, of its end
  int start_side = 1;
  const Count* start_offset = nullptr;  // >= 0
};

// Drops the vectors that interfere from the end of `start` and the beginning of `end`; where the answer is an alarm it
// drops none. `tool`: of an arc, that between the last of `start` and the first of `end`.
Interference check_interference(const SideGroups& groups, const CheckedSide& block, const ToolArc& tool,
                                SideGroup& start, SideGroup& end);

// The tool's own arc, in the selected plane.
ToolArc tool_arc(const SideGroups& groups, const SidePath& path, const SideGroup& start, const SideGroup& end);

}  // namespace toolcomp::fast
