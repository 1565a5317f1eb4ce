// SPDX-License-Identifier: Apache-2.0
// A corner of the programmed path: its class, and the vectors that stand at it. Vectors are seen from the corner, setup
// units. "former" is the block that ends there, "latter" the one that starts there.
#pragma once

#include <cstdint>
#include <optional>

#include "model/basis/event.h"
#include "model/fanuc/corner/offset_path.h"

namespace toolcomp::model {

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

}  // namespace toolcomp::model
