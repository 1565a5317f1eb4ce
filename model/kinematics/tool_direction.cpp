// SPDX-License-Identifier: Apache-2.0
#include "model/kinematics/tool_direction.h"

#include <algorithm>

namespace toolcomp::model {

Direction Direction::of(const Vector& vector) {
  const Real norm2 = squared_norm(vector);
  return {vector, norm2, vector / sqrt(norm2), true};
}

Kinematics::Kinematics(const spec::Setup& setup) : mechanism_(read_mechanism(setup)) {
  tip_control_built_ = mechanism_.type == MachineType::none || mechanism_.type == MachineType::head;
  for (const std::uint32_t offset : {19666U, 19709U, 19710U, 19711U, 19712U, 19713U, 19714U})
    if (parameter(setup, offset) != 0) tip_control_built_ = false;
}

bool Kinematics::turns(std::size_t axis) const {
  return std::ranges::any_of(mechanism_.turns, [axis](const Turn& turn) { return turn.axis == axis; });
}

Direction Kinematics::direction(const Position& angles) const {
  Direction result;
  if (!present()) return result;
  result.vector = mechanism_.reference;
  for (const Turn& turn : mechanism_.turns) result.vector = turn.apply(result.vector, turn.position(angles));
  result.unit = result.vector;  // turns keep its length 1
  result.reported = true;
  return result;
}

}  // namespace toolcomp::model
