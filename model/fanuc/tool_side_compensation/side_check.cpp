// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_side_compensation/side_check.h"

#include "spec/language/input_error.h"

namespace toolcomp::model {
namespace {

// A head in the plane of the arc. It lies on the offset circle there only if the tool stands upright on that plane.
CornerVector head(const SideArc& arc, const CompensationPlane& plane, const SpaceVector& v) {
  const PlanePoint there = in_plane_of(arc.plane, v.vector);
  return plane.is_parallel_to(arc.plane) ? CornerVector{there, v.former, v.latter} : CornerVector{there};
}

// Square to an arc that starts and ends in one place, or opposite with respect to its centre, the vectors do so too.
HeadPair pair_of(const SidePlan& block, const CompensationPlane& before, const SpaceVector& from,
                 const SpaceVector& to) {
  const bool alike = from.latter == Seat::square && to.former == Seat::square &&
                     block.offset_before == block.end->offset && before.is_same_as(block.plane);
  if (!alike) return HeadPair::any;
  const auto stays = [](const PlanePoint& v) { return known_zero(v[0]) && known_zero(v[1]); };
  const ArcEnds& ends = block.arc->ends;
  if (stays(ends.end - ends.start)) return HeadPair::same;
  return stays(ends.end + ends.start) ? HeadPair::opposite : HeadPair::any;
}

}  // namespace

PlaneChangeCheck::PlaneChangeCheck(const spec::Setup& setup, Recorder& recorder)
    : recorder_(recorder), checks_(!setup.bit(19605, 5)) {
  Rational degrees = parameter(setup, 6261);
  if (degrees < 0 || degrees > 180)
    throw spec::InputError("setup", 0, 0, "parameters.6261: expected an angle from 0 to 180");
  if (degrees == 0) degrees = 45;
  cosine_ = exact::cos_degrees(degrees);
  cosine2_ = (1 + exact::cos_degrees(Rational(2 * degrees))) / 2;
}

// cos(limit) |Va||Vb| - Va · Vb. Where both terms have one sign their squares tell it, without a root.
bool PlaneChangeCheck::turns_far(const Direction& former, const Direction& latter) const {
  const Real product = dot(former.vector, latter.vector);
  const Real norms2 = former.norm2 * latter.norm2;
  const bool one_sign = cosine_.sign() != Sign::zero && cosine_.sign() == product.sign();
  const bool equal = one_sign && (cosine2_ * norms2 - square(product)).sign() == Sign::zero;
  const Real scale = sqrt(norms2);
  const Real quantity = equal ? Real(0) : cosine_ * scale - product;
  // fanuc.tool-side.plane-change-angle: The first condition of the plane change check is that Va, the tool direction at
  // the end of A, and Vb, the tool direction at the end of B, differ by the limit angle or more.
  return recorder_.decide(Clause::fanuc_tool_side_plane_change_angle, quantity, scale) != Sign::negative;
}

bool PlaneChangeCheck::interferes(const SidePlan& former, const SidePlan& latter) const {
  // fanuc.tool-side.plane-change-check: 19605 bit 5, NIC, switches the interference check where the compensation plane
  // changes: 0 checks, 1 does not.
  if (!recorder_.decide(Clause::fanuc_tool_side_plane_change_check, checks_)) return false;
  const Direction& va = former.plane.tool;
  const Direction& vb = latter.plane.tool;
  if (!turns_far(va, vb)) return false;
  const Vector& ua = former.travel;
  const Vector& ub = latter.travel;
  const Vector wa = cross(va.vector, ua);
  const Real travels = sqrt(squared_norm(ua) * squared_norm(ub));
  // fanuc.tool-side.plane-change-side: The second condition of the plane change check, asked if the first holds, is
  // that the directions Wa = Va x Ua and Wb = Vb x Ub do not point against each other. Ua and Ub are the displacements
  // of A and B from start to end, also of arcs.
  const Sign side = recorder_.decide(Clause::fanuc_tool_side_plane_change_side, dot(wa, cross(vb.vector, ub)),
                                     sqrt(va.norm2 * vb.norm2) * travels);
  if (side == Sign::negative) return false;
  const Real along = dot(wa, cross(va.vector, ub));
  // fanuc.tool-side.plane-change-reversal: The third condition of the plane change check, asked if the first two hold,
  // is that Ra and Rb point against each other. Ra and Rb are the projections of Ua and Ub onto the plane perpendicular
  // to Va.
  return recorder_.decide(Clause::fanuc_tool_side_plane_change_reversal, -along, va.norm2 * travels) == Sign::positive;
}

std::optional<ToolArcRun> arc_run(Recorder& recorder, const SidePlan& block, const CompensationPlane& before,
                                  const SpaceVector& from, const SpaceVector& to) {
  if (!block.arc) return std::nullopt;
  const SideArc& arc = *block.arc;
  const Rational at_start = arc.sense_at_start * block.offset_before;
  const Rational at_end = arc.sense_at_end * block.end->offset;
  return std::optional<ToolArcRun>(std::in_place, recorder, arc_path(arc.ends, at_start, at_end),
                                   head(arc, before, from), head(arc, block.plane, to),
                                   pair_of(block, before, from, to));
}

CheckedPath between_vectors(const SidePlan& block, const CompensationPlane& before) {
  CheckedPath path;
  if (block.arc) {
    const SideArc& arc = *block.arc;
    const CompensationPlane& plane = block.at_corner ? before : block.plane;
    SideEnd start = arc_end(plane, arc, arc.ends.start, arc.sense_at_start);
    start.offset = block.at_corner ? block.offset_before : block.end->offset;
    path.start = seen(plane.frame(), start);
    path.end = seen(block.plane.frame(), *block.end);
  }
  // |VT|² u(Q - P) · ((Q + W) - (P + V)), in the plane at the end of the block.
  path.along = [&block](const Vector& from, const Vector& to) -> WayAlong {
    const Vector& travel = block.travel;
    const Vector seen = block.plane.along(travel);
    const Real length = sqrt(squared_norm(travel));
    return {dot(seen, travel + (to - from)),
            block.plane.tool.norm2 * length * (length + sqrt(squared_norm(from)) + sqrt(squared_norm(to))),
            squared_norm(seen)};
  };
  return path;
}

}  // namespace toolcomp::model
