// SPDX-License-Identifier: Apache-2.0
// The rules of tool posture control: what is asked of the great circle of a block, and of the posture at its end.
#pragma once

#include <vector>

#include "model/basis/recorder.h"
#include "model/fanuc/tool_posture_control/great_circle.h"
#include "model/kinematics/angle.h"
#include "model/kinematics/machine.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// The pole that an arc goes through inside, and on which side it passes the work-side axis else.
struct Passing {
  const SingularPosture* crossed = nullptr;
  int side = 0;
};

// `work_axis`: how the arc passes that. Clauses: fanuc.tool-posture.*.
class PostureRules {
 public:
  // Parameters 19738, 19739, 19696#3.
  PostureRules(const spec::Setup& setup, const Machine& machine, Recorder& recorder);

  // There is a plane of both directions.
  [[nodiscard]] bool spans_plane(const Direction& from, const Direction& to) const;
  // The pole of this axis along which a direction points. `clause`: at-start or at-end.
  [[nodiscard]] const SingularPosture* pole_along(Clause clause, const Vector& axis, const Direction& direction) const;
  // The work-side axis turns to a position before or behind the block. `clause`: pre-turn or post-turn.
  [[nodiscard]] bool turns(Clause clause, const Angle& to, const Angle& from) const;
  // The sign of the branch on which a tool-side position stands: zero on the edge of reach.
  [[nodiscard]] Sign branch(const Angle& tool) const;
  [[nodiscard]] Passing passing(const AxisPassed& work_axis) const;
  // Throws Alarm PS5459.
  void require_reach_inside(const AxisPassed& work_axis) const;
  // The end pair along the great circle is not the one to be reached.
  [[nodiscard]] bool is_mismatch(bool differs) const;

  // Near postures are looked for at all.
  [[nodiscard]] bool looks(bool type_2) const;
  // The pole that an arc which meets none comes near to.
  [[nodiscard]] const SingularPosture* near(const AxisPassed& work_axis) const;
  // The work-side axis turns by so nearly 180 degrees that it may stand instead.
  [[nodiscard]] bool may_stand(const Angle& turned) const;
  // The end pair in place of `end`, passing the singular tool-side position.
  [[nodiscard]] static Pose changed(const Pose& start, const Pose& end, const Angle& singular);
  // An end that was to be changed stays. Throws Alarm PS5421.
  void keep_end() const;

 private:
  // The least distance d of an arc from a pole.
  struct Distance {
    bool foot_inside = false;
    Real cosine;
  };
  [[nodiscard]] Distance distance(const AxisPassed& work_axis, int sign) const;
  // The foot of the pole of this sign lies on the arc, its ends included.
  [[nodiscard]] bool has_foot_inside(const AxisPassed& work_axis, int sign) const;

  const Machine& machine_;
  Recorder& recorder_;
  const std::vector<SingularPosture>& poles_;
  Rational limit_;  // 19738, degrees
  Rational veto_;   // 19739, degrees
  bool refuses_;    // 19696#3, NPC
};

}  // namespace toolcomp::model
