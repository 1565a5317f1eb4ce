// SPDX-License-Identifier: Apache-2.0
// The great circle along which tool posture control turns the tool through a block, and how it passes an axis.
// Directions are in one view of it, or in the programming frame.
#pragma once

#include <optional>

#include "model/kinematics/posture_motion.h"
#include "model/kinematics/tool_direction.h"

namespace toolcomp::model {

// The arc from one direction to another; they are neither the same nor opposite.
class GreatCircle {
 public:
  // Throws NotFinite where only a forced outcome says that they are neither.
  GreatCircle(Direction from, Direction to);

  [[nodiscard]] const Direction& from() const { return from_; }
  [[nodiscard]] const Direction& to() const { return to_; }
  // N = from × to, as long as they make it.
  [[nodiscard]] const Vector& normal() const { return normal_; }
  [[nodiscard]] const Real& normal2() const { return normal2_; }

  // The unit direction at the fraction t of the swept angle. Clause: fanuc.tool-posture.great-circle.
  [[nodiscard]] Vector at(const Rational& t) const;
  // By the swept angle, over 0 and under 180.
  [[nodiscard]] const DirectionSwing& swing() const;
  // t of that angle, degrees.
  [[nodiscard]] Real swept(const Rational& t) const { return t * swing().degrees; }

 private:
  Direction from_;
  Direction to_;
  Vector normal_;
  Real normal2_;
  mutable std::optional<DirectionSwing> swing_;  // made when it is asked for
};

// Known to be equal, without asking a sign that might be hard to prove.
bool known_same(const Vector& a, const Vector& b);

// How an arc passes an axis. The foot is the point of the whole great circle nearest to the axis.
struct AxisPassed {
  GreatCircle arc;
  Vector axis;        // unit
  Real side;          // N · axis: positive where the axis lies on the left of the arc
  Real along_from;    // from · axis
  Real along_to;      // to · axis
  Real behind_start;  // (from × axis) · N: positive where the foot comes behind the start
  Real before_end;    // (axis × to) · N: positive where it comes before the end
};
AxisPassed pass(const GreatCircle& arc, const Vector& axis);

}  // namespace toolcomp::model
