// SPDX-License-Identifier: Apache-2.0
#include "model/kinematics/tool_direction.h"

#include <algorithm>
#include <span>

namespace toolcomp::model {

Direction Direction::of(const Vector& vector) {
  const Real norm2 = squared_norm(vector);
  return {vector, norm2, vector / sqrt(norm2), true};
}

Kinematics::Kinematics(const spec::Setup& setup) : mechanism_(read_mechanism(setup)) {
  tip_control_built_ = mechanism_.type == MachineType::none || mechanism_.type == MachineType::head;
  for (const std::uint32_t offset : {19666U, 19709U, 19710U, 19711U, 19712U, 19713U, 19714U})
    if (parameter(setup, offset) != 0) tip_control_built_ = false;
  const bool turns_with_table = setup.bit(19746, 4) && !setup.bit(19696, 5);
  table_stands_ = has_table() && setup.series == spec::Series::series_30i && !turns_with_table;
}

bool Kinematics::turns(std::size_t axis) const {
  return std::ranges::any_of(mechanism_.turns, [axis](const Turn& turn) { return turn.axis == axis; });
}

Direction Kinematics::direction(const Position& angles) const {
  Direction result;
  if (!present()) return result;
  result.vector = mechanism_.reference;
  // The tool side comes first: of a mixed machine it is the axis of the tool.
  const bool by_tool_alone = table_stands_ && mechanism_.type == MachineType::mixed;
  std::span<const Turn> turns = mechanism_.turns;
  if (table_stands_) turns = turns.first(by_tool_alone ? 1 : 0);
  for (const Turn& turn : turns) result.vector = turn.apply(result.vector, turn.position(angles));
  result.unit = result.vector;  // turns keep its length 1
  result.reported = true;
  return result;
}

}  // namespace toolcomp::model
