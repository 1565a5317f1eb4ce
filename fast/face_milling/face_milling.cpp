#include "fast/face_milling/face_milling.h"

#include <cmath>

#include "fast/fault.h"

namespace toolcomp::fast::klartext {
namespace {

// (T.T) N − (N.T) T, exactly.
WideVector3 across(const WholeVector& normal, const WholeVector& tool) {
  const WideVector3 t = tool.exact();
  return cross(t, cross(normal.exact(), t));
}

}  // namespace

inline FaceMilling::Meeting FaceMilling::meet(const ToolVector& tool, bool along) const {
  Meeting meeting;
  meeting.t = tool.unit();
  if (along) {
    meeting.n = meeting.t;
    meeting.flat = true;
    return meeting;
  }
  const Vector normal = normal_.nearest();
  const double scale = 1 / std::sqrt(dot(normal, normal));
  meeting.n = {normal.x * scale, normal.y * scale, normal.z * scale};
  meeting.cosine = dot(meeting.n, meeting.t);
  const WholeVector& t = tool.vector();
  if (!normal_.narrow || !t.narrow) [[unlikely]] {
    meet_wide(tool, meeting);
    return meeting;
  }
  // Components are below 2^30.
  const std::int64_t x = normal_.small[1] * t.small[2] - normal_.small[2] * t.small[1];
  const std::int64_t y = normal_.small[2] * t.small[0] - normal_.small[0] * t.small[2];
  const std::int64_t z = normal_.small[0] * t.small[1] - normal_.small[1] * t.small[0];
  meeting.flat = (x | y | z) == 0;
  if (meeting.flat) [[unlikely]]
    return meeting;
  const Vector c{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  const double length = std::sqrt(dot(c, c));
  meeting.u = cross(meeting.t, c) * (1 / length);
  meeting.sine = length * scale;
  return meeting;
}

void FaceMilling::meet_wide(const ToolVector& tool, Meeting& meeting) const {
  const WideVector3 exact = cross(normal_.exact(), tool.vector().exact());
  meeting.flat = exact.x.sign() == 0 && exact.y.sign() == 0 && exact.z.sign() == 0;
  if (meeting.flat) return;
  const Vector c{exact.x.to_double(), exact.y.to_double(), exact.z.to_double()};
  meeting.u = cross(meeting.t, unit_of(c));
  // From the units of exact() to those of both vectors.
  const Vector normal = normal_.nearest();
  const double unit = (normal_.narrow ? 1e-10 : 1.0) * (tool.vector().narrow ? 1e-10 : 1.0);
  meeting.sine = unit * std::sqrt(dot(c, c)) / std::sqrt(dot(normal, normal));
}

Alarm FaceMilling::deviate(const ToolVector& tool, bool along, const EffectiveTool& effective, bool permitted) {
  if (const Alarm a = effective.check_before_angle()) return a;
  const Meeting meeting = meet(tool, along);
  // The sine still lacks |T|.
  const ContactAngle angle(normal_, tool.vector(), meeting.sine / dot(tool.vector().nearest(), meeting.t),
                           meeting.cosine);
  double deviation = 0;
  if (!effective.deviations()->find(angle, deviation)) return alarm::kAngleRange;
  if (effective.deviations()->below(effective.corner_without_deviation(), angle, deviation))
    return alarm::kCornerNegative;
  degrees_ = angle.degrees();
  corner_delta_ = deviation + effective.corner_delta_without_deviation();
  return effective.check_after_angle(permitted);
}

bool FaceMilling::below(double cosine, const ToolVector& tool) const {
  // n.t < −0.0002. The sum is good to 4 ulps of 1.
  constexpr double kLimit = -0.0002;
  constexpr double kSure = 0x1p-48;
  if (cosine > kLimit + kSure) [[likely]]
    return false;
  if (cosine < kLimit - kSure) return true;
  const WideVector3 n = normal_.exact();
  const WideVector3 t = tool.vector().exact();
  const Wide product = dot(n, t);
  return (Wide(25'000'000) * product * product - dot(n, n) * dot(t, t)).sign() > 0;
}

bool FaceMilling::jump(const Meeting& meeting, const ToolVector& tool) const {
  if (!before_.any) return false;
  if (meeting.flat != before_.flat) return true;
  if (meeting.flat) return false;
  const double product = dot(meeting.u, before_.u);
  constexpr double kSure = 0x1p-46;
  if (product > kSure) [[likely]]
    return false;
  if (product < -kSure) return true;
  return dot(across(normal_, tool.vector()), across(before_.normal, before_.tool)).sign() < 0;
}

void FaceMilling::mill(MoveHead& head, const ToolVector& tool, bool along, const ProgrammedPoint& programmed,
                       const EffectiveTool& effective, spec::Cause cause) {
  const Meeting meeting = meet(tool, along);
  const ToolValues& values = effective.values();
  const bool ball = effective.deviations() != nullptr;
  const double ring = ball ? 0 : values.ring;
  const double effective_ring = ball ? 0 : values.effective_ring;
  const double ring_delta = ball ? 0 : values.ring_delta;
  const double corner_delta = ball ? corner_delta_ : values.corner_delta;

  unsigned warnings = head.warnings;
  if (not_normalized(normal_)) [[unlikely]]
    warnings |= kNormalNotNormalized;
  if (below(meeting.cosine, tool)) [[unlikely]]
    warnings |= kNormalBelow;
  if (effective_ring > 0 && jump(meeting, tool) && !fault(Fault::face_jump_unnoticed)) [[unlikely]]
    warnings |= kContactJump;
  head.warnings = static_cast<Warnings>(warnings);
  before_.any = true;
  before_.flat = meeting.flat;
  before_.u = meeting.u;
  before_.normal.copy(normal_);
  before_.tool.copy(tool.vector());

  const Vector lean = meeting.n - meeting.t;
  Placement placement;
  placement.tool = meeting.t;
  placement.corner = ball ? values.corner + corner_delta : values.effective_corner;
  placement.shift = lean * corner_delta + meeting.u * ring_delta;
  if (fault(Fault::face_tip_along_normal)) placement.shift = meeting.n * corner_delta + meeting.u * ring_delta;
  Vector q{};  // from the programmed point
  const double tip_below = programmed.tip_below(values, true);
  if (programmed.contour) [[unlikely]] {
    const double corner = fault(Fault::contour_nominal_corner) ? values.corner : placement.corner;
    placement.tip = lean * corner + meeting.u * effective_ring - meeting.t * tip_below;
  } else {
    placement.tip = placement.shift;
    if (tip_below != 0) {
      q = meeting.t * -tip_below;
      placement.tip = placement.tip + q;
    }
    q = q - (lean * values.corner + meeting.u * ring);
  }
  spec::Contact<double>& contact = writer_.contact();
  const std::array<std::size_t, 3>& xyz = writer_.xyz();
  contact.point = {head.position[xyz[0]] + q.x, head.position[xyz[1]] + q.y, head.position[xyz[2]] + q.z};
  put(contact.normal, meeting.n);
  contact.flat = meeting.flat;
  if (ball) [[unlikely]]
    contact.angle = degrees_;
  else
    contact.angle.reset();
  writer_.move_in_contact(head, placement, values, cause);
}

}  // namespace toolcomp::fast::klartext
