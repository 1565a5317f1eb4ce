// SPDX-License-Identifier: Apache-2.0
// The programmed path of one block in space, and what a corner sees of it.
#pragma once

#include <optional>

#include "model/fanuc/corner/corner.h"
#include "model/fanuc/tool_side_compensation/compensation_plane.h"
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

// A circle or helix in the plane of G17, G18 or G19, setup units.
struct SideArc {
  spec::Plane plane = spec::Plane::xy;
  ArcEnds ends;  // `turn` as seen against the third axis of the plane
  // Whether the tool sees the plane against that axis (+1) or from the other side (-1), at the start and at the end.
  int sense_at_start = 1;
  int sense_at_end = 1;
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
    int turn = 1;                    // as seen from the tool
    std::optional<Rational> radius;  // where R gives it
  };

  Rational offset;  // signed distance of the tool to the left of the path
  // Of a line: its travel U, W = VT × U, and |W|², which is not 0.
  Vector travel;
  Vector left;
  Real left2;
  std::optional<OfArc> arc;
};

// Without its offset.
SideEnd line_end(const CompensationPlane& plane, const Vector& travel);
SideEnd arc_start(const SideArc& arc);
SideEnd arc_end(const SideArc& arc);

// r n: at right angles to the path, of the length of the offset. Without a frame.
Vector perpendicular(const CompensationPlane& plane, const SideEnd& end);

// What tells the direction of an end: the travel of a line, the radius of an arc from its centre.
Vector direction_of(const SideEnd& end);

// The end in the coordinates of a frame of the plane, as corners with arcs ask for it; `direction`: that of
// direction_of(end) there. Clause: fanuc.tool-side.arc-in-the-plane.
PathEnd seen(const CompensationPlane& plane, const PlanePoint& direction, const SideEnd& end);

// The arc in its own plane, as the machine runs it; the offsets are to the left as the tool sees them.
OffsetPath as_run(const SideArc& arc, const Rational& offset_at_start, const Rational& offset_at_end);

// Whether the tool stands at right angles to the plane. Certified.
bool is_square_to(const CompensationPlane& tool, spec::Plane plane);

}  // namespace toolcomp::model
