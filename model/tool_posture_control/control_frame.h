// What all blocks of one G43.4 or G43.5 share.
#pragma once

#include <memory>

#include "model/kinematics/machine.h"

namespace toolcomp::model {

// The programming coordinate system of a mode on its machine.
struct ControlFrame {
  const Machine& machine;
  ProgrammingFrame frame;
  Vector work_axis;  // u_w, unit, in the frame

  ControlFrame(const Machine& of, const Pose& frozen, const Vector& origin)
      : machine(of), frame(of, frozen, origin), work_axis(frame.work_axis()) {}
};

// Blocks on their way through the stages keep it beyond the end of the mode.
using SharedFrame = std::shared_ptr<const ControlFrame>;

}  // namespace toolcomp::model
