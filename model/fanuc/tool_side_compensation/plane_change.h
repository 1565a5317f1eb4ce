// SPDX-License-Identifier: Apache-2.0
// Interference check where the compensation plane changes between two blocks.
#pragma once

#include "model/basis/recorder.h"
#include "model/fanuc/tool_side_compensation/mode.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Clauses: fanuc.tool-side.plane-change-*.
class PlaneChangeCheck {
 public:
  // Parameters 19605#5 and 6261. Throws spec::InputError naming 6261.
  PlaneChangeCheck(const spec::Setup& setup, Recorder& recorder);

  // Whether the path from `former` to `latter` is at fault.
  [[nodiscard]] bool interferes(const SidePlan& former, const SidePlan& latter) const;

 private:
  [[nodiscard]] bool turns_far(const Direction& former, const Direction& latter) const;

  Recorder& recorder_;
  bool checks_;   // 19605#5, NIC, is 0
  Real cosine_;   // of the limit angle
  Real cosine2_;  // its square, rational for the angles for which it can be
};

}  // namespace toolcomp::model
