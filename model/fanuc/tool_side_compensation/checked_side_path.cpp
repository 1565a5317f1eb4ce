// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_side_compensation/checked_side_path.h"

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

// Square to an arc that starts and ends in one place, or opposite with respect to its centre, the vectors do so too.
HeadPair pair_of(const SidePlan& block, const ArcStart& start, const SpaceVector& from, const SpaceVector& to) {
  const bool alike = from.latter == Seat::square && to.former == Seat::square && start.offset == block.end->offset &&
                     start.plane.is_same_as(block.plane);
  if (!alike) return HeadPair::any;
  const auto stays = [](const PlanePoint& v) { return known_zero(v[0]) && known_zero(v[1]); };
  const ArcEnds& ends = block.path.arc->ends;
  if (stays(ends.end - ends.start)) return HeadPair::same;
  return stays(ends.end + ends.start) ? HeadPair::opposite : HeadPair::any;
}

}  // namespace

std::optional<ToolArcRun> arc_run(Recorder& recorder, const SidePlan& block, const ArcStart& start,
                                  const SpaceVector& from, const SpaceVector& to) {
  if (!block.path.arc) return std::nullopt;
  const SideArc& arc = *block.path.arc;
  return std::optional<ToolArcRun>(std::in_place, recorder, as_run(arc, start.offset, block.end->offset),
                                   head(arc, start.plane, from), head(arc, block.plane, to),
                                   pair_of(block, start, from, to));
}

CheckedPath between_vectors(const SidePlan& block, const ArcStart& start) {
  CheckedPath path;
  if (block.path.arc) {
    path.start = start.end;
    path.end = seen(block.plane, project(block.plane.frame(), direction_of(*block.end)), *block.end);
  }
  // |VT|² u(Q - P) · ((Q + W) - (P + V)), in the plane at the end of the block.
  path.along = [&block](const Vector& from, const Vector& to) -> WayAlong {
    const Vector& travel = block.path.travel;
    const Vector seen = block.plane.along(travel);
    const Real length = sqrt(squared_norm(travel));
    return {dot(seen, travel + (to - from)),
            block.plane.tool().norm2 * length * (length + sqrt(squared_norm(from)) + sqrt(squared_norm(to))),
            squared_norm(seen)};
  };
  return path;
}

}  // namespace toolcomp::model
