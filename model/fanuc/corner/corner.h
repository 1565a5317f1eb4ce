// SPDX-License-Identifier: Apache-2.0
// The path of one block in the compensation plane, line or arc, as its two ends see it; a corner of the programmed
// path: its class, and the vectors that stand at it. Vectors are seen from the corner, setup units. "former" is the
// block that ends there, "latter" the one that starts there.
//
// Directions stay as long as the program makes them, so that everything decided by them is rational wherever the
// program is; a root appears where a coordinate is made. Nothing here knows where in the plane a block lies: an end is
// the origin, and the centre of an arc follows from its direction there.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/basis/event.h"
#include "model/basis/recorder.h"
#include "model/geometry/plane_vector.h"

namespace toolcomp::model {

// A direction in the plane, not normalised and not zero.
struct Heading {
  PlanePoint along;
  Real length2;
  Real length;
};
Heading heading(const PlanePoint& along);

// One end of a block: the direction of travel there, and for an arc the circle about its centre through that end,
// imaginary where the end lies off the arc. The centre lies at turn · left(along) from the end and |along| is the
// radius R.
struct PathEnd {
  Heading heading;
  int turn = 0;     // 0 a line, 1 an arc counter-clockwise, -1 clockwise
  Rational offset;  // signed distance of the tool to the left of the path at this end, setup units

  [[nodiscard]] bool is_arc() const { return turn != 0; }
  // From this end to the centre; arcs only.
  [[nodiscard]] PlanePoint to_center() const { return Real(turn) * left(heading.along); }
  // The radius R' = R - turn · offset of the offset circle, and its square; arcs only.
  [[nodiscard]] Real radius() const { return heading.length - Rational(turn * offset); }
  [[nodiscard]] Real radius2() const {
    return heading.length2 + (Rational(offset * offset) - Rational(2 * turn * offset) * heading.length);
  }
};

// A block of which at least the travel or the arc is not zero.
struct OffsetPath {
  PlanePoint travel;  // programmed, from start to end
  PathEnd start;
  PathEnd end;
  bool one_radius = true;  // arcs: programmed start and end radius are the same

