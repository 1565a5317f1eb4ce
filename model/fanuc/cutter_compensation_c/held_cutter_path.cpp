// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/cutter_compensation_c/held_cutter_path.h"

#include "model/fanuc/corner/interference.h"

namespace toolcomp::model {

std::optional<ToolArcRun> HeldCutterPath::arc_run(Recorder& recorder, const SpaceVector& from,
                                                  const SpaceVector& to) const {
  if (!path_.is_arc()) return std::nullopt;
  const auto head = [&](const SpaceVector& v) {
    return CornerVector{in_plane_of(plane_, v.vector), v.former, v.latter};
  };
  return std::optional<ToolArcRun>(std::in_place, recorder, path_, head(from), head(to));
}

bool HeldCutterPath::arc_interferes(Recorder& recorder, ToolArcRun& run) const {
  return model::arc_interferes(recorder, path_.start, path_.end, run);
}

bool HeldCutterPath::line_interferes(Recorder& recorder, const Vector& from, const Vector& to) const {
  return model::line_interferes(recorder, path_, in_plane_of(plane_, from), in_plane_of(plane_, to));
}

Real HeldCutterPath::backwards(const Vector& from, const Vector& to) const {
  const PlanePoint way = path_.travel + (in_plane_of(plane_, to) - in_plane_of(plane_, from));
  return -dot(path_.travel, way) / sqrt(squared_norm(path_.travel));
}

OffsetPath path_of(const CutterBlock& block, const CutterOffset& own, const Rational& distance_before) {
  const Rational at_start = own.side * distance_before;
  if (block.motion != PlaneMotion::arc) return line_path(block.end - block.start, at_start, own.left());
  ArcEnds arc;
  arc.start = block.start - block.arc->center;
  arc.end = block.end - block.arc->center;
  arc.turn = block.arc_direction == spec::ArcDirection::ccw ? 1 : -1;
  arc.radius = block.radius;
  arc.one_radius = !block.arc->radius;
  return arc_path(arc, at_start, own.left());
}

}  // namespace toolcomp::model
