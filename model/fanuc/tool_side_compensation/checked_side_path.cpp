// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_side_compensation/checked_side_path.h"

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

// Square to an arc that starts and ends in one place, or opposite with respect to its centre, the vectors do so too.
HeadPair pair_of(const SideBlock& block, const SpaceVector& from, const SpaceVector& to) {
  const bool alike = from.latter == Seat::square && to.former == Seat::square &&
                     block.start.offset == block.end.offset && block.start.plane.is_same_as(block.plane);
  if (!alike) return HeadPair::any;
  const auto stays = [](const PlanePoint& v) { return known_zero(v[0]) && known_zero(v[1]); };
  const ArcEnds& ends = block.path.arc->ends;
  if (stays(ends.end - ends.start)) return HeadPair::same;
  return stays(ends.end + ends.start) ? HeadPair::opposite : HeadPair::any;
}

// |VT|² u(Q - P) · ((Q + W) - (P + V)), in the plane at the end of the block.
bool line_interferes(Recorder& recorder, const SideBlock& block, const Vector& from, const Vector& to) {
  const Vector& travel = block.path.travel;
  const Real along = dot(block.plane.along(travel), travel + (to - from));
  const Real length = sqrt(squared_norm(travel));
  const Real scale = block.plane.tool().norm2 * length * (length + sqrt(squared_norm(from)) + sqrt(squared_norm(to)));
  // fanuc.cutter-c.interference-direction: A straight block interferes if the tool's direction differs from the
  // programmed one by more than 90 degrees. Exactly 90 degrees, and a tool that does not move, are no interference
  // (ours).
  return recorder.decide(Clause::fanuc_cutter_c_interference_direction, along, scale) == Sign::negative;
}

PathEnd end_in_plane(const SideBlock& block) { return seen(block.plane, block.plane.frame(), block.end); }

}  // namespace

std::optional<ToolArcRun> arc_run(Recorder& recorder, const SideBlock& block, const SpaceVector& from,
                                  const SpaceVector& to) {
  if (!block.path.arc) return std::nullopt;
  const SideArc& arc = *block.path.arc;
  return std::optional<ToolArcRun>(std::in_place, recorder, as_run(arc, block.start.offset, block.end.offset),
                                   head(arc, block.start.plane, from), head(arc, block.plane, to),
                                   pair_of(block, from, to));
}

CheckedPath between_vectors(Recorder& recorder, const SideBlock& block) {
  return {
      .arc_interferes =
          [&](ToolArcRun& run) { return arc_interferes(recorder, block.start.end, end_in_plane(block), run); },
      .line_interferes = [&](const Vector& from,
                             const Vector& to) { return line_interferes(recorder, block, from, to); },
      .backwards =
          [&block](const Vector& from, const Vector& to) {
            const Vector along = block.plane.along(block.path.travel);
            return -dot(along, block.path.travel + (to - from)) / sqrt(squared_norm(along));
          },
      .excess = [&block] { return excess(block.start.end, end_in_plane(block)); },
  };
}

}  // namespace toolcomp::model
