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

VectorGroup way_round(CornerClass kind, const PathEnd& former, const PathEnd& latter, bool with_p1, bool with_p2) {
  VectorGroup group;
  group.reserve(4);
  if (with_p1) group.push_back(square_to_former(former));
  if (kind == CornerClass::acute) {
    group.push_back({prolonged(former), Seat::off, Seat::off});
    group.push_back({begun_before(latter), Seat::off, Seat::off});
  } else {
    group.push_back({tangents_meet(former, latter), Seat::off, Seat::off});
  }
  if (with_p2) group.push_back(square_to_latter(latter));
  return group;
}

}  // namespace toolcomp::model
