// SPDX-License-Identifier: Apache-2.0
// Where the tool goes: what the rules of 3D compensation make of a motion.
#pragma once

#include <optional>

#include "model/geometry/vector.h"
#include "spec/language/event.h"

namespace toolcomp::model::klartext {

// Units of the program, workpiece coordinates.
struct Compensated {
  Vector point;        // tip of the effective tool
  Vector tool_center;  // R2' above it
  Vector shift;        // of the tip against that of the nominal tool
  std::optional<spec::Contact<Real>> contact;
  spec::Cause cause = spec::Cause::programmed;
};

}  // namespace toolcomp::model::klartext
