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

Alarm FaceMilling::meet(const ToolVector& tool, bool along, const EffectiveTool& effective, bool permitted) {
  t_ = tool.unit();
  if (along) {
    n_ = t_;
    flat_ = true;
  } else {
    const Vector normal = normal_.nearest();
    const double scale = 1 / std::sqrt(dot(normal, normal));
    n_ = {normal.x * scale, normal.y * scale, normal.z * scale};
    const WholeVector& t = tool.vector();
    if (normal_.narrow && t.narrow) [[likely]] {
      // Components are below 2^30.
      const std::int64_t x = normal_.small[1] * t.small[2] - normal_.small[2] * t.small[1];
      const std::int64_t y = normal_.small[2] * t.small[0] - normal_.small[0] * t.small[2];
      const std::int64_t z = normal_.small[0] * t.small[1] - normal_.small[1] * t.small[0];
      flat_ = (x | y | z) == 0;
      if (!flat_) [[likely]] {
        const Vector c{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
        u_ = cross(t_, c);
        const double length = std::sqrt(dot(c, c));
        const double reciprocal = 1 / length;
        sine_ = length * scale;
        u_ = {u_.x * reciprocal, u_.y * reciprocal, u_.z * reciprocal};
      }
    } else {
      cross_exactly(tool);
    }
  }
  if (flat_) {
    u_ = {};
    sine_ = 0;
  }
  cosine_ = dot(n_, t_);
  if (effective.deviations() != nullptr) [[unlikely]]
    return deviate(tool, effective, permitted);
  corner_delta_ = effective.values().corner_delta;
  return effective.check(true, permitted);
}

void FaceMilling::cross_exactly(const ToolVector& tool) {
  const WideVector3 exact = cross(normal_.exact(), tool.vector().exact());
  flat_ = exact.x.sign() == 0 && exact.y.sign() == 0 && exact.z.sign() == 0;
  if (flat_) return;
  const Vector c{exact.x.to_double(), exact.y.to_double(), exact.z.to_double()};
  u_ = cross(t_, unit_of(c));
  // From the units of exact() to those of both vectors.
  const Vector normal = normal_.nearest();
  const double unit = (normal_.narrow ? 1e-10 : 1.0) * (tool.vector().narrow ? 1e-10 : 1.0);
  sine_ = unit * std::sqrt(dot(c, c)) / std::sqrt(dot(normal, normal));
}

Alarm FaceMilling::deviate(const ToolVector& tool, const EffectiveTool& effective, bool permitted) {
  if (const Alarm a = effective.check_before_angle()) return a;
  // sine_ still lacks |T|.
  const ContactAngle angle(normal_, tool.vector(), sine_ / dot(tool.vector().nearest(), t_), cosine_);
  double deviation = 0;
  if (!effective.deviations()->find(angle, deviation)) return alarm::kAngleRange;
  if (effective.deviations()->below(effective.corner_without_deviation(), angle, deviation))
    return alarm::kCornerNegative;
  degrees_ = angle.degrees();
  corner_delta_ = deviation + effective.corner_delta_without_deviation();
  return effective.check_after_angle(permitted);
}

bool FaceMilling::below(const ToolVector& tool) const {
  // n.t < −0.0002. The sum is good to 4 ulps of 1.
  constexpr double kLimit = -0.0002;
  constexpr double kSure = 0x1p-48;
  if (cosine_ > kLimit + kSure) [[likely]]
    return false;
  if (cosine_ < kLimit - kSure) return true;
  const WideVector3 n = normal_.exact();
  const WideVector3 t = tool.vector().exact();
  const Wide product = dot(n, t);
  return (Wide(25'000'000) * product * product - dot(n, n) * dot(t, t)).sign() > 0;
}

bool FaceMilling::jump(const ToolVector& tool) const {
  if (!before_.any) return false;
  if (flat_ != before_.flat) return true;
  if (flat_) return false;
  const double product = dot(u_, before_.u);
  constexpr double kSure = 0x1p-46;
  if (product > kSure) [[likely]]
    return false;
  if (product < -kSure) return true;
  return dot(across(normal_, tool.vector()), across(before_.normal, before_.tool)).sign() < 0;
}

Warnings FaceMilling::warnings(const ToolVector& tool, const EffectiveTool& effective) {
  unsigned found = 0;
  if (not_normalized(normal_)) found |= kNormalNotNormalized;
  if (below(tool)) found |= kNormalBelow;
  const bool has_flat = effective.deviations() == nullptr && effective.values().effective_ring > 0;
  if (has_flat && jump(tool) && !fault(Fault::face_jump_unnoticed)) found |= kContactJump;
  before_.any = true;
  before_.flat = flat_;
  before_.u = u_;
  before_.normal.copy(normal_);
  before_.tool.copy(tool.vector());
  return static_cast<Warnings>(found);
}

void FaceMilling::send(const MoveHead& head, const ProgrammedPoint& programmed, const EffectiveTool& effective,
                       spec::Cause cause) {
  const ToolValues& values = effective.values();
  const bool ball = effective.deviations() != nullptr;
  const double ring = ball ? 0 : values.ring;
  const double effective_ring = ball ? 0 : values.effective_ring;
  const double ring_delta = ball ? 0 : values.ring_delta;
  const Vector lean = n_ - t_;

  Placement placement;
  placement.tool = t_;
  placement.corner = ball ? values.corner + corner_delta_ : values.effective_corner;
  placement.shift = lean * corner_delta_ + u_ * ring_delta;
  if (fault(Fault::face_tip_along_normal)) placement.shift = n_ * corner_delta_ + u_ * ring_delta;
  spec::Contact<double>& contact = writer_.contact();
  Vector q{};  // from the programmed point
  if (programmed.contour) {
    const double corner = fault(Fault::contour_nominal_corner) ? values.corner : placement.corner;
    placement.tip = lean * corner + u_ * effective_ring;
    if (programmed.tip_below(values, true) != 0) [[unlikely]]
      placement.tip = placement.tip - t_ * programmed.tip_below(values, true);
  } else {
    const double below = programmed.tip_below(values, true);
    placement.tip = placement.shift - t_ * below;
    q = t_ * -below - lean * values.corner - u_ * ring;
  }
  const std::array<std::size_t, 3>& xyz = writer_.xyz();
  contact.point = {head.position[xyz[0]] + q.x, head.position[xyz[1]] + q.y, head.position[xyz[2]] + q.z};
  contact.normal = {n_.x + 0.0, n_.y + 0.0, n_.z + 0.0};
  contact.flat = flat_;
  if (ball)
    contact.angle = degrees_;
  else
    contact.angle.reset();
  writer_.move_in_contact(head, placement, values, cause);
}

}  // namespace toolcomp::fast::klartext
