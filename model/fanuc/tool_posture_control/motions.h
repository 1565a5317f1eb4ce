// SPDX-License-Identifier: Apache-2.0
// The tool and the rotary axes inside a block: evenly from pose to pose, or along a great circle.
#pragma once

#include <optional>

#include "model/fanuc/tool_posture_control/great_circle.h"
#include "model/kinematics/control_frame.h"
#include "model/kinematics/posture_motion.h"

namespace toolcomp::model {

// The coordinates in which the great circle of a block is looked at, so that what is zero is proven to be. Directions
// that the program says are looked at in the programming frame. Directions of commanded positions (type 1) are looked
// at as the table sees them with its work-side axis turned back by the position at the start: neither that position nor
// the frame's pose, which may be angles of any kind, enters the questions then.
struct ArcView {
  SharedFrame frame;
  std::optional<Angle> work;  // that position

  // u_w, unit.
  [[nodiscard]] const Vector& work_axis() const { return work ? frame->machine.work_side().line : frame->work_axis; }
  // A direction of the view as it is in the table frame, and in the programming frame.
  [[nodiscard]] Vector in_table(const Vector& direction) const {
    return work ? frame->machine.work_side().apply(direction, *work) : frame->frame.to_table(direction);
  }
  [[nodiscard]] Vector in_frame(const Vector& direction) const {
    return work ? frame->frame.from_table(in_table(direction)) : direction;
  }
  // As it is in the table frame, but for a turn about the work-side axis that is the same for all directions.
  [[nodiscard]] Vector about_axis(const Vector& direction) const {
    return work ? direction : frame->frame.to_table_beside(direction);
  }
};

// A part of the arc on one branch, and the pose with which it begins.
struct BranchPart {
  Pose start;
  int branch = 1;        // as of Solution
  int pole = 0;          // 1 or -1: it begins in this singular posture
  bool on_edge = false;  // it begins at another edge of reach: the branch is that of the pair to be reached
};

// Rotary axes that run evenly from pose to pose: conventional control, and the block that passes a singular posture.
// Clauses: fanuc.tool-center-point.conventional, fanuc.tool-posture.passing.
SharedMotion even_motion(const SharedFrame& frame, const Pose& start, const Pose& end);

// The tool without rotary axes, G43.5 on a machine that has none: along the great circle; between opposite directions
// the first one stays until the end. Clause: fanuc.tool-center-point.without-kinematics.
SharedMotion direction_motion(const Direction& from, const Direction& to);

// Rotary axes that follow the tool along a great circle. `side`: the work-side axis lies to the left of the arc (1), to
// the right (-1), or in its plane (0), as decided; `in_plane`: it does lie in its plane; `behind`: the arc goes through
// a singular posture, and there this part begins. Clauses: fanuc.tool-posture.great-circle, lift.
SharedMotion great_circle_motion(const ArcView& view, const GreatCircle& arc, int side, bool in_plane,
                                 const BranchPart& part, const std::optional<BranchPart>& behind);

}  // namespace toolcomp::model
