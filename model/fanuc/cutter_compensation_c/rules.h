// SPDX-License-Identifier: Apache-2.0
// The rules of cutter compensation C: the vectors at a corner. Clauses: fanuc.cutter-c.*.
#pragma once

#include <optional>

#include "model/fanuc/corner/corner.h"
#include "model/fanuc/cutter_compensation_c/mode.h"

namespace toolcomp::model {

class CutterRules {
 public:
  // Parameters 5003#0 and 5010.
  CutterRules(const spec::Setup& setup, Recorder& recorder);

  // The group between block A, which ends at a corner, and block B, which starts there, before small movements are
  // dropped; nothing where an inner corner has no intersection (PS0033). `repeated`: G41 or G42, in B or in a block
  // between.
  [[nodiscard]] std::optional<VectorGroup> by_first_rule(const CutterPlan& a, const CutterPlan& b, bool repeated) const;

  // The single rules. The offset at the end of `former` is not 0.
  [[nodiscard]] VectorGroup start_or_cancel(const PathEnd& former, const PathEnd& latter, bool cancels) const;
  [[nodiscard]] VectorGroup cancel_along(const PathEnd& former, const PlanePoint& direction) const;
  void drop_small_movements(VectorGroup& group, const OffsetPath& latter) const;

 private:
  Recorder& recorder_;
  bool type_b_;             // 5003#0, SUP
  Rational smallest_move_;  // 5010, setup units
};

}  // namespace toolcomp::model
