// SPDX-License-Identifier: Apache-2.0
// Rotary axes that follow the tool along a great circle.
#pragma once

#include <optional>

#include "model/fanuc/tool_posture_control/arc_view.h"
#include "model/fanuc/tool_posture_control/great_circle.h"
#include "model/kinematics/posture_motion.h"

namespace toolcomp::model {

// A part of the arc on one branch, and the pose with which it begins.
struct BranchPart {
  Pose start;
  int branch = 1;  // as of Solution
  int pole = 0;    // 1 or -1: it begins in this singular posture
};

// The arc goes through a singular posture: there the second part begins.
struct Crossing {
  Vector pole;  // unit, in the view
  BranchPart behind;
};

// Clauses: fanuc.tool-posture.great-circle, lift.
class GreatCircleMotion : public PostureMotion {
 public:
  // `side`: the work-side axis lies to the left of the arc (1), to the right (-1), or in its plane (0), as decided;
  // `in_plane`: it does lie in its plane.
  GreatCircleMotion(ArcView view, GreatCircle arc, int side, bool in_plane, BranchPart part,
                    std::optional<Crossing> crossing);

  [[nodiscard]] Posture at(const Rational& t) const override;
  [[nodiscard]] MotionForm form() const override;

 private:
  // How a direction of this height stands to the tool-side axis.
  struct Tilt {
    Real height;  // C
    Real aside;   // sqrt(ρ² - C²)
    Real toward;  // along u_t of the tilted direction seen along u_w
  };
  // Degrees of a part, at its beginning or inside.
  struct Angles {
    Real tool;  // from the extreme angle, 0 to 180
    Real work;  // azimuth of the tilted direction, from that of u_t
  };
  static Angles at_pole(int pole, int branch);

  [[nodiscard]] Tilt tilt(const Real& along_work_axis) const;
  [[nodiscard]] Angles angles(const Tilt& tilt, int branch) const;
  [[nodiscard]] Angles at_start(const BranchPart& part) const;
  // All directions of the arc are at right angles to the work-side axis.
  [[nodiscard]] bool is_level() const;
  // The azimuth that the tool has swung about the work-side axis, degrees.
  [[nodiscard]] Real swung(const Vector& tool, const Real& along_work_axis) const;
  [[nodiscard]] Posture posture(const BranchPart& part, const Vector& tool) const;
  // The pole that an arc beside it meets after all: only a forced outcome says that it does not.
  [[nodiscard]] std::optional<Posture> met_pole(const Vector& tool) const;
  // Of the angle at t against that of the pole.
  [[nodiscard]] Sign beyond_pole(const Rational& t) const;

  [[nodiscard]] const Machine& machine() const { return view_.frame()->machine; }

  ArcView view_;
  GreatCircle arc_;
  int side_;
  bool in_plane_;
  mutable std::optional<bool> level_;  // it is normal to that; decided when it is asked for
  BranchPart part_;
  std::optional<Crossing> crossing_;
  Real along_;   // u_t · t0
  Real across_;  // u_t · u_w
};

}  // namespace toolcomp::model
