// SPDX-License-Identifier: Apache-2.0
// The plane in which the tool side is compensated at one corner, the programmed path of one block in space, and what a
// corner sees of it in its plane.
//
// What lines decide is told by products with the tool direction VT of any length: no root, no frame. Only corners with
// arcs and coordinates use lengths.
#pragma once

#include <optional>

#include "model/fanuc/corner/corner.h"
#include "model/kinematics/tool_direction.h"
#include "spec/language/event.h"

namespace toolcomp::model {

// An orthonormal frame of the plane, right-handed as seen from the tool: (first, second, VT).
struct PlaneFrame {
  Vector first;
  Vector second;
};

// The compensation plane at one corner: at right angles to the tool there.
struct CompensationPlane {
  Direction tool;  // from tip to holder; seen from it left is left

  // Known to be the same plane, without a proof.
  [[nodiscard]] bool is_same_as(const CompensationPlane& other) const {
    return known_zero(tool.vector - other.tool.vector);
  }
  // Whether it is parallel to the plane of G17, G18 or G19: the tool stands upright there. Certified.
  [[nodiscard]] bool is_parallel_to(spec::Plane plane) const { return is_zero(in_plane_of(plane, tool.vector)); }
  // VT × u: to the left of u, |VT| times as long as the part of u in the plane.
  [[nodiscard]] Vector left(const Vector& u) const { return cross(tool.vector, u); }
  // |VT|² times the part of u in the plane.
  [[nodiscard]] Vector along(const Vector& u) const { return tool.norm2 * u - dot(u, tool.vector) * tool.vector; }

  // By Gram and Schmidt: the first vector is the part in the plane of a coordinate axis, the first one at right angles
  // to the tool if there is such an axis.
  [[nodiscard]] PlaneFrame frame() const;
  // The same with the part in the plane of `v`, which is not along the tool.
  [[nodiscard]] PlaneFrame frame_along(const Vector& v) const;
};

// A circle or helix in the plane of G17, G18 or G19, setup units.
struct SideArc {
  spec::Plane plane = spec::Plane::xy;
  ArcEnds ends;  // `turn` as seen against the third axis of the plane
  // Whether the tool sees the plane against that axis (+1) or from the other side (-1), at the start and at the end.
  int sense_at_start = 1;
  int sense_at_end = 1;
};

// A line or an arc as the corner at one of its ends sees it, in the compensation plane there: its tangent, of an arc
// without `ahead`. Of a line with the travel U, `left` is W = VT × U, which is not 0.
struct SideEnd : Tangent<Vector> {
  Vector direction;  // U; of an arc ρ, the radius from its centre, which is taken at the same height
  int turn = 0;      // 0 a line, 1 an arc counter-clockwise, -1 clockwise, as seen from the tool
  std::optional<Rational> radius =
      std::nullopt;  // of an arc, where R gives it and the tool stands upright on its plane

  [[nodiscard]] bool is_arc() const { return turn != 0; }
};

// Without its offset. The line is not along the tool.
SideEnd line_end(const CompensationPlane& plane, const Vector& travel);
// The same of the end of an arc that is seen there from its centre, with the sense there.
SideEnd arc_end(const CompensationPlane& plane, const SideArc& arc, const PlanePoint& from_center, int sense);

// The end in the coordinates of a frame of the plane, as corners with arcs ask for it; `direction`: that of the end
// there. Clause: fanuc.tool-side.arc-in-the-plane.
PathEnd seen(const PlanePoint& direction, const SideEnd& end);
PathEnd seen(const PlaneFrame& frame, const SideEnd& end);

}  // namespace toolcomp::model
