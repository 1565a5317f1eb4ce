// SPDX-License-Identifier: Apache-2.0
// The rules of FUNCTION PROG PATH: what the programmed point of a compensated block is. The section is nothing but
// them.
#pragma once

#include "model/basis/recorder.h"
#include "model/heidenhain/program/motion.h"

namespace toolcomp::model::klartext {

// What face and peripheral milling ask. Units of the program. Clauses: heidenhain.contour.*.
class ProgrammedContour {
 public:
  explicit ProgrammedContour(Recorder& recorder) : recorder_(recorder) {}

  // Whether the programmed point is on the contour, and the full radii count; else it is a point of the nominal tool,
  // and the deltas alone count.
  [[nodiscard]] bool on_contour(const Motion& motion) const;

  // The tip of the nominal tool whose reference point is programmed.
  [[nodiscard]] static Vector tip_of_reference(const Motion& motion);
  // OFF, a block with a normal: CR2 + rho u = tip_nom + R2 t, the centre of the nominal tool.
  [[nodiscard]] Vector nominal_center(const Motion& motion) const;
  // IS CONTOUR, a block with a normal: q.
  [[nodiscard]] Vector contact_point(const Motion& motion) const;

  // RL, RR: from where the tip is compensated, and by how much.
  struct Flank {
    Vector from;
    Real delta;
  };
  [[nodiscard]] Flank flank(const Motion& motion) const;

 private:
  Recorder& recorder_;
};

}  // namespace toolcomp::model::klartext
