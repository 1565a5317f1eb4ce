// SPDX-License-Identifier: Apache-2.0
// The compensation vectors at one corner, in the order the tool takes their heads.
#pragma once

#include <cstdint>
#include <vector>

#include "model/fanuc/corner/corner.h"
#include "model/geometry/vector.h"

namespace toolcomp::model {

// Where the head of a vector lies as a block sees it.
enum class Seat : std::uint8_t {
  off,    // anywhere
  on,     // on the block's offset path
  square  // at right angles to the programmed path, at the distance of the offset
};

struct CornerVector {
  PlanePoint vector;  // from the corner, setup units
  Seat former = Seat::off;
  Seat latter = Seat::off;
};

// At least one vector, at most four.
using VectorGroup = std::vector<CornerVector>;

// The same in X Y Z, whatever the plane of the corner.
struct SpaceVector {
  Vector vector;
  Seat former = Seat::off;
  Seat latter = Seat::off;
  bool after_stop = false;  // the tool gets there behind the single-block stop point
};
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
template <class Group, class V>
Group way_round(CornerClass kind, const Tangent<V>& former, const Tangent<V>& latter, bool with_p1, bool with_p2) {
  Group group;
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
inline VectorGroup way_round(CornerClass kind, const PathEnd& former, const PathEnd& latter, bool with_p1,
                             bool with_p2) {
  return way_round<VectorGroup>(kind, tangent(former), tangent(latter), with_p1, with_p2);
}

}  // namespace toolcomp::model
