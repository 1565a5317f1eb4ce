// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/corner/vector_group.h"

namespace toolcomp::model {

SpaceGroup in_space(spec::Plane plane, const VectorGroup& group) {
  SpaceGroup result;
  result.reserve(group.size());
  for (const CornerVector& v : group)
    result.push_back({in_space(plane, v.vector), v.former, v.latter, !result.empty()});
  return result;
}

CornerVector square_to_former(const PathEnd& former) { return {perpendicular(former), Seat::square, Seat::off}; }
CornerVector square_to_latter(const PathEnd& latter) { return {perpendicular(latter), Seat::off, Seat::square}; }

}  // namespace toolcomp::model
