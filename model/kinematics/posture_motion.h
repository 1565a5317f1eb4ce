// SPDX-License-Identifier: Apache-2.0
// The tool and the rotary axes inside a block run under tool center point control.
#pragma once

#include <memory>
#include <variant>

#include "model/kinematics/machine.h"

namespace toolcomp::model {

// At one moment.
struct Posture {
  Pose pose;    // without meaning where the machine has no rotary axes
  Vector tool;  // unit, in the programming frame
};

// How a motion is made.
//
// Both rotary axes run evenly.
struct EvenTurns {
  Pose start;
  Pose end;
};
// The direction cos(t Θ) from + sin(t Θ) ahead, without rotary axes.
struct DirectionSwing {
  Vector from;   // unit
  Vector ahead;  // unit, at right angles to it
  Real degrees;  // Θ
};
// The rotary axes that follow such a direction, here in the table frame.
struct LiftedSwing {
  DirectionSwing direction;
  Pose start;          // at t = 0
  int branch = 1;      // at t = 0, as of Solution
  int side = 0;        // on which the work-side axis lies: left 1, right -1; 0 in the plane of the directions
  bool level = false;  // all directions are at right angles to that axis
  int pole = 0;        // 1 or -1: it begins in this singular posture
};
using MotionForm = std::variant<EvenTurns, DirectionSwing, LiftedSwing>;

// At the fraction t of the block, 0 < t < 1. Positions are exact where the ends allow it, else known by enclosures.
class PostureMotion {
 public:
  PostureMotion() = default;
  PostureMotion(const PostureMotion&) = delete;
  PostureMotion& operator=(const PostureMotion&) = delete;
  virtual ~PostureMotion() = default;

  [[nodiscard]] virtual Posture at(const Rational& t) const = 0;
  // For who bounds how far it bends.
  [[nodiscard]] virtual MotionForm form() const = 0;
};

using SharedMotion = std::shared_ptr<const PostureMotion>;

}  // namespace toolcomp::model
