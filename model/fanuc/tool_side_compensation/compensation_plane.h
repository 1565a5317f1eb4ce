// SPDX-License-Identifier: Apache-2.0
// The plane in which the tool side is compensated at one corner: at right angles to the tool there.
//
// What lines decide is told by products with the tool direction VT of any length: no root, no frame. Only corners with
// arcs and coordinates use lengths.
#pragma once

#include <utility>

#include "model/geometry/plane_vector.h"
#include "model/geometry/vector.h"
#include "model/kinematics/tool_direction.h"

namespace toolcomp::model {

// An orthonormal frame of the plane, right-handed as seen from the tool: (first, second, VT).
struct PlaneFrame {
  Vector first;
  Vector second;
};

class CompensationPlane {
 public:
  CompensationPlane() = default;
  explicit CompensationPlane(Direction tool) : tool_(std::move(tool)) {}

  // The tool, from tip to holder; seen from it left is left.
  [[nodiscard]] const Direction& tool() const { return tool_; }
  // Known to be the same plane, without a proof.
  [[nodiscard]] bool is_same_as(const CompensationPlane& other) const;
  // VT × u: to the left of u, |VT| times as long as the part of u in the plane.
  [[nodiscard]] Vector left(const Vector& u) const { return cross(tool_.vector, u); }
  // |VT|² times the part of u in the plane.
  [[nodiscard]] Vector along(const Vector& u) const { return tool_.norm2 * u - dot(u, tool_.vector) * tool_.vector; }
  // A quarter turn to the right of a vector in the plane.
  [[nodiscard]] Vector right(const Vector& in_plane) const { return cross(in_plane, tool_.unit); }

  // By Gram and Schmidt: the first vector is the part in the plane of a coordinate axis, the first one at right angles
  // to the tool if there is such an axis.
  [[nodiscard]] PlaneFrame frame() const;
  // The same with the part in the plane of `v`, which is not along the tool.
  [[nodiscard]] PlaneFrame frame_along(const Vector& v) const;
  [[nodiscard]] bool has_rational_tool() const;

 private:
  Direction tool_;
};

// The part of a vector in the plane, in its frame; and back.
inline PlanePoint project(const PlaneFrame& frame, const Vector& v) {
  return {dot(frame.first, v), dot(frame.second, v)};
}
inline Vector lift(const PlaneFrame& frame, const PlanePoint& v) { return v[0] * frame.first + v[1] * frame.second; }

}  // namespace toolcomp::model
