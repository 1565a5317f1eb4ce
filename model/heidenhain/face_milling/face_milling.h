// SPDX-License-Identifier: Apache-2.0
// Face milling: LN blocks with a surface normal.
#pragma once

#include <optional>

#include "model/basis/recorder.h"
#include "model/heidenhain/face_milling/rules.h"
#include "model/heidenhain/program/tool_checks.h"

namespace toolcomp::model::klartext {

// The cutter is a disc of radius rho at height R2 above the tip, thickened by R2 (a ring torus), plus the shank. It
// touches the wall at q; the effective tool touches the same plane at the same point. Clauses: heidenhain.face.*,
// heidenhain.tool.*.
class FaceMilling {
 public:
  explicit FaceMilling(Recorder& recorder) : recorder_(recorder), checks_(recorder), rules_(recorder) {}

  // The alarms of a motion with a normal.
  [[nodiscard]] FaceContact check(const Motion& motion) const;

  // Where the tool goes; adds the warnings to the motion.
  Compensated compensate(Motion& motion, const FaceContact& contact);

  // Another motion, or a TOOL CALL, came between: no jump is looked for.
  void forget() { before_.reset(); }

 private:
  Recorder& recorder_;
  ToolChecks checks_;
  FaceRules rules_;
  std::optional<Vector> before_;  // w of the block before; 0 where its contact was on the axis
};

}  // namespace toolcomp::model::klartext
