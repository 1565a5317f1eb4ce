// SPDX-License-Identifier: Apache-2.0
// The rules of tool center point control that need nothing but a block: the lean angle Q of G43.5, and arcs in the
// workpiece coordinate system. What follows from the words alone is in words.cpp, poses are in model/kinematics.
#pragma once

#include <utility>

#include "model/basis/recorder.h"
#include "model/fanuc/program/step.h"
#include "model/kinematics/machine.h"
#include "model/kinematics/tool_direction.h"
#include "spec/language/axes.h"

namespace toolcomp::model {

// Clauses: fanuc.tool-center-point.*.
class TipRules {
 public:
  TipRules(spec::Axes axes, Recorder& recorder) : axes_(std::move(axes)), recorder_(recorder) {}

  // What the lean of a leg is toward: its travel; of an arc the tangent at its end, of any length.
  [[nodiscard]] Vector lean_travel(const Leg& leg) const;
  // The direction leaned by `degrees` towards that, or the direction itself where it lies along it.
  [[nodiscard]] Direction leaned(const Direction& tool, const Leg& leg, const Rational& degrees) const;

  // With 19696#5 = 1 on a machine with a table axis, an arc from pose to pose. `frozen`: the pose of the code. Throws
  // Alarm PS5421 or ARC_WITH_TABLE_TURNED.
  void require_table_still(const Machine& machine, spec::Plane plane, const Pose& start, const Pose& end,
                           const Pose& frozen) const;

 private:
  spec::Axes axes_;
  Recorder& recorder_;
};

}  // namespace toolcomp::model
