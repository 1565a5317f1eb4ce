#include "model/fanuc/cutter_compensation_c/block_path.h"

namespace toolcomp::model {

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
