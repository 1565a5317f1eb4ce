// Near a singular posture: parameters 19738 and 19739.
#pragma once

#include <optional>
#include <vector>

#include "model/basis/recorder.h"
#include "model/fanuc/tool_posture_control/great_circle.h"
#include "model/kinematics/angle.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// A singular posture of the machine: the tool along the work-side axis (1) or against it (-1).
struct Pole {
  int sign = 1;
  Angle tool;  // the tool-side position there, principal
};

// Whether the foot of the pole lies on the arc, its ends included. Clauses: fanuc.tool-posture.foot-*.
bool has_foot_inside(Recorder& recorder, const GreatCircle& arc, const AxisPassed& work_axis, int sign);

class NearSingular {
 public:
  NearSingular(const spec::Setup& setup, Recorder& recorder);

  // Near postures are looked for at all. Clause: fanuc.tool-posture.near-limit.
  [[nodiscard]] bool looks(bool type_2) const;
  // The pole that an arc which meets none comes near to. Clauses: fanuc.tool-posture.nearer-singular, near.
  [[nodiscard]] const Pole* near(const GreatCircle& arc, const AxisPassed& work_axis,
                                 const std::vector<Pole>& poles) const;
  // The work-side axis turns by so nearly 180 degrees that it may stand instead. Clause: fanuc.tool-posture.veto.
  [[nodiscard]] bool may_stand(const Angle& turned) const;

 private:
  // The least distance d of an arc from a pole.
  struct Distance {
    bool foot_inside = false;
    Real cosine;
  };
  [[nodiscard]] Distance distance(const GreatCircle& arc, const AxisPassed& work_axis, int sign) const;

  Recorder& recorder_;
  Rational limit_;  // 19738, degrees
  Rational veto_;   // 19739, degrees
  Real limit_cosine_;
  Real limit_sine2_;
  Real veto_cosine_;
};

}  // namespace toolcomp::model
