// SPDX-License-Identifier: Apache-2.0
// Face milling: LN blocks with a surface normal (heidenhain.face.*).
#pragma once

#include <cmath>

#include "fast/heidenhain/face_milling/face_line_arrays.h"
#include "fast/heidenhain/program/effective_tool.h"
#include "fast/heidenhain/program/event_writer.h"
#include "fast/heidenhain/program/tool_vector.h"
#include "fast/heidenhain/programmed_contour/programmed_contour.h"

namespace toolcomp::fast::klartext {

// N x T is made of whole numbers, exactly: nothing is lost where N is nearly along T.
class FaceMilling {
 public:
  explicit FaceMilling(EventWriter& writer) : writer_(writer) {}

  // The surface normal of the block to come.
  void take_normal(const std::array<spec::Decimal, 3>& components) {
    latest_ ^= 1U;
    normal_[latest_].set(components);
    unit_normal_ = unit_of(normal());
  }
  [[nodiscard]] const WholeVector& normal() const { return normal_[latest_]; }
  [[nodiscard]] const Vector& unit_normal() const { return unit_normal_.unit; }
  // Normal and tool, unit; u = t x (n x t)/|n x t|, and 0 where w = 0 or the tool has no ring.
  struct Meeting {
    Vector n, t, u;
    bool flat;      // w = 0
    double cosine;  // n.t
    double square;  // where w is not 0: (N x T)², in the units of the vectors
  };
  // `along`: the tool stands along the normal.
  [[gnu::always_inline]] [[nodiscard]] Meeting meet(const ToolVector& tool, bool along,
                                                    const EffectiveTool& effective) const;
  // The first alarm of heidenhain.tool.order-of-checks; with a table of deviations it is looked up.
  [[nodiscard]] Alarm check(const Meeting& meeting, const ToolVector& tool, const EffectiveTool& effective,
                            bool permitted) {
    if (effective.deviations() == nullptr) [[likely]]
      return effective.check(true, permitted);
    return deviate(meeting, tool, effective, permitted);
  }
  // The block checked: its warnings, which are added to those of the head, and its move.
  [[gnu::always_inline]] void mill(MoveHead& head, const Meeting& meeting, const ToolVector& tool,
                                   const ProgrammedPoint& programmed, const EffectiveTool& effective,
                                   spec::Cause cause);
  // Blocks as arrays (face_line_arrays.h): the contact before them, if there is one, and the last of them.
  [[nodiscard]] bool sees_contact() const { return before_.any; }
  void set_start(FaceLineStart& start) const {
    start.flat = before_.flat;
    start.u = before_.u;
  }
  void set_end(const FaceLineEnd& end, const std::array<std::int64_t, 3>& whole_normal) {
    latest_ ^= 1U;
    normal_[latest_].narrow = true;
    normal_[latest_].small = whole_normal;
    unit_normal_ = unit_of(normal());
    before_.flat = end.flat;
    before_.u = end.u;
  }
  void set_end_tool(const ToolVector& tool) { before_.tool = &tool; }
  // Any other motion and TOOL CALL: no contact is before the next.
  void forget() { before_.any = false; }
  // The tool of the block before is about to change.
  void keep_tool() {
    if (!before_.any) return;
    kept_.copy(*before_.tool);
    before_.tool = &kept_;
  }

 private:
  void meet_wide(const ToolVector& tool, Meeting& meeting) const;
  [[nodiscard]] double whole_dot(const ToolVector& tool) const;
  [[nodiscard]] Alarm deviate(const Meeting& meeting, const ToolVector& tool, const EffectiveTool& effective,
                              bool permitted);
  [[nodiscard]] bool below(double cosine, const ToolVector& tool) const;
  [[nodiscard]] bool exactly_below(const ToolVector& tool) const;
  // w.w_before < 0 where both contacts are on the ring.
  [[nodiscard]] bool jump(const Meeting& meeting, const ToolVector& tool) const;
  [[nodiscard]] bool exactly_opposed(const ToolVector& tool) const;

  EventWriter& writer_;
  // Of the latest block and the one before.
  std::array<WholeVector, 2> normal_;
  unsigned latest_ = 0;
  UnitVector unit_normal_;
  // With a table of deviations, of the block checked.
  ToolValues ball_;
  double degrees_ = 0;
  DeviationTable::Deviation deviation_;

  // The contact of the block before.
  struct Before {
    bool any = false;
    bool flat = false;
    Vector u;
    const ToolVector* tool = nullptr;
  };
  Before before_;
  ToolVector kept_;
};

inline FaceMilling::Meeting FaceMilling::meet(const ToolVector& tool, bool along,
                                              const EffectiveTool& effective) const {
  Meeting meeting;
  meeting.flat = true;
  meeting.cosine = 1;
  meeting.n = unit_normal_.unit;
  meeting.t = tool.unit();
  meeting.u = zero_vector();
  if (along) return meeting;
  meeting.cosine = dot(meeting.n, meeting.t);
  const WholeVector& n = normal();
  const WholeVector& t = tool.vector();
  if (!n.narrow || !t.narrow) [[unlikely]] {
    meet_wide(tool, meeting);
    return meeting;
  }
  // Components are below 2^30.
  const std::int64_t x = n.small[1] * t.small[2] - n.small[2] * t.small[1];
  const std::int64_t y = n.small[2] * t.small[0] - n.small[0] * t.small[2];
  const std::int64_t z = n.small[0] * t.small[1] - n.small[1] * t.small[0];
  meeting.flat = (x | y | z) == 0;
  if (meeting.flat) [[unlikely]]
    return meeting;
  const Vector c{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  meeting.square = dot(c, c);
  // Root and quotient side by side.
  if (effective.values().has_ring) meeting.u = cross(meeting.t, c) * (std::sqrt(meeting.square) * (1 / meeting.square));
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

inline void FaceMilling::mill(MoveHead& head, const Meeting& meeting, const ToolVector& tool,
                              const ProgrammedPoint& programmed, const EffectiveTool& effective, spec::Cause cause) {
  const bool ball = effective.deviations() != nullptr;
  const ToolValues& values = ball ? ball_ : effective.values();

  unsigned warnings = head.warnings;
  if (!unit_normal_.normalized) [[unlikely]]
    warnings |= kNormalNotNormalized;
  if (below(meeting.cosine, tool)) [[unlikely]]
    warnings |= kNormalBelow;
  if (values.effective_ring > 0 && jump(meeting, tool)) [[unlikely]]
    warnings |= kContactJump;
  head.warnings = static_cast<Warnings>(warnings);
  before_.any = true;
  before_.flat = meeting.flat;
  before_.u = meeting.u;
  before_.tool = &tool;

  const Vector lean = meeting.n - meeting.t;
  Placement placement;
  placement.tool = meeting.t;
  placement.corner = values.effective_corner;
  placement.shift = lean * values.corner_delta + meeting.u * values.ring_delta;
  Vector q = zero_vector();  // from the programmed point
  const double tip_below = programmed.tip_below(values, true);
  if (programmed.contour) [[unlikely]] {
    const double corner = placement.corner;
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
  put(contact.point, head.xyz + q);
  put(contact.normal, meeting.n);
  contact.flat = meeting.flat;
  if (ball) [[unlikely]]
    contact.angle = degrees_;
  else
    contact.angle.reset();
  writer_.move_in_contact(head, placement, values, cause);
}

}  // namespace toolcomp::fast::klartext
