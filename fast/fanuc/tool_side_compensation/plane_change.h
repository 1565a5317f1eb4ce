// SPDX-License-Identifier: Apache-2.0
// The interference check where the compensation plane changes between two blocks (clauses fanuc.tool-side).
#pragma once

#include "fast/fanuc/tool_side_compensation/travel.h"
#include "fast/kinematics/kinematics.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// No. 6261: the angle by which the tool direction has to change; 0 and none mean 45 degrees.
class PlaneChangeLimit {
 public:
  PlaneChangeLimit() = default;
  // Throws spec::InputError for an angle beyond 180 degrees.
  explicit PlaneChangeLimit(const spec::Setup& setup);
  // The angle between two tools is the limit or more.
  [[nodiscard]] bool reached(const Kinematics& kinematics, const Direction& first, const Direction& second) const;

 private:
  DoubleDouble cosine_;
  // Of the angles whose squared cosine is rational: 4 times it, with the sign of the cosine.
  int quarters_ = 0;
  bool rational_ = false;
};

}  // namespace toolcomp::fast
