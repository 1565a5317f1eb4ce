// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_side_compensation/side_path.h"

namespace toolcomp::model {
namespace {

SideEnd end_of(const SideArc& arc, const PlanePoint& from_center, int sense) {
  SideEnd end;
  end.arc = SideEnd::OfArc{arc.plane, from_center, sense * arc.ends.turn, arc.ends.radius};
  return end;
}

}  // namespace

SideEnd line_end(const CompensationPlane& plane, const Vector& travel) {
  SideEnd end;
  end.travel = travel;
  end.left = plane.left(travel);
  end.left2 = squared_norm(end.left);
  return end;
}

SideEnd arc_start(const SideArc& arc) { return end_of(arc, arc.ends.start, arc.sense_at_start); }
SideEnd arc_end(const SideArc& arc) { return end_of(arc, arc.ends.end, arc.sense_at_end); }

// Of an arc, along the part in the plane of the radius from the centre, ρ: -turn · offset · u(ρ)/|u(ρ)|, of which
// |VT|² u(ρ) has the length |VT| |VT × ρ|.
Vector perpendicular(const CompensationPlane& plane, const SideEnd& end) {
  if (!end.arc) return (end.offset / sqrt(end.left2)) * end.left;
  const SideEnd::OfArc& arc = *end.arc;
  const Vector from_center = in_space(arc.plane, arc.from_center);
  const Real& norm2 = plane.tool().norm2;
  const Real length = arc.radius && is_square_to(plane, arc.plane)
                          ? norm2 * Real(*arc.radius)
                          : sqrt(norm2 * squared_norm(plane.left(from_center)));
  return (Rational(-arc.turn * end.offset) / length) * plane.along(from_center);
}

Vector direction_of(const SideEnd& end) {
  return end.arc ? in_space(end.arc->plane, end.arc->from_center) : end.travel;
}

PathEnd seen(const CompensationPlane& plane, const PlanePoint& direction, const SideEnd& end) {
  if (!end.arc) {
    PathEnd line;
    line.heading = heading(direction);
    line.offset = end.offset;
    return line;
  }
  const SideEnd::OfArc& arc = *end.arc;
  const auto radius = is_square_to(plane, arc.plane) ? arc.radius : std::nullopt;
  return arc_end(direction, arc.turn, radius, end.offset);
}

OffsetPath as_run(const SideArc& arc, const Rational& offset_at_start, const Rational& offset_at_end) {
  return arc_path(arc.ends, arc.sense_at_start * offset_at_start, arc.sense_at_end * offset_at_end);
}

bool is_square_to(const CompensationPlane& tool, spec::Plane plane) {
  return is_zero(in_plane_of(plane, tool.tool().vector));
}

}  // namespace toolcomp::model
