// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_side_compensation/held_side_path.h"

#include "model/fanuc/corner/interference.h"

namespace toolcomp::model {
namespace {

// A head in the plane of the arc. It lies on the offset circle there only if the tool stands upright on that plane.
CornerVector head(const SideArc& arc, const CompensationPlane& plane, const SpaceVector& vector) {
  CornerVector result;
  result.vector = in_plane_of(arc.plane, vector.vector);
  if (is_square_to(plane, arc.plane)) {
    result.former = vector.former;
    result.latter = vector.latter;
  }
  return result;
}

}  // namespace

std::optional<ToolArcRun> HeldSidePath::arc_run(Recorder& recorder, const SpaceVector& from,
                                                const SpaceVector& to) const {
  if (!path.arc) return std::nullopt;
  return std::optional<ToolArcRun>(std::in_place, recorder, as_run(*path.arc, offset_at_start, end.offset),
                                   head(*path.arc, plane_at_start, from), head(*path.arc, plane, to),
                                   pair_of(from, to));
}

// Square to an arc that starts and ends in one place, or opposite with respect to its centre, the vectors do so too.
HeadPair HeldSidePath::pair_of(const SpaceVector& from, const SpaceVector& to) const {
  const bool alike = from.latter == Seat::square && to.former == Seat::square && offset_at_start == end.offset &&
                     plane_at_start.is_same_as(plane);
  if (!alike) return HeadPair::any;
  const auto stays = [](const PlanePoint& v) { return known_zero(v[0]) && known_zero(v[1]); };
  const ArcEnds& ends = path.arc->ends;
  if (stays(ends.end - ends.start)) return HeadPair::same;
  return stays(ends.end + ends.start) ? HeadPair::opposite : HeadPair::any;
}

bool HeldSidePath::arc_interferes(Recorder& recorder, ToolArcRun& run) const {
  return model::arc_interferes(recorder, start, seen(plane, plane.frame(), end), run);
}

// |VT|² u(Q - P) · ((Q + W) - (P + V)), in the plane at the end of the block.
bool HeldSidePath::line_interferes(Recorder& recorder, const Vector& from, const Vector& to) const {
  const Vector& travel = path.travel;
  const Real along = dot(plane.along(travel), travel + (to - from));
  const Real length = sqrt(squared_norm(travel));
  const Real scale = plane.tool().norm2 * length * (length + sqrt(squared_norm(from)) + sqrt(squared_norm(to)));
  // fanuc.cutter-c.interference-direction: A straight block interferes if the tool's direction differs from the
  // programmed one by more than 90 degrees. Exactly 90 degrees, and a tool that does not move, are no interference
  // (ours).
  return recorder.decide(Clause::fanuc_cutter_c_interference_direction, along, scale) == Sign::negative;
}

Real HeldSidePath::backwards(const Vector& from, const Vector& to) const {
  const Vector along = plane.along(path.travel);
  return -dot(along, path.travel + (to - from)) / sqrt(squared_norm(along));
}

Real HeldSidePath::excess() const { return model::excess(start, seen(plane, plane.frame(), end)); }

}  // namespace toolcomp::model
