// SPDX-License-Identifier: Apache-2.0
// The checks of a block of tool side compensation: where the compensation plane changes behind it, and for interference
// between the vectors at its ends.
#pragma once

#include <optional>

#include "model/fanuc/corner/interference.h"
#include "model/fanuc/tool_side_compensation/mode.h"

namespace toolcomp::model {

// Clauses: fanuc.tool-side.plane-change-*.
class PlaneChangeCheck {
 public:
  // Parameters 19605#5 and 6261. Throws spec::InputError naming 6261.
  PlaneChangeCheck(const spec::Setup& setup, Recorder& recorder);

  // Whether the path from `former` to `latter` is at fault.
  [[nodiscard]] bool interferes(const SidePlan& former, const SidePlan& latter) const;

 private:
  [[nodiscard]] bool turns_far(const Direction& former, const Direction& latter) const;

  Recorder& recorder_;
  bool checks_;   // 19605#5, NIC, is 0
  Real cosine_;   // of the limit angle
  Real cosine2_;  // its square, rational for the angles for which it can be
};

// `before`: the plane in which the vectors at the start of the block were made.

// Of an arc: as the tool runs it between two heads. Clause: fanuc.tool-side.arc-as-run.
std::optional<ToolArcRun> arc_run(Recorder& recorder, const SidePlan& block, const CompensationPlane& before,
                                  const SpaceVector& from, const SpaceVector& to);
// Clause: fanuc.tool-side.interference-in-the-plane.
CheckedPath between_vectors(const SidePlan& block, const CompensationPlane& before);

}  // namespace toolcomp::model
