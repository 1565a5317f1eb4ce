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

// The way round an outer corner: along the tangents, with the vectors at right angles to the former and to the latter
// block where they are asked for.
VectorGroup way_round(CornerClass kind, const PathEnd& former, const PathEnd& latter, bool with_p1, bool with_p2);

}  // namespace toolcomp::model
