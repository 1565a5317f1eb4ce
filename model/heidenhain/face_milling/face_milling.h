// Face milling: LN blocks with a surface normal.
#pragma once

#include <optional>

#include "model/basis/recorder.h"
#include "model/heidenhain/face_milling/contact_geometry.h"
#include "model/heidenhain/program/compensated.h"
#include "model/heidenhain/program/motion.h"
#include "model/heidenhain/program/tool_checks.h"
#include "model/heidenhain/programmed_contour/rules.h"

namespace toolcomp::model::klartext {

// The cutter is a disc of radius rho at height R2 above the tip, thickened by R2 (a ring torus), plus the shank. It
// touches the wall at q; the effective tool touches the same plane at the same point. Clauses: heidenhain.face.*,
// heidenhain.tool.*.
class FaceMilling {
 public:
  explicit FaceMilling(Recorder& recorder) : recorder_(recorder), checks_(recorder), contour_(recorder) {}

  // What the checks find out on the way.
  struct Checked {
    ContactGeometry geometry;
    Real dr2;                   // the delta of the corner radius that counts
    std::optional<Real> angle;  // theta, where a table of deviations counts
  };
  // The alarms of a motion with a normal.
  [[nodiscard]] Checked check(const Motion& motion) const;

  // Where the tool goes; adds the warnings to the motion.
  Compensated compensate(Motion& motion, const Checked& checked);

  // Another motion, or a TOOL CALL, came between: no jump is looked for.
  void forget() { before_.reset(); }

 private:
  // The ring of the effective tool, and its direction.
  struct Ring {
    bool flat = false;        // w = 0: the contact is on the axis
    bool has_bottom = false;  // rho' > 0
    Vector u;
    Real effective;  // rho'
    Real change;     // rho' - rho
  };

  void look_at_side(Motion& motion, const ContactGeometry& geometry) const;
  [[nodiscard]] Ring ring(const EffectiveTool& tool, const Checked& checked) const;
  void look_for_jump(Motion& motion, const Ring& ring, const Vector& w);

  Recorder& recorder_;
  ToolChecks checks_;
  ProgrammedContour contour_;
  std::optional<Vector> before_;  // w of the block before; 0 where its contact was on the axis
};

}  // namespace toolcomp::model::klartext
