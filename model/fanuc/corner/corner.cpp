// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/corner/corner.h"

namespace toolcomp::model {

CornerClass classify(Recorder& recorder, const PathEnd& former, const PathEnd& latter) {
  const PlanePoint& t1 = former.heading.along;
  const PlanePoint& t2 = latter.heading.along;
  const Real scale = former.heading.length * latter.heading.length;
  const Real turn = cross(t1, t2);
  // fanuc.cutter-c.corner-side: A corner is inner if the angle between A and B on the side of the workpiece is over 180
  // degrees, and outer if it is under 180 degrees. Exactly 180 degrees is inner. The tangent of an arc is taken at the
  // corner; for an arc of two radii it is at right angles to the radius there.
  const Sign side = recorder.decide(Clause::fanuc_cutter_c_corner_side, former.offset > 0 ? turn : -turn, scale);
  if (side == Sign::positive) return CornerClass::inner;
  const bool parallel = side == Sign::zero;
  // fanuc.cutter-c.straight-or-reversal: If t1 x t2 = 0 and B goes straight on, the corner is a tangent join, an inner
  // corner of 180 degrees. If B goes straight back, it is an outer acute corner of 0 degrees (ours), and the tool goes
  // round the end.
  // fanuc.cutter-c.obtuse-or-acute: An outer corner is obtuse from 90 degrees on and acute below.
  const Clause clause = parallel ? Clause::fanuc_cutter_c_straight_or_reversal : Clause::fanuc_cutter_c_obtuse_or_acute;
  const Sign ahead = recorder.decide(clause, dot(t1, t2), scale);
  if (ahead == Sign::negative) return CornerClass::acute;
  return parallel ? CornerClass::straight : CornerClass::obtuse;
}

bool is_under_one_degree(Recorder& recorder, const PathEnd& former, const PathEnd& latter) {
  return is_under_one_degree(recorder, square(cross(former.heading.along, latter.heading.along)),
                             square(dot(former.heading.along, latter.heading.along)));
}

bool is_under_one_degree(Recorder& recorder, const Real& cross2, const Real& dot2) {
  static const Rational tangent = Rational("174550649282175857651288952197/10000000000000000000000000000000");
  const Real ahead2 = Rational(tangent * tangent) * dot2;
  // fanuc.cutter-c.under-one-degree: An acute outer corner of two lines that is under 1 degree, straight back included,
  // makes a difference only at a start-up and at a cancel with SUP = 1. The vector is then P2 at start-up and P1 at
  // cancel, as with type A. For the tangent of 1 degree the decimal given is used.
  return recorder.decide(Clause::fanuc_cutter_c_under_one_degree, ahead2 - cross2, ahead2 + cross2) == Sign::positive;
}

}  // namespace toolcomp::model