  [[nodiscard]] bool is_arc() const { return start.is_arc(); }
};

// A straight block, with the offset in force at its start and at its end.
OffsetPath line_path(const PlanePoint& travel, const Rational& offset_at_start, const Rational& offset_at_end);

// An arc from `start` to `end`, both seen from the centre.
struct ArcEnds {
  PlanePoint start;
  PlanePoint end;
  int turn = 1;
  std::optional<Rational> radius;  // where R gives it: it stays rational where the centre is not
  bool one_radius = true;
};
OffsetPath arc_path(const ArcEnds& arc, const Rational& offset_at_start, const Rational& offset_at_end);
// One end of it; `from_center` is that end as seen from the centre.
PathEnd arc_end(const PlanePoint& from_center, int turn, const std::optional<Rational>& radius, const Rational& offset);

// The sign of the offset circle's radius R', decided under the clause; arcs only.
Sign decide_offset_radius(Recorder& recorder, Clause clause, const PathEnd& end);
// The same without a decision.
Sign offset_radius(const PathEnd& end);

// By the angle α between the two programmed paths on the side of the workpiece; of an arc its tangent counts.
enum class CornerClass : std::uint8_t {
  inner,     // α over 180°
  straight,  // 180°: one direction
  obtuse,    // 90° up to 180°
  acute      // under 90°, the exact reversal included
};

// Without trigonometry: by the signs of cross and scalar product. The offset of `former` is not 0. Clauses:
// fanuc.cutter-c.corner-side, straight-or-reversal, obtuse-or-acute.
CornerClass classify(Recorder& recorder, const PathEnd& former, const PathEnd& latter);

// Whether α of an acute corner is under 1°. Clause: fanuc.cutter-c.under-one-degree.
bool is_under_one_degree(Recorder& recorder, const PathEnd& former, const PathEnd& latter);
// The same by the squares of cross and scalar product, times one positive factor.
bool is_under_one_degree(Recorder& recorder, const Real& cross2, const Real& dot2);

// The line along a block at a corner: `left` at right angles to it, `ahead` along it, both of this length. V: the
// vectors of the plane in which the corner is seen.
template <class V>
struct Tangent {
  V left;
  V ahead;
  Real length;
  Rational offset;
};
inline Tangent<PlanePoint> tangent(const PathEnd& end) {
  return {left(end.heading.along), end.heading.along, end.heading.length, end.offset};
}

// P: at right angles to the path, of the length of the offset.
template <class V>
V perpendicular(const Tangent<V>& t) {
  return (t.offset / t.length) * t.left;
}
inline PlanePoint perpendicular(const PathEnd& end) { return perpendicular(tangent(end)); }
// M: where the offset tangent lines of both blocks meet, on one side of both or across; not where they are parallel.
// ρ1 (N1 ± N2) / (1 ± k) with N = left / length and k = N1 · N2.
template <class V>
V tangents_meet(const Tangent<V>& a, const Tangent<V>& b) {
  const V left = a.offset == b.offset ? b.left : -b.left;
  const Real denominator = a.length * b.length + dot(a.left, left);
  if (denominator.sign() == Sign::zero) throw NotFinite();  // only a forced class or turn comes here
  return (a.offset / denominator) * (b.length * a.left + a.length * left);
}
// Q1 and Q2: the offset lines prolonged beyond the corner by the length of the offset.
template <class V>
V prolonged(const Tangent<V>& t) {
  return (1 / t.length) * (t.offset * t.left + abs(t.offset) * t.ahead);
}
template <class V>
V begun_before(const Tangent<V>& t) {
  return (1 / t.length) * (t.offset * t.left - abs(t.offset) * t.ahead);
}

// Whether both ends have an offset path, which an arc has not where the offset is larger than its radius. Clause:
// fanuc.cutter-c.offset-radius-at-a-corner.
bool have_offset_paths(Recorder& recorder, const PathEnd& former, const PathEnd& latter);

// I: where the offset paths meet, each with its own offset: the meeting point that goes to the corner as the offset
// goes to 0. The tangents are not parallel, and there are offset paths. Nothing where they do not meet. Clauses:
// fanuc.cutter-c.line-meets-arc, line-arc-point, circles-apart, circles-nested, arc-arc-point.
std::optional<PlanePoint> paths_meet(Recorder& recorder, const PathEnd& former, const PathEnd& latter);

// Where the head of a vector lies as a block sees it.
enum class Seat : std::uint8_t {
  off,    // anywhere
  on,     // on the block's offset path
  square  // at right angles to the programmed path, at the distance of the offset
};

// A compensation vector at a corner.
template <class V>
struct SeatedVector {
  V vector;  // from the corner, setup units
  Seat former = Seat::off;
  Seat latter = Seat::off;
  bool after_stop = false;  // the tool gets there behind the single-block stop point
};
// In the plane of the corner, and in X Y Z whatever that plane is.
using CornerVector = SeatedVector<PlanePoint>;
using SpaceVector = SeatedVector<Vector>;

// In the order the tool takes their heads: at least one, at most four.
using VectorGroup = std::vector<CornerVector>;
using SpaceGroup = std::vector<SpaceVector>;
inline SpaceGroup in_space(spec::Plane plane, const VectorGroup& group) {
  SpaceGroup result;
  for (const CornerVector& v : group) result.push_back({in_space(plane, v.vector), v.former, v.latter});
  return result;
}

// P1 and P2 alone: at right angles to the former, to the latter block.
inline CornerVector square_to_former(const PathEnd& former) { return {perpendicular(former), Seat::square, Seat::off}; }
inline CornerVector square_to_latter(const PathEnd& latter) { return {perpendicular(latter), Seat::off, Seat::square}; }

// The way round an outer corner: P1 where it is asked for; along the tangents, by the two prolonged vectors of an acute
// corner or the one where the tangents meet; P2 where it is asked for.
template <class V>
std::vector<SeatedVector<V>> way_round(CornerClass kind, const Tangent<V>& former, const Tangent<V>& latter,
                                       bool with_p1, bool with_p2) {
  std::vector<SeatedVector<V>> group;
  if (with_p1) group.push_back({perpendicular(former), Seat::square, Seat::off});
  if (kind == CornerClass::acute) {
    group.push_back({prolonged(former)});
    group.push_back({begun_before(latter)});
  } else {
    group.push_back({tangents_meet(former, latter)});
  }
  if (with_p2) group.push_back({perpendicular(latter), Seat::off, Seat::square});
  return group;
}

// The rules of chapter 14 by which cutter compensation C and tool side compensation make the vectors at a corner of a
// plane (rules.cpp). The offset at the end of `former` is not 0, but for square_to. Clauses: fanuc.cutter-c.*.

// P1 alone; of an offset of 0 the vector 0.
VectorGroup square_to(Recorder& recorder, const PathEnd& former);
// Offset mode; nothing where an inner corner has no intersection (PS0033).
std::optional<VectorGroup> offset_mode(Recorder& recorder, const PathEnd& former, const PathEnd& latter);
// The side changes; `latter.offset` is the opposite of `former.offset`.
VectorGroup direction_change(Recorder& recorder, const PathEnd& former, const PathEnd& latter);
// Whether an arc that turns from `start` to `end`, both seen from its centre or both a quarter turn from there, sweeps
// less than a half circle. `radii`: the product of their lengths.
bool is_under_half_circle(Recorder& recorder, int turn, const PlanePoint& start, const PlanePoint& end,
                          const Real& radii);

}  // namespace toolcomp::model
