#include "model/fanuc/tool_posture_control/near_singular.h"

#include "model/kinematics/mechanism.h"

namespace toolcomp::model {

bool has_foot_inside(Recorder& recorder, const GreatCircle& arc, const AxisPassed& work_axis, int sign) {
  const Direction& from = arc.from();
  const Direction& to = arc.to();
  return recorder.decide(Clause::fanuc_tool_posture_foot_behind_the_start, sign * work_axis.behind_start,
                         from.norm2 * sqrt(to.norm2)) != Sign::negative &&
         recorder.decide(Clause::fanuc_tool_posture_foot_before_the_end, sign * work_axis.before_end,
                         sqrt(from.norm2) * to.norm2) != Sign::negative;
}

// The sine by that of the double angle: rational where its square is.
NearSingular::NearSingular(const spec::Setup& setup, Recorder& recorder)
    : recorder_(recorder),
      limit_(parameter(setup, 19738)),
      veto_(parameter(setup, 19739)),
      limit_cosine_(exact::cos_degrees(limit_)),
      limit_sine2_((1 - exact::cos_degrees(Rational(2 * limit_))) / 2),
      veto_cosine_(exact::cos_degrees(veto_)) {}

bool NearSingular::looks(bool type_2) const {
  return recorder_.decide(Clause::fanuc_tool_posture_near_limit, type_2 && limit_ > 0);
}

NearSingular::Distance NearSingular::distance(const GreatCircle& arc, const AxisPassed& work_axis, int sign) const {
  if (has_foot_inside(recorder_, arc, work_axis, sign)) return {true, sqrt(1 - square(work_axis.side) / arc.normal2())};
  const Real at_start = sign * work_axis.cosine_from;
  const Real at_end = sign * work_axis.cosine_to;
  return {false, at_start < at_end ? at_end : at_start};
}

const Pole* NearSingular::near(const GreatCircle& arc, const AxisPassed& work_axis,
                               const std::vector<Pole>& poles) const {
  if (poles.empty()) return nullptr;
  const Pole* pole = &poles.front();
  Distance least = distance(arc, work_axis, pole->sign);
  if (poles.size() > 1) {
    const Distance other = distance(arc, work_axis, poles.back().sign);
    if (recorder_.decide(Clause::fanuc_tool_posture_nearer_singular, least.cosine - other.cosine, 2) ==
        Sign::negative) {
      pole = &poles.back();
      least = other;
    }
  }
  bool is_near = false;
  if (least.foot_inside && limit_ <= 90)
    is_near = recorder_.decide(Clause::fanuc_tool_posture_near, limit_sine2_ * arc.normal2() - square(work_axis.side),
                               arc.normal2()) == Sign::positive;
  else
    is_near = least.foot_inside || limit_ > 180 ||
              recorder_.decide(Clause::fanuc_tool_posture_near, least.cosine - limit_cosine_, 2) == Sign::positive;
  return is_near ? pole : nullptr;
}

bool NearSingular::may_stand(const Angle& turned) const {
  if (veto_ < 0) return false;
  if (veto_ >= 180) return true;
  return recorder_.decide(Clause::fanuc_tool_posture_veto, -turned.cosine() - veto_cosine_, 2) != Sign::negative;
}

}  // namespace toolcomp::model
