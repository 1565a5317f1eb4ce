// FUNCTION PROG PATH: what the programmed point of a compensated block is.
#pragma once

#include "model/basis/recorder.h"
#include "model/heidenhain/program/motion.h"

namespace toolcomp::model::klartext {

// The rules that face and peripheral milling ask. Clauses: heidenhain.contour.*.
class ProgrammedContour {
 public:
  explicit ProgrammedContour(Recorder& recorder) : recorder_(recorder) {}

  // Whether the programmed point is on the contour, and the full radii count; else it is a point of the nominal tool,
  // and the deltas alone count.
  bool on_contour(const Motion& motion) const {
    if (!recorder_.decide(Clause::heidenhain_contour_mode, motion.contour)) return false;
    recorder_.decide(Clause::heidenhain_contour_reference_ignored, motion.center);
    return true;
  }

  // IS CONTOUR, a block with a normal: q.
  Vector contact_point(const Motion& motion) const {
    recorder_.reach(Clause::heidenhain_contour_face);
    return motion.position;
  }
  // OFF, a block with a normal: CR2 + rho u = tip_nom + R2 t, the centre of the nominal tool.
  Vector nominal_center(const Motion& motion) const {
    recorder_.reach(Clause::heidenhain_contour_nominal_tip);
    return motion.center ? motion.position : motion.position + motion.tool->r2 * motion.direction.unit;
  }

  // RL, RR: from where the tip is compensated, and by how much.
  struct Flank {
    Vector from;
    Real delta;
  };
  Flank flank(const Motion& motion) const {
    const EffectiveTool& tool = *motion.tool;
    if (on_contour(motion)) {
      recorder_.reach(Clause::heidenhain_contour_flank);
      return {motion.position, tool.r + tool.dr};
    }
    recorder_.reach(Clause::heidenhain_contour_nominal_tip);
    return {tip_of_reference(motion), tool.dr};
  }

  // The tip of the nominal tool whose reference point is programmed.
  static Vector tip_of_reference(const Motion& motion) {
    return motion.center ? motion.position - motion.tool->r2 * motion.direction.unit : motion.position;
  }

 private:
  Recorder& recorder_;
};

}  // namespace toolcomp::model::klartext
