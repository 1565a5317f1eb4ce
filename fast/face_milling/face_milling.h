// Face milling: LN blocks with a surface normal (heidenhain.face.*, sheet 5.2 to 5.4).
#pragma once

#include <cmath>

#include "fast/fault.h"
#include "fast/klartext/effective_tool.h"
#include "fast/klartext/event_writer.h"
#include "fast/klartext/tool_vector.h"
#include "fast/programmed_contour/programmed_contour.h"

namespace toolcomp::fast::klartext {

// N x T is made of whole numbers, exactly: nothing is lost where N is nearly along T.
class FaceMilling {
 public:
  explicit FaceMilling(EventWriter& writer) : writer_(writer) {}

  // The surface normal of the block to come, to be written.
  [[nodiscard]] WholeVector& normal() { return normal_; }
  // The first alarm of sheet 5.1 or 5.9; with a table of deviations it is looked up. `along`: the tool stands along the
  // normal.
  [[nodiscard]] Alarm check(const ToolVector& tool, bool along, const EffectiveTool& effective, bool permitted) {
    if (effective.deviations() == nullptr) [[likely]]
      return effective.check(true, permitted);
    return deviate(tool, along, effective, permitted);
  }
  // The block checked: its warnings, which are added to those of the head, and its move.
  [[gnu::always_inline]] void mill(MoveHead& head, const ToolVector& tool, bool along,
                                   const ProgrammedPoint& programmed, const EffectiveTool& effective,
                                   spec::Cause cause);
  // Any other motion and TOOL CALL: no contact is before the next.
  void forget() { before_.any = false; }

 private:
  // Normal and tool, unit; u = t x (n x t)/|n x t|, and 0 where w = 0.
  struct Meeting {
    Vector n, t, u;
    bool flat;      // w = 0
    double sine;    // |n x T|, T in its own units
    double cosine;  // n.t
  };
  [[gnu::always_inline]] [[nodiscard]] Meeting meet(const ToolVector& tool, bool along) const;
  void meet_wide(const ToolVector& tool, Meeting& meeting) const;
  [[nodiscard]] Alarm deviate(const ToolVector& tool, bool along, const EffectiveTool& effective, bool permitted);
  [[nodiscard]] bool below(double cosine, const ToolVector& tool) const;
  [[nodiscard]] bool exactly_below(const ToolVector& tool) const;
  // w.w_before < 0 where both contacts are on the ring.
  [[nodiscard]] bool jump(const Meeting& meeting, const ToolVector& tool) const;
  [[nodiscard]] bool exactly_opposed(const ToolVector& tool) const;

  EventWriter& writer_;
  WholeVector normal_;
  // With a table of deviations, of the block checked.
  ToolValues ball_;
  double degrees_ = 0;

  // The contact of the block before.
  struct Before {
    bool any = false;
    bool flat = false;
    Vector u;
    WholeVector normal, tool;
  };
  Before before_;
};

inline FaceMilling::Meeting FaceMilling::meet(const ToolVector& tool, bool along) const {
  Meeting meeting;
  meeting.flat = true;
  meeting.sine = 0;
  meeting.cosine = 1;
  meeting.t = tool.unit();
  if (along) {
    meeting.n = meeting.t;
    meeting.u = zero_vector();
    return meeting;
  }
  const Vector normal = normal_.nearest();
  const double scale = 1 / std::sqrt(dot(normal, normal));
  meeting.n = normal * scale;
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
  if ((x | y | z) == 0) [[unlikely]] {
    meeting.u = zero_vector();
    return meeting;
  }
  meeting.flat = false;
  const Vector c{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  const double length = std::sqrt(dot(c, c));
  meeting.u = cross(meeting.t, c) * (1 / length);
  meeting.sine = length * scale;
  return meeting;
}

inline bool FaceMilling::below(double cosine, const ToolVector& tool) const {
  // n.t < −0.0002. The sum is good to 4 ulps of 1.
  constexpr double kLimit = -0.0002;
  constexpr double kSure = 0x1p-48;
  if (cosine > kLimit + kSure) [[likely]]
    return false;
  return cosine < kLimit - kSure || exactly_below(tool);
}

inline bool FaceMilling::jump(const Meeting& meeting, const ToolVector& tool) const {
  if (!before_.any) [[unlikely]]
    return false;
  if (meeting.flat != before_.flat) return true;
  constexpr double kSure = 0x1p-46;
  const double product = dot(meeting.u, before_.u);
  if (product > kSure) [[likely]]
    return false;
  return !meeting.flat && (product < -kSure || exactly_opposed(tool));
}

inline void FaceMilling::mill(MoveHead& head, const ToolVector& tool, bool along, const ProgrammedPoint& programmed,
                              const EffectiveTool& effective, spec::Cause cause) {
  const Meeting meeting = meet(tool, along);
  const bool ball = effective.deviations() != nullptr;
  const ToolValues& values = ball ? ball_ : effective.values();

  unsigned warnings = head.warnings;
  if (not_normalized(normal_)) [[unlikely]]
    warnings |= kNormalNotNormalized;
  if (below(meeting.cosine, tool)) [[unlikely]]
    warnings |= kNormalBelow;
  if (values.effective_ring > 0 && jump(meeting, tool) && !fault(Fault::face_jump_unnoticed)) [[unlikely]]
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
  placement.corner = values.effective_corner;
  placement.shift = lean * values.corner_delta + meeting.u * values.ring_delta;
  if (fault(Fault::face_tip_along_normal))
    placement.shift = meeting.n * values.corner_delta + meeting.u * values.ring_delta;
  Vector q = zero_vector();  // from the programmed point
  const double tip_below = programmed.tip_below(values, true);
  if (programmed.contour) [[unlikely]] {
    const double corner = fault(Fault::contour_nominal_corner) ? values.corner : placement.corner;
    placement.tip = lean * corner + meeting.u * values.effective_ring - meeting.t * tip_below;
  } else {
    placement.tip = placement.shift;
    if (tip_below != 0) {
      q = meeting.t * -tip_below;
      placement.tip = placement.tip + q;
    }
    q = q - (lean * values.corner + meeting.u * values.ring);
  }
  spec::Contact<double>& contact = writer_.contact();
  const std::array<std::size_t, 3>& xyz = writer_.xyz();
  put(contact.point, Vector(head.position[xyz[0]], head.position[xyz[1]], head.position[xyz[2]]) + q);
  put(contact.normal, meeting.n);
  contact.flat = meeting.flat;
  if (ball) [[unlikely]]
    contact.angle = degrees_;
  else
    contact.angle.reset();
  writer_.move_in_contact(head, placement, values, cause);
}

}  // namespace toolcomp::fast::klartext
