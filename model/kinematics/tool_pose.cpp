// SPDX-License-Identifier: Apache-2.0
#include "model/kinematics/tool_pose.h"

namespace toolcomp::model {

Vector control_point(const ToolPose& at, const TipState& tool) {
  if (!at.frame) return tool.tip + Real(at.length) * tool.tool;
  return at.frame->frame.control_point(on_table(at, tool.tip), at.pose, at.length);
}

Vector on_table(const ToolPose& at, const Vector& tip) {
  return at.in_workpiece ? at.frame->frame.of_workpiece(tip, at.named_at.value_or(at.pose)) : tip;
}

Vector reported_tool(const ToolPose& at) {
  return at.in_workpiece ? at.frame->machine.direction_in_machine(at.pose) : at.frame->frame.direction(at.pose);
}

}  // namespace toolcomp::model
