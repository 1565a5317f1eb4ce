// SPDX-License-Identifier: Apache-2.0
// MDI intervention while cutter compensation C is on: a library call, for a program has no form for it.
#pragma once

#include <optional>
#include <vector>

#include "model/fanuc/corner/rules.h"

namespace toolcomp::model {

// A stop at the end B of a block, before a straight block B to C of the offset mode. Plane coordinates, setup units.
struct Intervention {
  PlanePoint stop;           // B as programmed
  VectorGroup group;         // the vectors there
  PlanePoint moved;          // what the MDI blocks move in the plane; they are not compensated
  PlanePoint end;            // C as programmed
  bool incremental = false;  // G91: C shifts as well
  Rational offset;           // signed, to the left
  PathEnd next;              // the start of the block after C, with its offset
};

// The heads as the tool takes them when the program goes on.
struct HeadsAfterIntervention {
  std::vector<PlanePoint> at_stop;  // shifted, not computed anew
  std::vector<PlanePoint> at_end;   // computed from the shifted start
};

// Nothing where the corner at C has no intersection any more (PS0033), or where nothing is left of the block. Clause:
// fanuc.cutter-c.manual-input.
std::optional<HeadsAfterIntervention> after_intervention(const CornerRules& rules, const Intervention& intervention);

}  // namespace toolcomp::model
