// The programmed path of one block in space, and what a corner sees of it.
#pragma once

#include <optional>

#include "model/geometry/offset_path.h"
#include "model/tool_side_compensation/compensation_plane.h"
#include "spec/language/event.h"

namespace toolcomp::model {

// The third axis of a plane: 0, 1, 2 for X, Y, Z.
constexpr std::size_t third_axis(spec::Plane plane) {
  switch (plane) {
    case spec::Plane::zx:
      return 1;
    case spec::Plane::yz:
      return 0;
    case spec::Plane::xy:
      break;
  }
  return 2;
}

// A circle or helix in the plane of G17, G18 or G19, setup units; `turn` as seen against its third axis.
struct SideArc {
  spec::Plane plane = spec::Plane::xy;
  ArcEnds ends;
};

// A line, or an arc.
struct SidePath {
  Vector travel;  // from start to end
  std::optional<SideArc> arc;
};

// A line or an arc as the corner at one of its ends sees it, in the compensation plane there.
struct SideEnd {
  // An end of an arc. The centre is taken at the height of that end.
  struct OfArc {
    spec::Plane plane = spec::Plane::xy;
    PlanePoint from_center;
    int turn = 1;                    // as seen against the third axis
    std::optional<Rational> radius;  // where R gives it
  };

  Rational offset;  // signed distance of the tool to the left of the path
  // Of a line: its travel U, W = VT × U, and |W|², which is not 0.
  Vector travel;
  Vector left;
  Real left2;
  std::optional<OfArc> arc;
};

SideEnd line_end(const CompensationPlane& plane, const Vector& travel, const Rational& offset);
SideEnd arc_start(const SideArc& arc, const Rational& offset);
SideEnd arc_end(const SideArc& arc, const Rational& offset);

// The end in the coordinates of a frame of the plane, as corners with arcs ask for it. The tool does not lie in the
// plane of an arc. Clause: fanuc.tool-side.arc-in-the-plane.
PathEnd seen(const CompensationPlane& plane, const PlaneFrame& frame, const SideEnd& end);

// The arc in its own plane, as the machine runs it, with the offsets of its ends as the tool sees them in the planes
// of its start and its end.
OffsetPath as_run(const SideArc& arc, const CompensationPlane& at_start, const Rational& offset_at_start,
                  const CompensationPlane& at_end, const Rational& offset_at_end);

// Whether the tool stands at right angles to the plane. Certified.
bool is_square_to(const CompensationPlane& tool, spec::Plane plane);

}  // namespace toolcomp::model
