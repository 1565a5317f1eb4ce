// SPDX-License-Identifier: Apache-2.0
// A block of tool side compensation between the vectors at its ends.
#pragma once

#include <optional>

#include "model/fanuc/corner/interference.h"
#include "model/fanuc/tool_side_compensation/mode.h"

namespace toolcomp::model {

// Of an arc: how it leaves the corner before it.
struct ArcStart {
  CompensationPlane plane;  // of that corner
  Rational offset;          // signed, to the left
  PathEnd end;              // as seen in the plane of that corner, if there is one, else in its own
};

// Of an arc: as the tool runs it between two heads. Clause: fanuc.tool-side.arc-as-run.
std::optional<ToolArcRun> arc_run(Recorder& recorder, const SidePlan& block, const ArcStart& start,
                                  const SpaceVector& from, const SpaceVector& to);
// Clause: fanuc.tool-side.interference-in-the-plane.
CheckedPath between_vectors(const SidePlan& block, const ArcStart& start);

}  // namespace toolcomp::model
