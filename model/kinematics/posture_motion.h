// The tool and the rotary axes inside a block run under tool center point control.
#pragma once

#include <memory>

#include "model/kinematics/machine.h"

namespace toolcomp::model {

// At one moment.
struct Posture {
  Pose pose;    // without meaning where the machine has no rotary axes
  Vector tool;  // unit, in the programming frame
};

// At the fraction t of the block, 0 < t < 1. Positions are exact where the ends allow it, else known by enclosures.
class PostureMotion {
 public:
  PostureMotion() = default;
  PostureMotion(const PostureMotion&) = delete;
  PostureMotion& operator=(const PostureMotion&) = delete;
  virtual ~PostureMotion() = default;

  [[nodiscard]] virtual Posture at(const Rational& t) const = 0;
};

using SharedMotion = std::shared_ptr<const PostureMotion>;

}  // namespace toolcomp::model
