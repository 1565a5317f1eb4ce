// SPDX-License-Identifier: Apache-2.0
#include "fast/heidenhain/face_milling/face_milling.h"

#include <cmath>

namespace toolcomp::fast::klartext {
namespace {

// (T.T) N − (N.T) T, exactly.
WideVector3 across(const WholeVector& normal, const WholeVector& tool) {
  const WideVector3 t = tool.exact();
  return cross(t, cross(normal.exact(), t));
}

}  // namespace

void FaceMilling::meet_wide(const ToolVector& tool, Meeting& meeting) const {
  const WideVector3 exact = cross(normal().exact(), tool.vector().exact());
  meeting.flat = exact.x.sign() == 0 && exact.y.sign() == 0 && exact.z.sign() == 0;
  if (meeting.flat) return;
  const Vector c{exact.x.to_double(), exact.y.to_double(), exact.z.to_double()};
  meeting.u = cross(meeting.t, unit_of(c));
  meeting.square = dot(c, c);
}

// In the units of Meeting::square.
inline double FaceMilling::whole_dot(const ToolVector& tool) const {
  const WholeVector& n = normal();
  const WholeVector& t = tool.vector();
  if (n.narrow && t.narrow) [[likely]]
    return static_cast<double>(n.small[0] * t.small[0] + n.small[1] * t.small[1] + n.small[2] * t.small[2]);
  return dot(n.exact(), t.exact()).to_double();
}

Alarm FaceMilling::deviate(const Meeting& meeting, const ToolVector& tool, const EffectiveTool& effective,
                           bool permitted) {
  if (const Alarm a = effective.check_before_angle()) return a;
  const ContactAngle angle = meeting.flat
                                 ? ContactAngle(normal(), tool.vector(), 0, meeting.cosine)
                                 : ContactAngle(normal(), tool.vector(), std::sqrt(meeting.square), whole_dot(tool));
  const DeviationTable& table = *effective.deviations();
  if (!table.find(angle, deviation_)) return AlarmCause::deviation_range;
  if (table.below(effective.corner_without_deviation(), effective.nearest_corner_without_deviation(), angle,
                  deviation_))
    return AlarmCause::corner_radius_negative;
  degrees_ = angle.degrees();
  // A ball: no ring.
  ball_ = effective.values();
  ball_.corner_delta = deviation_.value + effective.corner_delta_without_deviation();
  ball_.effective_corner = ball_.corner + ball_.corner_delta;
  ball_.ring = ball_.effective_ring = ball_.ring_delta = 0;
  return effective.check_after_angle(permitted);
}

bool FaceMilling::exactly_below(const ToolVector& tool) const {
  const WideVector3 n = normal().exact();
  const WideVector3 t = tool.vector().exact();
  const Wide product = dot(n, t);
  return (Wide(25'000'000) * product * product - dot(n, n) * dot(t, t)).sign() > 0;
}

bool FaceMilling::exactly_opposed(const ToolVector& tool) const {
  return dot(across(normal(), tool.vector()), across(normal_[latest_ ^ 1U], before_.tool->vector())).sign() < 0;
}

}  // namespace toolcomp::fast::klartext
