// SPDX-License-Identifier: Apache-2.0
// Certified bounds of the error of a chord, inside a move.
#pragma once

#include <array>
#include <memory>

#include "certify/trace/space.h"
#include "model/exact/vector.h"
#include "model/fanuc/program/motion.h"
#include "model/geometry/point_path.h"
#include "spec/language/axes.h"

namespace toolcomp::certify {

// The motion of the axes as a function of t from 0 to 1, evaluated in intervals over whole parts of it. A function f
// runs within max |f"| dt² / 8 of the chord of a part of length dt, at the same t; f" comes out of the motion's
// definition by the rules of differentiation (jet.h), so the bound tends to the true largest |f"| as the parts shrink:
//  * An arc turns evenly and its radius r grows evenly: f" = (2 r' θ' i - r θ'²) e^{iθ}; what goes evenly besides
//    (the travel of a helix, other axes, the length offset) has none.
//  * Under tool center point control the control point C is T, the tip, turned by the table, plus an arm turned by the
//    head; with axes that turn evenly |C"| <= Ω² arm + 2 Ω |T'| + |T"|.
//  * Under posture control cosine and sine of both axes come from the direction as by inverse kinematics. Their
//    derivatives hold 1 / h², h being the distance from the pole: a part is bounded by the least h in it.
//  * Through the pole itself the tilted direction swings about the work-side axis as the direction does, and both axes
//    are smooth functions of the signed distance from the pole: they are used where the axis lies in the plane of the
//    directions. Nothing has to be split there.
//  * Where the tool-side axis leaves the edge of its reach its rate is infinite. There the chord is bounded by what
//    contains the part: the box of all values.
class CurveBound {
 public:
  // `axes` are those of the setup. Only the axes in `space` are measured.
  CurveBound(const model::InsideMove::Form& move, const spec::Axes& axes, const TraceSpace& space);
  // A tip that runs along an arc, and axes that differ from it by an offset that changes evenly; X Y Z.
  CurveBound(const model::PointPath& tip, const exact::Vector3& offset_before, const exact::Vector3& offset_after,
             const spec::Axes& axes, const TraceSpace& space);
  CurveBound(CurveBound&&) noexcept;
  CurveBound& operator=(CurveBound&&) noexcept;
  ~CurveBound();

  // The bounds for the part from t0 to t1. Infinite if there is no bound.
  struct Part {
    Distance sagitta;  // largest error of one chord; each of n equal chords has at most 1/n² of it
    Distance extent;   // largest distance of two positions of the part
  };
  [[nodiscard]] Part part(const exact::Rational& t0, const exact::Rational& t1) const;

  // X Y Z of the axes at t.
  [[nodiscard]] std::array<exact::DoubleEnclosure, 3> space_at(const exact::Rational& t) const;

 private:
  struct Motion;
  std::unique_ptr<const Motion> motion_;
};

}  // namespace toolcomp::certify
