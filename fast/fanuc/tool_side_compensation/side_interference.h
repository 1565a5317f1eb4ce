// SPDX-License-Identifier: Apache-2.0
// The general interference check of tool side compensation: chapter 14's, line by line in the plane of the tool.
#pragma once

#include <optional>

#include "fast/fanuc/corner/interference.h"
#include "fast/fanuc/corner/tool_arc.h"
#include "fast/fanuc/tool_side_compensation/side_group.h"

namespace toolcomp::fast {

// How an arc is seen at its start: at the corner there, or by itself.
struct PathStart {
  const Direction* tool = nullptr;
  int side = 1;
  const Amount* offset = nullptr;
};

// Of a path between the groups at its start and its end. Drops the vectors that interfere from the end of `start` and
// the beginning of `end`; where the answer is an alarm it drops none. `sweep`: of an arc, the tool's own, between the
// last of `start` and the first of `end`.
Interference check_interference(const SideGroups& groups, const SidePath& path, const PathStart& at_start,
                                const std::optional<double>& sweep, SideGroup& start, SideGroup& end);

// Sweep and radii of the tool's own arc, in the selected plane.
void set_tool_arc(spec::Arc<double>& arc, const SideGroups& groups, const SidePath& path, const SideGroup& start,
                  const SideGroup& end);

}  // namespace toolcomp::fast
