// SPDX-License-Identifier: Apache-2.0
// A corner in the compensation plane: the block that ends there and the one that starts there. Vectors are seen from
// the corner, X Y Z, setup units.
#pragma once

#include <utility>

#include "model/fanuc/corner/corner.h"
#include "model/fanuc/tool_side_compensation/side_path.h"

namespace toolcomp::model {

// In the plane at the end of the former. Refers to them.
struct SideCorner {
  const CompensationPlane& plane;
  const SideEnd& former;
  const SideEnd& latter;

  [[nodiscard]] bool of_lines() const { return !former.is_arc() && !latter.is_arc(); }
};

// Of two lines, without a frame.
//
// With W = VT × U for the travel U of a line: S = VT · (U1 × U2) = W1 · U2 tells the turn to the left and C = W1 · W2
// the way ahead, both as rational as VT and the program.

// The class. The offset of `former` is not 0. Clauses: fanuc.tool-side.corner-side, straight-or-reversal,
// obtuse-or-acute.
CornerClass classify(Recorder& recorder, const SideCorner& lines);
// Whether they are parallel in the plane, asked where the side changes. Clause:
// fanuc.cutter-c.direction-change-parallel.
bool is_parallel(Recorder& recorder, const SideCorner& lines);
// Whether the angle of an acute corner is under 1°. Clause: fanuc.cutter-c.under-one-degree.
bool is_under_one_degree(Recorder& recorder, const SideCorner& lines);
// The way round an outer corner, with the vectors square to the former and to the latter block where they are asked
// for.
SpaceGroup way_round(CornerClass kind, const SideCorner& lines, bool with_former, bool with_latter);

// The vectors of a corner; of one that has a frame, as they are seen there too: how far apart two of them are is told
// there, nearer to what they are made of.
struct SideGroup {
  SideGroup(SpaceGroup all, VectorGroup seen = {}) : vectors(std::move(all)), in_frame(std::move(seen)) {}

  SpaceGroup vectors;
  VectorGroup in_frame;  // as many, or none
};

// Both ends of a corner with an arc in a frame of the plane.
struct FramedCorner {
  explicit FramedCorner(const SideCorner& of);

  // A group made of them.
  [[nodiscard]] SideGroup lifted(VectorGroup group) const;

  const SideCorner& corner;
  PlaneFrame frame;
  PathEnd former;
  PathEnd latter;
};

// One vector: where the offset paths meet; r n2.
inline SpaceGroup one(const Vector& meeting) { return {{meeting, Seat::on, Seat::on, false}}; }
inline SpaceGroup square_to_latter(const SideEnd& latter) {
  return {{perpendicular(latter), Seat::off, Seat::square, false}};
}

}  // namespace toolcomp::model
