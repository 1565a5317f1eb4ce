// SPDX-License-Identifier: Apache-2.0
#include "model/heidenhain/programmed_contour/rules.h"

namespace toolcomp::model::klartext {

// heidenhain.contour.mode: Under IS CONTOUR 3D compensation uses the full radius R + DR and the full corner radius R2 +
// DR2. Otherwise it uses DR and DR2 alone. Asked of every block that is compensated. In other blocks the programmed
// point remains that of the tool.
// heidenhain.contour.reference-ignored: Under IS CONTOUR the coordinates are those of the contour, whatever REFPNT
// says, with or without a normal. Asked of every block that is compensated under IS CONTOUR.
bool ProgrammedContour::on_contour(const Motion& motion) const {
  if (!recorder_.decide(Clause::heidenhain_contour_mode, motion.contour)) return false;
  recorder_.decide(Clause::heidenhain_contour_reference_ignored, motion.center);
  return true;
}

// heidenhain.contour.nominal-tip: Without IS CONTOUR the programmed point is the tip or the centre of the nominal tool
// (heidenhain.program.reference-point). Compensation starts from the tip of the nominal tool.
Vector ProgrammedContour::tip_of_reference(const Motion& motion) {
  return motion.center ? motion.position - motion.tool->r2 * motion.direction.unit : motion.position;
}

// heidenhain.program.reference-point: Under REFPNT CNT-CNT the programmed point is the centre of the tool, R2 above the
// tip along the tool. Otherwise, and always without TCPM, the programmed point is the tip.
Vector ProgrammedContour::nominal_center(const Motion& motion) const {
  recorder_.reach(Clause::heidenhain_contour_nominal_tip);
  return motion.center ? motion.position : motion.position + motion.tool->r2 * motion.direction.unit;
}

// heidenhain.contour.face: Under IS CONTOUR, in blocks with a normal, the programmed point is the contact point, and
// the effective tool touches there.
Vector ProgrammedContour::contact_point(const Motion& motion) const {
  recorder_.reach(Clause::heidenhain_contour_face);
  return motion.position;
}

// heidenhain.contour.flank: Under IS CONTOUR with RL or RR, the programmed point is on the contour, and the tip is
// beside it by the effective radius.
ProgrammedContour::Flank ProgrammedContour::flank(const Motion& motion) const {
  const EffectiveTool& tool = *motion.tool;
  if (on_contour(motion)) {
    recorder_.reach(Clause::heidenhain_contour_flank);
    return {motion.position, tool.r + tool.dr};
  }
  recorder_.reach(Clause::heidenhain_contour_nominal_tip);
  return {tip_of_reference(motion), tool.dr};
}

}  // namespace toolcomp::model::klartext
