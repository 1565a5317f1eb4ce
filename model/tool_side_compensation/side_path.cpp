#include "model/tool_side_compensation/side_path.h"

namespace toolcomp::model {
namespace {

SideEnd end_of(const SideArc& arc, const PlanePoint& from_center, const Rational& offset) {
  SideEnd end;
  end.offset = offset;
  end.arc = SideEnd::OfArc{arc.plane, from_center, arc.ends.turn, arc.ends.radius};
  return end;
}

// +1 where the tool sees the plane against its third axis, -1 from the other side.
int sense(const CompensationPlane& tool, spec::Plane plane) {
  return static_cast<int>(component(tool.tool().vector, third_axis(plane)).sign());
}

}  // namespace

SideEnd line_end(const CompensationPlane& plane, const Vector& travel, const Rational& offset) {
  SideEnd end;
  end.offset = offset;
  end.travel = travel;
  end.left = plane.left(travel);
  end.left2 = squared_norm(end.left);
  return end;
}

SideEnd arc_start(const SideArc& arc, const Rational& offset) { return end_of(arc, arc.ends.start, offset); }
SideEnd arc_end(const SideArc& arc, const Rational& offset) { return end_of(arc, arc.ends.end, offset); }

PathEnd seen(const CompensationPlane& plane, const PlaneFrame& frame, const SideEnd& end) {
  if (!end.arc) {
    PathEnd line;
    line.heading = heading(project(frame, end.travel));
    line.offset = end.offset;
    return line;
  }
  const SideEnd::OfArc& arc = *end.arc;
  const PlanePoint from_center = project(frame, in_space(arc.plane, arc.from_center));
  const auto radius = is_square_to(plane, arc.plane) ? arc.radius : std::nullopt;
  return arc_end(from_center, sense(plane, arc.plane) * arc.turn, radius, end.offset);
}

OffsetPath as_run(const SideArc& arc, const CompensationPlane& at_start, const Rational& offset_at_start,
                  const CompensationPlane& at_end, const Rational& offset_at_end) {
  return arc_path(arc.ends, sense(at_start, arc.plane) * offset_at_start, sense(at_end, arc.plane) * offset_at_end);
}

bool is_square_to(const CompensationPlane& tool, spec::Plane plane) {
  return is_zero(in_plane_of(plane, tool.tool().vector));
}

}  // namespace toolcomp::model
