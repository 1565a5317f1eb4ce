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
// The stop point is the first head.
SpaceGroup in_space(spec::Plane plane, const VectorGroup& group);

// P1 and P2 alone: at right angles to the former, to the latter block.
CornerVector square_to_former(const PathEnd& former);
CornerVector square_to_latter(const PathEnd& latter);

// The way round an outer corner: P1 where it is asked for; along the tangents, by the two prolonged vectors of an acute
// corner or the one where the tangents meet; P2 where it is asked for. `Corner` gives the vectors, as PathCorner does.
template <class Group, class Corner>
Group way_round(CornerClass kind, const Corner& corner, bool with_p1, bool with_p2) {
  Group group;
  group.reserve(4);
  if (with_p1) group.push_back({corner.square_to_former(), Seat::square, Seat::off});
  if (kind == CornerClass::acute) {
    group.push_back({corner.prolonged(), Seat::off, Seat::off});
    group.push_back({corner.begun_before(), Seat::off, Seat::off});
  } else {
    group.push_back({corner.tangents_meet(), Seat::off, Seat::off});
  }
  if (with_p2) group.push_back({corner.square_to_latter(), Seat::off, Seat::square});
  return group;
}

// The vectors of a corner of the plane (corner.h). Refers to its ends.
struct PathCorner {
  const PathEnd& former;
  const PathEnd& latter;

  [[nodiscard]] PlanePoint square_to_former() const { return perpendicular(former); }
  [[nodiscard]] PlanePoint prolonged() const { return model::prolonged(former); }
  [[nodiscard]] PlanePoint begun_before() const { return model::begun_before(latter); }
  [[nodiscard]] PlanePoint tangents_meet() const { return model::tangents_meet(former, latter); }
  [[nodiscard]] PlanePoint square_to_latter() const { return perpendicular(latter); }
};
inline VectorGroup way_round(CornerClass kind, const PathEnd& former, const PathEnd& latter, bool with_p1,
                             bool with_p2) {
  return way_round<VectorGroup>(kind, PathCorner{former, latter}, with_p1, with_p2);
}

}  // namespace toolcomp::model
