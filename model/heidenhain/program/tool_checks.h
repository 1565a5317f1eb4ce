// SPDX-License-Identifier: Apache-2.0
// Whether the tool may be used, in the order of the clause heidenhain.tool.order-of-checks.
#pragma once

#include "model/basis/recorder.h"
#include "model/heidenhain/program/motion.h"

namespace toolcomp::model::klartext {

// The checks of a block with 3D compensation. They throw Alarm. Clauses: heidenhain.tool.*.
class ToolChecks {
 public:
  explicit ToolChecks(Recorder& recorder) : recorder_(recorder) {}

  // E_NO_TOOL and E_RC_WITH_N.
  void block(const Motion& motion) const;
  // E_TOOL. Zero: a ball.
  Sign table(const EffectiveTool& tool) const;
  // E_TOOL_EFF.
  void radius(const EffectiveTool& tool) const;
  // E_R2_NEG, by a quantity with the sign of R2 + dR2.
  void corner(const Real& quantity, const Real& scale) const;
  // M107: the checks of oversize are left out.
  bool oversize_allowed(const Motion& motion) const;
  // E_OVERSIZE_DR.
  void oversize(const EffectiveTool& tool) const;

  // All of them for a block without a normal.
  void without_normal(const Motion& motion) const;

 private:
  Recorder& recorder_;
};

}  // namespace toolcomp::model::klartext
