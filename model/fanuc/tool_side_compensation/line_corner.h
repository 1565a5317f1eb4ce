// SPDX-License-Identifier: Apache-2.0
// A corner of two lines in the compensation plane: its class, and the vectors that stand at it, without a frame.
//
// With W = VT × U for the travel U of a line: S = VT · (U1 × U2) = W1 · U2 tells the turn to the left and C = W1 · W2
// the way ahead, both as rational as VT and the program. Vectors are seen from the corner, X Y Z, setup units.
#pragma once

#include "model/basis/recorder.h"
#include "model/fanuc/corner/corner.h"
#include "model/fanuc/tool_side_compensation/side_path.h"

namespace toolcomp::model {

// Refers to what it is made of.
class LineCorner {
 public:
  LineCorner(Recorder& recorder, const CompensationPlane& plane, const SideEnd& former, const SideEnd& latter);

  // The offset of `former` is not 0. Clauses: fanuc.tool-side.corner-side, straight-or-reversal, obtuse-or-acute.
  [[nodiscard]] CornerClass classify() const;
  // Whether the lines are parallel in the plane, asked where the side changes. Clause:
  // fanuc.cutter-c.direction-change-parallel.
  [[nodiscard]] bool is_parallel() const;
  // Whether the angle of an acute corner is under 1°. Clause: fanuc.cutter-c.under-one-degree.
  [[nodiscard]] bool is_under_one_degree() const;

  // r n1 and r n2: square to the former, to the latter line.
  [[nodiscard]] Vector square_to_former() const { return perpendicular(plane_, former_); }
  [[nodiscard]] Vector square_to_latter() const { return perpendicular(plane_, latter_); }
  // Vi: where the offset lines meet, on one side of both; not at a reversal.
  [[nodiscard]] Vector tangents_meet() const;
  // The same on different sides, of lines that are not parallel.
  [[nodiscard]] Vector meeting_across() const;
  // K1 and K2: the offset lines prolonged beyond the corner by the length of the offset.
  [[nodiscard]] Vector prolonged() const;
  [[nodiscard]] Vector begun_before() const;

 private:
  // |VT| |U1| |U2|, or |VT|² |U1| |U2|: what S and C are measured against.
  [[nodiscard]] Real scale_of_turn() const;
  [[nodiscard]] Real scale_ahead() const;

  Recorder& recorder_;
  const CompensationPlane& plane_;
  const SideEnd& former_;
  const SideEnd& latter_;
  Real turn_;   // S
  Real ahead_;  // C
};

}  // namespace toolcomp::model
