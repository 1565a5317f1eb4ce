// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/corner/corner.h"

namespace toolcomp::model {
namespace {

// The offset lies away from the centre: the offset circle is larger than the programmed one.
bool grows(const PathEnd& end) { return end.turn * end.offset <= 0; }
// R - |offset| has the sign of R² - offset².
Real radius_difference(const PathEnd& end) { return end.heading.length2 - Rational(end.offset * end.offset); }

// Of a quantity that has been decided not to be negative.
Real root(const Real& radicand) {
  if (radicand.sign() == Sign::negative) throw NotFinite();  // only a forced outcome comes here
  return sqrt(radicand);
}

// The side of a point that cannot lie on the line.
Real side(Sign decided) {
  if (decided == Sign::zero) throw NotFinite();  // only a forced outcome comes here
  return static_cast<int>(decided);
}

// The line's offset line ρN + s·t against the offset circle: s = s0 - sgn(s0) √(R'² - h²), where s0 and h + ρ are the
// places of the centre along and left of the line. Here all of them are |t| times as long.
std::optional<PlanePoint> line_meets_circle(Recorder& recorder, const PathEnd& line, const PathEnd& arc) {
  const Heading& t = line.heading;
  const PlanePoint center = arc.to_center();
  const Real h = dot(center, left(t.along)) - line.offset * t.length;
  const Real h2 = square(h);
  const Real radius2 = t.length2 * arc.radius2();
  const Real discriminant = radius2 - h2;
  // fanuc.cutter-c.line-meets-arc: The offset line of a line and the offset circle of an arc, in either order, meet if
  // R' is at least |h|. Touching counts as meeting. N, t and rho are those of the line; O and R' are those of the arc.
  const Sign meets = recorder.decide(Clause::fanuc_cutter_c_line_meets_arc, discriminant, radius2 + h2);
  if (meets == Sign::negative) return std::nullopt;
  const Real s0 = dot(center, t.along);
  // fanuc.cutter-c.line-arc-point: Of the points where an offset line and an offset circle meet, the one counts that
  // tends to the corner as the offset tends to 0. Seen from the foot of the perpendicular from O to the line, this
  // point is on the same side as C.
  const Real ahead = side(recorder.decide(Clause::fanuc_cutter_c_line_arc_point, s0, arc.heading.length * t.length));
  const Real s = meets == Sign::zero ? s0 : s0 - ahead * root(discriminant);
  return (line.offset / t.length) * left(t.along) + (s / t.length2) * t.along;
}

// O1 + (u e + w left(e)) / (2 e²) with e from O1 to O2, u = e² + R1'² - R2'² and w² = 4 e² R1'² - u², which is
// ((R1' + R2')² - e²) (e² - (R1' - R2')²).
std::optional<PlanePoint> circles_meet(Recorder& recorder, const PathEnd& former, const PathEnd& latter) {
  const PlanePoint center1 = former.to_center();
  const PlanePoint center2 = latter.to_center();
  const PlanePoint e = center2 - center1;
  const Real e2 = squared_norm(e);
  if (e2.sign() == Sign::zero) throw NotFinite();  // one centre means parallel tangents: only a forced turn comes here
  const Real radius1 = former.radius();
  const Real radius2 = latter.radius();
  const Real sum2 = square(radius1 + radius2);
  // fanuc.cutter-c.circles-apart: The offset circles of two arcs, (O1, R1') and (O2, R2'), can meet only if the
  // distance of their centres is at most the sum of the radii. Touching counts as meeting.
  const Sign apart = recorder.decide(Clause::fanuc_cutter_c_circles_apart, sum2 - e2, sum2 + e2);
  if (apart == Sign::negative) return std::nullopt;
  const Real difference2 = square(radius1 - radius2);
  // fanuc.cutter-c.circles-nested: Offset circles that do not lie apart (fanuc.cutter-c.circles-apart) meet if the
  // distance of their centres is at least the difference of the radii.
  const Sign nested = recorder.decide(Clause::fanuc_cutter_c_circles_nested, e2 - difference2, e2 + difference2);
  if (nested == Sign::negative) return std::nullopt;

  // fanuc.cutter-c.arc-arc-point: Of the two points where two offset circles meet, the one counts that is on the same
  // side of the line through the centres as the corner.
  const Sign q =
      recorder.decide(Clause::fanuc_cutter_c_arc_arc_point, cross(center1, center2), former.heading.length * sqrt(e2));
  const bool touch = apart == Sign::zero || nested == Sign::zero;
  const Real w = touch ? Real(0) : side(q) * root((sum2 - e2) * (e2 - difference2));
  const Real u = e2 + former.radius2() - latter.radius2();
  return center1 + (1 / (2 * e2)) * (u * e + w * left(e));
}

}  // namespace

Heading heading(const PlanePoint& along) {
  Heading result{along, squared_norm(along), {}};
  result.length = sqrt(result.length2);
  return result;
}

OffsetPath line_path(const PlanePoint& travel, const Rational& offset_at_start, const Rational& offset_at_end) {
  const Heading way = heading(travel);
  return {travel, {way, 0, offset_at_start}, {way, 0, offset_at_end}};
}

PathEnd arc_end(const PlanePoint& from_center, int turn, const std::optional<Rational>& radius,
                const Rational& offset) {
  const PlanePoint along = Real(turn) * left(from_center);
  return {radius ? Heading{along, Rational(*radius * *radius), *radius} : heading(along), turn, offset};
}

OffsetPath arc_path(const ArcEnds& arc, const Rational& offset_at_start, const Rational& offset_at_end) {
  return {arc.end - arc.start, arc_end(arc.start, arc.turn, arc.radius, offset_at_start),
          arc_end(arc.end, arc.turn, arc.radius, offset_at_end), arc.one_radius};
}

Sign decide_offset_radius(Recorder& recorder, Clause clause, const PathEnd& end) {
  const Real scale = end.heading.length2 + end.offset * end.offset;
  return recorder.decide(clause, grows(end) ? scale : radius_difference(end), scale);
}

Sign offset_radius(const PathEnd& end) { return grows(end) ? Sign::positive : radius_difference(end).sign(); }

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

bool have_offset_paths(Recorder& recorder, const PathEnd& former, const PathEnd& latter) {
  const auto has = [&](const PathEnd& end) {
    return !end.is_arc() ||
           decide_offset_radius(recorder, Clause::fanuc_cutter_c_offset_radius_at_a_corner, end) != Sign::negative;
  };
  return has(former) && has(latter);
}

std::optional<PlanePoint> paths_meet(Recorder& recorder, const PathEnd& former, const PathEnd& latter) {
  if (former.is_arc() && latter.is_arc()) return circles_meet(recorder, former, latter);
  if (latter.is_arc()) return line_meets_circle(recorder, former, latter);
  if (former.is_arc()) return line_meets_circle(recorder, latter, former);
  return tangents_meet(tangent(former), tangent(latter));
}

}  // namespace toolcomp::model
