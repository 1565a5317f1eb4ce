// SPDX-License-Identifier: Apache-2.0
// The rules of face milling: how the cutter touches the wall, and where its tip then is.
#pragma once

#include <optional>

#include "model/basis/recorder.h"
#include "model/heidenhain/face_milling/contact_geometry.h"
#include "model/heidenhain/program/compensated.h"
#include "model/heidenhain/program/motion.h"
#include "model/heidenhain/programmed_contour/rules.h"

namespace toolcomp::model::klartext {

// A motion with a normal, once its tool is checked.
struct FaceContact {
  ContactGeometry geometry;
  Real dr2;                   // the delta of the corner radius that counts
  std::optional<Real> angle;  // theta, where a table of deviations counts
};

// The ring of the effective tool, and its direction. Units of the program.
struct Ring {
  bool flat = false;        // w = 0: the contact is on the axis
  bool has_bottom = false;  // rho' > 0
  Vector u;
  Real effective;  // rho'
  Real change;     // rho' - rho
};

// Clauses: heidenhain.face.*, heidenhain.tool.effective-flat, heidenhain.tool.ring-change.
class FaceRules {
 public:
  explicit FaceRules(Recorder& recorder) : recorder_(recorder), contour_(recorder) {}

  // Whether the programmed point is on the contour.
  [[nodiscard]] bool applies(const Motion& motion) const;
  // The normal points below the tool, beyond rounding.
  [[nodiscard]] bool is_below(const ContactGeometry& geometry) const;
  [[nodiscard]] Ring ring(const EffectiveTool& tool, const FaceContact& contact) const;
  // Where the tool goes.
  [[nodiscard]] Compensated compensate(const Motion& motion, const FaceContact& contact, const Ring& ring,
                                       bool on_contour) const;
  // The clause by which the contact jumps over the flat bottom, where it does. `w_before`: of the block before, 0 where
  // its contact was on the axis.
  [[nodiscard]] std::optional<Clause> jump(const Ring& ring, const Vector& w,
                                           const std::optional<Vector>& w_before) const;

 private:
  Recorder& recorder_;
  ProgrammedContour contour_;
};

}  // namespace toolcomp::model::klartext
