// SPDX-License-Identifier: Apache-2.0
// The path of a block held by tool side compensation, as its corner and the interference check see it.
#pragma once

#include <optional>

#include "model/fanuc/corner/held.h"
#include "model/fanuc/tool_side_compensation/side_path.h"

namespace toolcomp::model {

// Clauses: fanuc.tool-side.interference-in-the-plane, arc-as-run.
class HeldSidePath final : public HeldPath {
 public:
  [[nodiscard]] std::optional<ToolArcRun> arc_run(Recorder& recorder, const SpaceVector& from,
                                                  const SpaceVector& to) const override;
  [[nodiscard]] bool arc_interferes(Recorder& recorder, ToolArcRun& run) const override;
  [[nodiscard]] bool line_interferes(Recorder& recorder, const Vector& from, const Vector& to) const override;
  [[nodiscard]] Real backwards(const Vector& from, const Vector& to) const override;
  [[nodiscard]] Real excess() const override;

  CompensationPlane plane;  // at its end; a lone start has nothing else
  SidePath path;
  SideEnd end;
  // Of an arc.
  CompensationPlane plane_at_start;  // of the corner there
  Rational offset_at_start;          // signed, to the left
  PathEnd start;                     // as seen in the plane of the corner there, where there is one, else in its own

 private:
  [[nodiscard]] HeadPair pair_of(const SpaceVector& from, const SpaceVector& to) const;
};

inline const HeldSidePath& side_path_of(const Held& held) { return static_cast<const HeldSidePath&>(*held.path); }

}  // namespace toolcomp::model
