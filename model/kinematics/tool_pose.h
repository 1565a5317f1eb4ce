// SPDX-License-Identifier: Apache-2.0
// How the tool stands at the end of a move under tool center point control, and what it does on the way.
#pragma once

#include <memory>
#include <optional>

#include "model/kinematics/control_frame.h"
#include "model/kinematics/posture_motion.h"

namespace toolcomp::model {

// At the end of a move.
struct ToolPose {
  SharedFrame frame;          // none: no rotary axes, the direction of the tool is that of I J K
  bool in_workpiece = false;  // points are those of the workpiece system (19696#5 = 1, a table axis)
  Pose pose;
  std::optional<Pose> named_at;  // the pose for which the point is given, where that is another: around a turn
  Rational length;               // tool length and holder offset
};

// Of the move that a block run under tool center point control makes of its own.
struct OwnMotion {
  std::optional<Pose> pre_turn;   // a turn before it, to this pose
  std::optional<Pose> post_turn;  // and one behind it
  SharedMotion motion;
  Rational length_before;       // of the tool at the start
  bool branch_differs = false;  // the warning posture-branch stands before it
};

// The tip in the programming system, X Y Z; the tool as events report it there.
struct TipState {
  Vector tip;
  Vector tool;
};

// Control point minus workpiece zero.
Vector control_point(const ToolPose& at, const TipState& tool);
// The tip in the system fixed to the table.
Vector on_table(const ToolPose& at, const Vector& tip);
// The direction that events report of a pose with a frame.
Vector reported_tool(const ToolPose& at);

}  // namespace toolcomp::model
