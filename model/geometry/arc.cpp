// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/arc.h"

#include "model/basis/alarm.h"
#include "model/basis/event.h"
#include "model/geometry/plane_vector.h"

namespace toolcomp::model {
Real swept_angle(const Real& sine, const Real& cosine, Sign side) {
  const Sign ahead = cosine.sign();
  if (side == Sign::zero) return ahead == Sign::negative ? 180 : 360;
  if (ahead == Sign::zero) return side == Sign::positive ? 90 : 270;
  const int turned = ahead == Sign::negative ? 180 : side == Sign::positive ? 0 : 360;
  // A forced side may turn by nothing, or by as little as the decision was near: such a sweep stands for one over 0.
  return turned + exact::arctangent_degrees(sine / cosine);
}

ArcGeometry arc_by_center(Recorder& recorder, const PlanePoint& start, const PlanePoint& travel,
                          const PlanePoint& to_center, spec::ArcDirection direction,
                          const Rational& allowed_difference) {
  ArcGeometry arc;
  arc.center = start + to_center;
  const bool closed = travel[0].sign() == Sign::zero && travel[1].sign() == Sign::zero;
  // fanuc.program.arc-full-circle: With I J K an arc that ends in the plane where it starts is a full circle of 360
  // degrees. It needs no axis word.
  if (recorder.decide(Clause::fanuc_program_arc_full_circle, closed)) {
    arc.sweep = 360;
    return arc;
  }
  const PlanePoint from = Real(-1) * to_center;
  const PlanePoint to = travel - to_center;
  const Real start_radius2 = dot(from, from);
  const Real end_radius2 = dot(to, to);
  const bool ends_in_center = end_radius2.sign() == Sign::zero;
  // fanuc.program.arc-ends-in-center: If an arc ends in its centre, no sweep can be stated.
  if (!recorder.decide(Clause::fanuc_program_arc_ends_in_center, ends_in_center)) {
    const Real left_turn = cross(from, to);
    const Real sine = direction == spec::ArcDirection::ccw ? left_turn : -left_turn;
    // fanuc.program.arc-sweep: With I J K the sweep is the angle from the start radius to the end radius in the
    // direction of the code, more than 0 and at most 360 degrees. If start and end lie on one ray from the centre, the
    // arc is a whole turn.
    const Sign side = recorder.decide(Clause::fanuc_program_arc_sweep, sine, sqrt(start_radius2 * end_radius2));
    arc.sweep = swept_angle(sine, dot(from, to), side);
  }
  const Real growth = end_radius2 - start_radius2;
  // fanuc.program.arc-spiral: With I J K start and end may have different distances from the centre. The tool then runs
  // a spiral whose radius changes evenly with the angle.
  if (recorder.decide(Clause::fanuc_program_arc_spiral, growth, end_radius2 + start_radius2) != Sign::zero)
    arc.radius = {sqrt(start_radius2), sqrt(end_radius2)};
  // fanuc.program.arc-radii: With I J K PS0020 is raised if the distances of start and end from the centre differ by
  // more than 3410. If 3410 is 0 or not given, no difference raises it.
  if (arc.radius && allowed_difference != 0) {
    const Real difference = sqrt(square(arc.radius->second - arc.radius->first));
    if (recorder.decide(Clause::fanuc_program_arc_radii, difference - allowed_difference, allowed_difference) ==
        Sign::positive)
      throw Alarm(AlarmCause::arc_radii_differ);
  }
  return arc;
}

ArcGeometry arc_by_radius(Recorder& recorder, const PlanePoint& start, const PlanePoint& travel, const Real& radius,
                          spec::ArcDirection direction) {
  const Real chord2 = dot(travel, travel);
  // The centre lies on the perpendicular bisector, at height h over the chord: h² = radius² − chord²/4.
  const Real radius2 = square(radius);
  const Real four_h2 = 4 * radius2 - chord2;
  // fanuc.program.arc-radius: R gives the radius. An arc exists if R is at least half the chord. A smaller R, 0
  // included, raises PS0020.
  const Sign reach = recorder.decide(Clause::fanuc_program_arc_radius, four_h2, 4 * radius2 + chord2);
  if (reach == Sign::negative) throw Alarm(AlarmCause::arc_radius_too_short);
  if (reach == Sign::positive && four_h2.sign() != Sign::positive) throw NotFinite();
  const Real height = reach == Sign::zero ? Real(0) : sqrt(four_h2 / (4 * chord2));  // h over the chord's length

  // fanuc.program.arc-larger: A positive R means the arc of at most 180 degrees, a negative one the larger arc.
  const bool larger = recorder.decide(Clause::fanuc_program_arc_larger, radius.sign() == Sign::negative);
  const bool center_left = (direction == spec::ArcDirection::ccw) != larger;
  const PlanePoint left{-travel[1], travel[0]};
  ArcGeometry arc;
  arc.center = start + Real(exact::Rational(1, 2)) * travel + (center_left ? height : -height) * left;
  const Sign side = reach == Sign::zero ? Sign::zero : larger ? Sign::negative : Sign::positive;
  const Real sine = (larger ? -height : height) * chord2;
  const Real cosine = radius2 - chord2 / 2;
  arc.sweep = side == Sign::zero ? Real(180) : swept_angle(sine, cosine, side);
  return arc;
}

}  // namespace toolcomp::model
