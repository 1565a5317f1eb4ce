// SPDX-License-Identifier: Apache-2.0
// The parameters that say how the rotary axes turn the tool, read in one place.
#pragma once

#include <cstdint>
#include <vector>

#include "model/geometry/vector.h"
#include "model/kinematics/turn.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Parameter 19680.
enum class MachineType : std::uint8_t { none, head, table, mixed };

// Parameters 19680-19690 and 19697-19699, or, where 19680 is 0, the older set 19610-19623. Without either the tool
// stands in +Z. Clauses: fanuc.tool-direction.*.
struct Mechanism {
  MachineType type = MachineType::none;  // none for the older set too
  // In the order they act on the reference direction: with 19680 the tool-side axis, then the work-side axis.
  std::vector<Turn> turns;
  Vector reference{0, 0, 1};  // tip to holder with the axes at 0; unit
};

// Throws spec::InputError naming the parameter that makes no sense.
Mechanism read_mechanism(const spec::Setup& setup);

// The value of a parameter, 0 where it is not given.
Rational parameter(const spec::Setup& setup, std::uint32_t number);

}  // namespace toolcomp::model
