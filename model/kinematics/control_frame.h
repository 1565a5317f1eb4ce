// SPDX-License-Identifier: Apache-2.0
// What all blocks of one G43.4 or G43.5 share.
#pragma once

#include <memory>
#include <utility>

#include "model/kinematics/machine.h"

namespace toolcomp::model {

// The programming coordinate system of a mode on its machine.
struct ControlFrame {
  const Machine& machine;
  ProgrammingFrame frame;
  Vector work_axis;  // u_w, unit, in the frame
  Pose zero;         // angles of the axes at their programmed position 0

  ControlFrame(const Machine& of, const Pose& frozen, const Vector& origin, Pose at_zero = {})
      : machine(of), frame(of, frozen, origin), work_axis(frame.work_axis()), zero(std::move(at_zero)) {}

  // Into programmed positions.
  void place(const Pose& pose, Position& position) const { machine.place(pose, zero, position); }
};

// Blocks on their way through the stages keep it beyond the end of the mode.
using SharedFrame = std::shared_ptr<const ControlFrame>;

}  // namespace toolcomp::model
