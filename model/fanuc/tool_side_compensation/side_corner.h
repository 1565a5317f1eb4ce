// SPDX-License-Identifier: Apache-2.0
// A corner in the compensation plane: the block that ends there and the one that starts there.
#pragma once

#include <utility>

#include "model/fanuc/corner/vector_group.h"
#include "model/fanuc/tool_side_compensation/line_corner.h"
#include "model/fanuc/tool_side_compensation/side_path.h"

namespace toolcomp::model {

// In the plane at the end of the former. Refers to them.
struct SideCorner {
  const CompensationPlane& plane;
  const SideEnd& former;
  const SideEnd& latter;

  [[nodiscard]] bool of_lines() const { return !former.arc && !latter.arc; }
};

// The vectors of a corner; of one that has a frame, as they are seen there too: how far apart two of them are is told
// there, nearer to what they are made of.
struct SideGroup {
  SideGroup(SpaceGroup all, VectorGroup seen = {}) : vectors(std::move(all)), in_frame(std::move(seen)) {}

  SpaceGroup vectors;
  VectorGroup in_frame;  // as many, or none

  [[nodiscard]] Real squared_distance(std::size_t a, std::size_t b) const;
};

// Both ends of a corner with an arc in a frame of the plane.
class FramedCorner {
 public:
  explicit FramedCorner(const SideCorner& corner);

  [[nodiscard]] const PathEnd& former() const { return former_; }
  [[nodiscard]] const PathEnd& latter() const { return latter_; }
  // A group made of them.
  [[nodiscard]] SideGroup lifted(VectorGroup group) const;

 private:
  void set_parallel(const Vector& v1, const Vector& v2);

  const SideCorner& corner_;
  PlaneFrame frame_;
  PathEnd former_;
  PathEnd latter_;
};

// One vector: where the offset paths meet; r n2.
inline SpaceGroup one(const Vector& meeting) { return {{meeting, Seat::on, Seat::on, false}}; }
inline SpaceGroup square_to_latter(const CompensationPlane& plane, const SideEnd& latter) {
  return {{perpendicular(plane, latter), Seat::off, Seat::square, false}};
}

// The way round an outer corner of two lines, with the vectors square to the former and to the latter block where they
// are asked for.
SpaceGroup way_round(CornerClass kind, const LineCorner& lines, bool with_former, bool with_latter);

}  // namespace toolcomp::model
