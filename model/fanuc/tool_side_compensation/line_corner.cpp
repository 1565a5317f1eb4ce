// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_side_compensation/line_corner.h"

#include "model/basis/event.h"

namespace toolcomp::model {

LineCorner::LineCorner(Recorder& recorder, const CompensationPlane& plane, const SideEnd& former, const SideEnd& latter)
    : recorder_(recorder),
      plane_(plane),
      former_(former),
      latter_(latter),
      // W1 · U2, of travels that are often rational.
      turn_(dot(plane.tool().vector, cross(former.travel, latter.travel))),
      ahead_(dot(former.left, latter.left)) {}

Real LineCorner::scale_of_turn() const {
  return sqrt(plane_.tool().norm2 * (squared_norm(former_.travel) * squared_norm(latter_.travel)));
}
Real LineCorner::scale_ahead() const {
  return plane_.tool().norm2 * sqrt(squared_norm(former_.travel) * squared_norm(latter_.travel));
}

CornerClass LineCorner::classify() const {
  // fanuc.tool-side.corner-side: A corner of two lines is inner if their angle on the side of the workpiece, in the
  // compensation plane, is over 180 degrees, and outer if it is under 180 degrees. Exactly 180 degrees is inner.
  const Sign side =
      recorder_.decide(Clause::fanuc_tool_side_corner_side, former_.offset > 0 ? turn_ : -turn_, scale_of_turn());
  if (side == Sign::positive) return CornerClass::inner;
  const bool parallel = side == Sign::zero;
  // fanuc.tool-side.straight-or-reversal: If S = 0 (fanuc.tool-side.corner-side) and B goes straight on, the corner is
  // an inner corner of 180 degrees. If B goes straight back, it is an outer acute corner of 0 degrees, and the tool
  // goes round the end.
  // fanuc.tool-side.obtuse-or-acute: An outer corner of two lines is obtuse from 90 degrees on and acute below, in the
  // compensation plane. To which class 90 degrees belongs makes no difference to the path.
  const Clause clause =
      parallel ? Clause::fanuc_tool_side_straight_or_reversal : Clause::fanuc_tool_side_obtuse_or_acute;
  const Sign ahead = recorder_.decide(clause, ahead_, scale_ahead());
  if (ahead == Sign::negative) return CornerClass::acute;
  return parallel ? CornerClass::straight : CornerClass::obtuse;
}

bool LineCorner::is_parallel() const {
  // fanuc.cutter-c.direction-change-parallel: At a change of direction, paths with parallel tangents count as paths
  // without intersection. This holds straight on and straight back, for lines and arcs, even if the offset circles
  // would meet. If B goes straight back, the two perpendicular vectors are the same.
  return recorder_.decide(Clause::fanuc_cutter_c_direction_change_parallel, turn_, scale_of_turn()) == Sign::zero;
}

bool LineCorner::is_under_one_degree() const {
  return model::is_under_one_degree(recorder_, plane_.tool().norm2 * square(turn_), square(ahead_));
}

// ρ (W1 |W2| + W2 |W1|) / (|W1| |W2| + C).
Vector LineCorner::tangents_meet() const {
  const Real length1 = sqrt(former_.left2);
  const Real length2 = sqrt(latter_.left2);
  const Real denominator = length1 * length2 + ahead_;
  if (denominator.sign() == Sign::zero) throw NotFinite();  // a reversal comes here only if its class is forced
  return (former_.offset / denominator) * (length2 * former_.left + length1 * latter_.left);
}

// ρ1 (W1 |W2| - W2 |W1|) / (|W1| |W2| - C).
Vector LineCorner::meeting_across() const {
  const Real length1 = sqrt(former_.left2);
  const Real length2 = sqrt(latter_.left2);
  const Real denominator = length1 * length2 - ahead_;
  if (denominator.sign() == Sign::zero) throw NotFinite();  // only a forced turn comes here
  return (former_.offset / denominator) * (length2 * former_.left - length1 * latter_.left);
}

Vector LineCorner::prolonged() const {
  const Rational reach = abs(former_.offset);
  return (1 / sqrt(former_.left2)) * (former_.offset * former_.left + reach * plane_.right(former_.left));
}

Vector LineCorner::begun_before() const {
  const Rational reach = abs(latter_.offset);
  return (1 / sqrt(latter_.left2)) * (latter_.offset * latter_.left - reach * plane_.right(latter_.left));
}

}  // namespace toolcomp::model
